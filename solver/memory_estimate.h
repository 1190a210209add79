// What a simulation will take of memory, told from counts before anything is made.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/counted_faces.h"

namespace hottel {

// What is asked beside the scene.
struct MemoryQuestion {
  Granularity granularity = Granularity::kElement;
  double parts = 1;            // into how many every element is divided further
  bool solves = false;         // for radiosities, beside the factors
  int channels = 1;            // of these
  std::uint64_t cells = 0;     // of light between the faces
  std::uint64_t pixels = 0;    // of a picture
  bool pairs_on_disk = false;  // what factors and their solution take of memory does not grow with them
};

// What one stage takes at its peak.
struct MemoryStage {
  std::string name;
  double count = 0;  // of what it takes memory for
  std::string unit;  // what that is called, as many
  double bytes = 0;
};

// What the tables of a dimension take at the most, in bytes: an element; a visible pair while it is measured, and in
// the matrix.
struct TableBytes {
  double element = 0, pair = 0, cached_pair = 0;
};

// About how many of the pairs of faces see each other, as sampled_pairs tells.
using PairSampling = std::function<SampledPairs(std::span<const CountedFace>)>;

// What stages take, one after another, beside the program and the scene. The elements and the matrix of the factors
// stay, the other stages are not there together.
//
//   (1) elements are those that dividing adds to the faces of the scene
//   (2) of_factors() is what is held against --memory: elements, and pairs until they are a matrix, where their number
//       is known
//   (3) of_solution() is the most at any time after the factors, held against what the machine has
//   (4) peak() is the most at any time, with as many pairs as there may be
class MemoryEstimate {
 public:
  // Pairs are drawn where all that there are may take more than `room` bytes, with the elements. `sampling`: null where
  // every pair sees each other. COST: linear in the faces, and that of the sampling.
  MemoryEstimate(std::vector<CountedFace> faces, const MemoryQuestion& question, const TableBytes& bytes, double room,
                 const PairSampling& sampling);

  const std::vector<MemoryStage>& stages() const { return stages_; }
  double of_factors() const { return of_factors_; }
  double of_solution() const { return of_solution_; }
  double peak() const { return peak_; }

 private:
  void add_solution(const ElementPairCounts& counts, const MemoryQuestion& question, double cached_pair);

  std::vector<MemoryStage> stages_;
  double of_factors_ = 0, of_solution_ = 0, peak_ = 0;
  double pairs_ = 0, known_pairs_ = 0;
};

// What may be taken: of factors as was asked for, or else as all; of all together 80 % of what is free.
struct MemoryLimits {
  std::uint64_t of_factors = 0, of_all = 0;
};
MemoryLimits memory_limits(std::uint64_t asked);

// Returns why it cannot be had: which counts need how much, what is allowed, and a remedy; empty where it can.
std::string memory_problem(const MemoryEstimate& estimate, const MemoryLimits& limits);

// Throws RequestError where dividing surfaces takes more than is allowed. estimate(room): as MemoryEstimate takes it.
void require_memory_for(const SceneTable& scene, const MemoryQuestion& question, std::uint64_t asked,
                        const std::function<MemoryEstimate(double room)>& estimate);

}  // namespace hottel

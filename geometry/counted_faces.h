// How many elements and pairs of them a scene has, told before any is made.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"

namespace hottel {

// A face, how many elements it is divided into, and whether they have rows.
struct CountedFace {
  std::uint32_t surface = 0;
  bool is_back = false;
  std::uint64_t elements = 1;
  bool has_row = false;
};

// Where elements are told apart, a face with a material has parts(s) of them, or the leaves of its trees; others, and
// all faces else, are one: groups are not told apart. `parts`: of a surface that is divided into more than one.
std::vector<CountedFace> counted_faces(const SceneTable& scene, Granularity granularity,
                                       const std::function<std::uint64_t(std::uint32_t surface)>& parts);

// What follows of the counts alone. A pair is one of two faces, of which one has a row: those of one face never see
// each other.
struct ElementPairCounts {
  double elements = 0, rows = 0, pairs = 0;  // doubles: there may be more than 2^64
};
ElementPairCounts pair_counts(std::span<const CountedFace> faces);

// Random numbers that are the same everywhere.
class SampleChance {
 public:
  std::uint64_t number() { return random_(); }
  double share() { return static_cast<double>(random_() >> 11) * 0x1p-53; }  // from 0, below 1

 private:
  std::mt19937_64 random_{1};
};

// A part of a face of which is asked what it sees: an element drawn from all that have rows, or from all.
struct DrawnFace {
  CountedFace face;
  double place;  // which of its elements, from 0, below 1
};

// About how many pairs see each other. Where fewer than four of those that were drawn do, it is not known: then there
// are about as many, or fewer, as if four did.
struct SampledPairs {
  double pairs = 0;
  bool is_known = false;
};

// Draws so many pairs, always alike, and asks sees() which see each other.
// REQUIRES at least two elements and a row.
SampledPairs sampled_pairs(
    std::span<const CountedFace> faces, std::size_t samples,
    const std::function<bool(const DrawnFace& a, const DrawnFace& b, SampleChance& chance)>& sees);

}  // namespace hottel

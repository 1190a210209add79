#include "solver/plane/scene_memory.h"

#include <algorithm>
#include <vector>

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/pair_estimate.h"

namespace hottel {
namespace {

// An element in the arrangement and in the tables; a pair in both of its rows.
constexpr double kBytesPerElement = 1500, kBytesPerKeptPair = 64;

// Beside what is on disk: the program; an edge with what is prepared of it; a row, and what it has of each channel; a
// sum while it is summed up. Of the memory that is allowed sums take a half.
constexpr double kBytesOfProgram = 4e7, kBytesPerEdge = 2500, kBytesPerRow = 600, kBytesPerRowAndChannel = 400,
                 kBytesPerSum = 96, kPartForSums = 0.5;

}  // namespace

MemoryEstimate estimate_memory(const Scene2& scene, const MemoryQuestion& question, double room) {
  const PairSampling sampling = [&scene](std::span<const CountedFace> faces) {
    return estimated_pairs_2(scene, faces);
  };
  return {counted_faces_2(scene, question.granularity), question,
          TableBytes{kBytesPerElement, static_cast<double>(kBytesPerPair), kBytesPerKeptPair}, room,
          is_convex_room(scene) ? PairSampling() : sampling};
}

void require_memory(const Scene2& scene, const MemoryQuestion& question, std::uint64_t memory) {
  require_memory_for(scene, question, memory, [&](double room) { return estimate_memory(scene, question, room); });
}

double memory_beside_disk(const Scene2& scene, double pairs, double memory) {
  const std::vector<CountedFace> faces = counted_faces_2(scene, Granularity::kElement);
  const ElementPairCounts counts = pair_counts(faces);
  const double prepared = static_cast<double>(scene.surfaces.size()) * kBytesPerEdge +
                          (counts.elements - static_cast<double>(faces.size())) * kBytesPerElement;
  const double sums = std::min(memory * kPartForSums, pairs * kBytesPerSum);
  const double solution = counts.rows * (kBytesPerRow + channel_count(scene) * kBytesPerRowAndChannel);
  return kBytesOfProgram + prepared + std::max(sums, solution);
}

}  // namespace hottel

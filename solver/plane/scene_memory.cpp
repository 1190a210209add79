#include "solver/plane/scene_memory.h"

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/pair_estimate.h"

namespace hottel {
namespace {

// An element in the arrangement and in the tables; a pair in both of its rows.
constexpr double kBytesPerElement = 1500, kBytesPerKeptPair = 64;

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

}  // namespace hottel

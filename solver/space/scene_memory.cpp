#include "solver/space/scene_memory.h"

#include "geometry/space/exchange/exchange_memory.h"
#include "geometry/space/exchange/pair_estimate.h"

namespace hottel {
namespace {

constexpr double kBytesPerKeptPair = 120;  // in both of its rows, with bounds

}  // namespace

MemoryEstimate estimate_memory(const Scene3& scene, const MemoryQuestion& question, double room) {
  const PairSampling sampling = [&scene](std::span<const CountedFace> faces) {
    return estimated_pairs_3(scene, faces);
  };
  return {counted_faces_3(scene, question.granularity), question,
          TableBytes{static_cast<double>(kBytesPerElement3), static_cast<double>(kBytesPerPair3), kBytesPerKeptPair},
          room, sampling};
}

void require_memory(const Scene3& scene, const MemoryQuestion& question, std::uint64_t memory) {
  require_memory_for(scene, question, memory, [&](double room) { return estimate_memory(scene, question, room); });
}

}  // namespace hottel

// What a scene in the plane will take of memory.
#pragma once

#include <cstdint>

#include "geometry/plane/scene/scene.h"
#include "solver/memory_estimate.h"

namespace hottel {

// Tells it from the counts of faces and elements, and from pairs of elements that are drawn (estimated_pairs_2): no
// element is made. COST: linear, and a quarter of a second at most for the pairs.
MemoryEstimate estimate_memory(const Scene2& scene, const MemoryQuestion& question, double room = 0);

// Throws RequestError, naming the file, where some surface is divided, or will be, and that takes more than is allowed:
// before any element is made. memory: as asked for, 0 where it was not.
void require_memory(const Scene2& scene, const MemoryQuestion& question, std::uint64_t memory);

// Bytes that `solve` takes at the most, the program and the scene included, where factors are on disk: within a factor
// of 1.5. pairs: that see each other; memory: what is allowed for sums of them.
double memory_beside_disk(const Scene2& scene, double pairs, double memory);

}  // namespace hottel

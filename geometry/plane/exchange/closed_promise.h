// The promise of a scene in the plane to be closed, where its exact factors are not asked for.
#pragma once

#include <cstdint>
#include <functional>

namespace hottel {

struct PreparedScene2;
struct SceneTable;

// Throws RequestError, naming the first front, where a front with a material sees the sky.
//
//   (1) decided without rounding, whatever method gives the factors
//   (2) the same as of the exact factors: their elements where the scene was prepared divided, else faces
// scene: the one that makes the promise; it may differ from that which was prepared in values, and in where it was
// typed. memory, progress: as in ExchangeRequest.
// COST: linear in the triangles where no such front looks into the region that reaches infinity; else the rows of those
// that do.
void require_closed(const SceneTable& scene, const PreparedScene2& prepared, std::uint64_t memory,
                    const std::function<void(double)>& progress = {});

}  // namespace hottel

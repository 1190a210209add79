#include "geometry/space/arrangement/nothing_between.h"

#include <algorithm>

#include "geometry/space/arrangement/closed_hull.h"

namespace hottel {
namespace {

// Whether some vertex lies strictly on one side of a polygon: before its front, or behind.
bool has_vertex_at(const Occluders3& occluders, std::size_t s, bool is_before) {
  SignTier tier;
  return std::ranges::any_of(IdRange<VertexId3>(occluders.vertices().size()), [&](VertexId3 v) {
    const int side = occluders.side_of(v, s, tier);
    return is_before ? side > 0 : side < 0;
  });
}

}  // namespace

bool is_convex_room(const Scene3& scene, const Occluders3& occluders) {
  return std::ranges::none_of(scene.surfaces, [](const Surface& surface) { return surface.back.has_value(); }) &&
         ClosedHull3(occluders).is_room();
}

bool faces_nothing(const Scene3& scene, const Occluders3& occluders) {
  for (std::size_t s = 0; s < occluders.size(); ++s)
    if (has_vertex_at(occluders, s, true) || (scene.surfaces[s].back && has_vertex_at(occluders, s, false)))
      return false;
  return true;
}

}  // namespace hottel

#include "geometry/space/exchange/facing.h"

#include <algorithm>

namespace hottel {
namespace {

using Part = ElementTable3::Part;

// Whether a surface has a corner before the side of a patch.
bool is_surface_before(const Occluders3& occluders, std::uint32_t surface, const Part& part) {
  const auto corners = occluders.outline(surface);
  return std::any_of(corners.begin(), corners.end(), [&](VertexId3 v) {
    SignTier tier;
    const int side = occluders.side_of(v, part.patch.surface, tier);
    return part.is_back ? side < 0 : side > 0;
  });
}

bool is_patch_before(const Occluders3& occluders, const Patch3& patch, const Part& part) {
  const IntegerVector& anchor = occluders.vertices().exact(occluders.outline(part.patch.surface).front());
  const IntegerVector& normal = occluders.exact_normal(part.patch.surface);
  const Integer height = patch.weight * dot(normal, anchor);
  return std::any_of(patch.corners.begin(), patch.corners.end(), [&](const IntegerVector& corner) {
    const int side = cmp(dot(normal, corner), height);
    return part.is_back ? side < 0 : side > 0;
  });
}

}  // namespace

bool surfaces_face_each_other(const Occluders3& occluders, const Part& i, const Part& j) {
  return i.patch.surface != j.patch.surface && is_surface_before(occluders, j.patch.surface, i) &&
         is_surface_before(occluders, i.patch.surface, j);
}

bool face_each_other(const Occluders3& occluders, const Part& i, const Part& j) {
  return surfaces_face_each_other(occluders, i, j) && is_patch_before(occluders, j.patch, i) &&
         is_patch_before(occluders, i.patch, j);
}

}  // namespace hottel

#include "geometry/space/exchange/pair_setting.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

Box3 box_of(const Vertices3& vertices, const Patch3& patch) {
  Box3 box;
  for (const IntegerVector& corner : patch.corners) {
    const auto place = [&](const Integer& value) { return rounded_quotient(value, patch.weight, vertices.shift()); };
    BoundedVector p{place(corner.x), place(corner.y), place(corner.z)};
    p.size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    p.error = 0x1p-50 * p.size;
    box.include(p);
  }
  return box;
}

}  // namespace

PairSetting3::PairSetting3(const Blockers3& blockers, const SurfaceBoxes3& boxes, const Patch3& i, const Patch3& j)
    : bodies(blockers, i, j) {
  if (i.surface == j.surface && !i.is_sky()) return;
  if (!bodies.patch_sides[0].has_front || !bodies.patch_sides[1].has_front) return;
  find_hull();
  Box3 box = box_of(blockers.vertices(), i);
  box.include(box_of(blockers.vertices(), j));
  std::vector<std::uint32_t> near;
  boxes.find(box, near);
  std::sort(near.begin(), near.end());
  for (const std::uint32_t surface : near) {
    if (surface == i.surface || surface == j.surface) continue;
    const std::uint32_t body = bodies.add(blockers, surface);
    if (!may_stand_between(body))
      bodies.drop_last();
    else if (hides_all(body))
      return;
  }
  sight = bodies.bodies.size() > 2 ? Sight3::kMixed : Sight3::kClear;
}

void PairSetting3::find_hull() {
  add_hull_planes(0, 1);
  add_hull_planes(1, 0);
}

void PairSetting3::add_hull_planes(std::uint32_t of_edges, std::uint32_t of_points) {
  const std::vector<std::uint32_t>& corners = bodies.bodies[of_edges].corners;
  const std::vector<std::uint32_t>& others = bodies.bodies[of_points].corners;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::uint32_t a = corners[c], b = corners[(c + 1) % corners.size()];
    for (const std::uint32_t p : others) {
      const PairBodies3::Plane plane = bodies.plane_through(a, b, p);
      bool has_positive = false, has_negative = false;
      for (const std::vector<std::uint32_t>* all : {&corners, &others})
        for (const std::uint32_t q : *all) {
          if (has_positive && has_negative) break;
          const int sign = bodies.orientation(plane, q);
          has_positive |= sign > 0;
          has_negative |= sign < 0;
        }
      if (has_positive != has_negative) hull.push_back({plane, has_positive ? 1 : -1});
    }
  }
}

bool PairSetting3::is_beside_hull(std::uint32_t body) const {
  const std::vector<std::uint32_t>& corners = bodies.bodies[body].corners;
  return std::any_of(hull.begin(), hull.end(), [&](const HullPlane& plane) {
    return std::none_of(corners.begin(), corners.end(),
                        [&](std::uint32_t q) { return bodies.orientation(plane.plane, q) * plane.inside > 0; });
  });
}

bool PairSetting3::may_stand_between(std::uint32_t body) const {
  const auto& of_body = bodies.of_body[body];
  if (!of_body[0].has_front || !of_body[1].has_front) return false;
  const auto& of_patch = bodies.of_patch[body];
  if (!(of_patch[0].has_front && of_patch[1].has_behind) && !(of_patch[0].has_behind && of_patch[1].has_front))
    return false;
  return !is_beside_hull(body);
}

// For each point of one patch what is hidden of the other one is convex, and the other way round: corners suffice.
bool PairSetting3::hides_all(std::uint32_t body) const {
  const auto& of_patch = bodies.of_patch[body];
  if (of_patch[0].straddles() || of_patch[1].straddles()) return false;
  const auto is_off = [&](std::uint32_t patch) {
    const std::vector<std::uint32_t>& corners = bodies.bodies[patch].corners;
    return std::none_of(corners.begin(), corners.end(), [&](std::uint32_t p) { return bodies.side(p, body) == 0; });
  };
  if (!is_off(0) || !is_off(1)) return false;
  const std::vector<std::uint32_t>& corners = bodies.bodies[body].corners;
  // Seen from patch 0 the corners go around one way.
  const int turn = of_patch[0].has_front ? -1 : 1;
  for (const std::uint32_t p : bodies.bodies[0].corners)
    for (const std::uint32_t q : bodies.bodies[1].corners)
      for (std::size_t c = 0; c < corners.size(); ++c)
        if (bodies.orientation(p, q, corners[c], corners[(c + 1) % corners.size()]) * turn < 0) return false;
  return true;
}

}  // namespace hottel

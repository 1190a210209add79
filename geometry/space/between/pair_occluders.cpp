#include "geometry/space/between/pair_occluders.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

// Rounding of doubles is far below this part of a length.
constexpr double kSlack = 1e-9;
constexpr double kSureNormal = 1e-11;  // of which the error is that part of it

// Whether a surface has a corner in front of a patch. True also of the sky.
bool is_before(const Occluders3& occluders, std::uint32_t surface, const KnownPatch3& patch) {
  const auto corners = occluders.outline(surface);
  return patch.turn == 0 || std::any_of(corners.begin(), corners.end(), [&](VertexId3 v) {
           SignTier tier;
           return occluders.side_of(v, patch.patch->surface, tier) * patch.turn > 0;
         });
}

}  // namespace

PairOccluders3::PairOccluders3(const Occluders3& occluders, const SurfaceBoxes3& boxes, const KnownPatch3& i,
                               const KnownPatch3& j, FirstMet3* first_met)
    : bodies(occluders, i, j),
      reach_(boxes.reach()),
      solids_(first_met == nullptr ? nullptr : &first_met->hiders().bodies()) {
  find_between(occluders, boxes, first_met);
}

PairOccluders3::PairOccluders3(const Occluders3& occluders, const SurfaceBoxes3& boxes, const Patch3& i,
                               const Patch3& j, FirstMet3* first_met)
    : bodies(occluders, i, j),
      reach_(boxes.reach()),
      solids_(first_met == nullptr ? nullptr : &first_met->hiders().bodies()) {
  find_between(occluders, boxes, first_met);
}

void PairOccluders3::find_between(const Occluders3& occluders, const SurfaceBoxes3& boxes, FirstMet3* first_met) {
  bodies.hides_joined = first_met != nullptr;
  if (!can_see()) return;
  const KnownPatch3 &i = bodies.known(0), &j = bodies.known(1);
  const bool is_far = j.patch->is_far();
  Box3 box = i.box;
  if (!is_far) box.include(j.box);
  const auto is_other = [&](std::uint32_t surface) {
    return surface != i.patch->surface && surface != j.patch->surface;
  };
  thread_local std::vector<std::uint32_t> near;
  near.clear();
  if (!is_far) {
    boxes.find(box, near);
    std::erase_if(near, [&](std::uint32_t surface) { return !is_other(surface); });
    // Where nothing in the box around both is in front of both, no hull is needed.
    const auto is_in_front = [&](std::uint32_t surface) {
      return is_before(occluders, surface, i) && is_before(occluders, surface, j);
    };
    if (std::none_of(near.begin(), near.end(), is_in_front)) {
      sight = PairVisibility3::kClear;
      return;
    }
  }
  find_hull(occluders.vertices());
  const auto is_near = [&](const Box3& other) {
    return std::none_of(half_spaces.begin(), half_spaces.end(), [&](const HullHalfSpace3& half) {
      const Direction3 highest{half.x > 0 ? other.high[0] : other.low[0], half.y > 0 ? other.high[1] : other.low[1],
                               half.z > 0 ? other.high[2] : other.low[2]};
      return half.height(highest) < 0;
    });
  };
  if (is_far) {
    boxes.find_where(is_near, near);
    std::erase_if(near, [&](std::uint32_t surface) { return !is_other(surface); });
  } else {
    std::erase_if(near, [&](std::uint32_t surface) { return !is_near(boxes.of(surface)); });
  }
  std::sort(near.begin(), near.end());
  if (first_met != nullptr) {
    const auto stays = [first_met](std::uint32_t surface) { return !first_met->is_never_first(surface); };
    const auto middle = std::stable_partition(near.begin(), near.end(), stays);
    left_out.assign(middle, near.end());
    near.erase(middle, near.end());
  }
  add_bodies(occluders, near);
}

PairOccluders3::PairOccluders3(const Occluders3& occluders, const PairOccluders3& whole, const Patch3& i,
                               const Patch3& j)
    : bodies(occluders, i, j), left_out(whole.left_out), reach_(whole.reach_), solids_(whole.solids_) {
  bodies.hides_joined = whole.bodies.hides_joined;
  if (!can_see()) return;
  find_hull(occluders.vertices());
  std::vector<std::uint32_t> near;
  for (std::uint32_t body = 2; body < whole.bodies.end_of_between(); ++body)
    near.push_back(whole.bodies.bodies[body].surface);
  add_bodies(occluders, near);
}

bool PairOccluders3::can_see() const {
  const Patch3 &i = *bodies.known(0).patch, &j = *bodies.known(1).patch;
  if (i.surface == j.surface && !i.is_sky()) return false;
  return bodies.patch_sides[0].has_front && bodies.patch_sides[1].has_front;
}

void PairOccluders3::add_bodies(const Occluders3& occluders, std::span<const std::uint32_t> near) {
  for (const std::uint32_t surface : near) {
    if (!bodies.add_between(occluders, surface)) continue;
    const std::uint32_t body = bodies.count() - 1;
    if (is_beside_hull(body))
      bodies.drop_last();
    else if (hides_all(body))
      return;
  }
  sight = count_between() > 0 ? PairVisibility3::kMixed : PairVisibility3::kClear;
  if (sight != PairVisibility3::kMixed) return;
  keep_left_out_at_lines(occluders);
  if (solids_ != nullptr) add_solids(occluders);
}

// No line passes an outline beside which there is a surface that no line meets, whatever has been left out.
void PairOccluders3::keep_left_out_at_lines(const Occluders3& occluders) {
  if (left_out.empty()) return;
  std::vector<EdgeId3> edges;
  for (std::size_t body = 2; body < bodies.bodies.size(); ++body)
    for (const DirectedEdge3& side : occluders.edges(bodies.bodies[body].surface)) edges.push_back(side.edge);
  std::ranges::sort(edges);
  std::erase_if(left_out, [&](std::uint32_t surface) {
    const auto sides = occluders.edges(surface);
    const bool is_neighbour = std::any_of(sides.begin(), sides.end(), [&](const DirectedEdge3& side) {
      return std::ranges::binary_search(edges, side.edge);
    });
    if (!is_neighbour) return false;
    const bool is_met = may_stand_between(bodies.add(occluders, surface));
    bodies.drop_last();
    return !is_met;
  });
}

void PairOccluders3::add_solids(const Occluders3& occluders) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t body = 2; body < bodies.count(); ++body)
    if (const std::uint32_t number = solids_->body_of(bodies.bodies[body].surface); number != ConvexBody3::kNone)
      numbers.push_back(number);
  std::ranges::sort(numbers);
  const auto has = [this](std::uint32_t patch, std::uint32_t number) {
    const std::uint32_t surface = bodies.bodies[patch].surface;
    return surface != Patch3::kSky && solids_->body_of(surface) == number;
  };
  for (auto first = numbers.begin(); first != numbers.end();) {
    const std::uint32_t number = *first;
    const auto last = std::find_if(first, numbers.end(), [number](std::uint32_t other) { return other != number; });
    const ConvexBody3& body = solids_->bodies()[number];
    // A surface in the plane of the lid bounds nothing, but may be met.
    const bool is_whole = std::ranges::find(body.plane_of, ConvexBody3::kNone) == body.plane_of.end();
    if (last - first > 1 && is_whole && !has(0, number) && !has(1, number)) bodies.add_solid(occluders, body);
    first = last;
  }
}

void PairOccluders3::find_hull(const Vertices3& vertices) {
  add_hull_planes(0, 1);
  add_hull_planes(1, 0);
  const double unit_ratio = std::ldexp(1.0, static_cast<int>(bodies.shift() - vertices.shift()));
  for (const HullPlane& plane : hull) add_half_space(plane, unit_ratio);
}

void PairOccluders3::add_half_space(const HullPlane& plane, double unit_ratio) {
  const BoundedVector& bounded = plane.plane.normal;
  if (!(bounded.error <= kSureNormal * bounded.size)) return;  // of points that all but coincide
  const auto place = [&](std::uint32_t number) {
    const PairGeometry3::Point& p = bodies.points[number];
    const double scale = unit_ratio / p.approximate_weight;
    return Direction3{scale * p.approximate.x, scale * p.approximate.y, scale * p.approximate.z};
  };
  const Direction3 a = place(plane.plane.p);
  double slack = kSlack * length(a);
  const auto way = [&](std::uint32_t number) {
    if (bodies.points[number].is_far()) {
      slack += kSlack * reach_;
      return unit(bodies.place(number));
    }
    const Direction3 p = place(number);
    slack += kSlack * length(p);
    return p - a;
  };
  const Direction3 b = way(plane.plane.q), c = way(plane.plane.r);
  Direction3 normal = cross(b, c);
  const double size = length(normal);
  if (!(size > 1e-6 * length(b) * length(c))) return;  // too thin to be told in doubles
  normal = (plane.inside / size) * normal;
  slack += kSlack * length(b);
  half_spaces.push_back({normal.x, normal.y, normal.z, slack - dot(normal, a)});
}

void PairOccluders3::add_hull_planes(std::uint32_t of_edges, std::uint32_t of_points) {
  const std::vector<std::uint32_t>& corners = bodies.bodies[of_edges].corners;
  const std::vector<std::uint32_t>& others = bodies.bodies[of_points].corners;
  const bool is_far = bodies.is_far(of_edges);
  std::vector<std::uint32_t> all(corners);
  all.insert(all.end(), others.begin(), others.end());
  std::vector<BoundedVector> ways;  // from the first point of planes
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t next = c + 1 == corners.size() ? 0 : c + 1;
    const std::uint32_t a = corners[c], b = corners[next];
    if (!is_far) bodies.set_ways(a, all, ways);
    for (std::size_t k = 0; k < others.size(); ++k) {
      const std::uint32_t p = others[k];
      if (is_far) bodies.set_ways(p, all, ways);
      const BoundedVector &to_b = ways[next], &to_other = ways[is_far ? c : corners.size() + k];
      const PairGeometry3::Plane plane = is_far ? PairGeometry3::Plane{p, a, b, cross(to_other, to_b)}
                                                : PairGeometry3::Plane{a, b, p, cross(to_b, to_other)};
      bool has_positive = false, has_negative = false;
      for (std::size_t q = 0; q < all.size() && !(has_positive && has_negative); ++q) {
        const int sign = bodies.orientation(plane, all[q], ways[q]);
        has_positive |= sign > 0;
        has_negative |= sign < 0;
      }
      if (has_positive != has_negative) hull.push_back({plane, has_positive ? 1 : -1});
    }
  }
}

bool PairOccluders3::is_beside_hull(std::uint32_t body) const {
  const std::vector<std::uint32_t>& corners = bodies.bodies[body].corners;
  return std::any_of(hull.begin(), hull.end(), [&](const HullPlane& plane) {
    return std::none_of(corners.begin(), corners.end(),
                        [&](std::uint32_t q) { return bodies.orientation(plane.plane, q) * plane.inside > 0; });
  });
}

bool PairOccluders3::may_stand_between(std::uint32_t body) const {
  const auto& of_body = bodies.of_body[body];
  if (!of_body[0].has_front || !of_body[1].has_front) return false;
  const auto& of_patch = bodies.of_patch[body];
  if (!(of_patch[0].has_front && of_patch[1].has_behind) && !(of_patch[0].has_behind && of_patch[1].has_front))
    return false;
  return !is_beside_hull(body);
}

// For each point of one patch what is hidden of the other one is convex, and the other way round: corners suffice.
bool PairOccluders3::hides_all(std::uint32_t body) const {
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

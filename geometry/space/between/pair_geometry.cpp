#include "geometry/space/between/pair_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/arrangement/short_integers.h"

namespace hottel {
namespace {

int sign_of(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// The memory of the corners of the body that was taken away last, for the next one.
thread_local std::vector<std::uint32_t> spare_corners;

void take_away_last(std::vector<PairGeometry3::Body>& bodies) {
  spare_corners.swap(bodies.back().corners);
  bodies.pop_back();
}

}  // namespace

PairGeometry3::PairGeometry3(const Occluders3& occluders, const KnownPatch3& i, const KnownPatch3& j)
    : vertices_(&occluders.vertices()), known_{&i, &j} {
  const long top = std::max(i.bits, j.bits);
  shift_ = top <= 53 && occluders.vertices().shift() == 0 ? 0 : std::max(0L, top - 53);
  constexpr std::size_t kManyPoints = 32, kManyBodies = 8;
  points.reserve(kManyPoints);
  bodies.reserve(kManyBodies);
  add_patch(occluders, i);
  add_patch(occluders, j);
  patch_sides = {side_of_body(0, 1), side_of_body(1, 0)};
}

PairGeometry3::PairGeometry3(const Occluders3& occluders, const Patch3& i, const Patch3& j)
    : PairGeometry3(occluders, std::unique_ptr<const OwnPatches>(new OwnPatches{{occluders, i}, {occluders, j}})) {}

PairGeometry3::PairGeometry3(const Occluders3& occluders, std::unique_ptr<const OwnPatches> own)
    : PairGeometry3(occluders, own->i, own->j) {
  own_ = std::move(own);
}

std::uint32_t PairGeometry3::add_point(const IntegerVector& exact, const Integer& weight,
                                       const BoundedVector& approximate, double approximate_weight, long spare) {
  points.push_back({&exact, &weight, approximate, approximate_weight, spare});
  if (spare > 0) points.back().approximate.error += 0x1p-52 * approximate.size;
  return static_cast<std::uint32_t>(points.size() - 1);
}

std::uint32_t PairGeometry3::vertex(const Occluders3& occluders, VertexId3 v) {
  static const Integer kOne = 1;
  const auto [number, is_new] = vertex_numbers_.try_number(v, static_cast<std::uint32_t>(points.size()));
  const Vertices3& vertices = occluders.vertices();
  if (is_new)
    add_point(vertices.exact(v), kOne,
              shift_ == vertices.shift() ? vertices.approximate(v) : rounded(vertices.exact(v), shift_), 1);
  return number;
}

void PairGeometry3::add_patch(const Occluders3& occluders, const KnownPatch3& known) {
  const Patch3& patch = *known.patch;
  Body body{{}, &known.normal, known.rounded_normal, patch.surface};
  body.corners.reserve(patch.corners.size());
  const std::size_t others = points.size();
  const double weight = known.weight;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const IntegerVector& corner = patch.corners[k];
    if (patch.is_far()) {
      body.corners.push_back(add_point(corner, patch.weight, known.approximate[k], weight));
      continue;
    }
    if (const VertexId3 same = known.vertices[k]; !same.is_none()) {
      body.corners.push_back(vertex(occluders, same));
      continue;
    }
    const long shift = shift_ + known.spare;
    const BoundedVector approximate = shift == 0 ? known.approximate[k] : rounded(corner, shift);
    const auto may_be_same = [&](const Point& p) {
      const double slack = 1e-9 * (weight * p.approximate.size + p.approximate_weight * approximate.size);
      return std::fabs(weight * p.approximate.x - p.approximate_weight * approximate.x) <= slack &&
             std::fabs(weight * p.approximate.y - p.approximate_weight * approximate.y) <= slack &&
             std::fabs(weight * p.approximate.z - p.approximate_weight * approximate.z) <= slack;
    };
    const auto is_same = [&](const Point& p) {
      return may_be_same(p) && is_at_vertex_3(multiple(p.weight(), corner), patch.weight, p.exact());
    };
    const auto found = std::find_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(others), is_same);
    body.corners.push_back(found == points.begin() + static_cast<std::ptrdiff_t>(others)
                               ? add_point(corner, patch.weight, approximate, weight, known.spare)
                               : static_cast<std::uint32_t>(found - points.begin()));
  }
  bodies.push_back(std::move(body));
}

std::uint32_t PairGeometry3::begin_body(const Occluders3& occluders, std::uint32_t surface) {
  const auto number = static_cast<std::uint32_t>(bodies.size());
  const auto outline = occluders.outline(surface);
  Body& body = bodies.emplace_back(Body{{}, &occluders.exact_normal(surface), occluders.normal(surface), surface});
  body.corners.swap(spare_corners);
  body.corners.clear();
  body.corners.reserve(outline.size());
  for (const VertexId3 v : outline) body.corners.push_back(vertex(occluders, v));
  return number;
}

std::uint32_t PairGeometry3::add(const Occluders3& occluders, std::uint32_t surface) {
  const std::uint32_t number = begin_body(occluders, surface);
  of_body.push_back({side_of_body(number, 0), side_of_body(number, 1)});
  of_patch.push_back({side_of_body(0, number), side_of_body(1, number)});
  return number;
}

bool PairGeometry3::add_between(const Occluders3& occluders, std::uint32_t surface) {
  const std::uint32_t number = begin_body(occluders, surface);
  const Side beside_first = side_of_body(number, 0);
  const Side beside_second = beside_first.has_front ? side_of_body(number, 1) : Side{};
  if (beside_second.has_front) {
    const Side first = side_of_body(0, number), second = side_of_body(1, number);
    if ((first.has_front && second.has_behind) || (first.has_behind && second.has_front)) {
      of_body.push_back({beside_first, beside_second});
      of_patch.push_back({first, second});
      return true;
    }
  }
  take_away_last(bodies);
  return false;
}

void PairGeometry3::drop_last() {
  take_away_last(bodies);
  of_body.pop_back();
  of_patch.pop_back();
}

void PairGeometry3::add_solid(const Occluders3& occluders, const ConvexBody3& body) {
  if (solids.empty()) end_of_between_ = count();
  Solid& solid = solids.emplace_back(Solid{&body, {}, {}, {}});
  for (std::size_t k = 0; k < body.surfaces.size(); ++k) {
    std::uint32_t face = 2;
    while (face < end_of_between_ && bodies[face].surface != body.surfaces[k]) ++face;
    if (face == end_of_between_) face = add(occluders, body.surfaces[k]);
    solid.faces.push_back(face);
    const IntegerVector& outward = body.planes[body.plane_of[k]].outward;
    solid.outward.push_back(static_cast<signed char>(dot_sign(bodies[face].exact_normal(), outward)));
    for (std::size_t patch = 0; patch < 2; ++patch)
      if (of_body[face][patch].has_behind) solid.may_hide[patch] = false;
  }
  for (std::uint32_t k = 0; k < solid.faces.size(); ++k) {
    const std::vector<std::uint32_t>& corners = bodies[solid.faces[k]].corners;
    for (std::uint32_t side = 0; side < corners.size(); ++side) {
      const std::uint32_t a = corners[side], b = corners[(side + 1) % corners.size()];
      const auto is_same = [&](const Solid::Edge& edge) {
        const std::vector<std::uint32_t>& others = bodies[solid.faces[edge.face[0]]].corners;
        const std::uint32_t c = others[edge.side[0]], d = others[(edge.side[0] + 1) % others.size()];
        return (a == c && b == d) || (a == d && b == c);
      };
      if (const auto known = std::ranges::find_if(solid.edges, is_same); known == solid.edges.end())
        solid.edges.push_back({{k, Solid::kNone}, {side, 0}});
      else {
        known->face[1] = k;
        known->side[1] = side;
      }
    }
  }
}

PairGeometry3::Side PairGeometry3::side_of_body(std::uint32_t body, std::uint32_t other) const {
  Side result;
  for (const std::uint32_t point : bodies[body].corners) {
    const int sign = side(point, other);
    result.has_front |= sign > 0;
    result.has_behind |= sign < 0;
  }
  return result;
}

// weight of p * q - weight of q * p.
BoundedVector PairGeometry3::way(std::uint32_t p, std::uint32_t q) const {
  const Point &from = points[p], &to = points[q];
  const BoundedVector &a = from.approximate, &b = to.approximate;
  const double v = from.approximate_weight, w = to.approximate_weight;
  BoundedVector d{v * b.x - w * a.x, v * b.y - w * a.y, v * b.z - w * a.z};
  d.size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const double sizes = v * b.size + w * a.size;
  if (a.error != 0 || b.error != 0 || sizes > 0x1p53)
    d.error = 1.001 * (v * b.error + w * a.error + 0x1p-52 * sizes) + detail::kUnderflow;
  return d;
}

IntegerVector PairGeometry3::exact_way(std::uint32_t p, std::uint32_t q) const {
  const Point &from = points[p], &to = points[q];
  return difference(multiple(from.weight(), to.exact()), multiple(to.weight(), from.exact()));
}

Direction3 PairGeometry3::place(std::uint32_t point) const {
  const Point& p = points[point];
  const BoundedVector& a = p.approximate;
  const double w = p.approximate_weight;
  if (p.is_far()) return {a.x, a.y, a.z};
  return {a.x / w, a.y / w, a.z / w};
}

int PairGeometry3::side(std::uint32_t point, std::uint32_t body) const {
  const Body& b = bodies[body];
  if (is_far(body)) return 1;
  for (const std::uint32_t corner : b.corners)
    if (corner == point) return 0;
  const int sign = filtered_sign(b.normal, way(b.corners.front(), point));
  return sign != kUndecided ? sign : sgn(dot(b.exact_normal(), exact_way(b.corners.front(), point)));
}

int PairGeometry3::orientation(std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) const {
  if (p == q || p == r || p == s || q == r || q == s || r == s) return 0;
  const BoundedVector a = way(p, q), b = way(p, r), c = way(p, s);
  const int sign = filtered_sign(cross(a, b), c);
  if (sign == kUndecided && is_small_integer(a) && is_small_integer(b) && is_small_integer(c))
    return sign_of(small_determinant(a, b, c));
  return sign != kUndecided ? sign : determinant_sign(exact_way(p, q), exact_way(p, r), exact_way(p, s));
}

void PairGeometry3::set_ways(std::uint32_t p, std::span<const std::uint32_t> others,
                             std::vector<BoundedVector>& ways) const {
  ways.clear();
  for (const std::uint32_t q : others) ways.push_back(way(p, q));
}

int PairGeometry3::orientation(const Plane& plane, std::uint32_t s, const BoundedVector& way_to_s) const {
  if (s == plane.p || s == plane.q || s == plane.r) return 0;
  const int sign = filtered_sign(plane.normal, way_to_s);
  return sign != kUndecided ? sign : orientation(plane.p, plane.q, plane.r, s);
}

}  // namespace hottel

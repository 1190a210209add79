#include "geometry/space/visibility/eye_planes.h"

#include <utility>

namespace hottel {
namespace {

BoundedVector nearest(const IntegerVector& a) { return rounded(a, std::max(0L, bits(a) - 53)); }

void negate(BoundedVector& a) {
  a.x = -a.x;
  a.y = -a.y;
  a.z = -a.z;
}

}  // namespace

EyePlanes3::EyePlanes3(const Occluders3& occluders, Eye3 eye, bool always_exact)
    : occluders_(occluders), eye_(std::move(eye)), always_exact_(always_exact) {
  const std::size_t count = occluders.edge_count();
  normals_.reserve(count);
  definitions_.reserve(count);
  exact_normals_.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    const Occluders3::Edge& edge = occluders.edge(EdgeId3(e));
    // Of a sun two directions that are close do not tell their plane in doubles: to integers they do.
    normals_.push_back(eye_.sun() ? nearest(exact_normal(PlaneId3(e))) : cross(eye_.toward(edge.from), edge.vector));
    definitions_.push_back({PlaneDefinition3::Kind::kEdge, static_cast<std::uint32_t>(edge.from.number()),
                            static_cast<std::uint32_t>(edge.to.number())});
  }
  find_facing();
}

void EyePlanes3::find_facing() {
  facing_.resize(occluders_.size());
  for (std::size_t s = 0; s < occluders_.size(); ++s) {
    if (const SunFrame3* const sun = eye_.sun()) {
      counts_.count(SignTier::kExact);
      facing_[s] = static_cast<signed char>(sun->facing(occluders_.exact_normal(s)));
      continue;
    }
    const VertexId3 anchor = occluders_.outline(s).front();
    int sign = filtered_sign(occluders_.normal(s), eye_.toward(anchor));
    counts_.count(sign == kUndecided ? SignTier::kExact : SignTier::kFilter);
    if (sign == kUndecided) sign = sgn(dot(occluders_.exact_normal(s), eye_.exact_toward(anchor)));
    facing_[s] = static_cast<signed char>(-sign);
  }
}

PlaneSide3 EyePlanes3::add(const PlaneDefinition3& definition, IntegerVector normal) {
  const PlaneId3 plane(normals_.size());
  normals_.push_back(nearest(normal));
  exact_normals_.push_back(std::make_unique<IntegerVector>(std::move(normal)));
  definitions_.push_back(definition);
  return {plane, false};
}

// With N turned so that the eye is in front and P = N . (x - v) > 0 the plane of s is met at -P / (N . w); it is met
// before that of t where P_s (N_t . w) - P_t (N_s . w) > 0, for both N . w are negative.
PlaneSide3 EyePlanes3::add_crossing(std::size_t s, std::size_t t) {
  const PlaneDefinition3 definition{PlaneDefinition3::Kind::kCrossing, static_cast<std::uint32_t>(s),
                                    static_cast<std::uint32_t>(t)};
  if (const SunFrame3* const sun = eye_.sun())
    return add(definition, sun->crossing(plane_of(occluders_, s), plane_of(occluders_, t)));
  const auto height = [this](std::size_t k) -> Integer {
    return -facing_[k] * dot(occluders_.exact_normal(k), eye_.exact_toward(occluders_.outline(k).front()));
  };
  const Integer of_s = height(s) * static_cast<int>(facing_[t]), of_t = height(t) * static_cast<int>(facing_[s]);
  const IntegerVector &a = occluders_.exact_normal(s), &b = occluders_.exact_normal(t);
  return add(definition, primitive({of_s * b.x - of_t * a.x, of_s * b.y - of_t * a.y, of_s * b.z - of_t * a.z}));
}

PlaneSide3 EyePlanes3::add_horizon(const IntegerVector& normal) {
  return add({PlaneDefinition3::Kind::kHorizon, 0, 0}, normal);
}

bool EyePlanes3::passes_through(PlaneId3 plane, VertexId3 v) const {
  const PlaneDefinition3& definition = definitions_[plane.index()];
  const auto number = static_cast<std::uint32_t>(v.number());
  return definition.kind == PlaneDefinition3::Kind::kEdge && (definition.a == number || definition.b == number);
}

VertexId3 EyePlanes3::shared_vertex(PlaneId3 a, PlaneId3 b) const {
  const PlaneDefinition3& definition = definitions_[a.index()];
  if (definition.kind == PlaneDefinition3::Kind::kEdge)
    for (const std::uint32_t v : {definition.a, definition.b})
      if (passes_through(b, VertexId3(v))) return VertexId3(v);
  return VertexId3::none();
}

int EyePlanes3::settled_sign(VertexId3 v, PlaneId3 plane) {
  if (!always_exact_ && passes_through(plane, v)) {
    counts_.count(SignTier::kCombinatorial);
    return 0;
  }
  counts_.count(SignTier::kExact);
  return sgn(dot(exact_normal(plane), eye_.exact_toward(v)));
}

int EyePlanes3::settled_sign(const ConeCorner3& corner, PlaneId3 plane) {
  if (!corner.vertex.is_none()) {
    const int sign = settled_sign(corner.vertex, plane);
    return corner.is_antipode ? -sign : sign;
  }
  if (!always_exact_ && (plane == corner.first.plane || plane == corner.second.plane || plane == corner.plane.plane)) {
    counts_.count(SignTier::kCombinatorial);
    return 0;
  }
  counts_.count(SignTier::kExact);
  return sgn(dot(exact_cross(corner.first, corner.second), exact_normal(plane)));
}

IntegerVector EyePlanes3::exact_cross(PlaneSide3 first, PlaneSide3 second) {
  const bool is_opposite = first.is_opposite != second.is_opposite;
  return is_opposite ? cross(exact_normal(second.plane), exact_normal(first.plane))
                     : cross(exact_normal(first.plane), exact_normal(second.plane));
}

ConeCorner3 EyePlanes3::corner(PlaneSide3 first, PlaneSide3 second) {
  ConeCorner3 result{cross(normals_[first.plane.index()], normals_[second.plane.index()]),
                     second,
                     shared_vertex(first.plane, second.plane),
                     false,
                     first,
                     second};
  if (first.is_opposite != second.is_opposite) negate(result.direction);
  if (result.vertex.is_none()) return result;
  // Both planes pass through the vertex: the direction is to it or away from it.
  const BoundedVector toward = eye_.toward(result.vertex);
  int sign = filtered_sign(result.direction, toward);
  if (sign == kUndecided) sign = sgn(dot(exact_cross(first, second), eye_.exact_toward(result.vertex)));
  result.direction = toward;
  result.is_antipode = sign < 0;
  if (result.is_antipode) negate(result.direction);
  return result;
}

IntegerVector EyePlanes3::exact_direction(const ConeCorner3& corner) {
  if (corner.vertex.is_none()) return primitive(exact_cross(corner.first, corner.second));
  const IntegerVector toward = primitive(eye_.exact_toward(corner.vertex));
  return corner.is_antipode ? IntegerVector{-toward.x, -toward.y, -toward.z} : toward;
}

const IntegerVector& EyePlanes3::exact_normal(PlaneId3 plane) {
  std::unique_ptr<IntegerVector>& kept = exact_normals_[plane.index()];
  if (!kept) {
    const EdgeId3 edge(plane.number());
    const Occluders3::Edge& ends = occluders_.edge(edge);
    kept = std::make_unique<IntegerVector>(
        cross(eye_.exact_toward(ends.from), eye_.sun() ? eye_.exact_toward(ends.to) : occluders_.exact_vector(edge)));
  }
  return *kept;
}

}  // namespace hottel

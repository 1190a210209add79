#include "geometry/space/moving/moving_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/moving/sight_corner.h"
#include "kernel/doubles.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

constexpr double kExactLimit = 0x1p53;

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

}  // namespace

MovingPlanes3::MovingPlanes3(const PairGeometry3& bodies) : bodies_(bodies) {
  add_lines();
  find_met_points();
  const auto count = static_cast<std::uint32_t>(bodies.bodies.size());
  first_face_ = static_cast<std::uint32_t>(planes_.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    Plane& plane = planes_.emplace_back();
    plane.kind = Kind::kFace;
    plane.a = k;
    plane.bodies[0] = k;
    plane.normal.first = bodies.bodies[k].normal;
    plane.normal.terms[0] = bodies.bodies[k].normal.size;
  }
  for (const PairGeometry3::Body& body : bodies.bodies) {
    std::vector<PlaneSide3>& sides = sides_.emplace_back();
    for (std::size_t c = 0; c < body.corners.size(); ++c)
      sides.push_back(line(body.corners[c], body.corners[(c + 1) % body.corners.size()]));
  }
  first_crossing_ = static_cast<std::uint32_t>(planes_.size());
  for (std::uint32_t k = 0; k < count; ++k)
    for (std::uint32_t patch = 0; patch < 2; ++patch) {
      Plane& plane = planes_.emplace_back();
      plane.kind = Kind::kCrossing;
      plane.a = k;
      plane.b = patch;
      plane.bodies = {k, patch};
    }
}

void MovingPlanes3::find_met_points() {
  for (const PairGeometry3::Body& body : bodies_.bodies)
    met_points_.insert(met_points_.end(), body.corners.begin(), body.corners.end());
  std::sort(met_points_.begin(), met_points_.end());
  met_points_.erase(std::unique(met_points_.begin(), met_points_.end()), met_points_.end());
}

void MovingPlanes3::add_lines() {
  const auto count = static_cast<std::uint32_t>(bodies_.bodies.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::vector<std::uint32_t>& corners = bodies_.bodies[k].corners;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto [a, b] = std::minmax(corners[c], corners[(c + 1) % corners.size()]);
      const auto [place, is_new] = line_numbers_.try_emplace(key_of(a, b), static_cast<std::uint32_t>(planes_.size()));
      if (!is_new) {
        planes_[place->second].bodies[1] = k;
        continue;
      }
      Plane& plane = planes_.emplace_back();
      plane.kind = Kind::kLine;
      plane.a = a;
      plane.b = b;
      plane.bodies[0] = k;
      const PairGeometry3::Point &p = bodies_.points[a], &q = bodies_.points[b];
      const double size = p.approximate_weight * q.approximate.size + q.approximate_weight * p.approximate.size;
      if (!p.is_far() && p.approximate.error == 0 && q.approximate.error == 0 && size <= kExactLimit) {
        const double v = p.approximate_weight, w = q.approximate_weight;
        BoundedVector& edge = plane.edge;
        edge = {v * q.approximate.x - w * p.approximate.x, v * q.approximate.y - w * p.approximate.y,
                v * q.approximate.z - w * p.approximate.z};
        edge.size = std::max({std::fabs(edge.x), std::fabs(edge.y), std::fabs(edge.z)});
      } else {
        const IntegerVector& exact = exact_edge(plane);
        plane.edge = rounded(exact, std::max(0L, bits(exact) - 53));
      }
    }
  }
}

void MovingPlanes3::take(const Stretch3& stretch) {
  stretch_ = &stretch;
  ++stretch_stamp_;
  known_zeros_.forget();
  in_face_.resize(bodies_.bodies.size());
  told_facings_.resize(bodies_.bodies.size());
  look_from(stretch);
  unit_of_moves_ = 0;
  toward_.resize(bodies_.points.size());
  exact_toward_.resize(bodies_.points.size());
  moves_.resize(bodies_.points.size());
}

void MovingPlanes3::look_from(const Stretch3& stretch) {
  const std::size_t count = bodies_.points.size();
  offsets_.resize(count);
  drifts_.resize(count);
  const bool fits =
      bits(stretch.from) <= 53 && bits(stretch.way) <= 53 && mpz_sizeinbase(stretch.weight.get_mpz_t(), 2) <= 53;
  largest_offset_ = largest_drift_ = 0;
  is_small_ = fits;
  if (fits) {
    const BoundedVector from = rounded(stretch.from, 0), way = rounded(stretch.way, 0);
    const double weight = truncated_double(stretch.weight);
    for (std::size_t k = 0; k < count && is_small_; ++k) {
      const PairGeometry3::Point& p = bodies_.points[k];
      if (p.is_far()) {
        offsets_[k] = p.approximate;
        drifts_[k] = {};
        continue;
      }
      const double w = p.approximate_weight;
      is_small_ = p.approximate.error == 0 && weight * p.approximate.size + w * from.size <= kExactLimit &&
                  w * way.size <= kExactLimit;
      BoundedVector &offset = offsets_[k], &drift = drifts_[k];
      offset = {weight * p.approximate.x - w * from.x, weight * p.approximate.y - w * from.y,
                weight * p.approximate.z - w * from.z};
      offset.size = std::max({std::fabs(offset.x), std::fabs(offset.y), std::fabs(offset.z)});
      drift = {w * way.x, w * way.y, w * way.z, w * way.size};
      largest_offset_ = std::max(largest_offset_, offset.size);
      largest_drift_ = std::max(largest_drift_, drift.size);
    }
    if (is_small_) return;
  }
  std::vector<IntegerVector> exact;
  exact.reserve(count);
  long top = 0;
  for (const PairGeometry3::Point& p : bodies_.points) {
    if (p.is_far()) {
      exact.emplace_back();
      continue;
    }
    exact.push_back(difference(multiple(stretch.weight, p.exact()), multiple(p.weight(), stretch.from)));
    top = std::max(top, bits(exact.back()) - p.spare);
  }
  const long shift = std::max(0L, top - 60);
  for (std::size_t k = 0; k < count; ++k) {
    const PairGeometry3::Point& p = bodies_.points[k];
    offsets_[k] = p.is_far() ? p.approximate : rounded(exact[k], shift + p.spare);
    drifts_[k] = rounded(multiple(p.weight(), stretch.way), shift + p.spare);
  }
}

void MovingPlanes3::move_to(double t, double left, double right) {
  left_ = left;
  right_ = right;
  is_unlucky_ = false;
  kept_signs_.clear();
  ++stamp_;
  t_ = t;
  split_double_3(t, mantissa_, places_);
  const double whole = truncated_double(mantissa_);
  const double scale = places_ <= 60 ? std::ldexp(1.0, static_cast<int>(places_)) : 0;
  const bool is_exact = is_small_ && scale > 0 && largest_offset_ * scale + whole * largest_drift_ <= kExactLimit;
  unit_ = is_exact ? scale : 1;
  const double of_offset = is_exact ? scale : 1, of_drift = is_exact ? whole : t;
  for (const std::uint32_t k : met_points_) {
    const BoundedVector &u = offsets_[k], &d = drifts_[k];
    BoundedVector& w = toward_[k];
    w = {of_offset * u.x - of_drift * d.x, of_offset * u.y - of_drift * d.y, of_offset * u.z - of_drift * d.z};
    w.size = std::max({std::fabs(w.x), std::fabs(w.y), std::fabs(w.z)});
    if (!is_exact)
      w.error = 1.001 * (u.error + t * d.error + 2 * kUnitRoundoff * (t * d.size + w.size)) + detail::kUnderflow;
  }
  if (unit_ == unit_of_moves_) return;
  unit_of_moves_ = unit_;
  for (const std::uint32_t k : met_points_) {
    const BoundedVector& d = drifts_[k];
    moves_[k] = {-unit_ * d.x, -unit_ * d.y, -unit_ * d.z};
  }
}

PlaneSide3 MovingPlanes3::line(std::uint32_t a, std::uint32_t b) const {
  return {PlaneId3(line_numbers_.at(key_of(a, b))), a > b};
}

// The determinant of corners in order is positive where the back is seen: then they are taken as they are. In the
// opposite cone all normals are turned.
void MovingPlanes3::cone_sides(std::uint32_t body, int facing, bool is_antipodal,
                               std::vector<PlaneSide3>& result) const {
  result.clear();
  for (std::uint32_t k = 0; k < sides_[body].size(); ++k) result.push_back(cone_side(body, k, facing, is_antipodal));
  if (facing > 0) std::reverse(result.begin(), result.end());
}

MovingPlanes3::Values MovingPlanes3::height(std::uint32_t body) {
  const PairGeometry3::Body& b = bodies_.bodies[body];
  const std::uint32_t anchor = b.corners.front();
  const BoundedValue product = dot(b.normal, toward_[anchor]);
  const double weight = bodies_.points[anchor].approximate_weight;
  return {product.value / weight, (product.error + 3 * kUnitRoundoff * std::fabs(product.value)) / weight};
}

const MovingVector3& MovingPlanes3::normal(PlaneId3 id) {
  Plane& plane = planes_[id.index()];
  if (plane.stamp == stamp_ || plane.kind == Kind::kFace) return plane.normal;
  plane.stamp = stamp_;
  if (plane.kind == Kind::kLine)
    find_line(plane);
  else
    find_crossing(plane);
  return plane.normal;
}

void MovingPlanes3::find_line(Plane& plane) {
  const BoundedVector& w = toward_[plane.a];
  plane.normal.first = cross(w, plane.edge);
  plane.normal.second = cross(moves_[plane.a], plain(plane.edge));
  const double slack = w.error / kUnitRoundoff;
  plane.normal.terms = {(w.size + slack) * plane.edge.size, size_of(moves_[plane.a]) * plane.edge.size, 0};
}

// With h the height of the planes over the point: m = s (h_k N_patch - h_patch N_k), s the sign of h_k.
void MovingPlanes3::find_crossing(Plane& plane) {
  const PairGeometry3::Body &k = bodies_.bodies[plane.a], &patch = bodies_.bodies[plane.b];
  Values hk = height(plane.a), hp = height(plane.b);
  const auto slope = [this](const PairGeometry3::Body& body) {
    const std::uint32_t anchor = body.corners.front();
    return dot(plain(body.normal), moves_[anchor]) / bodies_.points[anchor].approximate_weight;
  };
  double k_slope = slope(k), p_slope = slope(patch);
  int sign = hk.value > hk.error ? 1 : hk.value < -hk.error ? -1 : sgn(exact_height(plane.a));
  if (sign < 0) {
    hk.value = -hk.value;
    hp.value = -hp.value;
    k_slope = -k_slope;
    p_slope = -p_slope;
  }
  const BoundedVector &n = k.normal, &m = patch.normal;
  BoundedVector& first = plane.normal.first;
  first = {hk.value * m.x - hp.value * n.x, hk.value * m.y - hp.value * n.y, hk.value * m.z - hp.value * n.z};
  first.size = std::max({std::fabs(first.x), std::fabs(first.y), std::fabs(first.z)});
  const double a = std::fabs(hk.value), b = std::fabs(hp.value);
  const double sizes = a * m.size + b * n.size;
  first.error = 1.01 * (4 * kUnitRoundoff * sizes + hk.error * (m.size + m.error) + a * m.error +
                        hp.error * (n.size + n.error) + b * n.error) +
                detail::kUnderflow;
  plane.normal.second = k_slope * plain(m) - p_slope * plain(n);
  const auto slope_size = [this](const PairGeometry3::Body& body) {
    const std::uint32_t anchor = body.corners.front();
    return 3 * body.normal.size * size_of(moves_[anchor]) / bodies_.points[anchor].approximate_weight;
  };
  plane.normal.terms = {sizes + first.error / kUnitRoundoff, slope_size(k) * m.size + slope_size(patch) * n.size, 0};
}

bool MovingPlanes3::passes_through(const Plane& plane, std::uint32_t point) const {
  if (plane.kind == Kind::kLine) return plane.a == point || plane.b == point;
  if (plane.kind != Kind::kFace) return false;
  const std::vector<std::uint32_t>& corners = bodies_.bodies[plane.a].corners;
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

std::uint32_t MovingPlanes3::shared_point(PlaneId3 a, PlaneId3 b) const {
  const Plane &p = planes_[a.index()], &q = planes_[b.index()];
  const Plane &line = p.kind == Kind::kLine ? p : q, &other = p.kind == Kind::kLine ? q : p;
  if (line.kind != Kind::kLine) return MovingCorner3::kNoPoint;
  if (passes_through(other, line.a)) return line.a;
  if (passes_through(other, line.b)) return line.b;
  return MovingCorner3::kNoPoint;
}

MovingCorner3 MovingPlanes3::corner_at(std::uint32_t point, bool is_antipode, PlaneSide3 plane) const {
  MovingCorner3 result;
  const BoundedVector& w = toward_[point];
  result.direction = {w, moves_[point], {}, {w.size + w.error / kUnitRoundoff, size_of(moves_[point]), 0}};
  if (is_antipode) result.direction = opposite(result.direction);
  result.plane = plane;
  result.point = point;
  result.is_antipode = is_antipode;
  return result;
}

MovingCorner3 MovingPlanes3::corner(PlaneSide3 first, PlaneSide3 second) {
  const MovingVector3 &a = normal(first.plane), &b = normal(second.plane);
  const bool is_turned = first.is_opposite != second.is_opposite;
  const std::uint32_t shared = shared_point(first.plane, second.plane);
  if (shared != MovingCorner3::kNoPoint) {
    // Both planes pass through the point: the direction is to it or away from it.
    int sign = filtered_sign(cross(a.first, b.first), toward_[shared]);
    if (sign == kUndecided)
      sign = determinant_sign(exact_normal(first.plane), exact_normal(second.plane), exact_toward(shared));
    return corner_at(shared, (sign < 0) != is_turned, second);
  }
  MovingCorner3 result;
  result.plane = second;
  result.first = first;
  result.second = second;
  MovingVector3& d = result.direction;
  const Direction3 a0 = plain(a.first), b0 = plain(b.first);
  d.first = cross(a.first, b.first);
  d.second = cross(a.second, b0) + cross(a0, b.second);
  d.third = cross(a.second, b.second);
  d.terms = {2 * a.terms[0] * b.terms[0], 2 * (a.terms[1] * b.terms[0] + a.terms[0] * b.terms[1]),
             2 * a.terms[1] * b.terms[1]};
  if (is_turned) d = opposite(d);
  return result;
}

bool MovingPlanes3::is_about_one_body(const MovingCorner3& corner, PlaneId3 plane) const {
  if (corner.point != MovingCorner3::kNoPoint) return false;
  const auto has = [this](PlaneId3 id, std::uint32_t body) {
    return planes_[id.index()].bodies[0] == body || planes_[id.index()].bodies[1] == body;
  };
  for (const std::uint32_t body : planes_[plane.index()].bodies)
    if (body != kNoBody && has(corner.first.plane, body) && has(corner.second.plane, body)) return true;
  return false;
}

bool MovingPlanes3::is_zero_by_identity(const MovingCorner3& corner, PlaneId3 plane) const {
  if (corner.point != MovingCorner3::kNoPoint) return passes_through(planes_[plane.index()], corner.point);
  const auto is_same = [&](PlaneId3 other) { return other == plane || is_one_face(other, plane); };
  return is_same(corner.first.plane) || is_same(corner.second.plane) || corner.plane.plane == plane;
}

// True iff one is the plane of a face, in which the point is, and the other one goes through an edge of that face.
bool MovingPlanes3::is_one_face(PlaneId3 a, PlaneId3 b) const {
  const Plane &p = planes_[a.index()], &q = planes_[b.index()];
  const Plane &face = p.kind == Kind::kFace ? p : q, &line = p.kind == Kind::kFace ? q : p;
  return face.kind == Kind::kFace && line.kind == Kind::kLine && (line.bodies[0] == face.a || line.bodies[1] == face.a);
}

int MovingPlanes3::settled_sign(const MovingCorner3& corner, PlaneId3 plane) {
  if (is_zero_by_identity(corner, plane) || known_zeros_.has(corner, plane)) {
    counts_.count(SignTier::kCombinatorial);
    return 0;
  }
  counts_.count(SignTier::kExact);
  if (std::array<WideSum, 3> powers; sum_whole(corner, plane, powers)) return powers[0].sign();
  return dot_sign(exact_first(corner), exact_normal(plane));
}

void MovingPlanes3::tell(PlaneId3 plane, SightCorner3& corner) const {
  const Plane& told = planes_[plane.index()];
  if (told.kind == Kind::kLine) {
    corner.edges.push_back({told.a, told.b});
    return;
  }
  corner.bodies.push_back(told.a);
  if (told.kind == Kind::kCrossing) corner.bodies.push_back(told.b);
}

}  // namespace hottel

// Signs beside planes, and how far those that were relied on keep (MovingPlanes3).
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/space/moving/moving_planes.h"
#include "kernel/doubles.h"

namespace hottel {
namespace {

// Roots are told to this part of the stretch: those at which what is seen may jump, and others.
constexpr double kJumpError = 0x1p-50;
constexpr double kRootError = 0x1p-46;

}  // namespace

inline bool MovingPlanes3::is_far_from_zero(const std::array<double, 3>& c, const std::array<double, 3>& e) {
  const double reach = std::max(left_, right_);
  ++relied_;
  return std::fabs(c[0]) - e[0] > (std::fabs(c[1]) + e[1]) * reach + (std::fabs(c[2]) + e[2]) * reach * reach;
}

int MovingPlanes3::facing(std::uint32_t body) {
  if (bodies_.is_far(body)) return 1;
  if (in_face_[body] == stretch_stamp_) return 0;
  ToldFacing& told = told_facings_[body];
  // Relied on again it narrows nothing. Where signs are kept each is as often as it was asked for.
  if (told.stamp == stamp_ && !keeps_signs_) {
    counts_.count(told.tier);
    ++relied_;
    return told.facing;
  }
  const PairGeometry3::Body& b = bodies_.bodies[body];
  const std::uint32_t anchor = b.corners.front();
  const BoundedVector& w = toward_[anchor];
  const BoundedValue product = dot(b.normal, w);
  int sign = sign_of(product);
  const SignTier tier = sign == kUndecided ? SignTier::kExact : SignTier::kFilter;
  counts_.count(tier);
  if (sign == kUndecided) sign = sgn(exact_height(body));
  const auto exact = [&] {
    return std::array<Integer, 3>{exact_height(body), dot(b.exact_normal(), exact_drift(anchor)), 0};
  };
  if (sign == 0) {
    if (exact()[1] == 0)
      in_face_[body] = stretch_stamp_;
    else
      is_unlucky_ = true;
    return 0;
  }
  const double slope = dot(plain(b.normal), moves_[anchor]);
  const double slope_error = 16 * kUnitRoundoff * b.normal.size * size_of(moves_[anchor]) + detail::kUnderflow;
  const std::array<double, 3> c{product.value, slope, 0}, e{product.error, slope_error, 0};
  if (keeps_signs_) keep(body, {c, e}, sign);
  if (!is_far_from_zero(c, e) && !narrow(c, e, sign, kJumpError)) narrow_exactly(exact(), sign);
  told = {stamp_, -sign, tier};
  return -sign;
}

// For a sign that is zero at t: the other coefficients of its polynomial are zero too.
bool MovingPlanes3::is_zero_for_every_t(const MovingCorner3& corner, PlaneId3 plane) {
  if (known_zeros_.has(corner, plane)) return true;
  counts_.count(SignTier::kExact);
  const std::array<Integer, 3>& c = exact_determinant(corner, plane);
  if (c[1] != 0 || c[2] != 0) return false;
  known_zeros_.add(corner, plane);
  return true;
}

int MovingPlanes3::sign(std::uint32_t point, PlaneId3 plane, const BoundedVector& normal) {
  const int result = filtered_sign(toward_[point], normal);
  if (result != kUndecided) {
    counts_.count(SignTier::kFilter);
    return result;
  }
  if (passes_through(planes_[plane.index()], point) || known_zeros_.has(point, plane)) {
    counts_.count(SignTier::kCombinatorial);
    return 0;
  }
  counts_.count(SignTier::kExact);
  return dot_sign(exact_toward(point), exact_normal(plane));
}

bool MovingPlanes3::is_any_positive(std::span<const std::uint32_t> points, PlaneSide3 side) {
  const BoundedVector& m = normal(side.plane).first;
  const int positive = side.is_opposite ? -1 : 1;
  return std::any_of(points.begin(), points.end(),
                     [&](std::uint32_t point) { return sign(point, side.plane, m) == positive; });
}

inline MovingPlanes3::Beside MovingPlanes3::beside(const MovingCorner3& corner, PlaneId3 plane,
                                                   const MovingVector3& m) {
  const BoundedValue value = dot(corner.direction.first, m.first);
  const int sign = sign_of(value);
  if (sign == kUndecided) return {value, settled_sign(corner, plane)};
  counts_.count(SignTier::kFilter);
  return {value, sign};
}

void MovingPlanes3::find_signs(std::span<const MovingCorner3> corners, PlaneSide3 side,
                               std::vector<signed char>& signs) {
  const MovingVector3& m = normal(side.plane);
  signs.resize(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [value, sign] = beside(corners[k], side.plane, m);
    rely(corners[k], side.plane, m, value, sign);
    signs[k] = static_cast<signed char>(side.is_opposite ? -sign : sign);
  }
}

bool MovingPlanes3::rely_if_none_is_positive(std::span<const MovingCorner3> corners, PlaneSide3 side) {
  const MovingVector3& m = normal(side.plane);
  const int positive = side.is_opposite ? -1 : 1;
  beside_.clear();
  for (const MovingCorner3& corner : corners) {
    beside_.push_back(beside(corner, side.plane, m));
    if (beside_.back().sign == positive) return false;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) rely(corners[k], side.plane, m, beside_[k].value, beside_[k].sign);
  return true;
}

bool MovingPlanes3::rely_if_none_is_positive(std::span<const std::uint32_t> points, PlaneSide3 side) {
  if (is_any_positive(points, side)) return false;
  rely(points, side);
  return true;
}

void MovingPlanes3::rely(std::span<const std::uint32_t> points, PlaneSide3 side) {
  const MovingVector3& m = normal(side.plane);
  for (const std::uint32_t point : points) {
    const BoundedVector& w = toward_[point];
    const BoundedValue value = dot(w, m.first);
    if (!keeps_signs_ && is_point_far(point, m, value)) {
      counts_.count(SignTier::kFilter);
      continue;
    }
    rely(corner_at(point, false, side), side.plane, m, value, sign(point, side.plane, m.first));
  }
}

// is_far_from_zero() of a point beside a plane.
inline bool MovingPlanes3::is_point_far(std::uint32_t point, const MovingVector3& m, BoundedValue value) {
  const BoundedVector& w = toward_[point];
  const Direction3& move = moves_[point];
  const double slope = dot(move, plain(m.first)) + dot(plain(w), m.second);
  const double slope_error = 32 * kUnitRoundoff * (unit_ * drifts_[point].size) * m.terms[0] +
                             32 * kUnitRoundoff * (w.size + w.error / kUnitRoundoff) * m.terms[1] + detail::kUnderflow;
  return is_far_from_zero({value.value, slope, 0}, {value.error, slope_error, 0});
}

// The polynomial of a corner beside a plane, with what it may be off.
inline MovingPlanes3::Quadratic MovingPlanes3::quadratic(const MovingCorner3& corner, const MovingVector3& m,
                                                         BoundedValue value) {
  const MovingVector3& v = corner.direction;
  const Direction3 v0 = plain(v.first), m0 = plain(m.first);
  const auto bound = [&](int a, int b) { return 32 * kUnitRoundoff * v.terms[a] * m.terms[b] + detail::kUnderflow; };
  Quadratic result{{value.value, dot(v.second, m0) + dot(v0, m.second), 0},
                   {value.error, bound(1, 0) + bound(0, 1), 0}};
  if (corner.point == MovingCorner3::kNoPoint) {
    result.c[2] = dot(v.third, m0) + dot(v.second, m.second);
    result.e[2] = bound(2, 0) + bound(1, 1);
  }
  return result;
}

inline void MovingPlanes3::rely(const MovingCorner3& corner, PlaneId3 plane, const MovingVector3& m, BoundedValue value,
                                int sign) {
  const Quadratic near = quadratic(corner, m, value);
  if (keeps_signs_) keep(corner, plane, near, sign);
  if (!is_far_from_zero(near.c, near.e)) rely_closely(corner, plane, near, sign);
}

// Where there may be a root.
void MovingPlanes3::rely_closely(const MovingCorner3& corner, PlaneId3 plane, const Quadratic& near, int sign) {
  const auto& [c, e] = near;
  const bool is_linear = corner.point != MovingCorner3::kNoPoint;
  if (is_zero_by_identity(corner, plane) || is_about_one_body(corner, plane)) return;
  if (sign == 0) {
    if (is_unlucky_) return;
    is_unlucky_ = std::fabs(c[1]) > e[1] || std::fabs(c[2]) > e[2];
    if (!is_unlucky_) is_unlucky_ = !is_zero_for_every_t(corner, plane);
    return;
  }
  if (!narrow(c, e, sign, kRootError) && (is_linear || !rely_on_factors(corner, plane)))
    narrow_exactly(exact_determinant(corner, plane), sign);
}

// With n_a, n_b for the normals of lines, v for their common end, c for the other end of b: n_a x n_b = v (n_a . c), or
// the opposite.
std::optional<MovingPlanes3::Factors> MovingPlanes3::factors(PlaneId3 a, PlaneId3 b, PlaneId3 c) const {
  const std::array<PlaneId3, 3> ids{a, b, c};
  for (std::size_t k = 0; k < 3; ++k) {
    const PlaneId3 first = ids[k], second = ids[(k + 1) % 3], third = ids[(k + 2) % 3];
    const Plane& line = planes_[second.index()];
    if (planes_[first.index()].kind != Kind::kLine || line.kind != Kind::kLine) continue;
    const std::uint32_t common = shared_point(first, second);
    if (common != MovingCorner3::kNoPoint) return Factors{{third, first}, {common, line.a == common ? line.b : line.a}};
  }
  return {};
}

// False where there are none.
bool MovingPlanes3::rely_on_factors(const MovingCorner3& corner, PlaneId3 plane) {
  const std::optional<Factors> f = factors(corner.first.plane, corner.second.plane, plane);
  if (!f) return false;
  for (const std::size_t k : {0U, 1U}) {
    const MovingVector3& m = normal(f->plane[k]);
    const MovingCorner3 at = corner_at(f->point[k], false, {});
    rely(at, f->plane[k], m, dot(at.direction.first, m.first), this->sign(f->point[k], f->plane[k], m.first));
  }
  return true;
}

// The polynomial whose sign is relied on, in integers.
const std::array<Integer, 3>& MovingPlanes3::exact_determinant(const MovingCorner3& corner, PlaneId3 plane) {
  if (std::array<WideSum, 3> powers; sum_whole(corner, plane, powers)) {
    for (std::size_t k = 0; k < 3; ++k) powers[k].set(determinant_[k]);
    return determinant_;
  }
  const auto& d = exact_direction(corner).powers;
  const IntegerVector &n = exact_normal(plane), &n1 = exact_turn(plane);
  const auto add = [](Integer& sum, const IntegerVector& a, const IntegerVector& b) {
    mpz_addmul(sum.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
  };
  for (std::size_t k = 0; k < 3; ++k) {
    determinant_[k] = 0;
    add(determinant_[k], d[k], n);
    if (k > 0) add(determinant_[k], d[k - 1], n1);
  }
  return determinant_;
}

bool MovingPlanes3::narrow(const std::array<double, 3>& c, const std::array<double, 3>& e, int sign, double accuracy) {
  const double turn = sign;
  const double c0 = turn * c[0], c1 = turn * c[1], c2 = turn * c[2];
  const double square = c1 * c1 - 4 * c0 * c2;
  const double square_error = 2 * std::fabs(c1) * e[1] + e[1] * e[1] +
                              4 * (std::fabs(c0) * e[2] + std::fabs(c2) * e[0] + e[0] * e[2]) +
                              8 * kUnitRoundoff * (c1 * c1 + 4 * std::fabs(c0 * c2));
  if (square < -square_error) return true;
  // Far enough from a double root roots move by what the polynomial may be off there, over its slope, `root`.
  if (!(c0 > e[0]) || !(square > 4 * square_error)) return false;
  const double root = std::sqrt(square);
  const double q = -(c1 + std::copysign(root, c1)) / 2, q_error = e[1] / 2 + square_error / root;
  const double near = c0 / q, far = q / c2;
  const auto error_of = [&](double r) { return e[0] + std::fabs(r) * (e[1] + std::fabs(r) * e[2]); };
  const auto is_settled = [&](double r) {
    const double error = 2 * error_of(r) / root + 8 * kUnitRoundoff * std::fabs(r);
    return error_of(r) <= accuracy * root || r - error >= right_ || r + error <= -left_;
  };
  const bool is_far = std::fabs(q) - q_error > 1.001 * std::max(left_, right_) * (std::fabs(c2) + e[2]);
  if (!is_settled(near) || !(is_far || is_settled(far))) return false;
  take_root(near);
  if (!is_far) take_root(far);
  return true;
}

void MovingPlanes3::narrow_exactly(const std::array<Integer, 3>& c, int sign) {
  counts_.count(SignTier::kExact);
  thread_local Integer square, product;
  mpz_mul(square.get_mpz_t(), c[1].get_mpz_t(), c[1].get_mpz_t());
  mpz_mul(product.get_mpz_t(), c[0].get_mpz_t(), c[2].get_mpz_t());
  mpz_mul_2exp(product.get_mpz_t(), product.get_mpz_t(), 2);
  square -= product;
  if (sgn(square) <= 0) return;
  // Doubles suffice from here: nothing cancels. Exponents are kept apart, for these numbers may be long.
  long e0, e1, e2, e3;
  const double d0 = sign * mpz_get_d_2exp(&e0, c[0].get_mpz_t()), d1 = sign * mpz_get_d_2exp(&e1, c[1].get_mpz_t()),
               d2 = sign * mpz_get_d_2exp(&e2, c[2].get_mpz_t());
  double d3 = mpz_get_d_2exp(&e3, square.get_mpz_t());
  if (e3 % 2 != 0) {
    d3 *= 2;
    --e3;
  }
  e3 /= 2;
  const long top = d1 == 0 ? e3 : std::max(e1, e3);
  const double linear = d1 == 0 ? 0 : ldexp_3(d1, e1 - top), root = ldexp_3(std::sqrt(d3), e3 - top);
  const double q = -(linear + std::copysign(root, linear)) / 2;
  take_root(ldexp_3(d0 / q, e0 - top));
  if (d2 != 0) take_root(ldexp_3(q / d2, top - e2));
}

// A root that rounding alone may keep from the one that is known, or from the end of the stretch, is that.
void MovingPlanes3::take_root(double root) {
  constexpr double kLeast = std::numeric_limits<double>::min(), kSame = 1 - 0x1p-51;
  if (root > 0 && root < kSame * right_) right_ = std::max(root, kLeast);
  if (root < 0 && -root < kSame * left_) left_ = std::max(-root, kLeast);
}

}  // namespace hottel

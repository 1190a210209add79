// Proofs that signs which were relied on keep (MovingPlanes3).
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/space/moving/kept_sign.h"
#include "geometry/space/moving/moving_planes.h"
#include "kernel/doubles.h"

namespace hottel {
namespace {

// Errors of coefficients are taken as so many times what roots are told by: products of sums of products of three
// numbers, each off by some units, come to 135 units of their sizes at most, where 32 are taken.
constexpr double kErrors = 5;
// An interval is that much shorter than the way to the roots: first, and where that was not enough, as roots of
// integers are told nearly to the last digit.
constexpr double kShrunk[] = {1 - 0x1p-49, 1 - 0x1p-46, 1 - 0x1p-40};

// c[0] + c[1] s + c[2] s^2, off by no more than the second.
std::pair<double, double> value_at(const std::array<double, 3>& c, const std::array<double, 3>& e, double s) {
  const double size = std::fabs(s);
  return {c[0] + s * (c[1] + s * c[2]),
          1.01 * kErrors * (e[0] + size * (e[1] + size * e[2])) +
              8 * kUnitRoundoff * (std::fabs(c[0]) + size * (std::fabs(c[1]) + size * std::fabs(c[2])))};
}

}  // namespace

// A polynomial of degree 2 has the sign of its values at both ends of an interval all along it where in the form of
// Bernstein, q0 (1 - x)^2 + 2 b x (1 - x) + q1 x^2, b has that sign too, or is zero, or b^2 < q0 q1.
bool keeps_sign_3(const std::array<double, 3>& c, const std::array<double, 3>& e, int sign, double left, double right) {
  const auto [low, low_error] = value_at(c, e, -left);
  const auto [high, high_error] = value_at(c, e, right);
  const double q0 = sign * low - low_error, q1 = sign * high - high_error;
  if (!(q0 > 0 && q1 > 0)) return false;
  const double reach = std::max(left, right);
  const double b = sign * (c[0] + c[1] * ((right - left) / 2) - c[2] * left * right);
  const double error = 2 * value_at(c, e, reach).second;
  if (b - error >= 0) return true;
  const double most = std::fabs(b) + error;
  return most * most * (1 + 0x1p-40) < q0 * q1;
}

// The same of integers, at numbers that doubles are. Where there is no root, or a double one, the sign is the same on
// both sides of it. A line has the sign of its values at both ends.
bool keeps_sign_3(const std::array<Integer, 3>& c, int sign, double left, double right) {
  const bool is_line = sgn(c[2]) == 0;
  if (is_line ? sgn(c[1]) == 0 : c[1] * c[1] <= 4 * c[0] * c[2]) return true;
  Integer l, r;
  unsigned places_of_left, places_of_right;
  split_double_3(left, l, places_of_left);
  split_double_3(right, r, places_of_right);
  const unsigned places = std::max(places_of_left, places_of_right);
  l <<= places - places_of_left;
  r <<= places - places_of_right;
  if (is_line) {
    const Integer c0 = c[0] << places;
    return sgn(c0 - l * c[1]) * sign > 0 && sgn(c0 + r * c[1]) * sign > 0;
  }
  // All times 4^places.
  const Integer c0 = sign * (c[0] << 2 * places), c1 = sign * (c[1] << places), c2 = sign * c[2];
  const Integer q0 = c0 - l * (c1 - l * c2), q1 = c0 + r * (c1 + r * c2);
  if (sgn(q0) <= 0 || sgn(q1) <= 0) return false;
  const Integer twice_b = 2 * c0 + c1 * (r - l) - 2 * c2 * l * r;
  return sgn(twice_b) >= 0 || twice_b * twice_b < 4 * q0 * q1;
}

bool MovingPlanes3::is_surely_far_from_zero(const Quadratic& near) const {
  const auto& [c, e] = near;
  const double reach = std::max(left_, right_);
  const double others = (std::fabs(c[1]) + kErrors * e[1]) * reach + (std::fabs(c[2]) + kErrors * e[2]) * reach * reach;
  return std::fabs(c[0]) - kErrors * e[0] > others * (1 + 0x1p-40);
}

void MovingPlanes3::keep(const MovingCorner3& corner, PlaneId3 plane, const Quadratic& near, int sign) {
  if (sign == 0 || is_surely_far_from_zero(near)) return;  // zeros are such for all t
  if (is_zero_by_identity(corner, plane) || is_about_one_body(corner, plane)) return;
  kept_signs_.push_back({corner, plane, kNoBody, near, sign});
}

void MovingPlanes3::keep(std::uint32_t body, const Quadratic& near, int sign) {
  if (!is_surely_far_from_zero(near)) kept_signs_.push_back({{}, PlaneId3(0), body, near, sign});
}

std::array<Integer, 3> MovingPlanes3::exact_powers(const KeptSign& kept) {
  if (kept.body == kNoBody) return exact_determinant(kept.corner, kept.plane);
  const PairGeometry3::Body& b = bodies_.bodies[kept.body];
  return {exact_height(kept.body), dot(b.exact_normal(), exact_drift(b.corners.front())), 0};
}

// Shortens the interval where it holds a root, to just before it.
bool MovingPlanes3::proves(const KeptSign& kept, double& left, double& right) {
  if (keeps_sign_3(kept.near.c, kept.near.e, kept.sign, left, right)) return true;
  const std::array<Integer, 3> exact = exact_powers(kept);
  if (sgn(exact[0]) != kept.sign) return false;
  const double known_left = std::exchange(left_, left), known_right = std::exchange(right_, right);
  narrow_exactly(exact, kept.sign);
  const double to_left = std::exchange(left_, known_left), to_right = std::exchange(right_, known_right);
  for (const double shrunk : kShrunk) {
    left = std::min(left, to_left * shrunk);
    right = std::min(right, to_right * shrunk);
    if (keeps_sign_3(exact, kept.sign, left, right)) return true;
  }
  return false;
}

std::optional<MovingPlanes3::ProvenInterval> MovingPlanes3::prove_signs(double left, double right) {
  left *= kShrunk[0];
  right *= kShrunk[0];
  for (const KeptSign& kept : kept_signs_)
    if (!proves(kept, left, right)) return {};
  // No further than that, as doubles: t itself where a root is nearer than the next one.
  return ProvenInterval{std::min(std::nextafter(t_ - left, 2.0), t_), std::max(std::nextafter(t_ + right, -1.0), t_)};
}

}  // namespace hottel

#include "geometry/space/visibility/direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/space/point.h"
#include "kernel/plain_functions.h"

namespace hottel {

Direction3 unit_of_3(const Vector3& v) {
  const Rational largest = std::max({Rational(abs(v.x)), Rational(abs(v.y)), Rational(abs(v.z))});
  return unit({to_double(v.x / largest), to_double(v.y / largest), to_double(v.z / largest)});
}

bool has_opposite_corners_3(std::span<const Direction3> corners) {
  constexpr double kNarrow = 0.7072, kOpposite = -0.99;
  const auto is_near_first = [&](const Direction3& corner) { return dot(corner, corners[0]) > kNarrow; };
  if (std::all_of(corners.begin() + 1, corners.end(), is_near_first)) return false;
  for (std::size_t a = 1; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (dot(corners[a], corners[b]) < kOpposite) return true;
  return false;
}

double solid_angle_fraction_3(std::span<const Direction3> corners) {
  double half_angle = 0;
  const Direction3& a = corners[0];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Direction3 &b = corners[k], &c = corners[k + 1];
    const double volume = dot(a, cross(b - a, c - a)), rest = 1 + dot(a, b) + dot(b, c) + dot(c, a);
    // Of nearly a half space rounding may have turned the volume, which is not negative.
    half_angle += same_bits::atan2(rest < 0 ? std::max(volume, 0.0) : volume, rest);
  }
  return half_angle / (2 * std::numbers::pi);
}

// What is left of a full turn by the angles between neighbouring planes.
double solid_angle_fraction_by_normals_3(std::span<const Direction3> inward) {
  double angle = 2 * std::numbers::pi;
  for (std::size_t k = 0; k < inward.size(); ++k) {
    const Direction3 &a = inward[k], &b = inward[k + 1 == inward.size() ? 0 : k + 1];
    angle -= same_bits::atan2(length(cross(a, b)), dot(a, b));
  }
  return std::max(angle, 0.0) / (4 * std::numbers::pi);
}

double view_factor_3(std::span<const Direction3> corners, const Direction3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
    const Direction3 turn = cross(a, b - a);
    const double sine = length(turn);
    if (sine > 0) sum += same_bits::atan2(sine, dot(a, b)) / sine * dot(turn, normal);
  }
  return sum / (2 * std::numbers::pi);
}

double view_factor_by_normals_3(std::span<const Direction3> corners, std::span<const Direction3> inward,
                                const Direction3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
    sum += same_bits::atan2(length(cross(a, b - a)), dot(a, b)) * dot(inward[k], normal);
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace hottel

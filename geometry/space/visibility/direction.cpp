#include "geometry/space/visibility/direction.h"

#include <cmath>
#include <numbers>

namespace hottel {

double solid_angle_fraction_3(std::span<const Direction3> corners) {
  double half_angle = 0;
  const Direction3& a = corners[0];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Direction3 &b = corners[k], &c = corners[k + 1];
    const double volume = dot(a, cross(b - a, c - a));
    half_angle += std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
  }
  return half_angle / (2 * std::numbers::pi);
}

double view_factor_3(std::span<const Direction3> corners, const Direction3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
    const Direction3 turn = cross(a, b - a);
    const double sine = length(turn);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) / sine * dot(turn, normal);
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace hottel

#include "geometry/space/visibility/direction.h"

#include <cmath>
#include <numbers>

namespace hottel {
namespace {

Direction3 minus(const Direction3& a, const Direction3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

double dot(const Direction3& a, const Direction3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Direction3 cross(const Direction3& a, const Direction3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

double solid_angle_fraction_3(std::span<const Direction3> corners) {
  double half_angle = 0;
  const Direction3& a = corners[0];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Direction3 &b = corners[k], &c = corners[k + 1];
    const double volume = dot(a, cross(minus(b, a), minus(c, a)));
    half_angle += std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
  }
  return half_angle / (2 * std::numbers::pi);
}

double view_factor_3(std::span<const Direction3> corners, const Direction3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
    const Direction3 turn = cross(a, minus(b, a));
    const double sine = std::sqrt(dot(turn, turn));
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) / sine * dot(turn, normal);
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace hottel

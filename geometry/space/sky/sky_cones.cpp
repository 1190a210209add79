#include "geometry/space/sky/sky_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/space/visibility/direction.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr std::size_t kAround = 8;
// Directions are integers of about this length.
constexpr double kLength = 256;
// Heights over the horizon, as sines: below it, and where the upper cones begin.
constexpr double kBelow = -0.05, kUpper = 0.6;
// The cosine and the sine of where the first one begins: at right angles to nothing that scenes are made of.
constexpr double kCosine = 0.95533648912560598, kSine = 0.29552020666133960;

// What the view factor of a cone in doubles is off by, at most: six arcs, each by some units of the last place.
constexpr double kOfFactor = 0x1p-47;

Direction3 in_doubles(const IntegerVector& v) {
  const BoundedVector rough = rounded(v, std::max(0L, bits(v) - 53));
  return unit({rough.x, rough.y, rough.z});
}

IntegerVector rounded_direction(const Direction3& d) {
  const auto whole = [](double value) { return exact_integer(std::nearbyint(kLength * value)); };
  return {whole(d.x), whole(d.y), whole(d.z)};
}

// Seen from within, counter-clockwise.
Patch3 cone_of(std::vector<IntegerVector> corners) {
  if (determinant_sign(corners[0], corners[1], corners[2]) > 0) std::reverse(corners.begin(), corners.end());
  return {Patch3::kSky, std::move(corners), 0};
}

// The part of a cone above the horizon.
std::vector<Direction3> above(const std::vector<Direction3>& cone, const Direction3& normal) {
  std::vector<Direction3> result;
  for (std::size_t k = 0; k < cone.size(); ++k) {
    const Direction3 &a = cone[k], &b = cone[(k + 1) % cone.size()];
    const double at_a = dot(normal, a), at_b = dot(normal, b);
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) != (at_b < 0)) result.push_back(unit(a + (at_a / (at_a - at_b)) * (b - a)));
  }
  return result;
}

// Lambert's sum over arcs. An arc that is short has a normal that is told badly, but not times its angle.
double view_factor(const std::vector<Direction3>& cone, const Direction3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < cone.size(); ++k) {
    const Direction3 &a = cone[k], &b = cone[(k + 1) % cone.size()];
    const Direction3 across = cross(a, b);
    const double sine = length(across);
    if (sine > 0) sum += same_bits::atan2(sine, dot(a, b)) / sine * dot(normal, across);
  }
  return std::fabs(sum) / (2 * std::numbers::pi);
}

}  // namespace

std::vector<Patch3> sky_cones(const Patch3& patch) {
  const IntegerVector exact = primitive(normal_of(patch));
  const Direction3 up = in_doubles(exact);
  const double x = std::fabs(up.x), y = std::fabs(up.y), z = std::fabs(up.z);
  const Direction3 axis = x <= y && x <= z ? Direction3{1, 0, 0} : y <= z ? Direction3{0, 1, 0} : Direction3{0, 0, 1};
  const Direction3 u = unit(cross(axis, up)), v = cross(up, u);
  std::array<IntegerVector, kAround> low, high;
  double cosine = kCosine, sine = kSine;
  for (std::size_t k = 0; k < kAround; ++k) {
    const Direction3 along = cosine * u + sine * v;
    const auto at_height = [&](double height) {
      return rounded_direction(std::sqrt(1 - height * height) * along + height * up);
    };
    low[k] = at_height(kBelow);
    high[k] = at_height(kUpper);
    const double next = (cosine - sine) * std::numbers::sqrt2 / 2;  // an eighth of a turn on
    sine = (cosine + sine) * std::numbers::sqrt2 / 2;
    cosine = next;
  }
  const IntegerVector top = rounded_direction(up);
  std::vector<Patch3> cones;
  for (std::size_t k = 0; k < kAround; ++k) {
    const std::size_t next = (k + 1) % kAround;
    cones.push_back(cone_of({low[k], high[k], high[next], low[next]}));
  }
  for (std::size_t k = 0; k < kAround; k += 2)
    cones.push_back(cone_of({top, high[k], high[k + 1], high[(k + 2) % kAround]}));
  return cones;
}

UnobstructedMeasure3 unobstructed_sky(const Vertices3& vertices, const Patch3& patch, const Patch3& cone) {
  const IntegerVector exact = normal_of(patch);
  const bool is_before = std::any_of(cone.corners.begin(), cone.corners.end(),
                                     [&](const IntegerVector& corner) { return dot_sign(exact, corner) > 0; });
  if (!is_before) return {};
  std::vector<Direction3> corners;
  for (const IntegerVector& corner : cone.corners) corners.push_back(in_doubles(corner));
  const Direction3 normal = in_doubles(exact);
  const double factor = view_factor(above(corners, normal), normal);
  const Enclosure area = patch_area(vertices, patch);
  UnobstructedMeasure3 result;
  result.measure = factor * area.lower;
  result.error = 2 * kOfFactor * area.upper;
  result.bounds = {std::max(0.0, (factor - 2 * kOfFactor) * area.lower),
                   std::min(area.upper, (factor + 2 * kOfFactor) * area.upper)};
  return result;
}

}  // namespace hottel

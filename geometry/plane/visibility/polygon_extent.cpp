#include "geometry/plane/visibility/polygon_extent.h"

#include <cmath>
#include <numbers>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct Way {
  double x, y;
};

double cross(const Way& a, const Way& b) { return a.x * b.y - a.y * b.x; }

// From one direction to another, counter-clockwise: 0 to a full turn, which it is where there is only one.
double turn_between(const Way& a, const Way& b, bool is_only) {
  if (is_only) return 2 * std::numbers::pi;
  const double turn = same_bits::atan2(cross(a, b), a.x * b.x + a.y * b.y);
  return turn < 0 ? turn + 2 * std::numbers::pi : turn;
}

}  // namespace

std::optional<PolygonExtent2> extent_of(const Point2& eye, const RoundedPolygon2& polygon,
                                        const std::optional<Rational>& range) {
  if (polygon.corners.empty() || polygon.sees_sky()) return std::nullopt;
  const double x = to_double(eye.x), y = to_double(eye.y), radius = range ? to_double(*range) : 0;
  const auto way = [&](std::size_t k) { return Way{polygon.corners[k].x - x, polygon.corners[k].y - y}; };
  PolygonExtent2 extent;
  const std::size_t count = polygon.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Way a = way(k), b = way(k + 1 == count ? 0 : k + 1);
    if (polygon.corners[k].after == kRange) {
      const double turn = turn_between(a, b, count == 1);
      extent.area += radius * radius * turn / 2;
      extent.perimeter += radius * turn;
    } else {
      extent.area += cross(a, b) / 2;
      extent.perimeter += std::hypot(b.x - a.x, b.y - a.y);
    }
  }
  return extent;
}

std::optional<Rational> exact_area_of(const RoundedPolygon2& polygon) {
  HOTTEL_REQUIRE(polygon.exact.size() == polygon.corners.size());
  if (polygon.corners.empty() || polygon.sees_sky()) return std::nullopt;
  Rational doubled;
  for (std::size_t k = 0; k < polygon.exact.size(); ++k) {
    const Point2 &a = polygon.exact[k], &b = polygon.exact[k + 1 == polygon.exact.size() ? 0 : k + 1];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

}  // namespace hottel

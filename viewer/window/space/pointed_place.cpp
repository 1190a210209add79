#include "viewer/window/space/pointed_place.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace hottel {
namespace {

Direction3 in_doubles(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
Direction3 in_doubles(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }

// Counts, even or odd, how often a ray in the plane of a loop crosses it: seen along the longest axis of the normal.
bool crosses_oddly(const std::vector<Point3>& loop, const Direction3& normal, const Direction3& place) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const auto flat = [&](const Direction3& p) {
    return z >= x && z >= y ? std::array{p.x, p.y} : y >= x ? std::array{p.z, p.x} : std::array{p.y, p.z};
  };
  const std::array<double, 2> at = flat(place);
  bool is_odd = false;
  std::array<double, 2> before = flat(in_doubles(loop.back()));
  for (const Point3& corner : loop) {
    const std::array<double, 2> now = flat(in_doubles(corner));
    if ((before[1] > at[1]) != (now[1] > at[1])) {
      const double share = (at[1] - before[1]) / (now[1] - before[1]);
      if (at[0] < std::lerp(before[0], now[0], share)) is_odd = !is_odd;
    }
    before = now;
  }
  return is_odd;
}

bool holds(const Polygon3& polygon, const Direction3& normal, const Direction3& place) {
  bool is_in = crosses_oddly(polygon.points, normal, place);
  for (const auto& hole : polygon.holes) is_in = is_in != crosses_oddly(hole, normal, place);
  return is_in;
}

}  // namespace

std::optional<Direction3> first_place_on_way_3(const Scene3& scene, const Direction3& eye, const Direction3& way) {
  std::optional<Direction3> first;
  double nearest = HUGE_VAL;
  for (const Polygon3& polygon : scene.polygons) {
    const Direction3 normal = in_doubles(doubled_area(polygon));
    const double along = dot(normal, in_doubles(polygon.points[0]) - eye) / dot(normal, way);
    if (!(along > 0 && along < nearest)) continue;
    const Direction3 place = eye + along * way;
    if (!holds(polygon, normal, place)) continue;
    nearest = along;
    first = place;
  }
  return first;
}

}  // namespace hottel

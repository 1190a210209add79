#include "geometry/space/scene/near_plane.h"

#include <algorithm>

#include "geometry/planarity.h"
#include "geometry/space/scene/bent_loops.h"

namespace hottel {

Rational float_spacing(const Polygon3& polygon, int digits) {
  Rational largest;
  for (const Point3& p : corners_of(polygon))
    for (const Rational* coordinate : {&p.x, &p.y, &p.z}) largest = std::max(largest, Rational(abs(*coordinate)));
  if (largest == 0) return 0;
  // 2^e <= largest < 2^(e + 1)
  long e = static_cast<long>(mpz_sizeinbase(largest.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(largest.get_den_mpz_t(), 2));
  if (scaled_by_power_of_two(1, e) > largest) --e;
  return scaled_by_power_of_two(1, e - digits + 1);
}

bool accept_nearly_plane(Polygon3& polygon, const Rational& unit) {
  polygon.is_nearly_plane = false;
  polygon.facets.clear();
  const std::vector<std::vector<Point3>> loops = loops_of(polygon);
  if (std::any_of(loops.begin(), loops.end(), [](const auto& loop) { return loop.size() < 3; })) return false;
  const std::vector<Point3> points = corners_of(polygon);
  if (points.size() < 4 || are_in_one_plane(points)) return false;
  const Bend3 bend = bend_of(points);
  polygon.is_nearly_plane =
      is_within_planarity(bend.squared_distance, bend.squared_diameter, unit) && !triangles_of_loops(loops).empty();
  return polygon.is_nearly_plane;
}

}  // namespace hottel

#include "solver/plane/methods/arithmetic_naive.h"

#include <algorithm>

#include "geometry/plane/visibility/visible_lines.h"

namespace hottel {
namespace {

// Compares as it answers.
class WatchedPoints {
 public:
  WatchedPoints(const StepLimit2<NaivePoints2>& points, const Vertices2& vertices, WrongOrientations2& counts)
      : points_(points), vertices_(vertices), counts_(counts) {}

  int orientation(VertexId i, VertexId j, VertexId k) const {
    const int sign = points_.orientation(i, j, k);
    ++counts_.asked;
    if (sign != vertices_.orientation(i, j, k)) ++counts_.wrong;
    return sign;
  }

 private:
  const StepLimit2<NaivePoints2>& points_;
  const Vertices2& vertices_;
  WrongOrientations2& counts_;
};

// The power of two above every coordinate of the scene.
int exponent_of(const std::vector<Point2>& points) {
  long exponent = -100'000;
  const auto include = [&exponent](const Rational& value) {
    if (value == 0) return;
    const auto bits = [](const Integer& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); };
    exponent = std::max(exponent, bits(value.get_num()) - bits(value.get_den()) + 1);
  };
  for (const Point2& p : points) {
    include(p.x);
    include(p.y);
  }
  return static_cast<int>(exponent);
}

}  // namespace

NaivePoints2::NaivePoints2(const Vertices2& vertices) {
  std::vector<Point2> points;
  for (const VertexId v : vertices.ids()) points.push_back(vertices.to_scene(vertices.exact(v)));
  const int exponent = exponent_of(points);
  for (const Point2& p : points)
    place_.push_back(
        {to_double(scaled_by_power_of_two(p.x, -exponent)), to_double(scaled_by_power_of_two(p.y, -exponent))});
}

std::uint64_t naive_step_limit(const Triangulation2& triangulation) {
  return (std::uint64_t{1} << 16) + 64 * triangulation.triangle_count();
}

WrongOrientations2 count_wrong_orientations(const Arrangement2& arrangement, const NaivePoints2& points) {
  const std::uint64_t limit = naive_step_limit(arrangement.triangulation());
  WrongOrientations2 counts;
  std::atomic<std::uint64_t> cut_off = 0;
  View2 view;
  for (const VertexId v : arrangement.vertices().ids()) {
    const StepLimit2 limited(points, limit, cut_off);
    const WatchedPoints watched(limited, arrangement.vertices(), counts);
    look_around(watched, arrangement.triangulation(), v, view);
    for_each_gap(watched, v, view, true, [](const Gap2&) {});
  }
  return counts;
}

}  // namespace hottel

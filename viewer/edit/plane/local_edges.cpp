#include "viewer/edit/plane/local_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The binary logarithm, off by less than 2.
long size_of(const Rational& value) {
  return static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) -
         static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

double scaled(double length, long shift) {
  return std::ldexp(length, static_cast<int>(std::clamp(shift, -1'000'000L, 1'000'000L)));
}

}  // namespace

LocalFoot2 local_foot(const LocalEdge2& edge, const Place2& place) {
  const double dx = edge.to_x - edge.from_x, dy = edge.to_y - edge.from_y;
  const double wx = place[0] - edge.from_x, wy = place[1] - edge.from_y;
  const double along = wx * dx + wy * dy, whole = dx * dx + dy * dy;
  const double t = along <= 0 || whole == 0 ? 0 : along >= whole ? 1 : along / whole;
  const double rest_x = t == 1 ? place[0] - edge.to_x : wx - t * dx;
  const double rest_y = t == 1 ? place[1] - edge.to_y : wy - t * dy;
  return {t, std::sqrt(rest_x * rest_x + rest_y * rest_y)};
}

LocalEdges2::LocalEdges2(const Scene2& scene) {
  if (scene.edges.empty()) return;
  origin_ = scene.edges.front().from;
  std::vector<Rational> ways;  // four for each edge
  ways.reserve(4 * scene.edges.size());
  std::optional<long> size;
  for (const Edge2& edge : scene.edges)
    for (const Point2* p : {&edge.from, &edge.to})
      for (const Rational& way : {Rational(p->x - origin_.x), Rational(p->y - origin_.y)}) {
        if (way != 0) size = std::max(size.value_or(size_of(way)), size_of(way));
        ways.push_back(way);
      }
  shift_ = -size.value_or(0);
  const auto local = [&](std::size_t k) { return to_double(scaled_by_power_of_two(ways[k], shift_)); };
  edges_.reserve(scene.edges.size());
  for (std::size_t k = 0; k < ways.size(); k += 4)
    edges_.push_back({local(k), local(k + 1), local(k + 2), local(k + 3)});
}

Place2 LocalEdges2::to_local(const Place2& place) const {
  HOTTEL_REQUIRE(std::isfinite(place[0]) && std::isfinite(place[1]));
  return {to_double(scaled_by_power_of_two(exact_value(place[0]) - origin_.x, shift_)),
          to_double(scaled_by_power_of_two(exact_value(place[1]) - origin_.y, shift_))};
}

double LocalEdges2::to_local(double length) const { return scaled(length, shift_); }

double LocalEdges2::from_local(double length) const { return scaled(length, -shift_); }

}  // namespace hottel

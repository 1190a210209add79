#include "geometry/plane/arrangement/ring_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/plane/arrangement/meeting_boxes.h"

namespace hottel {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

// What surely holds a coordinate.
double below(const Rational& value) { return std::max(std::nextafter(to_double(value), -kMost), -kMost); }
double above(const Rational& value) { return std::min(std::nextafter(to_double(value), kMost), kMost); }

std::optional<Point2> crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Rational at_c = doubled_area(a, b, c), at_d = doubled_area(a, b, d);
  if (sgn(at_c) * sgn(at_d) >= 0 || sgn(doubled_area(c, d, a)) * sgn(doubled_area(c, d, b)) >= 0) return std::nullopt;
  const Rational t = at_c / (at_c - at_d);
  return Point2{c.x + t * (d.x - c.x), c.y + t * (d.y - c.y)};
}

}  // namespace

std::optional<RingCrossing2> find_ring_crossing(const std::vector<Point2>& ring) {
  const std::size_t n = ring.size();
  const auto end = [&](std::size_t side) -> const Point2& { return ring[side + 1 == n ? 0 : side + 1]; };
  std::vector<NumberedBox2> boxes;
  boxes.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto [low_x, high_x] = std::minmax(ring[k].x, end(k).x);
    const auto [low_y, high_y] = std::minmax(ring[k].y, end(k).y);
    boxes.push_back({{below(low_x), below(low_y)}, {above(high_x), above(high_y)}, static_cast<std::uint32_t>(k)});
  }
  std::optional<RingCrossing2> found;
  for_each_meeting(boxes, boxes, [&](std::uint32_t i, std::uint32_t j) {
    if (i + 1 >= j || (i == 0 && j + 1 == n)) return;  // neighbours share an end
    if (found && std::tie(found->first, found->second) < std::tuple<std::size_t, std::size_t>(i, j)) return;
    if (auto at = crossing(ring[i], end(i), ring[j], end(j))) found = RingCrossing2{i, j, std::move(*at)};
  });
  return found;
}

}  // namespace hottel

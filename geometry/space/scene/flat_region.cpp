#include "geometry/space/scene/flat_region.h"

#include <algorithm>
#include <utility>

namespace hottel {

Rational doubled_area(const FlatPoint3& a, const FlatPoint3& b, const FlatPoint3& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

Rational doubled_area(const std::vector<FlatPoint3>& loop) {
  Rational area;
  for (std::size_t k = 2; k < loop.size(); ++k) area += doubled_area(loop[0], loop[k - 1], loop[k]);
  return area;
}

FlatRegion3::FlatRegion3(std::vector<std::vector<FlatPoint3>> loops) : loops_(std::move(loops)) {
  bool is_first = true;
  for (const auto& loop : loops_)
    for (const FlatPoint3& p : loop) {
      if (is_first) low_ = high_ = p;
      is_first = false;
      low_ = {std::min(low_.u, p.u), std::min(low_.v, p.v)};
      high_ = {std::max(high_.u, p.u), std::max(high_.v, p.v)};
    }
}

void FlatRegion3::append_sides(std::vector<FlatSegment3>& segments) const {
  for (const auto& loop : loops_)
    for (std::size_t k = 0; k < loop.size(); ++k) segments.push_back({loop[k], loop[(k + 1) % loop.size()]});
}

bool FlatRegion3::contains(const FlatPoint3& point) const {
  if (point.u < low_.u || point.u > high_.u || point.v < low_.v || point.v > high_.v) return false;
  bool is_in = false;
  for (const auto& loop : loops_)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const FlatPoint3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
      const bool is_up = a.v <= point.v && b.v > point.v, is_down = b.v <= point.v && a.v > point.v;
      if (!is_up && !is_down) continue;
      const Rational turn = doubled_area(a, b, point);
      if (is_up ? turn > 0 : turn < 0) is_in = !is_in;
    }
  return is_in;
}

bool FlatRegion3::is_on_border(const FlatPoint3& p) const {
  if (p.u < low_.u || p.u > high_.u || p.v < low_.v || p.v > high_.v) return false;
  for (const auto& loop : loops_)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const FlatPoint3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if (doubled_area(a, b, p) == 0 && (p.u - a.u) * (p.u - b.u) <= 0 && (p.v - a.v) * (p.v - b.v) <= 0) return true;
    }
  return false;
}

bool FlatRegion3::may_meet(const FlatRegion3& other) const {
  return low_.u <= other.high_.u && other.low_.u <= high_.u && low_.v <= other.high_.v && other.low_.v <= high_.v;
}

std::vector<FlatPoint3> without_straight_points(const std::vector<FlatPoint3>& loop) {
  std::vector<FlatPoint3> result;
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (doubled_area(loop[(k + loop.size() - 1) % loop.size()], loop[k], loop[(k + 1) % loop.size()]) != 0)
      result.push_back(loop[k]);
  return result;
}

std::vector<FlatPoint3> common_part(const std::vector<FlatPoint3>& a, const std::vector<FlatPoint3>& b) {
  std::vector<FlatPoint3> rest = a, next;
  for (std::size_t k = 0; k < b.size() && !rest.empty(); ++k) {
    const FlatPoint3 &from = b[k], &to = b[(k + 1) % b.size()];
    next.clear();
    for (std::size_t c = 0; c < rest.size(); ++c) {
      const FlatPoint3 &p = rest[c], &q = rest[(c + 1) % rest.size()];
      const Rational at_p = doubled_area(from, to, p), at_q = doubled_area(from, to, q);
      if (at_p >= 0) next.push_back(p);
      if (sgn(at_p) * sgn(at_q) >= 0) continue;
      const Rational t = at_p / (at_p - at_q);
      next.push_back({p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)});
    }
    rest.swap(next);
  }
  // What only touches has lost all its area, but not all its points.
  if (doubled_area(rest) == 0) return {};
  std::vector<FlatPoint3> result;
  for (const FlatPoint3& p : rest)
    if (result.empty() || !(result.back() == p)) result.push_back(p);
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return without_straight_points(result);
}

bool enters(const std::vector<FlatPoint3>& polygon, const std::vector<FlatPoint3>& other) {
  const auto is_outside = [](const FlatPoint3& a, const FlatPoint3& b, const std::vector<FlatPoint3>& points) {
    return std::all_of(points.begin(), points.end(), [&](const FlatPoint3& p) { return doubled_area(a, b, p) <= 0; });
  };
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (is_outside(polygon[k], polygon[(k + 1) % polygon.size()], other)) return false;
  for (std::size_t k = 0; k < other.size(); ++k)
    if (is_outside(other[k], other[(k + 1) % other.size()], polygon)) return false;
  return true;
}

}  // namespace hottel

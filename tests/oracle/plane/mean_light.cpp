#include "tests/oracle/plane/mean_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracle/gauss_rule.h"

namespace hottel::oracle {
namespace {

using Real = long double;

struct Place {
  Real x, y;
  bool operator==(const Place&) const = default;
};
Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }
Place operator*(Real t, const Place& a) { return {t * a.x, t * a.y}; }
Real cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
Real dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }

using Polygon = std::vector<Place>;

std::vector<Place> end_points(const std::vector<LitSegment>& segments) {
  std::vector<Place> points;
  for (const LitSegment& s : segments)
    for (const Place& p : {Place{s.ax, s.ay}, Place{s.bx, s.by}})
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  return points;
}

// What is met first in a direction.
double seen_along(const std::vector<LitSegment>& segments, double sky, const Place& eye, const Place& way) {
  Real nearest = INFINITY;
  double seen = sky;
  for (const LitSegment& s : segments) {
    const Place a = Place{s.ax, s.ay} - eye, b = Place{s.bx, s.by} - eye;
    if (cross(way, a) * cross(way, b) > 0) continue;
    const Real turn = cross(way, b - a), t = cross(a, b - a) / turn;
    if (turn == 0 || t <= 0 || t >= nearest) continue;
    nearest = t;
    seen = turn > 0 ? s.left : s.right;  // the eye lies on the left of a segment that runs from right to left
  }
  return seen;
}

// The view from a place: neighbouring end points, and what is seen between them. It stays the same in a part.
struct View {
  struct Sector {
    Place from, to;
    double seen;
    bool is_reflex;
  };
  std::vector<Sector> sectors;

  View(const std::vector<LitSegment>& segments, double sky, const Place& eye) {
    std::vector<Place> points = end_points(segments);
    const auto angle = [&](const Place& p) { return std::atan2(p.y - eye.y, p.x - eye.x); };
    std::sort(points.begin(), points.end(), [&](const Place& p, const Place& q) { return angle(p) < angle(q); });
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool is_last = k + 1 == points.size();
      const Place &from = points[k], &to = points[is_last ? 0 : k + 1];
      const Real end = angle(to) + (is_last ? 2 * std::numbers::pi_v<Real> : 0), middle = (angle(from) + end) / 2;
      sectors.push_back({from, to, seen_along(segments, sky, eye, {std::cos(middle), std::sin(middle)}),
                         end - angle(from) > std::numbers::pi_v<Real>});
    }
  }

  Real light(const Place& eye) const {
    Real sum = 0;
    for (const Sector& s : sectors) {
      if (s.seen == 0) continue;
      const Place a = s.from - eye, b = s.to - eye;
      const Real turn = std::atan2(cross(a, b), dot(a, b));
      sum += s.seen * (s.is_reflex && turn <= 0 ? turn + 2 * std::numbers::pi_v<Real> : turn);
    }
    return sum / (2 * std::numbers::pi_v<Real>);
  }
};

Polygon side_of(const Polygon& polygon, const Place& p, const Place& along) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Place &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const Real at_a = cross(along, a - p), at_b = cross(along, b - p);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

Real area(const Polygon& polygon) {
  Real twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return twice / 2;
}

std::vector<Polygon> parts_of(const Polygon& rectangle, const std::vector<Place>& points) {
  std::vector<Polygon> parts{rectangle};
  const Real least = area(rectangle) * 1e-17L;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      std::vector<Polygon> next;
      const Place along = points[j] - points[i];
      for (const Polygon& part : parts)
        for (const Real sign : {1, -1}) {
          Polygon half = side_of(part, points[i], sign * along);
          if (half.size() >= 3 && area(half) > least) next.push_back(std::move(half));
        }
      parts = std::move(next);
    }
  return parts;
}

// Over a triangle at whose first corner the direction to an end point may jump: collapsed there.
Real over_triangle(const View& view, const GaussRule& rule, const Place& p, const Place& q, const Place& r) {
  Real sum = 0;
  for (std::size_t i = 0; i < rule.node.size(); ++i)
    for (std::size_t j = 0; j < rule.node.size(); ++j) {
      const Real s = rule.node[i], t = rule.node[j];
      const Place x = p + s * ((1 - t) * (q - p) + t * (r - p));
      sum += rule.weight[i] * rule.weight[j] * s * view.light(x);
    }
  return sum * cross(q - p, r - p);
}

}  // namespace

long double mean_irradiance(const std::vector<LitSegment>& segments, double sky, long double x, long double y) {
  return segments.empty() ? sky : View(segments, sky, {x, y}).light({x, y});
}

MeanLight mean_light(const std::vector<LitSegment>& segments, double sky, long double x0, long double y0,
                     long double x1, long double y1) {
  static const GaussRule kLow(6), kHigh(10);
  const Polygon rectangle{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  Real low = 0, high = 0;
  for (const Polygon& part : parts_of(rectangle, end_points(segments))) {
    Place centre{0, 0};
    for (const Place& p : part) centre = centre + 1 / static_cast<Real>(part.size()) * p;
    const View view(segments, sky, centre);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Place &p = part[k], &q = part[(k + 1) % part.size()], middle = 0.5L * (p + q);
      low += over_triangle(view, kLow, p, middle, centre) + over_triangle(view, kLow, q, centre, middle);
      high += over_triangle(view, kHigh, p, middle, centre) + over_triangle(view, kHigh, q, centre, middle);
    }
  }
  return {high / area(rectangle), std::fabs(high - low) / area(rectangle)};
}

}  // namespace hottel::oracle

#include "benchmarks/reports/space/contour_measure.h"

#include <boost/math/constants/constants.hpp>

namespace hottel {
namespace {

LongPoint minus(const LongPoint& a, const LongPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
LongReal dot(const LongPoint& a, const LongPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LongPoint cross(const LongPoint& a, const LongPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
LongReal length(const LongPoint& a) { return sqrt(dot(a, a)); }
bool is_zero(const LongPoint& a) { return a.x == 0 && a.y == 0 && a.z == 0; }
bool are_equal(const LongPoint& a, const LongPoint& b) { return is_zero(minus(a, b)); }

LongReal log_squares(const LongReal& u, const LongReal& h) { return log(LongReal(u * u + h * h)); }

// Integral of ln sqrt(u^2 + h^2) from 0 to u, for h >= 0.
LongReal once(const LongReal& u, const LongReal& h) {
  if (u == 0) return 0;
  const LongReal turned = h == 0 ? LongReal(0) : LongReal(h * atan(LongReal(u / h)));
  return u * log_squares(u, h) / 2 - u + turned;
}

// A function whose second derivative is ln sqrt(u^2 + h^2).
LongReal twice(const LongReal& u, const LongReal& h) {
  if (u == 0 && h == 0) return 0;
  const LongReal logarithm = log_squares(u, h), turned = h == 0 ? LongReal(0) : LongReal(h * u * atan(LongReal(u / h)));
  return (u * u - h * h) * logarithm / 4 - 3 * u * u / 4 + turned;
}

struct Side {
  LongPoint from, to;
  LongPoint way() const { return minus(to, from); }
};

// The integrals of ln r over both lengths.

LongReal of_parallels(const Side& a, const Side& b) {
  const LongReal la = length(a.way()), lb = length(b.way());
  const LongPoint apart = minus(b.from, a.from);
  const LongReal h = length(cross(apart, a.way())) / la;
  // Places of both ends of b along a.
  LongReal low = dot(apart, a.way()) / la, high = low + (dot(a.way(), b.way()) > 0 ? lb : LongReal(-lb));
  if (high < low) std::swap(low, high);
  return twice(high, h) - twice(LongReal(high - la), h) - twice(low, h) + twice(LongReal(low - la), h);
}

// Two sides from one corner. The integral I(a, b) has a dI/da + b dI/db = 2 I + a b, for ln (k r) = ln k + ln r.
LongReal from_a_corner(const LongPoint& a, const LongPoint& b) {
  const LongReal la = length(a), lb = length(b), c = dot(a, b) / (la * lb), s = length(cross(a, b)) / (la * lb);
  const auto along = [&](const LongReal& at, const LongReal& over) -> LongReal {
    return once(LongReal(over - at * c), LongReal(at * s)) - once(LongReal(-at * c), LongReal(at * s));
  };
  return (la * along(la, lb) + lb * along(lb, la) - la * lb) / 2;
}

struct Node {
  LongReal place, weight;  // on (0, 1)
};

// Tanh-sinh: with steps of 1/64 analytic functions get more than 60 digits.
const std::vector<Node>& nodes() {
  static const std::vector<Node> result = [] {
    std::vector<Node> all;
    const LongReal half_pi = boost::math::constants::half_pi<LongReal>(), step = LongReal(1) / 64;
    for (int k = -340; k <= 340; ++k) {
      const LongReal t = k * step, e = exp(LongReal(-2 * half_pi * sinh(t)));
      all.push_back({LongReal(1 / (1 + e)), LongReal(step * 2 * half_pi * cosh(t) * e / ((1 + e) * (1 + e)))});
    }
    return all;
  }();
  return result;
}

LongReal of_skew(const Side& a, const Side& b) {
  const LongPoint way = a.way(), other = b.way();
  const LongReal lb = length(other);
  LongReal sum = 0;
  for (const Node& node : nodes()) {
    const LongPoint p{a.from.x + node.place * way.x, a.from.y + node.place * way.y, a.from.z + node.place * way.z};
    const LongPoint apart = minus(b.from, p);
    const LongReal low = dot(apart, other) / lb, h = length(cross(apart, other)) / lb;
    sum += node.weight * (once(LongReal(low + lb), h) - once(low, h));
  }
  return sum * length(way);
}

LongReal over_both(const Side& a, const Side& b) {
  if (is_zero(cross(a.way(), b.way()))) return of_parallels(a, b);
  if (are_equal(a.from, b.from)) return from_a_corner(a.way(), b.way());
  if (are_equal(a.from, b.to)) return from_a_corner(a.way(), minus(b.from, b.to));
  if (are_equal(a.to, b.from)) return from_a_corner(minus(a.from, a.to), b.way());
  if (are_equal(a.to, b.to)) return from_a_corner(minus(a.from, a.to), minus(b.from, b.to));
  return of_skew(a, b);
}

}  // namespace

LongReal contour_measure(const std::vector<LongPoint>& first, const std::vector<LongPoint>& second) {
  LongReal sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      const Side a{first[i], first[(i + 1) % first.size()]}, b{second[j], second[(j + 1) % second.size()]};
      const LongReal cosine = dot(a.way(), b.way());
      if (cosine != 0) sum += cosine / (length(a.way()) * length(b.way())) * over_both(a, b);
    }
  return abs(sum) / boost::math::constants::two_pi<LongReal>();
}

}  // namespace hottel

#include "tests/oracle/space/pair_alone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hottel::oracle {
namespace {

using std::numbers::pi_v;

constexpr int kMaxParts = 300;

struct LongVector {
  long double x, y, z;
};
LongVector operator+(const LongVector& a, const LongVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
LongVector operator-(const LongVector& a, const LongVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
LongVector operator*(long double s, const LongVector& a) { return {s * a.x, s * a.y, s * a.z}; }
long double dot(const LongVector& a, const LongVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
long double length(const LongVector& a) { return std::sqrt(dot(a, a)); }
LongVector cross(const LongVector& a, const LongVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

long double to_long(const mpq_class& value) {
  const double leading = value.get_d();
  return static_cast<long double>(leading) + static_cast<long double>(mpq_class(value - leading).get_d());
}
LongVector to_long(const SpacePoint& p) { return {to_long(p.x), to_long(p.y), to_long(p.z)}; }

SpacePoint between(const SpacePoint& a, const SpacePoint& b, const mpq_class& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

// The outline, with the corners of the other one that lie on its sides.
SpacePolygon with_contacts(const SpacePolygon& polygon, const SpacePolygon& other) {
  SpacePolygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const SpacePoint &a = polygon[k], along = polygon[(k + 1) % polygon.size()] - a;
    std::vector<mpq_class> places{0};
    for (const SpacePoint& p : other) {
      const mpq_class t = dot(p - a, along) / dot(along, along);
      if (t > 0 && t < 1 && cross(p - a, along) == SpacePoint{0, 0, 0}) places.push_back(t);
    }
    std::sort(places.begin(), places.end());
    for (const mpq_class& t : places) result.push_back(between(a, polygon[(k + 1) % polygon.size()], t));
  }
  return result;
}

// The factor from a point with this normal to a polygon in front of it (Lambert).
class Factor {
 public:
  Factor(const SpacePolygon& polygon, const LongVector& normal) : normal_(normal) {
    for (const SpacePoint& p : polygon) corners_.push_back(to_long(p));
  }

  long double operator()(const LongVector& x) const {
    long double sum = 0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const LongVector p = corners_[k] - x, q = corners_[(k + 1) % corners_.size()] - x, m = cross(p, q);
      const long double size = length(m);
      if (size > 0) sum -= std::atan2(size, dot(p, q)) * dot(m, normal_) / size;
    }
    return sum / (2 * pi_v<long double>);
  }

 private:
  std::vector<LongVector> corners_;
  LongVector normal_;
};

// Nodes and weights in (0, 1) that come ever closer to both ends. SEE: Takahasi and Mori 1974.
struct DoubleExponential {
  std::vector<long double> node, weight;

  explicit DoubleExponential(long double step) {
    for (int k = -static_cast<int>(3.1L / step); static_cast<long double>(k) * step <= 3.1L; ++k) {
      const long double t = static_cast<long double>(k) * step, s = pi_v<long double> / 2 * std::sinh(t);
      node.push_back(1 / (1 + std::exp(-2 * s)));
      weight.push_back(step * pi_v<long double> / 4 * std::cosh(t) / (std::cosh(s) * std::cosh(s)));
    }
  }
};

// A part of i, and the corner from where rays are drawn.
struct Triangle {
  LongVector apex, p, q;
};

long double integral(const Factor& factor, const Triangle& part, const DoubleExponential& rule) {
  long double sum = 0;
  for (std::size_t b = 0; b < rule.node.size(); ++b) {
    const LongVector towards = part.p - part.apex + rule.node[b] * (part.q - part.p);
    for (std::size_t a = 0; a < rule.node.size(); ++a)
      sum += rule.weight[a] * rule.weight[b] * rule.node[a] * factor(part.apex + rule.node[a] * towards);
  }
  return sum * length(cross(part.p - part.apex, part.q - part.apex));
}

// The distance of a point from an outline.
long double distance(const LongVector& x, const std::vector<LongVector>& outline) {
  long double result = std::numeric_limits<long double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const LongVector along = outline[(k + 1) % outline.size()] - outline[k], w = x - outline[k];
    const long double t = std::clamp(dot(w, along) / dot(along, along), 0.0L, 1.0L);
    result = std::min(result, length(w - t * along));
  }
  return result;
}

// Both halves of a triangle, cut across its longest side; the apex is the corner that is nearest to the target.
std::array<Triangle, 2> halves(const Triangle& whole, const std::vector<LongVector>& target) {
  std::array<LongVector, 3> c{whole.apex, whole.p, whole.q};
  while (length(c[1] - c[2]) < std::max(length(c[0] - c[1]), length(c[0] - c[2])))
    std::rotate(c.begin(), c.begin() + 1, c.end());
  const LongVector middle = 0.5L * (c[1] + c[2]);
  std::array<Triangle, 2> result{Triangle{c[0], c[1], middle}, Triangle{c[0], c[2], middle}};
  for (Triangle& part : result) {
    if (distance(part.p, target) < distance(part.apex, target)) std::swap(part.apex, part.p);
    if (distance(part.q, target) < distance(part.apex, target)) std::swap(part.apex, part.q);
  }
  return result;
}

}  // namespace

SpacePolygon part_in_front(const SpacePolygon& polygon, const SpacePolygon& other) {
  const SpacePoint normal = normal_of(other);
  SpacePolygon result;
  bool has_front = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const SpacePoint &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const mpq_class over_p = dot(normal, p - other[0]), over_q = dot(normal, q - other[0]);
    has_front |= over_p > 0;
    if (over_p >= 0) result.push_back(p);
    if (over_p * over_q < 0) result.push_back(between(p, q, over_p / (over_p - over_q)));
  }
  if (!has_front) result.clear();
  return result;
}

FineMeasure exchange_of_pair_alone(const SpacePolygon& i, const SpacePolygon& j) {
  const SpacePolygon source = part_in_front(i, j), target = part_in_front(j, i);
  if (source.empty() || target.empty()) return {};
  static const DoubleExponential coarse(1.0L / 6), fine(1.0L / 8);
  const LongVector normal = to_long(normal_of(i));
  const Factor factor(target, 1 / length(normal) * normal);
  const SpacePolygon outline = with_contacts(source, target);
  LongVector centre{0, 0, 0};
  for (const SpacePoint& p : outline) centre = centre + 1 / static_cast<long double>(outline.size()) * to_long(p);
  std::vector<Triangle> work;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const LongVector p = to_long(outline[k]), q = to_long(outline[(k + 1) % outline.size()]), m = 0.5L * (p + q);
    work.push_back({p, m, centre});
    work.push_back({q, m, centre});
  }
  std::vector<LongVector> rim;
  for (const SpacePoint& p : target) rim.push_back(to_long(p));
  FineMeasure result;
  const long double enough = 2e-17L * length(normal);
  for (int left = kMaxParts; !work.empty(); --left) {
    const Triangle part = work.back();
    work.pop_back();
    const long double measure = integral(factor, part, fine),
                      error = std::fabs(measure - integral(factor, part, coarse));
    if (error > enough && left > static_cast<int>(work.size())) {
      for (const Triangle& half : halves(part, rim)) work.push_back(half);
    } else {
      result.measure += measure;
      result.error += error;
    }
  }
  return result;
}

}  // namespace hottel::oracle

// Let x be a point of the smaller patch with the normal n, E(x) the factor to the other one. Over its edges f, with r =
// f(t) - x,
//
//   2 pi E = - sum over f of the integral of n.(v x r) / r.r over t
//          = - sum over f of angle(p, q) n.m / |m|,     p and q = r at both ends, m = p x q
//
// along a straight line x(s), s in [-1, 1], of length 2 R at most, the integral is analytic where r.r is not 0. Let l
// be the distance of f(t) from the centre of the patch, whose points are all within R. In the ellipse where the sum of
// the distances to both ends is 2 a, |r| <= l + R + a R and |r.r| >= (l - R - a R)^2 (log_distance.cpp: the zeros are
// where the sum is 2 (l - R)/R at least).
#include "geometry/space/unobstructed/small_part.h"

#include <algorithm>
#include <numbers>

#include "geometry/space/unobstructed/local_outline.h"
#include "kernel/legendre_rule.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

using Real = long double;
using Vector = LocalVector3<Real>;
using std::numbers::pi;

constexpr int kMaxNodes = 12;
constexpr double kRound = kRoundoff<Real>;

double to_double(Real value) { return static_cast<double>(value); }

// Twice the area and the normal of an outline.
struct Normal {
  Vector unit;
  double off = 0;

  explicit Normal(const LocalOutline3<Real>& outline) {
    double error = 0;
    Vector sum;
    for (std::size_t k = 2; k < outline.corners.size(); ++k) {
      const Vector a = outline.corners[k - 1] - outline.corners[0], b = outline.corners[k] - outline.corners[0];
      const double size_a = to_double(length(a)), size_b = to_double(length(b));
      sum = sum + cross(a, b);
      error += 6 * kRound * size_a * size_b + 2 * outline.most_off * (size_a + size_b);
    }
    const Real size = length(sum);
    unit = 1 / size * sum;
    off = 2 * error / to_double(size) + 8 * kRound;
  }
};

// The factor from points of one outline to another.
class Factor {
 public:
  // Points are off by at most `off`.
  Factor(const LocalOutline3<Real>& from, const LocalOutline3<Real>& to, double off)
      : normal_(from), to_(to), off_(off) {}

  // Rounding: both vectors are off by that of their ends and of the difference, m by what these make and 6 roundoffs of
  // the product of their lengths, and the scalar product too. angle(p, q) m / |m| changes with m by less than angle/|m|
  // and 1/(|p| |q|), where the former is at most pi/2 / (|p| |q|) for acute angles.
  Approximation<Real> operator()(const Vector& x) const {
    Approximation<Real> sum;
    const std::size_t count = to_.corners.size();
    Vector p = to_.corners[count - 1] - x;
    double size_p = to_double(length(p)), off_p = off_ + to_.off[count - 1] + kRound * size_p;
    for (std::size_t k = 0; k < count; ++k) {
      const Vector q = to_.corners[k] - x, m = cross(p, q);
      const double size_q = to_double(length(q)), off_q = off_ + to_.off[k] + kRound * size_q;
      const Real size = length(m), cosine = dot(p, q), angle = same_bits::atan2(size, cosine);
      if (size > 0) sum.value -= angle * dot(m, normal_.unit) / size;
      const double product = size_p * size_q, a = to_double(angle);
      const double off_m = 6 * kRound * product + off_p * size_q + off_q * size_p + off_p * off_q;
      const double slope = cosine > 0 ? 1.6 / product : a / to_double(size);
      sum.error += 2.1 * off_m * (slope + 1 / product) + a * (normal_.off + 20 * kRound);
      p = q;
      size_p = size_q;
      off_p = off_q;
    }
    return {sum.value / (2 * std::numbers::pi_v<Real>), sum.error / (2 * pi) + static_cast<double>(count + 4) * kRound};
  }

 private:
  Normal normal_;
  const LocalOutline3<Real>& to_;
  double off_;
};

// The distances of the edges of an outline from a point, at least, and their lengths over these.
struct Edge {
  double distance, ratio;
};
std::vector<Edge> edges_from(const Vector& x, const LocalOutline3<Real>& outline) {
  std::vector<Edge> result;
  for (std::size_t k = 0; k < outline.corners.size(); ++k) {
    const Vector v = outline.corners[k + 1 == outline.corners.size() ? 0 : k + 1] - outline.corners[k],
                 w = x - outline.corners[k];
    const Vector rest = w - std::clamp(dot(w, v) / square(v), Real(0), Real(1)) * v;
    const double distance = to_double(length(rest)) * (1 - 0x1p-40) - outline.most_off -
                            16 * kRound * (outline.size + to_double(length(x)));
    result.push_back({distance, to_double(length(v)) / distance});
  }
  return result;
}

double area_sine(double x) { return same_bits::log1p(x + x * x / (1 + std::sqrt(1 + x * x))); }  // arsinh

// By how much n nodes for one coordinate are off, times the largest density.
double coordinate_error(int n, const std::vector<Edge>& edges, double nearest, double radius) {
  const double a = (nearest / radius - 1) * (n - 1) / (n + 1), rho = a + std::sqrt(a * a - 1), r = 1 / (rho * rho);
  double most = 0;
  for (const Edge& edge : edges) {
    const double left = 1 - (1 + a) * radius / edge.distance;
    most += 2 / (left * left) * std::min(edge.ratio, 2 * area_sine(edge.ratio));
  }
  return 1.001 * 32.0 / 15 * a * most / (2 * pi) * same_bits::pow(r, n) / (1 - r);
}

}  // namespace

std::optional<Approximation<long double>> measure_of_small(const LocalPair3& pair, int exponent, double error) {
  const LocalOutline3<Real> first(pair, 0, exponent), second(pair, 1, exponent);
  const bool is_first = first.radius <= second.radius;
  const LocalOutline3<Real>&small = is_first ? first : second, &other = is_first ? second : first;
  const std::vector<Edge> edges = edges_from(small.centre, other);
  double nearest = edges[0].distance;
  for (const Edge& edge : edges) nearest = std::min(nearest, edge.distance);
  if (!(nearest > 4 * small.radius)) return {};

  const std::vector<PatchCell3<Real>> cells = cells_of(small);
  double density = 0;
  for (const PatchCell3<Real>& cell : cells) density += cell.most_density;
  const auto error_of = [&](int n) { return 2 * density * coordinate_error(n, edges, nearest, small.radius); };
  int n = 3;
  while (n <= kMaxNodes && error_of(n) > error) ++n;
  if (n > kMaxNodes) return {};

  const LegendreRule<Real>& rule = legendre_rule<Real>(n);
  const Factor factor(small, other, small.most_off + 8 * kRound * small.size);
  CompensatedSum<Real> sum;
  double off = error_of(n);
  for (const PatchCell3<Real>& cell : cells)
    for (std::size_t a = 0; a < rule.node.size(); ++a)
      for (std::size_t b = 0; b < rule.node.size(); ++b) {
        const std::array<Real, 4> share = shares_of_corners(rule.node, a, rule.node, b);
        Vector x;
        for (std::size_t c = 0; c < 4; ++c) x = x + share[c] * small.corners[cell.corner[c]];
        const Approximation<Real> area = mixed(share, cell.density), seen = factor(x);
        const Real weight = rule.weight[a] * rule.weight[b];
        sum.add(weight * (area.value * seen.value));
        off += to_double(weight) * ((to_double(area.value) + area.error) * (seen.error + 8 * kRound) + area.error);
      }
  return Approximation<Real>{sum.value(), 1.001 * off};
}

}  // namespace hottel

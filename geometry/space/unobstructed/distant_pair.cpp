#include "geometry/space/unobstructed/distant_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/space/unobstructed/distance_sum.h"
#include "geometry/space/unobstructed/local_outline.h"
#include "kernel/legendre_rule.h"

namespace hottel {
namespace {

using Vector = LocalVector3<double>;
using std::numbers::pi;

constexpr double kRound = kRoundoff<double>;
constexpr int kMaxNodes = 10;
constexpr double kEnough = 0x1p-47;  // what quadrature may be off by at least, of the largest value times the area

constexpr double kMore = 1 + 0x1p-40;  // above all roundings

// One of the two patches, without what is behind the other one.
class Part {
 public:
  Part(const LocalPair3& pair, int side, int exponent) : outline_(pair, side, exponent), cells_(cells_of(outline_)) {
    for (const LocalPair3::Corner& corner : pair.outline(side))
      heights_.push_back(height(pair, 1 - side, corner, exponent));
  }

  const Vector& centre() const { return outline_.centre; }
  double radius() const { return outline_.radius; }
  // All points that are made are off by at most this.
  double off() const { return outline_.most_off + 8 * kRound * outline_.size; }
  // Of height times density: at most, summed over cells.
  double largest() const {
    double sum = 0;
    for (const PatchCell3<double>& cell : cells_) {
      double most = 0;
      for (const std::size_t c : cell.corner) most = std::max(most, heights_[c].value + heights_[c].error);
      sum += most * cell.most_density;
    }
    return sum;
  }

  // Of lines along which one coordinate of a cell runs, the first or the second one: how long they are at most, and how
  // far from the centre of the patch their middles are.
  struct Lines {
    double length = 0, middle = 0;
  };
  Lines lines(int coordinate) const {
    Lines most;
    for (const PatchCell3<double>& cell : cells_) {
      const auto corner = [&](std::size_t c) { return outline_.corners[cell.corner[c % 4]]; };
      const std::size_t first = coordinate == 0 ? 0 : 1;
      for (const std::size_t side : {first, first + 2}) {
        const Vector a = corner(side), b = corner(side + 1);
        most.length = std::max(most.length, kMore * length(b - a) + 2 * off());
        most.middle = std::max(most.middle, kMore * length(0.5 * (a + b) - outline_.centre) + off());
      }
    }
    return most;
  }

  // Nodes whose weights are those of rules for each coordinate, times height and density; and by how much their sum is
  // off.
  WeightedPoints3 nodes(const std::array<int, 2>& counts, double& off) const {
    WeightedPoints3 result;
    off = 0;
    for (const PatchCell3<double>& cell : cells_) {
      WeightedCell3 weighted{{}, {}, cell.density};
      for (std::size_t c = 0; c < 4; ++c) {
        weighted.corner[c] = outline_.corners[cell.corner[c]];
        weighted.height[c] = heights_[cell.corner[c]];
      }
      result.add(weighted, legendre_rule<double>(counts[0]), legendre_rule<double>(counts[1]), off);
    }
    off *= 1.001;
    return result;
  }

 private:
  // The height above the plane of a patch: not negative, and 0 where the outline was cut there.
  static Approximation<double> height(const LocalPair3& pair, int over, const LocalPair3::Corner& corner,
                                      int exponent) {
    if (corner.corner == LocalPair3::Corner::kCut) return {};
    const BoundedVector& normal = pair.normal(over);
    const BoundedValue product = dot(normal, bounded_difference_3(corner.position, pair.corners(over)[0]));
    const double size = length(Vector{normal.x, normal.y, normal.z});
    const double value = std::ldexp(std::max(product.value, 0.0) / size, -exponent);
    return {value,
            1.001 * (std::ldexp(product.error / size, -exponent) + value * (1.8 * normal.error / size + 4 * kRound))};
  }

  LocalOutline3<double> outline_;
  std::vector<PatchCell3<double>> cells_;
  std::vector<Approximation<double>> heights_;
};

// For one coordinate of one patch, the error of n nodes where all else is fixed, in units of the largest value of
// height * density * height * density / distance^4. The coordinate runs along a line x; points y of the other patch
// have sums |y - x(0)| + |y - x(1)| of at least twice the distance from its middle, so of A lengths of the line. In the
// ellipse where (rho + 1/rho)/2 = a < A, height and density, which are linear, are at most a times their largest
// values, and the square of the distance is at least (1 - a/A)^2 times that of y from the middle.
double coordinate_error(int n, double most) {
  const double a = most * (n - 1) / (n + 1), rho = a + std::sqrt(a * a - 1), r = 1 / (rho * rho);
  const double nearest = (1 - a / most) * (1 - a / most);
  double last = 1;  // r^n
  for (int k = 0; k < n; ++k) last *= r;
  return 32.0 / 15 * a * a / (nearest * nearest) * last / (1 - r);
}

// Nodes for a coordinate with A = most; 0 where too many would be needed.
int nodes_for(double most, double enough) {
  if (!(most >= 5)) return 0;
  for (int n = 2; n <= kMaxNodes; ++n)
    if (most * (n - 1) > 1.5 * (n + 1) && coordinate_error(n, most) <= enough) return n;
  return 0;
}

}  // namespace

// S = 1/pi int int (height of x above j) (height of y above i) / |x - y|^4.
std::optional<Approximation<double>> measure_of_distant(const LocalPair3& pair, int exponent, double relative) {
  const Part first(pair, 0, exponent), second(pair, 1, exponent);
  const std::array<const Part*, 2> parts{&first, &second};
  const double between = length(first.centre() - second.centre());
  const double distance = (between - first.radius() - second.radius()) / kMore;
  if (!(distance > 0)) return {};
  // What quadrature may be off by in units of this: all of it, one coordinate after the other.
  const double unit = first.largest() * second.largest() / (pi * distance * distance * distance * distance);
  const double enough_each = std::max(kEnough, relative) / 4;
  std::array<std::array<int, 2>, 2> counts{};
  double quadrature = 0;
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t c = 0; c < 2; ++c) {
      const Part::Lines lines = parts[p]->lines(static_cast<int>(c));
      const double most = 2 * (between / kMore - parts[1 - p]->radius() - lines.middle) / (kMore * lines.length);
      counts[p][c] = nodes_for(most, enough_each);
      if (counts[p][c] == 0) return {};
      quadrature += unit * coordinate_error(counts[p][c], most);
    }

  double off_first = 0, off_second = 0;
  const WeightedPoints3 outer = first.nodes(counts[0], off_first), inner = second.nodes(counts[1], off_second);
  CompensatedSum<double> sum;
  double sum_outer = 0, sum_inner = 0;
  for (const double weight : inner.weight) sum_inner += weight;
  for (std::size_t k = 0; k < outer.size(); ++k) {
    sum.add(outer.weight[k] * sum_over_fourth_powers({outer.x[k], outer.y[k], outer.z[k]}, inner));
    sum_outer += outer.weight[k];
  }
  const double value = sum.value() / pi, power = distance * distance * distance * distance;
  const double off = first.off() + second.off() + 2 * kRound * (distance + 2 * (first.radius() + second.radius()));
  const double weights = off_first * (sum_inner + off_second) + off_second * sum_outer;
  const double rounding = (20 + static_cast<double>(inner.size()) / 4) * kRound + 4.01 * off / distance;
  return Approximation<double>{value, 1.001 * (quadrature + weights / (pi * power) + rounding * value)};
}

}  // namespace hottel

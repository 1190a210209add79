#include "tests/oracle/plane/line_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace hottel::oracle {

namespace {

struct Point {
  double x, y;
  auto operator<=>(const Point&) const = default;
};

struct Wall {
  Point a, b;
  int left, right;
};

struct Hit {
  double along;
  int behind, ahead;  // the labels on the side a traveller comes from, and on the side where he goes on
};

// Abscissas and weights of the eight-point Gauss-Legendre rule on [-1, 1], the positive half (Abramowitz and Stegun,
// table 25.4).
constexpr std::array<std::pair<double, double>, 4> kGauss{
    {{0.183434642495649804939476142360, 0.362683783378361982965150449277},
     {0.525532409916328985817739049189, 0.313706645877887287337962201987},
     {0.796666477413626739591553936476, 0.222381034453374470544355994426},
     {0.960289856497536231683560868569, 0.101228536290376259152531354310}}};

class Sweep {
 public:
  explicit Sweep(const std::vector<Segment>& segments) {
    for (const Segment& s : segments)
      walls_.push_back({{s.ax.get_d(), s.ay.get_d()}, {s.bx.get_d(), s.by.get_d()}, s.left, s.right});
    std::set<Point> points;
    for (const Wall& wall : walls_) points.insert({wall.a, wall.b});
    points_.assign(points.begin(), points.end());
  }

  // The angles in [0, pi] at which the projections of two vertices coincide, with both ends of the range.
  std::vector<double> critical_directions() const {
    std::vector<double> angles{0, std::numbers::pi / 2, std::numbers::pi};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = i + 1; j < points_.size(); ++j) {
        const double angle = std::atan2(points_[j].y - points_[i].y, points_[j].x - points_[i].x);
        angles.push_back(angle < 0 ? angle + std::numbers::pi : angle);
      }
    }
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
  }

  // Adds weight times the width of every free strip in direction `angle`.
  void add_direction(double angle, double weight) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto offset = [&](const Point& p) { return c * p.y - s * p.x; };
    std::vector<double> offsets;
    for (const Point& p : points_) offsets.push_back(offset(p));
    std::sort(offsets.begin(), offsets.end());
    std::vector<Hit> hits;
    for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
      const double width = offsets[k + 1] - offsets[k], middle = offsets[k] + width / 2;
      if (width <= 0) continue;
      hits.clear();
      for (const Wall& wall : walls_) {
        const double a = offset(wall.a), b = offset(wall.b);
        if ((a < middle) == (b < middle)) continue;
        const double share = (middle - a) / (b - a);
        const double along =
            c * (wall.a.x + share * (wall.b.x - wall.a.x)) + s * (wall.a.y + share * (wall.b.y - wall.a.y));
        // A wall that rises to the left of the direction shows its left face to what comes.
        hits.push_back(b > a ? Hit{along, wall.left, wall.right} : Hit{along, wall.right, wall.left});
      }
      std::sort(hits.begin(), hits.end(), [](const Hit& p, const Hit& q) { return p.along < q.along; });
      int from = kInfinity;
      for (const Hit& hit : hits) {
        add(from, hit.behind, weight * width);
        from = hit.ahead;
      }
      add(from, kInfinity, weight * width);
    }
  }

  // The sums, compensated while they are formed (Neumaier).
  std::map<ElementPair, double> measures() const {
    std::map<ElementPair, double> result;
    for (const auto& [pair, sum] : sums_) result[pair] = sum.first + sum.second;
    return result;
  }

 private:
  void add(int f, int g, double measure) {
    if (f == kInfinity && g == kInfinity) return;
    const double term = f == g ? 2 * measure : measure;
    auto& [sum, lost] = sums_[std::minmax({f, g})];
    const double next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }

  std::vector<Wall> walls_;
  std::vector<Point> points_;
  std::map<ElementPair, std::pair<double, double>> sums_;
};

}  // namespace

std::map<ElementPair, double> line_sweep(const std::vector<Segment>& segments) {
  Sweep sweep(segments);
  const std::vector<double> angles = sweep.critical_directions();
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const double middle = (angles[k] + angles[k + 1]) / 2, half = (angles[k + 1] - angles[k]) / 2;
    for (const auto& [abscissa, weight] : kGauss) {
      sweep.add_direction(middle - half * abscissa, half * weight);
      sweep.add_direction(middle + half * abscissa, half * weight);
    }
  }
  return sweep.measures();
}

}  // namespace hottel::oracle

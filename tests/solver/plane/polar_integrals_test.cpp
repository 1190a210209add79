#include "solver/plane/light/polar_integrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/oracle/gauss_rule.h"

namespace hottel::polar_integrals_test {
namespace {

struct Exact {
  long double area = 0, angle = 0;
};

// Over triangles collapsed at their first corner, where the pole may lie.
Exact by_quadrature(const CellPart2& part, const Vector2& z, const Vector2& axis) {
  static const GaussRule kRule(40);
  Exact sum;
  for (int k = 1; k + 1 < part.size(); ++k) {
    const Vector2 &p = part[0], &q = part[k], &r = part[k + 1];
    const long double qx = static_cast<long double>(q.x) - p.x, qy = static_cast<long double>(q.y) - p.y,
                      rx = static_cast<long double>(r.x) - p.x, ry = static_cast<long double>(r.y) - p.y,
                      turn = qx * ry - qy * rx;
    for (std::size_t i = 0; i < kRule.node.size(); ++i)
      for (std::size_t j = 0; j < kRule.node.size(); ++j) {
        const long double s = kRule.node[i], t = kRule.node[j];
        const long double x = z.x + (p.x + s * ((1 - t) * qx + t * rx)), y = z.y + (p.y + s * ((1 - t) * qy + t * ry));
        const long double weight = kRule.weight[i] * kRule.weight[j] * s * turn;
        sum.area += weight;
        sum.angle += weight * std::atan2(axis.x * y - axis.y * x, axis.x * x + axis.y * y);
      }
  }
  return sum;
}

class Cells {
 public:
  explicit Cells(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return low + (high - low) * 0x1p-32 * static_cast<double>(random_()); }
  // A cell whose centre lies between near and far (logarithmically) from the pole, and an axis about it.
  Vector2 centre(double near, double far) {
    const double r = std::exp(number(std::log(near), std::log(far))), angle = number(-3.2, 3.2);
    return {r * std::cos(angle), r * std::sin(angle)};
  }
  CellPart2 part(double height) {
    CellPart2 part(height);
    for (int cuts = static_cast<int>(random_() % 4); cuts > 0; --cuts) {
      const double angle = number(-3.2, 3.2);
      part.cut(number(-0.3, 0.5), {std::cos(angle), std::sin(angle)});
    }
    return part;
  }

 private:
  std::mt19937 random_;
};

Vector2 axis_towards(const Vector2& z, double turned) {
  const double angle = std::atan2(z.y, z.x) + turned;
  return {std::cos(angle), std::sin(angle)};
}

TEST(PolarIntegrals2, AgreeWithQuadratureWithinTheirBounds) {
  constexpr double kUnit = 0x1p-53;
  for (const double height : {1.0, 0.25, 3.0}) {
    Cells cells(7);
    const PolarIntegrals2 integrals(height);
    std::size_t near = 0, far = 0;
    for (int k = 0; k < 300; ++k) {
      const Vector2 z = cells.centre(4 * integrals.radius(), 1e6);
      const Vector2 axis = axis_towards(z, cells.number(-0.5, 0.5));
      const CellPart2 part = cells.part(height);
      if (part.size() < 3) continue;
      const AreaAndAngle2 found = integrals.over(part, z, axis);
      const Exact exact = by_quadrature(part, z, axis);
      const double corners = 8 * kUnit * integrals.radius() * integrals.radius();  // the quadrature's own
      EXPECT_NEAR(found.area, static_cast<double>(exact.area), kUnit * integrals.area_error() + corners);
      EXPECT_NEAR(found.angle, static_cast<double>(exact.angle), kUnit * integrals.angle_error(z) + corners);
      const AreaAndAngle2 whole = integrals.over_cell(z, axis);
      const Exact exact_whole = by_quadrature(CellPart2(height), z, axis);
      EXPECT_NEAR(whole.angle, static_cast<double>(exact_whole.angle),
                  kUnit * (integrals.is_near(z) ? integrals.angle_error(z) : 12 * height) + corners);
      ++(integrals.is_near(z) ? near : far);
    }
    EXPECT_GT(near, 10u);
    EXPECT_GT(far, 100u);
  }
}

// The pole is a corner of the part: a quadrant of the cell cut off there.
TEST(PolarIntegrals2, HoldAboutThePoleItself) {
  const PolarIntegrals2 integrals(1);
  CellPart2 quadrant(1);
  quadrant.cut(-0.125, {1, 0});
  quadrant.cut(0.25, {0, 1});
  const Vector2 z{-0.125, 0.25}, axis{std::sqrt(0.5), std::sqrt(0.5)};
  // The square of the longer side, cut: x up to 0.375, y up to 0.75. By symmetry of arc tangents in a rectangle:
  const double w = 0.375, h = 0.75;
  const auto under = [](double a, double b) {
    return a * b / 2 * std::atan(b / a) - a * a / 4 * std::log1p(b * b / a / a);
  };
  const double lower = under(w, h), upper = w * h / 2 * std::atan(1e300) - under(h, w);
  const AreaAndAngle2 found = integrals.over(quadrant, z, axis);
  EXPECT_NEAR(found.area, w * h, 1e-15);
  EXPECT_NEAR(found.angle, lower + upper - w * h * std::atan(1.0), 1e-15);
}

TEST(PolarIntegrals2, OfNothingAreNothing) {
  const PolarIntegrals2 integrals(1);
  CellPart2 part(1);
  part.cut(-2, {1, 0});
  EXPECT_EQ(part.size(), 0);
  part.cut(1, {0, 1});
  EXPECT_EQ(part.size(), 0);
  CellPart2 all(1);
  all.cut(3, {0, 1});
  EXPECT_EQ(integrals.over(all, {100, 0}, {1, 0}).area, 1.0);
}

}  // namespace
}  // namespace hottel::polar_integrals_test

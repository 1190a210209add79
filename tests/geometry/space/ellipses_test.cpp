// Vectors and arcs along parts of stretches, on ellipses about them and at nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/space/proven/arcs_on_ellipse.h"
#include "geometry/space/proven/node_balls.h"
#include "geometry/space/proven/node_lanes.h"
#include "kernel/wide_real.h"

namespace hottel::ellipses_test {
namespace {

using Complex = std::complex<double>;
using Vector = LocalVector3<double>;
using ComplexVector = LocalVector3<Complex>;

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
Vector some_point(std::mt19937_64& random, double size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

// The value and the slope of a vector along a part at a complex x.
ComplexVector sum_at(const PartVector3& v, const std::array<Complex, 3>& powers) {
  const auto component = [&](double Vector::*axis) {
    return powers[0] * (v.power[0].*axis) + powers[1] * (v.power[1].*axis) + powers[2] * (v.power[2].*axis);
  };
  return {component(&Vector::x), component(&Vector::y), component(&Vector::z)};
}
ComplexVector value_of(const PartVector3& v, Complex x) { return sum_at(v, {1, x, x * x}); }
ComplexVector slope_of(const PartVector3& v, Complex x) { return sum_at(v, {0, 1, 2.0 * x}); }
double length_of(const ComplexVector& v) { return std::sqrt(std::norm(v.x) + std::norm(v.y) + std::norm(v.z)); }

// The sum of half axes of the ellipse on which reach is the half axis, and a half axis for such a sum.
double rho_of(double reach) { return reach + std::sqrt(std::max(0.0, reach * reach - 1)); }
double half_axis_of(double rho) { return (rho + 1 / rho) / 2; }
// A point of the ellipse, by an angle; part of the way there from the middle.
Complex on_ellipse(double rho, double angle, double part = 1) {
  return part * Complex((rho + 1 / rho) / 2 * std::cos(angle), (rho - 1 / rho) / 2 * std::sin(angle));
}

// Of many kinds: linear ones, such that pass close by zero, some that hardly bend, some along one direction.
ProvenVector3<double> some_vector(int kind, std::mt19937_64& random) {
  ProvenVector3<double> v;
  v.is_linear = kind % 2 == 0;
  v.power = {some_point(random, 1), some_point(random, between(random, 0, 2)), some_point(random, 1)};
  if (v.is_linear) v.power[2] = {};
  if (kind % 7 == 0) {
    const double s = between(random, -1, 1);
    v.power[0] = 1e-6 * some_point(random, 1) - s * v.power[1] - (s * s) * v.power[2];
  }
  if (kind % 11 == 0) v.power[2] = 1e-9 * v.power[2];
  if (kind % 13 == 0 && !v.is_linear) {
    const double a = between(random, -2, 2), b = between(random, 1, 3);
    v.power = {(a * a / 4 + b) * v.power[0], a * v.power[0], v.power[0]};
  }
  v.base = between(random, 0, 1);
  return v;
}

TEST(PartVectors, AreThoseOfStretches) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const ProvenVector3<double> v = some_vector(k, random);
    const double low = between(random, 0, 0.5), half = between(random, 0.01, 0.25), x = between(random, -1, 1);
    const PartVector3 part(v, low, half);
    const WideReal s = WideReal(low) - v.base + WideReal(half) * (1 + WideReal(x));
    const auto component = [&](double Vector::*axis) {
      const WideReal exact = v.power[0].*axis + s * (v.power[1].*axis + s * WideReal(v.power[2].*axis));
      const WideReal found = part.power[0].*axis + x * (part.power[1].*axis + x * WideReal(part.power[2].*axis));
      return static_cast<double>(found - exact);
    };
    const Vector off{component(&Vector::x), component(&Vector::y), component(&Vector::z)};
    EXPECT_LE(length(off), part.error[0] + part.error[1] + part.error[2]);
    const auto off_at_nodes = part.off_at_nodes();
    EXPECT_LE(*std::ranges::max_element(off_at_nodes), 1e-14);
  }
}

TEST(Ellipses, HoldWhatVectorsComeTo) {
  std::mt19937_64 random(2);
  int close = 0, count = 0;
  for (int k = 0; k < 1500; ++k) {
    const PartVector3 vector(some_vector(k, random), between(random, 0, 0.5), between(random, 0.01, 0.25));
    const VectorOnEllipse3 on(vector);
    const double farthest = rho_of(on.reach());
    for (const double part : {0.3, 0.75, 0.95}) {
      const double rho = std::min(32.0, 1 + part * (farthest - 1));
      if (rho < 1.01) continue;
      const VectorOnEllipse3::Bounds bounds = on.within(half_axis_of(rho));
      double least = 1e300;
      for (int m = 0; m <= 40; ++m) {
        const Complex x = on_ellipse(rho, m * std::numbers::pi / 30, m <= 30 ? 1 : between(random, 0, 1));
        const ComplexVector v = value_of(vector, x);
        least = std::min(least, std::abs(dot(v, v)));
        EXPECT_LE(length_of(v), bounds.most);
        EXPECT_LE(length_of(cross(v, slope_of(vector, x))), bounds.turn * (1 + 1e-12) + 1e-15);
      }
      EXPECT_GE(least, bounds.least_square);
      ++count;
      close += least < 4 * bounds.least_square ? 1 : 0;
    }
  }
  EXPECT_GT(close, 0.7 * count);
}

// Every vector that is within what is known of one.
TEST(Ellipses, HoldWhatVectorsMayBe) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 300; ++k) {
    ProvenVector3<double> vector = some_vector(k, random), other = vector;
    for (int power = 0; power < (vector.is_linear ? 2 : 3); ++power) {
      vector.error[power] = 0.02;
      other.power[power] = other.power[power] + some_point(random, 0.02);
    }
    const double half = between(random, 0.01, 0.25);
    const PartVector3 part(vector, 0.25, half), of_other(other, 0.25, half);
    const VectorOnEllipse3 on(part);
    const double rho = std::min(8.0, 1 + 0.5 * (rho_of(on.reach()) - 1));
    if (rho < 1.01) continue;
    const VectorOnEllipse3::Bounds bounds = on.within(half_axis_of(rho));
    for (int m = 0; m <= 30; ++m) {
      const Complex x = on_ellipse(rho, m * std::numbers::pi / 30);
      const ComplexVector v = value_of(of_other, x);
      EXPECT_GE(std::abs(dot(v, v)), bounds.least_square);
      EXPECT_LE(length_of(v), bounds.most);
      EXPECT_LE(length_of(cross(v, slope_of(of_other, x))), bounds.turn * (1 + 1e-12));
    }
  }
}

// Arcs of a line of points as an eye that moves sees it: from one to another one, or to where other lines cross it.
struct SomeArc {
  std::vector<ProvenVector3<double>> planes, corners;
  std::vector<SeenArc3> arcs{{0, 0, 1, 1, 0}};
  Vector moment;

  explicit SomeArc(int kind, std::mt19937_64& random) : moment(some_point(random, 1)) {
    const Vector eye = some_point(random, 1), way = some_point(random, 1);
    const auto line = [&](const Vector& a, const Vector& b) {
      return of_powers({cross(a - eye, b - eye), cross(b - a, way), {}});
    };
    const auto meet = [&](const ProvenVector3<double>& a, const ProvenVector3<double>& b) {
      const auto &p = a.power, &q = b.power;
      return of_powers({cross(p[0], q[0]), cross(p[0], q[1]) + cross(p[1], q[0]), cross(p[1], q[1])});
    };
    const Vector a = some_point(random, 2), b = some_point(random, 2);
    planes.push_back(line(a, b));
    for (const Vector& end : {a, b}) {
      const bool is_point = kind % 2 == 0;
      kind /= 2;
      corners.push_back(is_point ? of_powers({end - eye, -way, {}})
                                 : meet(planes[0], line(some_point(random, 2), some_point(random, 2))));
    }
  }

  static ProvenVector3<double> of_powers(const std::array<Vector, 3>& powers) {
    ProvenVector3<double> v;
    v.power = powers;
    v.is_linear = square(powers[2]) == 0;
    return v;
  }
};

std::vector<PartVector3> along(const std::vector<ProvenVector3<double>>& vectors, double low, double half) {
  std::vector<PartVector3> result;
  for (const ProvenVector3<double>& vector : vectors) result.emplace_back(vector, low, half);
  return result;
}

// The largest that the formula comes to on the way from the middle to a place, where its roots and its logarithm are
// followed step by step.
double largest_on_way(const PartArcs3& part, Complex to) {
  constexpr int kSteps = 100;
  Complex length_of_n, length_of_b, length_of_e, angle;
  double largest = 0;
  const auto follow = [](Complex& value, Complex root, bool is_first) {
    value = is_first || std::abs(root - value) <= std::abs(root + value) ? root : -root;
  };
  for (int k = 0; k <= kSteps; ++k) {
    const Complex x = to * (k / static_cast<double>(kSteps));
    const auto b = value_of(part.corners[0], x), e = value_of(part.corners[1], x), n = value_of(part.planes[0], x);
    follow(length_of_n, std::sqrt(dot(n, n)), k == 0);
    follow(length_of_b, std::sqrt(dot(b, b)), k == 0);
    follow(length_of_e, std::sqrt(dot(e, e)), k == 0);
    const Complex sine = dot(n, cross(b, e)) / length_of_n, cosine = dot(b, e), i(0, 1);
    Complex found = -i * std::log((cosine + i * sine) / (length_of_b * length_of_e));
    if (k > 0) found += 2 * std::numbers::pi * std::round((angle - found).real() / (2 * std::numbers::pi));
    angle = found;
    const Complex moment = part.moment.x * n.x + part.moment.y * n.y + part.moment.z * n.z;
    largest = std::max(largest, std::abs(0.5 * angle * moment / length_of_n));
  }
  return largest;
}

TEST(Ellipses, HoldWhatArcsComeTo) {
  std::mt19937_64 random(4);
  int close = 0, count = 0;
  for (int k = 0; k < 160; ++k) {
    const SomeArc arc(k, random);
    const double half = between(random, 0.01, 0.5);
    const auto planes = along(arc.planes, 0, half), corners = along(arc.corners, 0, half);
    const PartArcs3 part{arc.arcs, planes, corners, arc.moment, 0, length(arc.moment) * (1 + 1e-15)};
    ArcsOnEllipse3 on;
    on.set(part);
    const double rho = std::min(32.0, 1 + 0.75 * (rho_of(on.reach()) - 1));
    if (rho < 1.3) continue;
    const double bound = on.largest(half_axis_of(rho));
    double largest = 0;
    for (int m = 0; m < 16; ++m) largest = std::max(largest, largest_on_way(part, on_ellipse(rho, m * 0.4)));
    EXPECT_LE(largest, bound);
    ++count;
    close += bound < 100 * largest ? 1 : 0;
  }
  EXPECT_GT(count, 100);
  EXPECT_GT(close, 0.6 * count);
}

// The mean of an arc at nodes, in doubles and in many digits; `off`: what its vectors are off, at most.
void expect_at_nodes(int kind, double off, std::mt19937_64& random) {
  SomeArc arc(kind, random);
  ProvenPiece3<WideReal> wide;
  wide.arcs = arc.arcs;
  const auto widen = [&](std::vector<ProvenVector3<double>>& from, std::vector<ProvenVector3<WideReal>>& to) {
    for (ProvenVector3<double>& v : from) {
      ProvenVector3<WideReal>& exact = to.emplace_back();
      exact.is_linear = v.is_linear;
      for (std::size_t power = 0; power < (v.is_linear ? 2U : 3U); ++power) {
        const Vector p = v.power[power];
        exact.power[power] = {WideReal(p.x), WideReal(p.y), WideReal(p.z)};
        v.power[power] = p + some_point(random, off);
        v.error[power] = off * (1 + 1e-9) + 1e-16;
      }
    }
  };
  widen(arc.planes, wide.planes);
  widen(arc.corners, wide.corners);
  const double low = between(random, 0, 0.5), half = between(random, 0.01, 0.2);
  const auto planes = along(arc.planes, low, half), corners = along(arc.corners, low, half);
  const PartArcs3 part{arc.arcs, planes, corners, arc.moment, 0, length(arc.moment) * (1 + 1e-15)};
  const ProvenMoment3<WideReal> moment{{arc.moment.x, arc.moment.y, arc.moment.z}, 0, part.moment_size};
  const std::vector<signed char> turns{0};
  for (const int nodes : {4, 8, 16, 20}) {
    const auto found = mean_at_nodes_3(part, turns, legendre_rule<double>(nodes));
    const auto exact = mean_at_nodes_3(wide, moment, turns, legendre_rule<WideReal>(nodes), low, low + 2 * half);
    if (!found || !exact || !std::isfinite(exact->rad)) continue;
    EXPECT_LE(exact->rad, 1e-80);
    EXPECT_LE(std::fabs(static_cast<double>(found->mid - exact->mid)), found->rad);
  }
}

TEST(Nodes, HoldWhatTheFormulaIs) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 200; ++k)
    for (const double off : {0.0, 1e-9, 1e-4}) expect_at_nodes(k, off, random);
}

}  // namespace
}  // namespace hottel::ellipses_test

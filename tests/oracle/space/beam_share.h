// What a beam sends into a cone of directions, circle by circle around its axis.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <utility>
#include <vector>

namespace hottel::oracle {

// The part of a beam's power, intensity cos^n t for t <= f, that goes into the directions with m . w > 0 for all m of
// `inward`: the integral over t of the intensity and the length of what of the circle at t is in the cone, over that of
// the whole circle. Between the circles through corners, those that touch a side, and the border of the beam, it is
// smooth but for square roots at the ends, which tanh-sinh quadrature does not mind.
//
// REQUIRES that the cone is convex and less than a half space; Real has the precision that is asked for, and more.
template <class Real>
class BeamShare {
 public:
  using Vector = std::array<Real, 3>;

  BeamShare(const Vector& axis, const Real& half_angle, const Real& falloff) : falloff_(falloff), reach_(half_angle) {
    using std::fabs;
    const Real size = length(axis);
    for (int k = 0; k < 3; ++k) axis_[k] = axis[k] / size;
    const int least = fabs(axis_[0]) < fabs(axis_[1]) ? (fabs(axis_[0]) < fabs(axis_[2]) ? 0 : 2)
                                                      : (fabs(axis_[1]) < fabs(axis_[2]) ? 1 : 2);
    Vector other{0, 0, 0};
    other[least] = 1;
    first_ = cross(axis_, other);
    const Real across = length(first_);
    for (Real& x : first_) x /= across;
    second_ = cross(axis_, first_);
  }

  Real operator()(const std::vector<Vector>& inward, const std::vector<Vector>& corners) const {
    using std::acos, std::asin, std::atan2, std::cos, std::fabs, std::pow, std::sin, std::sqrt;
    const Real pi = boost::math::constants::pi<Real>();
    std::vector<Real> breaks{0, reach_};
    std::vector<Side> sides;
    for (const Vector& m : inward) {
      const Real height = dot(m, axis_), x = dot(m, first_), y = dot(m, second_), across = sqrt(Real(x * x + y * y));
      sides.push_back({height, across, atan2(y, x)});
      const Real touching = atan2(across, -height);  // where the circle is beside the plane, and its mirror image
      breaks.push_back(fabs(Real(touching - pi / 2)));
      breaks.push_back(pi - fabs(Real(touching - pi / 2)));
    }
    for (const Vector& c : corners) breaks.push_back(atan2(length(cross(axis_, c)), dot(axis_, c)));
    std::sort(breaks.begin(), breaks.end());
    const auto density = [&](const Real& t) {
      return falloff_ == 0 ? Real(sin(t)) : Real(pow(std::max<Real>(0, cos(t)), falloff_) * sin(t));
    };
    const auto within = [&](const Real& t) { return Real(density(t) * arc_within(sides, t)); };
    boost::math::quadrature::tanh_sinh<Real> rule(12);
    Real sum = 0;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      if (breaks[k + 1] <= reach_ && breaks[k + 1] - breaks[k] > 1e-15) {
        const Real middle = (breaks[k] + breaks[k + 1]) / 2, half = (breaks[k + 1] - breaks[k]) / 2;
        sum += half * rule.integrate([&](const Real& x) { return within(Real(middle + half * x)); }, Real(-1), Real(1));
      }
    const Real power = falloff_ + 1;
    return sum * power /
           (2 * pi * (1 - (falloff_ == 0 ? Real(cos(reach_)) : Real(pow(std::max<Real>(0, cos(reach_)), power)))));
  }

 private:
  struct Side {
    Real height, across, angle;
  };

  static Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Real length(const Vector& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
  }

  // The length of the angles at which the circle at t is within all sides. Each side leaves one arc of it.
  Real arc_within(const std::vector<Side>& sides, const Real& t) const {
    using std::acos, std::cos, std::floor, std::sin;
    const Real pi = boost::math::constants::pi<Real>();
    std::vector<std::pair<Real, Real>> left{{0, 2 * pi}};
    for (const Side& side : sides) {
      const Real along = side.height * cos(t), across = side.across * sin(t);
      if (along >= across) continue;
      if (along <= -across) return 0;
      const Real half = acos(Real(-along / across));
      Real from = side.angle - half;
      from -= 2 * pi * floor(Real(from / (2 * pi)));
      const Real to = from + 2 * half;
      std::vector<std::pair<Real, Real>> next;
      for (const auto& [a, b] : left)
        for (const Real& shift : {Real(0), Real(-2 * pi)}) {
          const Real low = std::max<Real>(a, from + shift), high = std::min<Real>(b, to + shift);
          if (low < high) next.emplace_back(low, high);
        }
      left = std::move(next);
    }
    Real sum = 0;
    for (const auto& [a, b] : left) sum += b - a;
    return sum;
  }

  Vector axis_, first_, second_;
  Real falloff_, reach_;
};

}  // namespace hottel::oracle

// The sum over the arcs that bound what is seen, in doubles or in more digits. Internal to geometry/space/exchange.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "geometry/space/pieces/arc_angle.h"
#include "geometry/space/vectors/local_vector.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

template <class Real>
using ArcVector3 = std::conditional_t<std::is_same_v<Real, double>, Direction3, LocalVector3<Real>>;

// From one corner to another one, both on a plane.
struct SeenArc3 {
  std::uint32_t plane, begin, end;  // numbers of planes and corners
  double count;
  int turn = 0;  // of arcs of more than a right angle: the sign of the angle, which never passes half a turn
};

// Of a vector that is zero, as it may be at an end of a piece, nothing.
template <class Real>
ArcVector3<Real> unit_or_zero(const ArcVector3<Real>& a) {
  using std::sqrt;
  const Real square = dot(a, a);
  return square > 0 ? Real(1 / sqrt(square)) * a : ArcVector3<Real>{};
}

namespace detail {

// Corners this close to each other are taken by their differences.
inline constexpr double kCloseCorners = 0.25;
// What an angle or a product of unit vectors loses, in units of the vectors.
template <class Real>
inline constexpr double kArcRounding = (std::is_same_v<Real, double> ? 1 : 8) * kRoundoff<Real>;

// x / sin x - 1 by the square of half the chord, q = sin^2 (x / 2) <= kCloseCorners^2: sum of 2 4 .. 2k / (3 5 .. (2k +
// 1)) q^k.
template <class Real>
Real angle_over_sine_less_one(const Real& q) {
  // Of q at the most, a sixteenth, as many powers as there are digits.
  constexpr int kTerms = (std::numeric_limits<Real>::digits + 3) / 4;
  static const std::vector<Real> factors = [] {
    std::vector<Real> result;
    for (int k = 0; k < kTerms; ++k) result.push_back((Real(2 * k) + 2) / (Real(2 * k) + 3));
    return result;
  }();
  Real sum = 1;
  for (int k = kTerms - 1; k > 0; --k) sum = 1 + factors[k] * q * sum;
  return factors[0] * q * sum;
}

// As arc_angle() has it.
template <class Real>
Real angle_of_arc(const Real& sine, const Real& cosine, int turn) {
  if constexpr (std::is_same_v<Real, double>) {
    return arc_angle(sine, cosine, turn);
  } else {
    using std::atan2;
    if (!(cosine < 0 && turn != 0)) return atan2(sine, cosine);
    const Real angle = atan2(Real(turn * sine), cosine);
    return turn * (angle < 0 ? Real(angle + 2 * pi_of<Real>()) : angle);
  }
}

}  // namespace detail

// An arc between unit vectors on a plane with some normal.
template <class Real>
struct ArcShape3 {
  ArcVector3<Real> normal;  // unit
  Real sine, cosine;

  ArcShape3(const ArcVector3<Real>& plane, const ArcVector3<Real>& b, const ArcVector3<Real>& e)
      : normal(unit_or_zero<Real>(plane)), sine(dot(normal, cross(b, e - b))), cosine(dot(b, e)) {}
};

// Half the sum over arcs of angles times unit normals. `at`: the unit vectors of corners; normal_of(plane): a vector at
// right angles to a plane. `rounding`, where it is not null, is raised to what it may have lost, at most.
//
// With unit vectors b and e the angle from b to e about the normal n is signed: atan2 of n . (b x e) and b . e.
// Close to a direction c, as the arcs close and so the sum of c x (e - b) is zero:
//   angle n = (angle / sine) b x e,   b x e = (b - c) x (e - c) + c x (e - b).
template <class Real, class NormalOf>
ArcVector3<Real> sum_of_arcs(const std::vector<SeenArc3>& arcs, const std::vector<ArcVector3<Real>>& at,
                             const NormalOf& normal_of, double* rounding) {
  double spread = 0;
  for (const ArcVector3<Real>& corner : at) {
    const ArcVector3<Real> apart = corner - at.front();
    spread = std::max(spread, static_cast<double>(dot(apart, apart)));
  }
  ArcVector3<Real> sum;
  const bool is_close = spread < detail::kCloseCorners * detail::kCloseCorners;
  if (is_close) {
    const ArcVector3<Real>& c = at.front();
    for (const SeenArc3& arc : arcs) {
      const ArcVector3<Real>&b = at[arc.begin], &e = at[arc.end], way = e - b;
      const Real more = detail::angle_over_sine_less_one<Real>(dot(way, way) / 4);
      sum = sum + Real(arc.count / 2) * (cross(b - c, way) + more * cross(b, way));
    }
  } else {
    for (const SeenArc3& arc : arcs) {
      const ArcShape3<Real> shape(normal_of(arc.plane), at[arc.begin], at[arc.end]);
      const Real angle = detail::angle_of_arc<Real>(shape.sine, shape.cosine, arc.turn);
      sum = sum + Real(arc.count * angle / 2) * shape.normal;
    }
  }
  if (rounding)
    *rounding = std::max(*rounding, detail::kArcRounding<Real> * static_cast<double>(arcs.size()) *
                                        (is_close ? std::sqrt(spread) : 1.0));
  return sum;
}

}  // namespace hottel

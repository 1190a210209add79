#include "geometry/space/visibility/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/space/visibility/beam_arc.h"
#include "kernel/coprime_integers.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr long kFirstPrecision = 128, kLastPrecision = 1 << 12;
constexpr double kLeastCosine = 0x1p-8;  // below it the cosine of vectors in doubles may be off by 2^-44 of itself

Direction3 in_doubles(const IntegerVector& a) {
  const BoundedVector w = rounded(a, bits(a) - 53);
  return unit({w.x, w.y, w.z});
}

// sin^2 of an angle in degrees, where that is rational, from 0 to 90.
std::optional<Rational> rational_sine_squared(const Rational& degrees) {
  if (degrees == 30) return Rational(1, 4);
  if (degrees == 45) return Rational(1, 2);
  if (degrees == 60) return Rational(3, 4);
  if (degrees == 90) return Rational(1);
  return std::nullopt;
}

Ball sine_squared(const Rational& degrees, long precision) {
  const Ball sine = Ball::sine_of_degrees(degrees, precision);
  return sine.times(sine, precision);
}

// 1 - cos f = 2 sin^2 (f / 2)
Ball opening(const Rational& degrees, long precision) {
  const Ball half = sine_squared(degrees / 2, precision);
  return half.plus(half, precision);
}

Ball full_turn(long precision) {
  const Ball pi = Ball::pi(precision);
  return pi.plus(pi, precision);
}

// The solid angle of a cone: what is left of a full turn by the angles between neighbouring planes.
Ball solid_angle(const ExactCone3& cone, long precision) {
  Ball angle = full_turn(precision);
  for (std::size_t k = 0; k < cone.inward.size(); ++k)
    angle = angle.minus(
        angle_between_3(cone.inward[k], cone.inward[k + 1 == cone.inward.size() ? 0 : k + 1], precision), precision);
  return angle;
}

template <class F>
void for_each_arc(const ExactCone3& cone, const F& f) {
  for (std::size_t k = 0; k < cone.inward.size(); ++k)
    f(DirectionArc3{cone.inward[k], cone.corners[k], cone.corners[k + 1 == cone.inward.size() ? 0 : k + 1]});
}

// The point of the great circle of an arc that is nearest to the axis: |m|^2 a - (a . m) m.
IntegerVector nearest_to(const IntegerVector& axis, const DirectionArc3& arc) {
  return difference(multiple(dot(arc.normal, arc.normal), axis), multiple(dot(axis, arc.normal), arc.normal));
}

// Whether that is an inner point of the arc.
bool turns_at_inner_point(const DirectionArc3& arc, const IntegerVector& axis) {
  const IntegerVector forward = cross(arc.normal, axis);
  return dot_sign(forward, arc.from) < 0 && dot_sign(forward, arc.to) > 0;
}

}  // namespace

std::string beam_problem(const Beam3& beam) {
  if (beam.axis.is_zero()) return "the direction is zero";
  if (beam.half_angle <= 0 || beam.half_angle > 180) return "the half angle is not above 0 and at most 180 degrees";
  if (beam.falloff < 0) return "the falloff is negative";
  return "";
}

BeamPower3::BeamPower3(const Beam3& beam) : beam_(beam) {
  HOTTEL_REQUIRE(beam_problem(beam).empty());
  const auto [x, y, z] = coprime_integers<3>({beam.axis.x, beam.axis.y, beam.axis.z});
  const IntegerVector axis{x, y, z};
  const Rational reach = beam.reach();
  is_wide_ = reach > 90;
  if (is_wide_)
    narrow_ = {opposite(axis), 180 - reach, 0};
  else
    narrow_ = {axis, reach, beam.falloff};
  narrow_.middle = in_doubles(narrow_.axis);
  if (!beam.is_even()) {
    narrow_.cosine = Ball::sine_of_degrees(90 - narrow_.half_angle, kFirstPrecision).bounds().lower;
    narrow_.sine_squared = sine_squared(narrow_.half_angle, kFirstPrecision);
  }
  axis_ = in_doubles(axis);
  exponent_ = to_double(beam.falloff);
  const double one_minus_cosine = opening(reach, kFirstPrecision).bounds().upper;
  const double rest = is_wide_ || reach == 90 || beam.falloff == 0
                          ? one_minus_cosine
                          : -same_bits::expm1((exponent_ + 1) * same_bits::log1p(-one_minus_cosine));
  axial_ = (exponent_ + 1) / (2 * std::numbers::pi * rest);
}

int BeamPower3::Narrow::side(const IntegerVector& direction) const {
  constexpr double kFiltered = 1e-13;
  const double guess = dot(middle, in_doubles(direction)) - cosine;
  if (std::fabs(guess) > kFiltered) return guess > 0 ? 1 : -1;
  const int height = dot_sign(axis, direction);
  if (half_angle == 90 || height < 0) return height;
  // sin^2 f |a|^2 |w|^2 - |a x w|^2
  const IntegerVector turn = cross(axis, direction);
  const Rational sizes = Rational(dot(axis, axis) * dot(direction, direction)), of_turn = Rational(dot(turn, turn));
  if (height == 0) return -1;
  if (const auto square = rational_sine_squared(half_angle)) return sgn(Rational(*square * sizes - of_turn));
  for (long precision = kFirstPrecision;; precision *= 2) {
    const Ball square = precision == kFirstPrecision ? sine_squared : hottel::sine_squared(half_angle, precision);
    const Ball product = square.times(Ball::of(sizes, 2 * precision), precision);
    if (const int sign = product.minus(Ball::of(of_turn, 2 * precision), precision).sign(); sign != 0) return sign;
  }
}

int BeamPower3::side(const IntegerVector& direction) const {
  if (beam_.is_even()) return 1;
  return is_wide_ ? -narrow_.side(direction) : narrow_.side(direction);
}

// A beam of at most 90 degrees is convex: a cone with all corners in it is in it, and one without a corner in it meets
// it only through an edge that comes nearest to the axis at an inner point, or around the axis.
BeamPower3::Meets BeamPower3::meeting(const Narrow& beam, const ExactCone3& cone) {
  bool is_all_within = true;
  for (const IntegerVector& corner : cone.corners) is_all_within &= beam.side(corner) >= 0;
  if (is_all_within) return Meets::kAll;
  bool meets = cone.locate(beam.axis).place != ExactCone3::Place::kOutside;
  for (std::size_t k = 0; k < cone.corners.size() && !meets; ++k) meets = beam.side(cone.corners[k]) > 0;
  if (meets || beam.half_angle == 90) return meets ? Meets::kPart : Meets::kNothing;
  for_each_arc(cone, [&](const DirectionArc3& arc) {
    if (meets || !turns_at_inner_point(arc, beam.axis)) return;
    meets = beam.side(nearest_to(beam.axis, arc)) > 0;
  });
  return meets ? Meets::kPart : Meets::kNothing;
}

Ball BeamPower3::share_at(const Narrow& beam, const ExactCone3& cone, Meets meets, long precision) {
  if (meets == Meets::kNothing) return {};
  if (meets == Meets::kAll && beam.falloff == 0)
    return solid_angle(cone, precision)
        .over(full_turn(precision).times(opening(beam.half_angle, precision), precision), precision);
  const BeamArcs3 arcs(beam.axis, beam.half_angle, beam.falloff, precision);
  Ball sum;
  if (meets == Meets::kAll) {
    for_each_arc(cone, [&](const DirectionArc3& arc) { sum = sum.plus(arcs.within(arc), precision); });
    return sum.over(full_turn(precision), precision);
  }
  for_each_arc(cone, [&](const DirectionArc3& arc) {
    if (beam.side(arc.from) > 0 || beam.side(arc.to) > 0 ||
        (beam.half_angle < 90 && turns_at_inner_point(arc, beam.axis) && beam.side(nearest_to(beam.axis, arc)) > 0))
      sum = sum.plus(arcs.entering(arc), precision);
  });
  const ExactCone3::Located axis = cone.locate(beam.axis);
  const std::size_t count = cone.inward.size();
  const Ball turn = full_turn(precision);
  switch (axis.place) {
    case ExactCone3::Place::kOutside:
      break;
    case ExactCone3::Place::kInside:
      sum = sum.plus(turn, precision);
      break;
    case ExactCone3::Place::kOnEdge:
      sum = sum.plus(Ball::pi(precision), precision);
      break;
    case ExactCone3::Place::kAtCorner:
      sum = sum.plus(
          angle_between_3(cone.inward[(axis.side + count - 1) % count], opposite(cone.inward[axis.side]), precision),
          precision);
      break;
  }
  return sum.over(turn, precision);
}

// True only where the share of the cone is below 2^-960, as it is where the falloff is large and all of the cone is far
// from the axis: then no digits are needed to know all that doubles tell. What leaves beyond the angle t is
// (cos^k t - cos^k f) / (1 - cos^k f), and so at most cos^k t, k = n + 1.
bool BeamPower3::is_far_below_doubles(const ExactCone3& cone) const {
  if (beam_.falloff < 1 || cone.locate(narrow_.axis).place != ExactCone3::Place::kOutside) return false;
  double most = 0;  // cosine of what is nearest to the axis: of a corner, or of the nearest point of a side
  for_each_arc(cone, [&](const DirectionArc3& arc) {
    most = std::max(most, dot(axis_, in_doubles(arc.from)));
    if (turns_at_inner_point(arc, narrow_.axis))
      most = std::max(most, dot(axis_, in_doubles(nearest_to(narrow_.axis, arc))));
  });
  constexpr double kError = 1e-14;
  return (exponent_ + 1) * same_bits::log2(most + kError) < -970;
}

Ball BeamPower3::share(const ExactCone3& cone, long digits) const {
  const auto refined = [digits](const auto& at) {
    Ball result;
    for (long precision = std::max(kFirstPrecision, 2 * digits); precision <= kLastPrecision; precision *= 2) {
      result = at(precision);
      if (result.sign() > 0 && result.is_relatively_narrow(digits)) break;
    }
    return result;
  };
  if (beam_.is_even())
    return refined([&](long p) { return solid_angle(cone, p).over(full_turn(p).plus(full_turn(p), p), p); });
  const Meets meets = meeting(narrow_, cone);
  if (meets == (is_wide_ ? Meets::kAll : Meets::kNothing)) return {};
  if (is_far_below_doubles(cone)) return Ball::up_to_power_of_two(-960);
  if (!is_wide_) return refined([&](long p) { return share_at(narrow_, cone, meets, p); });
  // Of all directions, those around the opposite axis left out: 1 - cos f is 1 + the cosine of what is left out.
  return refined([&](long p) {
    const Ball left_out = share_at(narrow_, cone, meets, p).times(opening(narrow_.half_angle, p), p);
    return solid_angle(cone, p).over(full_turn(p), p).minus(left_out, p).over(opening(beam_.half_angle, p), p);
  });
}

BeamPower3::Meets BeamPower3::meets(const ExactCone3& cone) const {
  if (beam_.is_even()) return Meets::kAll;
  const Meets meets = meeting(narrow_, cone);
  if (!is_wide_ || meets == Meets::kPart) return meets;
  return meets == Meets::kAll ? Meets::kNothing : Meets::kAll;
}

double BeamPower3::intensity(const IntegerVector& direction) const {
  return side(direction) < 0 ? 0 : uncut_intensity(direction);
}

double BeamPower3::uncut_intensity(const IntegerVector& direction) const {
  if (beam_.falloff == 0) return axial_;
  if (dot_sign(narrow_.axis, direction) <= 0) return 0;  // not wide: there is a falloff
  const double cosine = dot(axis_, in_doubles(direction));
  if (cosine > kLeastCosine) return axial_ * same_bits::pow(cosine, exponent_);
  const auto number = [](const Integer& value) { return Ball::of(Rational(value), kFirstPrecision); };
  const Integer squares = dot(narrow_.axis, narrow_.axis) * dot(direction, direction);
  const Ball height =
      number(dot(narrow_.axis, direction)).over(number(squares).square_root(kFirstPrecision), kFirstPrecision);
  return axial_ * height.power(beam_.falloff, kFirstPrecision).nearest_of_ends().lower;
}

}  // namespace hottel

#include "geometry/space/visibility/beam_arc.h"

#include <optional>
#include <utility>
#include <vector>

#include "geometry/space/visibility/cosine_quadrature.h"
#include "kernel/ball_number.h"
#include "kernel/real_ball.h"

namespace hottel {
namespace {

// The most that falloff + 1 may be for sums of powers.
constexpr long kMostTerms = 1001;

struct Turn {
  explicit Turn(const Real& angle) : sine(angle.precision()), cosine(angle.precision()) {
    arb_sin_cos(sine.x, cosine.x, angle.x, angle.precision());
  }
  Real sine, cosine;
};

// Angles from low to high, low <= high.
struct Range {
  Real low, high;
  bool is_empty = false;  // true only where they are one

  Real length() const { return high - low; }
  // What of them is from `from` to `to`.
  Range within(const Real& from, const Real& to) const {
    Range result{larger(low, from), smaller(high, to)};
    result.is_empty = arb_is_nonpositive(result.length().x) != 0;
    result.high = larger(result.low, result.high);
    return result;
  }
};

// s and c0 of an arc.
struct Course {
  Real s, c0;
};

}  // namespace

struct BeamArcs3::State {
  IntegerVector axis;
  Rational power;  // n + 1
  long precision;
  long terms = 0;  // n + 1 where it is whole and not too large
  bool is_right = false;
  Real axis_length, sine, cosine;  // of f
  Real power_ball, beyond;         // 1 - cos^(n + 1) f

  State(const IntegerVector& axis_, const Rational& half_angle, const Rational& falloff, long p)
      : axis(axis_),
        power(falloff + 1),
        precision(p),
        axis_length(root(Real(dot(axis_, axis_), p))),
        sine(p),
        cosine(p),
        power_ball(p),
        beyond(p) {
    if (power.get_den() == 1 && power <= kMostTerms) terms = power.get_num().get_si();
    is_right = half_angle == 90;
    arb_swap(sine.x, Ball::sine_of_degrees(half_angle, p).number().x);
    arb_swap(cosine.x, Ball::sine_of_degrees(90 - half_angle, p).number().x);
    arb_set(power_ball.x, Ball::of(power, p).number().x);
    if (is_right) {
      arb_one(beyond.x);
      return;
    }
    // k log cos f = k/2 log(1 - sin^2 f)
    Real logarithm = -(sine * sine);
    arb_log1p(logarithm.x, logarithm.x, p);
    logarithm = over(logarithm * power_ball, 2);
    arb_expm1(beyond.x, logarithm.x, p);
    beyond = -beyond;
  }

  Real number(const Integer& value) const { return Real(value, precision); }
  Real pi() const {
    Real result(precision);
    arb_const_pi(result.x, precision);
    return result;
  }

  // The angles of the ends of an arc from the point of its great circle that is nearest to the axis: the first is in
  // (-pi, pi], the second is less than pi larger. Where all of the great circle is as far, from 0.
  Range angles(const DirectionArc3& arc, const Real& normal_length) const {
    const Integer volume = dot(arc.normal, cross(arc.from, arc.to));
    const Real length = angle_of(number(volume), normal_length * number(dot(arc.from, arc.to)));
    const IntegerVector forward = cross(arc.normal, axis);
    if (is_zero(forward)) return {Real(precision), length};
    Real first = angle_of(number(dot(forward, arc.from)), normal_length * number(dot(axis, arc.from)));
    Real last = first + length;
    return {std::move(first), std::move(last)};
  }

  Course course(const DirectionArc3& arc, const Real& normal_length) const {
    const IntegerVector turn = cross(axis, arc.normal);
    const Real both = normal_length * axis_length;
    return {number(dot(axis, arc.normal)) / both, root(number(dot(turn, turn))) / both};
  }

  // The integral of dphi. The points p and q of both angles have a . (p x q) = s sin(v - u) and
  // p . q - (a . p) (a . q) = sin u sin v + s^2 cos u cos v.
  Real turning(const Course& course, const Range& range) const {
    const Turn u(range.low), v(range.high), between(range.length());
    return angle_of(course.s * between.sine, u.sine * v.sine + course.s * course.s * u.cosine * v.cosine);
  }

  // The integral of s / (1 + c) du; its antiderivative goes on through u = pi.
  Real half_power(const Course& course, const Range& range) const {
    Real one(precision);
    arb_one(one.x);
    const auto antiderivative = [&](const Real& u) {
      const Turn half(over(u, 2));
      return times(angle_of(course.s * half.sine, (one + course.c0) * half.cosine), 2);
    };
    return antiderivative(range.high) - antiderivative(range.low);
  }

  // The integral of s (1 - c^k) / (1 - c^2) du for whole k:
  //   k even: the sum of s c^j for even j < k;   k odd: s / (1 + c), and the sum of s c^j for odd j < k
  // where j times the integral of cos^j is cos^(j-1) sin between its ends, and j - 1 times that of cos^(j-2).
  Real whole_power(const Course& course, const Range& range) const {
    const Turn u(range.low), v(range.high);
    const bool is_odd = terms % 2 == 1;
    Real sum(precision);
    const Real square = course.c0 * course.c0, u_square = u.cosine * u.cosine, v_square = v.cosine * v.cosine;
    Real power_of_c0(precision), u_part(precision), v_part(precision), integral(precision);
    arb_one(power_of_c0.x);
    if (is_odd) {  // j = 1
      power_of_c0 = course.c0;
      integral = v.sine - u.sine;
      u_part = u_square * u.sine;  // cos^(j+1) sin
      v_part = v_square * v.sine;
    } else {  // j = 0
      integral = range.length();
      u_part = u.cosine * u.sine;
      v_part = v.cosine * v.sine;
    }
    for (long j = is_odd ? 1 : 0; j < terms; j += 2) {
      sum = sum + power_of_c0 * integral;
      power_of_c0 = power_of_c0 * square;
      integral = over(v_part - u_part + times(integral, j + 1), j + 2);
      u_part = u_part * u_square;
      v_part = v_part * v_square;
    }
    sum = sum * course.s;
    return is_odd ? sum + half_power(course, range) : sum;
  }

  // The same for any k where all angles are from -pi/3 to pi/3.
  Real inner_power(const Course& course, const Range& range) const {
    return course.s * integral_of_power_ratio_3(course.c0, power_ball, range.low, range.high);
  }

  // cos^p for the cosine of an angle from 0 to pi/2, as which rounding may have made it negative.
  Real cosine_power(const Real& base, const Real& exponent) const {
    Real result(precision);
    if (arb_is_positive(base.x)) {
      arb_pow(result.x, base.x, exponent.x, precision);
      return result;
    }
    Real top(precision);
    arb_get_ubound_arf(arb_midref(top.x), base.x, precision);
    arb_pow(top.x, top.x, exponent.x, precision);
    return hull_with_zero(top);
  }

  static Real hull_with_zero(const Real& top) {
    Real result = over(top, 2);
    mag_t size;
    mag_init(size);
    arb_get_mag(size, result.x);
    arb_add_error_mag(result.x, size);
    mag_clear(size);
    return result;
  }

  // The same for any k where all angles are from pi/3 to pi/2: that of dphi less that of s times c^k + c^(k+2) + ...
  // The integrals of cos^j of two neighbours j are known from each other; downward what is not known of the first one
  // is forgotten, for it is below 2^-j.
  Real outer_power(const Course& course, const Range& range) const {
    const long count = precision / 2 + 8;
    Turn u(range.low), v(range.high);
    const auto exponent = [this](long more) { return power_ball + number(Integer(more)); };
    std::vector<Real> boundary;  // cos^(j-1) sin between the ends, for j = k + 2, k + 4, ...
    Real at_u = cosine_power(u.cosine, exponent(1)), at_v = cosine_power(v.cosine, exponent(1));
    for (long i = 0; i < count; ++i) {
      boundary.push_back(at_v * v.sine - at_u * u.sine);
      at_u = at_u * u.cosine * u.cosine;
      at_v = at_v * v.cosine * v.cosine;
    }
    Real half(precision);
    arb_set_d(half.x, 0.5);
    Real integral = hull_with_zero(cosine_power(half, exponent(2 * count)) * range.length());
    // What is left out of the sum, c0^j times the integral of cos^j for j = k + 2 count and on, is below 4/3 of the
    // first one's bound, and so below twice the integral's.
    Real sum = times(integral, 2);
    const Real square = course.c0 * course.c0;
    // sum := the integral of cos^j, and c0^2 times that before.
    for (long i = count - 1; i >= 0; --i) {
      const Real j = exponent(2 * i + 2);
      Real one(precision);
      arb_one(one.x);
      integral = (j * integral - boundary[static_cast<std::size_t>(i)]) / (j - one);
      sum = integral + square * sum;
    }
    return turning(course, range) - course.s * cosine_power(course.c0, power_ball) * sum;
  }

  // c^k is next to nothing from 2^-least_digits() on: below what a ball of this precision tells beside 1.
  long least_digits() const { return precision + 16; }

  // The integral of s (1 - c^k) / (1 - c^2) du where c^k is next to nothing: that of dphi.
  Real far_power(const Course& course, const Range& range) const {
    Real factor(precision);
    arb_one(factor.x);
    arb_add_error_2exp_si(factor.x, -least_digits());
    return turning(course, range) * factor;
  }

  // An angle u, exactly, beyond which c^k is next to nothing; c is c0 cos u. Nothing where u is not below pi/3, as for
  // small k.
  std::optional<Real> reach(const Course& course, const Real& third) const {
    Real least(precision), angle(precision);  // 2^(-digits / k)
    arb_const_log2(least.x, precision);
    least = -times(least, least_digits()) / power_ball;
    arb_exp(least.x, least.x, precision);
    if (arb_lt(course.c0.x, least.x)) return angle;
    const Real ratio = least / course.c0;
    arb_acos(angle.x, ratio.x, precision);
    if (!arb_is_finite(angle.x) || !arb_lt(angle.x, third.x)) return std::nullopt;
    arb_get_ubound_arf(arb_midref(angle.x), angle.x, precision);
    mag_zero(arb_radref(angle.x));
    return angle;
  }

  // The integral of s (1 - c^k) / (1 - c^2) du over angles from -pi/2 to pi/2.
  Real real_power(const Course& course, const Range& range) const {
    if (arb_is_zero(course.c0.x)) return course.s * range.length();
    const Real third = over(pi(), 3), quarter_turn = over(pi(), 2);
    Real result(precision);
    if (const auto near = reach(course, third)) {
      if (const Range inner = range.within(-*near, *near); !inner.is_empty) result = inner_power(course, inner);
      for (const Range& half : {range, Range{-range.high, -range.low}})
        if (const Range outer = half.within(*near, quarter_turn); !outer.is_empty)
          result = result + far_power(course, outer);
      return result;
    }
    if (const Range inner = range.within(-third, third); !inner.is_empty) result = inner_power(course, inner);
    if (const Range outer = range.within(third, quarter_turn); !outer.is_empty)
      result = result + outer_power(course, outer);
    const Range mirrored{-range.high, -range.low};
    if (const Range outer = mirrored.within(third, quarter_turn); !outer.is_empty)
      result = result + outer_power(course, outer);
    return result;
  }

  Real integral(const Course& course, const Range& range) const {
    return (terms > 0 ? whole_power(course, range) : real_power(course, range)) / beyond;
  }
};

BeamArcs3::BeamArcs3(const IntegerVector& axis, const Rational& half_angle, const Rational& falloff, long precision) {
  return_flint_memory_at_thread_end();
  state_ = std::make_unique<State>(axis, half_angle, falloff, precision);
}
BeamArcs3::BeamArcs3(BeamArcs3&&) noexcept = default;
BeamArcs3::~BeamArcs3() = default;

namespace {

Ball to_ball(Real& value) {
  Ball result;
  arb_swap(result.number().x, value.x);
  return result;
}

}  // namespace

Ball BeamArcs3::within(const DirectionArc3& arc) const {
  const State& state = *state_;
  if (dot_sign(state.axis, arc.normal) == 0) return {};
  const Real normal_length = root(state.number(dot(arc.normal, arc.normal)));
  Real result = state.integral(state.course(arc, normal_length), state.angles(arc, normal_length));
  return to_ball(result);
}

Ball BeamArcs3::entering(const DirectionArc3& arc) const {
  const State& state = *state_;
  if (dot_sign(state.axis, arc.normal) == 0) return {};
  const Real normal_length = root(state.number(dot(arc.normal, arc.normal)));
  const Course course = state.course(arc, normal_length);
  const Range range = state.angles(arc, normal_length);
  // cos u0 = cos f / c0
  const Real half = angle_of(root(state.sine * state.sine - course.s * course.s), state.cosine);
  Real result(state.precision), middle(state.precision);
  for (int turn = 0; turn < 2; ++turn) {
    const Range inside = range.within(middle - half, middle + half);
    if (!inside.is_empty) {
      const Range moved{inside.low - middle, inside.high - middle};
      result = result + state.integral(course, moved) - state.turning(course, moved);
    }
    middle = times(state.pi(), 2);
  }
  return to_ball(result);
}

Ball angle_between_3(const IntegerVector& a, const IntegerVector& b, long precision) {
  return_flint_memory_at_thread_end();
  const IntegerVector turn = cross(a, b);
  Real result = angle_of(root(Real(dot(turn, turn), precision)), Real(dot(a, b), precision));
  return to_ball(result);
}

}  // namespace hottel

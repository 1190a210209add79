#include "solver/plane/light/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "kernel/coprime_integers.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr long kFirstPrecision = 128, kMostPrecision = 1 << 20;

Ball radians(const Rational& degrees, long precision) {
  return Ball::pi(precision).times(Ball::of(Rational(degrees / 180), precision), precision);
}

// The sign of a ball of growing precision. REQUIRES a number that is not 0.
template <class Make>
int sign_of(const Make& make) {
  for (long precision = kFirstPrecision; precision <= kMostPrecision; precision *= 2)
    if (const int sign = make(precision).sign(); sign != 0) return sign;
  throw RequestError("the direction of a light cannot be told from the border of its beam");
}

Point2 coprime(const Point2& direction) {
  const auto [x, y] = coprime_integers<2>({direction.x, direction.y});
  return {Rational(x), Rational(y)};
}

// A direction of any length in doubles, the larger of which is 1.
std::pair<double, double> in_doubles(const Point2& direction) {
  const Rational size = std::max<Rational>(abs(direction.x), abs(direction.y));
  return {to_double(direction.x / size), to_double(direction.y / size)};
}

// The angle of (cosine, sine) in degrees, in (-180, 180], where it is a multiple of 45.
std::optional<int> eighth(const Rational& cosine, const Rational& sine) {
  if (sine == 0) return cosine > 0 ? 0 : 180;
  if (cosine == 0) return sine > 0 ? 90 : -90;
  if (abs(sine) != abs(cosine)) return std::nullopt;
  const int size = cosine > 0 ? 45 : 135;
  return sine > 0 ? size : -size;
}

// The number of degrees in (-180, 180] that is the same angle.
Rational reduced(const Rational& degrees) {
  const Rational turns = (180 - degrees) / 360;
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), turns.get_num_mpz_t(), turns.get_den_mpz_t());
  return degrees + 360 * Rational(whole);
}

}  // namespace

Beam2::Beam2(const Light& light, const LightPlace2& place)
    : direction_(light.type == LightType::kSpot ? coprime(place.direction) : Point2{1, 0}),
      turned_(reduced(place.turned)),
      half_angle_(light.half_angle()),
      falloff_(light.falloff),
      is_round_(light.is_round()) {
  std::tie(x_, y_) = in_doubles(direction_);
  falloff_in_doubles_ = to_double(falloff_);
  half_in_radians_ = to_double(half_angle_) / 180 * std::numbers::pi;
  turned_in_radians_ = to_double(turned_) / 180 * std::numbers::pi;
  peak_ = 0.5 / border_power(kFirstPrecision).nearest_of_ends().lower;
}

// From the direction that is not turned, in (-pi, pi].
Ball Beam2::raw_angle(const Point2& direction, long precision) const {
  return Ball::atan2(Ball::of(cross(direction_, direction), precision), Ball::of(dot(direction_, direction), precision),
                     precision);
}

// The sign of the raw angle less so many degrees, exactly.
int Beam2::compare(const Point2& direction, const Rational& degrees) const {
  if (degrees <= -180) return 1;
  if (degrees > 180) return -1;
  const Rational cosine = dot(direction_, direction), sine = cross(direction_, direction);
  if (const auto known = eighth(cosine, sine)) return sgn(Rational(*known - degrees));
  double along = to_double(cosine), across = to_double(sine);
  if (const double size = std::max(std::fabs(along), std::fabs(across)); !(size > kLeastSize && size < 1 / kLeastSize))
    std::tie(along, across) = in_doubles({cosine, sine});
  const double angle = same_bits::atan2(across, along) * 180 / std::numbers::pi;
  if (const double rest = angle - to_double(degrees); std::fabs(rest) > 1e-9) return rest > 0 ? 1 : -1;
  return sign_of(
      [&](long precision) { return raw_angle(direction, precision).minus(radians(degrees, precision), precision); });
}

// How many turns to add to the raw angle less what the axis is turned, so that it lies in (-180, 180].
int Beam2::turns_to_add(const Point2& direction) const {
  if (turned_ == 0) return 0;
  if (compare(direction, turned_ + 180) > 0) return -1;
  return compare(direction, turned_ - 180) <= 0 ? 1 : 0;
}

// From the axis, in (-pi, pi].
Ball Beam2::angle(const Point2& direction, long precision) const {
  const Ball raw = raw_angle(direction, precision);
  if (turned_ == 0) return raw;
  return raw.minus(radians(turned_ - 360 * turns_to_add(direction), precision), precision);
}

Beam2::Side Beam2::side(const Point2& direction) const {
  if (half_angle_ == 180) return Side::kInside;
  const Rational shift = turned_ - 360 * turns_to_add(direction);
  if (compare(direction, shift - half_angle_) < 0) return Side::kBelow;
  return compare(direction, shift + half_angle_) > 0 ? Side::kAbove : Side::kInside;
}

// True iff one passes the opposite of the axis, strictly or to arrive there, on the way counter-clockwise: then the
// angle of `to` is not above that of `from`, as (-180, 180] has it.
bool Beam2::passes_behind(const Point2& from, const Point2& to) const {
  return sign_of([&](long precision) { return angle(to, precision).minus(angle(from, precision), precision); }) < 0;
}

Ball Beam2::border_power(long precision) const {
  if (falloff_ > 0 && half_angle_ == 90) return Ball::whole_cosine_power(falloff_, precision);
  return Ball::cosine_power(radians(half_angle_, precision), falloff_, precision);
}

// The integral of cos^n from the axis to a direction, or to the border beyond which it lies.
Ball Beam2::power_up_to(const Point2& direction, Side side, long precision) const {
  if (side == Side::kInside) return Ball::cosine_power(angle(direction, precision), falloff_, precision);
  const Ball border = border_power(precision);
  return side == Side::kAbove ? border : Ball().minus(border, precision);
}

// True only where the share is below 2^-960, as it is where the falloff is large and all directions are far from the
// axis: then no digits are needed to know all that doubles tell. Let t be the angle of the nearest direction, and
// T = 1 / sqrt(n). As log cos t <= -t^2 / 2 what is sent out is at most pi exp(-n t^2 / 2); and for n >= 1 half the
// beam is at least min(f, T) cos(1), as cos^n T grows with n. Where f < T, n t^2 is below 1.
bool Beam2::is_far_below_doubles(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const {
  if (falloff_ < 1) return false;
  // The angles that directions in the beam may have: from where they begin, and from the border where they are beyond.
  const auto angle_in = [&](const Point2& direction, Side side) {
    return side == Side::kInside ? angle(direction, kFirstPrecision).nearest_of_ends().lower
                                 : static_cast<int>(side) * half_in_radians_;
  };
  const double a = angle_in(from, first), b = angle_in(to, last);
  const bool holds_axis = is_behind ? a <= 0 || b >= 0 : a <= 0 && b >= 0;
  if (holds_axis) return false;
  const double nearest = std::min(std::fabs(a), std::fabs(b)), n = falloff_in_doubles_;
  const double most = same_bits::log2(n) / 2 - n * nearest * nearest / (2 * std::numbers::ln2);  // and log2(3) more
  return most < -970;
}

Enclosure Beam2::share(const Point2& from, const Point2& to) const {
  const Side first = side(from), last = side(to);
  const bool is_behind = passes_behind(from, to);
  if (is_dark(from, to, first, last, is_behind)) return {0, 0};
  if (is_far_below_doubles(from, to, first, last, is_behind)) return {0, 0x1p-961};
  for (long precision = kFirstPrecision;; precision *= 2) {
    const Ball border = border_power(precision);
    Ball power = power_up_to(to, last, precision).minus(power_up_to(from, first, precision), precision);
    if (is_behind) power = power.plus(border.plus(border, precision), precision);
    const Enclosure bounds = power.over(border.plus(border, precision), precision).bounds();
    if (bounds.upper < 0x1p-960) return {std::max(bounds.lower, 0.0), bounds.upper};  // doubles tell no more
    if (bounds.lower > 0 && bounds.width() <= 0x1p-50 * bounds.lower) return bounds;
    if (precision > kMostPrecision) throw RequestError("the power of a light between two directions cannot be told");
  }
}

Beam2::Meets Beam2::meets(const Point2& from, const Point2& to) const {
  if (half_angle_ == 180) return Meets::kAll;
  const Side first = side(from), last = side(to);
  const bool is_behind = passes_behind(from, to);
  if (is_dark(from, to, first, last, is_behind)) return Meets::kNothing;
  return first == Side::kInside && last == Side::kInside && !is_behind ? Meets::kAll : Meets::kPart;
}

// True where nothing of the beam but a border is among the directions.
bool Beam2::is_dark(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const {
  // All of the beam but what is between them, where the way leads past its back.
  const bool is_beyond =
      is_behind ? first == Side::kAbove && last == Side::kBelow : first == last && first != Side::kInside;
  return is_beyond || touches_only(from, to, first, last, is_behind);
}

// True where only a border of the beam is among the directions.
bool Beam2::touches_only(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const {
  if (half_angle_ == 180) return false;
  const auto is_at = [&](const Point2& direction, const Rational& degrees) {
    return compare(direction, turned_ - 360 * turns_to_add(direction) + degrees) == 0;
  };
  const bool leaves_at_once = first == Side::kInside && is_at(from, half_angle_);
  const bool arrives_last = last == Side::kInside && is_at(to, -half_angle_);
  if (is_behind) return (leaves_at_once || first == Side::kAbove) && (arrives_last || last == Side::kBelow);
  return (leaves_at_once && last == Side::kAbove) || (arrives_last && first == Side::kBelow);
}

bool Beam2::contains(const Point2& direction) const { return is_round_ || side(direction) == Side::kInside; }

// Of the angle from the axis: the cosine of the raw angle less what the axis is turned.
Ball Beam2::cosine(const Point2& direction, long precision) const {
  const Rational along = dot(direction_, direction), across = cross(direction_, direction);
  const auto part = [&](const Rational& value, const Rational& degrees) {
    return Ball::of(value, precision).times(Ball::sine_of_degrees(degrees, precision), precision);
  };
  const Rational squares = dot(direction_, direction_) * dot(direction, direction);
  return part(along, 90 - turned_)
      .plus(part(across, turned_), precision)
      .over(Ball::of(squares, precision).square_root(precision), precision);
}

double Beam2::uncut_intensity(const Point2& direction) const {
  if (falloff_ == 0) return peak_;
  const Rational axis = turned_ - 360 * turns_to_add(direction);
  if (compare(direction, axis - 90) <= 0 || compare(direction, axis + 90) >= 0) return 0;
  const auto [x, y] = in_doubles(direction);
  if (const double t = angle_in_doubles(x, y); !is_near_right_angle(t))
    return peak_ * same_bits::pow(same_bits::cos(t), falloff_in_doubles_);
  for (long precision = kFirstPrecision;; precision *= 2)
    if (const Ball height = cosine(direction, precision); height.sign() > 0 && height.is_relatively_narrow(100))
      return peak_ * height.power(falloff_, precision).nearest_of_ends().lower;
}

double Beam2::angle_in_doubles(double x, double y) const {
  const double angle = same_bits::atan2(x_ * y - y_ * x, x_ * x + y_ * y);
  return std::remainder(angle - turned_in_radians_, 2 * std::numbers::pi);
}

}  // namespace hottel

#include "solver/plane/light/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr long kFirstPrecision = 128, kMostPrecision = 1 << 20;

Rational cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }

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
    : direction_(light.type == LightType::kSpot ? place.direction : Point2{1, 0}),
      turned_(reduced(place.turned)),
      half_angle_(light.half_angle()),
      falloff_(light.falloff),
      is_round_(light.is_round()) {
  const Rational size = std::max<Rational>(abs(direction_.x), abs(direction_.y));
  x_ = to_double(direction_.x / size);
  y_ = to_double(direction_.y / size);
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
  const double angle = std::atan2(to_double(sine), to_double(cosine)) * 180 / std::numbers::pi;
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

Enclosure Beam2::share(const Point2& from, const Point2& to) const {
  const Side first = side(from), last = side(to);
  const bool is_behind = passes_behind(from, to);
  if (is_dark(from, to, first, last, is_behind)) return {0, 0};
  for (long precision = kFirstPrecision;; precision *= 2) {
    const Ball border = border_power(precision);
    Ball power = power_up_to(to, last, precision).minus(power_up_to(from, first, precision), precision);
    if (is_behind) power = power.plus(border.plus(border, precision), precision);
    const Enclosure bounds = power.over(border.plus(border, precision), precision).bounds();
    const bool is_least = bounds.lower >= 0 && bounds.upper < 0x1p-960;  // doubles tell no more
    if (is_least || (bounds.lower > 0 && bounds.width() <= 0x1p-50 * bounds.lower)) return bounds;
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

double Beam2::uncut_intensity(const Point2& direction) const {
  if (falloff_ == 0) return peak_;
  const Rational axis = turned_ - 360 * turns_to_add(direction);
  if (compare(direction, axis - 90) <= 0 || compare(direction, axis + 90) >= 0) return 0;
  const Rational size = std::max<Rational>(abs(direction.x), abs(direction.y));
  const double cosine = std::cos(angle_in_doubles(to_double(direction.x / size), to_double(direction.y / size)));
  return peak_ * std::pow(std::max(cosine, 0.0), falloff_in_doubles_);
}

double Beam2::angle_in_doubles(double x, double y) const {
  const double angle = std::atan2(x_ * y - y_ * x, x_ * x + y_ * y);
  return std::remainder(angle - turned_in_radians_, 2 * std::numbers::pi);
}

}  // namespace hottel

// Normals and directions that are good to the last digit all along a piece (MovingPlanes3).
#include <algorithm>
#include <cmath>

#include "geometry/space/exchange/moving_planes.h"

namespace hottel {
namespace {

constexpr double kUnit = 0x1p-53;
// Relative error from which a normal or a direction is made from integers.
constexpr double kIllConditioned = 1e-13;

double to_double(const Integer& value, long shift) {
  long exponent;
  const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t());
  return ldexp_3(mantissa, exponent - shift);
}

Direction3 to_doubles(const IntegerVector& a, long shift) {
  return {to_double(a.x, shift), to_double(a.y, shift), to_double(a.z, shift)};
}

}  // namespace

bool MovingPlanes3::is_fine(const MovingVector3& vector, double low, double high) const {
  const double s = shortest_between(vector, low - t_, high - t_);
  const Direction3 d = value_at(vector, s);
  const double lost =
      vector.first.error +
      32 * kUnit * (vector.terms[0] + std::fabs(s) * (vector.terms[1] + std::fabs(s) * vector.terms[2]));
  return lost <= kIllConditioned * size_of(d);
}

MovingVector3 MovingPlanes3::rounded_polynomial(const ExactPolynomial& exact, double low, double high) const {
  const auto& powers = exact.powers;
  const long top = std::max({bits(powers[0]), bits(powers[1]), bits(powers[2])});
  MovingVector3 result{rounded(powers[0], top - 53), to_doubles(powers[1], top - 53), to_doubles(powers[2], top - 53)};
  const double s = shortest_between(result, low - t_, high - t_), t = t_ + s;
  // About t: s = (p / q) with q a power of two, and everything times q^2.
  Integer p;
  unsigned places;
  split_double_3(t, p, places);
  Integer here = mantissa_;
  const unsigned common = std::max(places, places_);
  p <<= common - places;
  here <<= common - places_;
  p -= here;
  const auto scaled = [&](const IntegerVector& a, unsigned times) {
    IntegerVector b = a;
    for (Integer* value : {&b.x, &b.y, &b.z}) *value <<= times * common;
    return b;
  };
  const IntegerVector first =
      sum(sum(scaled(powers[0], 2), multiple(p, scaled(powers[1], 1))), multiple(p * p, powers[2]));
  const IntegerVector second = sum(scaled(powers[1], 2), multiple(2 * p, scaled(powers[2], 1)));
  const IntegerVector third = scaled(powers[2], 2);
  const long shift = bits(!is_zero(first) ? first : !is_zero(second) ? second : third) - 53;
  result = {rounded(first, shift), to_doubles(second, shift), to_doubles(third, shift)};
  result.base = t;
  return result;
}

MovingVector3 MovingPlanes3::fine_normal(PlaneId3 plane, double low, double high) {
  MovingVector3 result = normal(plane);
  if (!is_fine(result, low, high)) return rounded_polynomial({{exact_normal(plane), exact_turn(plane), {}}}, low, high);
  result.base = t_;
  return result;
}

MovingVector3 MovingPlanes3::fine_direction(const MovingCorner3& corner, double low, double high) {
  MovingVector3 result = corner.direction;
  if (!is_fine(result, low, high)) return rounded_polynomial(exact_direction(corner), low, high);
  result.base = t_;
  return result;
}

}  // namespace hottel

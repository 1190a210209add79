// Normals and directions that are good to the last digit all along a piece (MovingPlanes3).
#include <algorithm>
#include <cmath>

#include "geometry/space/moving/moving_planes.h"
#include "geometry/space/vectors/integer_reals.h"
#include "kernel/doubles.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

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

// Those of the first power that is not zero.
long leading_bits(const std::array<IntegerVector, 3>& powers) {
  return bits(!is_zero(powers[0]) ? powers[0] : !is_zero(powers[1]) ? powers[1] : powers[2]);
}

template <class Real>
LocalVector3<Real> wide(const IntegerVector& a, long shift) {
  LocalVector3<Real> result;
  integer_reals::set_quotient(a.x, 1, shift, result.x);
  integer_reals::set_quotient(a.y, 1, shift, result.y);
  integer_reals::set_quotient(a.z, 1, shift, result.z);
  return result;
}

MovingVector3 rounded_powers(const std::array<IntegerVector, 3>& powers, double base) {
  const long shift = leading_bits(powers) - 53;
  MovingVector3 result{rounded(powers[0], shift), to_doubles(powers[1], shift), to_doubles(powers[2], shift)};
  result.base = base;
  return result;
}

// Sets the powers of s' of a polynomial in s = s' + p / q, times q^2, with q = 2^places.
void set_moved(const std::array<const Integer*, 3>& from, const Integer& p, unsigned places,
               const std::array<Integer*, 3>& to) {
  thread_local Integer scaled, step;
  for (std::size_t k = 0; k < 3; ++k) mpz_mul_2exp(to[k]->get_mpz_t(), from[k]->get_mpz_t(), 2 * places);
  mpz_mul_2exp(scaled.get_mpz_t(), from[1]->get_mpz_t(), places);
  mpz_addmul(to[0]->get_mpz_t(), p.get_mpz_t(), scaled.get_mpz_t());
  if (sgn(*from[2]) == 0) return;
  mpz_mul(step.get_mpz_t(), p.get_mpz_t(), p.get_mpz_t());
  mpz_addmul(to[0]->get_mpz_t(), step.get_mpz_t(), from[2]->get_mpz_t());
  mpz_mul_2exp(scaled.get_mpz_t(), from[2]->get_mpz_t(), places + 1);
  mpz_addmul(to[1]->get_mpz_t(), p.get_mpz_t(), scaled.get_mpz_t());
}

template <class Real>
WideVector3<Real> wide_powers(const std::array<IntegerVector, 3>& powers, double base) {
  const long shift = leading_bits(powers);
  return {wide<Real>(powers[0], shift), wide<Real>(powers[1], shift), wide<Real>(powers[2], shift), base};
}

}  // namespace

bool MovingPlanes3::is_fine(const MovingVector3& vector, double low, double high) const {
  const double s = shortest_between(vector, low - t_, high - t_);
  const Direction3 d = value_at(vector, s);
  const double lost =
      vector.first.error +
      32 * kUnitRoundoff * (vector.terms[0] + std::fabs(s) * (vector.terms[1] + std::fabs(s) * vector.terms[2]));
  return lost <= kIllConditioned * size_of(d);
}

std::pair<MovingPlanes3::ExactPolynomial, double> MovingPlanes3::about_shortest(const ExactPolynomial& exact,
                                                                                double low, double high) const {
  const auto& powers = exact.powers;
  const long top = std::max({bits(powers[0]), bits(powers[1]), bits(powers[2])});
  const MovingVector3 about{rounded(powers[0], top - 53), to_doubles(powers[1], top - 53),
                            to_doubles(powers[2], top - 53)};
  const double t = t_ + shortest_between(about, low - t_, high - t_);
  // s = (p / q) with q a power of two, and everything times q^2.
  Integer p;
  unsigned places;
  split_double_3(t, p, places);
  Integer here = mantissa_;
  const unsigned common = std::max(places, places_);
  p <<= common - places;
  here <<= common - places_;
  p -= here;
  std::pair<ExactPolynomial, double> result{{}, t};
  auto& about_t = result.first.powers;
  for (Integer IntegerVector::*axis : {&IntegerVector::x, &IntegerVector::y, &IntegerVector::z})
    set_moved({&(powers[0].*axis), &(powers[1].*axis), &(powers[2].*axis)}, p, common,
              {&(about_t[0].*axis), &(about_t[1].*axis), &(about_t[2].*axis)});
  return result;
}

MovingVector3 MovingPlanes3::fine_normal(PlaneId3 plane, double low, double high) {
  MovingVector3 result = normal(plane);
  result.base = t_;
  if (is_fine(result, low, high)) return result;
  const auto [about, base] = about_shortest({{exact_normal(plane), exact_turn(plane), {}}}, low, high);
  return rounded_powers(about.powers, base);
}

MovingVector3 MovingPlanes3::fine_direction(const MovingCorner3& corner, double low, double high) {
  MovingVector3 result = corner.direction;
  result.base = t_;
  if (is_fine(result, low, high)) return result;
  const auto [about, base] = about_shortest(exact_direction(corner), low, high);
  return rounded_powers(about.powers, base);
}

template <class Real>
WideVector3<Real> MovingPlanes3::wide_normal(PlaneId3 plane, double low, double high) {
  const auto [about, base] = about_shortest({{exact_normal(plane), exact_turn(plane), {}}}, low, high);
  return wide_powers<Real>(about.powers, base);
}

template <class Real>
WideVector3<Real> MovingPlanes3::wide_direction(const MovingCorner3& corner, double low, double high) {
  const auto [about, base] = about_shortest(exact_direction(corner), low, high);
  return wide_powers<Real>(about.powers, base);
}

template <class Real>
MovingPlanes3::WholeVector<Real> MovingPlanes3::whole_vector(const ExactPolynomial& exact, double low,
                                                             double high) const {
  if constexpr (std::is_same_v<Real, double>) {
    const auto [about, base] = about_shortest(exact, low, high);
    const MovingVector3 found = rounded_powers(about.powers, base);
    if (!is_short_somewhere(found, low, high)) return found;
  }
  const auto [about, base] = about_shortest(without_zeros(exact, low, high), low, high);
  if constexpr (std::is_same_v<Real, double>)
    return rounded_powers(about.powers, base);
  else
    return wide_powers<Real>(about.powers, base);
}

template MovingPlanes3::WholeVector<double> MovingPlanes3::whole_vector<double>(const ExactPolynomial&, double,
                                                                                double) const;
template MovingPlanes3::WholeVector<WideReal> MovingPlanes3::whole_vector<WideReal>(const ExactPolynomial&, double,
                                                                                    double) const;
template WideVector3<long double> MovingPlanes3::wide_normal(PlaneId3, double, double);
template WideVector3<LongerReal> MovingPlanes3::wide_normal(PlaneId3, double, double);
template WideVector3<WideReal> MovingPlanes3::wide_normal(PlaneId3, double, double);
template WideVector3<long double> MovingPlanes3::wide_direction(const MovingCorner3&, double, double);
template WideVector3<LongerReal> MovingPlanes3::wide_direction(const MovingCorner3&, double, double);
template WideVector3<WideReal> MovingPlanes3::wide_direction(const MovingCorner3&, double, double);

}  // namespace hottel

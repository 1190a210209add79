#include "kernel/ball.h"

#include <arb_hypgeom.h>
#include <arf.h>
#include <fmpq.h>

#include <utility>

#include "kernel/ball_number.h"

namespace hottel {
namespace {

void set(arb_t out, const Rational& value, long precision) {
  fmpq_t q;
  fmpq_init(q);
  fmpq_set_mpq(q, value.get_mpq_t());
  arb_set_fmpq(out, q, precision);
  fmpq_clear(q);
}

}  // namespace

Ball::Ball() : number_(std::make_unique<BallNumber>()) {}
Ball::Ball(const Ball& other) : number_(std::make_unique<BallNumber>(*other.number_)) {}
Ball::Ball(Ball&&) noexcept = default;
Ball& Ball::operator=(Ball other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}
Ball::~Ball() = default;

Ball Ball::of(const Rational& value, long precision) {
  Ball result;
  set(result.number_->x, value, precision);
  return result;
}

Ball Ball::up_to_power_of_two(long exponent) {
  Ball result;
  arf_set_si_2exp_si(arb_midref(result.number_->x), 1, exponent - 1);
  mag_one(arb_radref(result.number_->x));
  mag_mul_2exp_si(arb_radref(result.number_->x), arb_radref(result.number_->x), exponent - 1);
  return result;
}

Ball Ball::root(const Integer& radicand, long precision) {
  Ball result;
  set_integer(result.number_->x, radicand);
  arb_sqrt(result.number_->x, result.number_->x, precision);
  return result;
}

Ball Ball::pi(long precision) {
  Ball result;
  arb_const_pi(result.number_->x, precision);
  return result;
}

Ball Ball::sine_of_degrees(const Rational& degrees, long precision) {
  Ball result;
  const Rational half_turns = degrees / 180;
  fmpq_t q;
  fmpq_init(q);
  fmpq_set_mpq(q, half_turns.get_mpq_t());
  arb_sin_pi_fmpq(result.number_->x, q, precision);
  fmpq_clear(q);
  return result;
}

Ball Ball::atan2(const Ball& y, const Ball& x, long precision) {
  Ball result;
  arb_atan2(result.number_->x, y.number_->x, x.number_->x, precision);
  return result;
}

Ball Ball::whole_cosine_power(const Rational& exponent, long precision) {
  Ball result;
  BallNumber half, upper, lower;
  set(half.x, Rational((exponent + 1) / 2), precision);
  arb_gamma(upper.x, half.x, precision);
  set(half.x, Rational(exponent / 2 + 1), precision);
  arb_rgamma(lower.x, half.x, precision);
  arb_mul(upper.x, upper.x, lower.x, precision);
  arb_const_sqrt_pi(lower.x, precision);
  arb_mul(upper.x, upper.x, lower.x, precision);
  arb_mul_2exp_si(result.number_->x, upper.x, -1);
  return result;
}

namespace {

// C_n(t) = (cos^(n-1) t sin t + (n - 1) C_(n-2)(t)) / n, from C_0 = t or C_1 = sin t.
void whole_power(arb_t out, const arb_t angle, unsigned long n, long precision) {
  arb_t sine, cosine, square, power;
  arb_init(sine);
  arb_init(cosine);
  arb_init(square);
  arb_init(power);
  arb_sin_cos(sine, cosine, angle, precision);
  arb_mul(square, cosine, cosine, precision);
  arb_set(out, n % 2 == 0 ? angle : sine);
  arb_mul(power, sine, n % 2 == 0 ? cosine : square, precision);  // cos^(k-1) sin of the next k
  for (unsigned long k = 2 + n % 2; k <= n; k += 2) {
    arb_mul_ui(out, out, k - 1, precision);
    arb_add(out, out, power, precision);
    arb_div_ui(out, out, k, precision);
    arb_mul(power, power, square, precision);
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(square);
  arb_clear(power);
}

// Half the incomplete beta function of the square of a function of the angle.
void half_beta(arb_t out, const arb_t root, const arb_t a, const arb_t b, long precision) {
  arb_sqr(out, root, precision);
  arb_hypgeom_beta_lower(out, a, b, out, 0, precision);
  arb_mul_2exp_si(out, out, -1);
}

// A ball around 0 that holds a number and its opposite.
void set_about_zero(arb_t out, const arb_t size) {
  mag_t most;
  mag_init(most);
  arb_get_mag(most, size);
  arb_zero(out);
  mag_swap(arb_radref(out), most);
  mag_clear(most);
}

}  // namespace

Ball Ball::cosine_power(const Ball& angle, const Rational& exponent, long precision) {
  constexpr unsigned long kMostRecursive = 64;
  Ball result;
  if (exponent == 0) return angle;
  if (exponent.get_den() == 1 && exponent <= kMostRecursive) {
    whole_power(result.number_->x, angle.number_->x, exponent.get_num().get_ui(), precision);
    return result;
  }
  BallNumber sine, cosine, size, a, b, quarter;
  arb_sin_cos(sine.x, cosine.x, angle.number_->x, precision);
  arb_abs(size.x, angle.number_->x);
  arb_const_pi(quarter.x, precision);
  arb_mul_2exp_si(quarter.x, quarter.x, -2);
  arb_set_d(a.x, 0.5);
  set(b.x, Rational((exponent + 1) / 2), precision);
  if (arb_contains_zero(sine.x) && !arb_is_zero(sine.x) && arb_lt(size.x, quarter.x)) {
    set_about_zero(result.number_->x, size.x);  // no cosine is above 1
    return result;
  }
  if (arb_lt(size.x, quarter.x)) {
    half_beta(result.number_->x, sine.x, a.x, b.x, precision);
  } else {
    // From the other end: what is missing to pi / 2.
    BallNumber rest;
    if (arb_is_positive(cosine.x)) {
      half_beta(rest.x, cosine.x, b.x, a.x, precision);
    } else {  // at most the angle that is missing, for no cosine is above 1
      arb_mul_2exp_si(quarter.x, quarter.x, 1);
      arb_sub(rest.x, quarter.x, size.x, precision);
      set_about_zero(rest.x, rest.x);
    }
    const Ball whole = whole_cosine_power(exponent, precision);
    arb_sub(result.number_->x, whole.number_->x, rest.x, precision);
  }
  if (arf_sgn(arb_midref(angle.number_->x)) < 0) arb_neg(result.number_->x, result.number_->x);
  return result;
}

Ball Ball::plus(const Ball& other, long precision) const {
  Ball result;
  arb_add(result.number_->x, number_->x, other.number_->x, precision);
  return result;
}

Ball Ball::minus(const Ball& other, long precision) const {
  Ball result;
  arb_sub(result.number_->x, number_->x, other.number_->x, precision);
  return result;
}

Ball Ball::times(const Ball& other, long precision) const {
  Ball result;
  arb_mul(result.number_->x, number_->x, other.number_->x, precision);
  return result;
}

Ball Ball::over(const Ball& other, long precision) const {
  Ball result;
  arb_div(result.number_->x, number_->x, other.number_->x, precision);
  return result;
}

Ball Ball::square_root(long precision) const {
  Ball result;
  arb_sqrtpos(result.number_->x, number_->x, precision);
  return result;
}

Ball Ball::power(const Rational& exponent, long precision) const {
  Ball result;
  fmpq_t q;
  fmpq_init(q);
  fmpq_set_mpq(q, exponent.get_mpq_t());
  arb_pow_fmpq(result.number_->x, number_->x, q, precision);
  fmpq_clear(q);
  return result;
}

void Ball::add_product(const Ball& a, const Ball& b, long precision) {
  arb_addmul(number_->x, a.number_->x, b.number_->x, precision);
}

int Ball::sign() const { return arb_is_positive(number_->x) ? 1 : arb_is_negative(number_->x) ? -1 : 0; }

namespace {

Enclosure ends(const arb_t x, arf_rnd_t round_lower, arf_rnd_t round_upper) {
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  // The ends themselves are exact: midpoint -+ radius with enough bits, rounded outward.
  arb_get_lbound_arf(lower, x, 30 + arb_bits(x) + 64);
  arb_get_ubound_arf(upper, x, 30 + arb_bits(x) + 64);
  const Enclosure result{arf_get_d(lower, round_lower), arf_get_d(upper, round_upper)};
  arf_clear(lower);
  arf_clear(upper);
  return result;
}

}  // namespace

bool Ball::is_relatively_narrow(long digits) const {
  return arb_is_zero(number_->x) || arb_rel_error_bits(number_->x) <= -digits;
}

Enclosure Ball::nearest_of_ends() const { return ends(number_->x, ARF_RND_NEAR, ARF_RND_NEAR); }

Enclosure Ball::bounds() const { return ends(number_->x, ARF_RND_FLOOR, ARF_RND_CEIL); }

int Ball::compare(double value) const {
  arf_t number;
  arf_init(number);
  arf_set_d(number, value);
  BallNumber difference;
  arb_sub_arf(difference.x, number_->x, number, arb_bits(number_->x) + 128);
  arf_clear(number);
  return arb_is_positive(difference.x) ? 1 : arb_is_negative(difference.x) ? -1 : 0;
}

}  // namespace hottel

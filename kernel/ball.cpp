#include "kernel/ball.h"

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

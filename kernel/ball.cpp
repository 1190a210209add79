#include "kernel/ball.h"

#include <arf.h>
#include <fmpq.h>

#include <utility>

#include "kernel/ball_hidden.h"

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

Ball::Ball() : hidden_(std::make_unique<Hidden>()) {}
Ball::Ball(const Ball& other) : hidden_(std::make_unique<Hidden>(*other.hidden_)) {}
Ball::Ball(Ball&&) noexcept = default;
Ball& Ball::operator=(Ball other) noexcept {
  std::swap(hidden_, other.hidden_);
  return *this;
}
Ball::~Ball() = default;

Ball Ball::of(const Rational& value, long precision) {
  Ball result;
  set(result.hidden_->x, value, precision);
  return result;
}

Ball Ball::root(const Integer& radicand, long precision) {
  Ball result;
  set_integer(result.hidden_->x, radicand);
  arb_sqrt(result.hidden_->x, result.hidden_->x, precision);
  return result;
}

Ball Ball::pi(long precision) {
  Ball result;
  arb_const_pi(result.hidden_->x, precision);
  return result;
}

Ball Ball::sine_of_degrees(const Rational& degrees, long precision) {
  Ball result;
  const Rational half_turns = degrees / 180;
  fmpq_t q;
  fmpq_init(q);
  fmpq_set_mpq(q, half_turns.get_mpq_t());
  arb_sin_pi_fmpq(result.hidden_->x, q, precision);
  fmpq_clear(q);
  return result;
}

Ball Ball::atan2(const Ball& y, const Ball& x, long precision) {
  Ball result;
  arb_atan2(result.hidden_->x, y.hidden_->x, x.hidden_->x, precision);
  return result;
}

Ball Ball::plus(const Ball& other, long precision) const {
  Ball result;
  arb_add(result.hidden_->x, hidden_->x, other.hidden_->x, precision);
  return result;
}

Ball Ball::minus(const Ball& other, long precision) const {
  Ball result;
  arb_sub(result.hidden_->x, hidden_->x, other.hidden_->x, precision);
  return result;
}

Ball Ball::times(const Ball& other, long precision) const {
  Ball result;
  arb_mul(result.hidden_->x, hidden_->x, other.hidden_->x, precision);
  return result;
}

Ball Ball::over(const Ball& other, long precision) const {
  Ball result;
  arb_div(result.hidden_->x, hidden_->x, other.hidden_->x, precision);
  return result;
}

Ball Ball::square_root(long precision) const {
  Ball result;
  arb_sqrtpos(result.hidden_->x, hidden_->x, precision);
  return result;
}

void Ball::add_product(const Ball& a, const Ball& b, long precision) {
  arb_addmul(hidden_->x, a.hidden_->x, b.hidden_->x, precision);
}

int Ball::sign() const { return arb_is_positive(hidden_->x) ? 1 : arb_is_negative(hidden_->x) ? -1 : 0; }

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
  return arb_is_zero(hidden_->x) || arb_rel_error_bits(hidden_->x) <= -digits;
}

Enclosure Ball::nearest_of_ends() const { return ends(hidden_->x, ARF_RND_NEAR, ARF_RND_NEAR); }

Enclosure Ball::bounds() const { return ends(hidden_->x, ARF_RND_FLOOR, ARF_RND_CEIL); }

int Ball::compare(double value) const {
  arf_t number;
  arf_init(number);
  arf_set_d(number, value);
  Hidden difference;
  arb_sub_arf(difference.x, hidden_->x, number, arb_bits(hidden_->x) + 128);
  arf_clear(number);
  return arb_is_positive(difference.x) ? 1 : arb_is_negative(difference.x) ? -1 : 0;
}

}  // namespace hottel

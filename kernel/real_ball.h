// Balls with operators, for long formulas. Internal to kernel: it shows Arb.
#pragma once

#include <arb.h>

#include <utility>

#include "kernel/ball_number.h"
#include "kernel/rational.h"

namespace hottel {

// A ball with its precision, which results of operators take from the one on the left.
class Real {
 public:
  explicit Real(long precision) : precision_(precision) { arb_init(x); }
  Real(const Integer& value, long precision) : Real(precision) {
    set_integer(x, value);
    arb_set_round(x, x, precision);
  }
  Real(const Real& other) : Real(other.precision_) { arb_set(x, other.x); }
  Real(Real&& other) noexcept : Real(other.precision_) { arb_swap(x, other.x); }
  Real& operator=(const Real& other) {
    arb_set(x, other.x);
    precision_ = other.precision_;
    return *this;
  }
  Real& operator=(Real&& other) noexcept {
    arb_swap(x, other.x);
    std::swap(precision_, other.precision_);
    return *this;
  }
  ~Real() { arb_clear(x); }

  long precision() const { return precision_; }
  Real operator-() const {
    Real result(*this);
    arb_neg(result.x, result.x);
    return result;
  }

  arb_t x;

 private:
  long precision_;
};

inline Real operator+(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_add(result.x, a.x, b.x, a.precision());
  return result;
}
inline Real operator-(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_sub(result.x, a.x, b.x, a.precision());
  return result;
}
inline Real operator*(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_mul(result.x, a.x, b.x, a.precision());
  return result;
}
inline Real operator/(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_div(result.x, a.x, b.x, a.precision());
  return result;
}
inline Real times(const Real& a, long factor) {
  Real result(a.precision());
  arb_mul_si(result.x, a.x, factor, a.precision());
  return result;
}
inline Real over(const Real& a, long divisor) {
  Real result(a.precision());
  arb_div_si(result.x, a.x, divisor, a.precision());
  return result;
}
inline Real root(const Real& a) {
  Real result(a.precision());
  arb_sqrtpos(result.x, a.x, a.precision());
  return result;
}
inline Real angle_of(const Real& y, const Real& x) {
  Real result(x.precision());
  arb_atan2(result.x, y.x, x.x, x.precision());
  return result;
}
inline Real larger(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_max(result.x, a.x, b.x, a.precision());
  return result;
}
inline Real smaller(const Real& a, const Real& b) {
  Real result(a.precision());
  arb_min(result.x, a.x, b.x, a.precision());
  return result;
}

}  // namespace hottel

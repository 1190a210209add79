// Real numbers enclosed at any precision: a thin owner of Arb's balls, kept out of public headers.
#pragma once

#include <memory>

#include "kernel/enclosure.h"
#include "kernel/rational.h"

namespace hottel {

struct BallNumber;

// A ball that contains a real number. `precision` is in bits: that of the middle of the result.
//
//   (1) every operation returns a ball that contains the result for every number in its operands
//   (2) bounds() contains the ball and is at most two ulps wide when the precision allows it
//   (3) sign() and compare() are never wrong: 0 where the ball is too wide to tell, or the number is just that
//
// A ball by itself is exactly 0. No operation throws for want of precision: the ball becomes wider.
// COST: an allocation a ball; then that of Arb at this precision.
// SEE: Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, 2017.
class Ball {
 public:
  Ball();
  Ball(const Ball&);
  Ball(Ball&&) noexcept;
  Ball& operator=(Ball) noexcept;
  ~Ball();

  static Ball of(const Rational& value, long precision);
  // All numbers from 0 to 2^exponent; its lower bound is 0.
  static Ball up_to_power_of_two(long exponent);
  // Square root of an integer. REQUIRES: radicand >= 0.
  static Ball root(const Integer& radicand, long precision);
  static Ball pi(long precision);

  // sin(pi x / 180). Exact at multiples of 90.
  static Ball sine_of_degrees(const Rational& degrees, long precision);

  // Angle of the vector (x, y) in (-pi, pi].
  static Ball atan2(const Ball& y, const Ball& x, long precision);

  // The integral of cos^exponent from 0 to an angle. REQUIRES: exponent >= 0; where it is above 0, an angle that lies
  // in -pi/2..pi/2: the part of the ball beyond is cut off. Whole exponents up to 64 by the recursion, others by
  // incomplete beta functions.
  static Ball cosine_power(const Ball& angle, const Rational& exponent, long precision);
  // The same up to pi/2: sqrt(pi) Gamma((n + 1) / 2) / (2 Gamma(n / 2 + 1)).
  static Ball whole_cosine_power(const Rational& exponent, long precision);

  // Sum, difference, product and quotient, rounded to the precision. Where the divisor holds 0, nothing is known of
  // the quotient, and its sign() is 0.
  Ball plus(const Ball& other, long precision) const;
  Ball minus(const Ball& other, long precision) const;
  Ball times(const Ball& other, long precision) const;
  Ball over(const Ball& other, long precision) const;

  // Of the numbers in the ball that are not negative.
  Ball square_root(long precision) const;
  // To an exponent. REQUIRES: sign() > 0.
  Ball power(const Rational& exponent, long precision) const;

  // Adds a * b, rounded once.
  void add_product(const Ball& a, const Ball& b, long precision);

  int sign() const;  // of every number in the ball, or 0 when they differ

  // Both ends of the ball, each rounded to the nearest double.
  Enclosure nearest_of_ends() const;
  // Doubles below and above every number in the ball.
  Enclosure bounds() const;
  // Sign of (every number in the ball - value), or 0 when not settled.
  int compare(double value) const;

  // True iff the ball is at most 2^-digits times as wide as every number in it is large; true of an exact zero.
  bool is_relatively_narrow(long digits) const;

  // What it is made of, for kernel/ball_number.h.
  BallNumber& number() { return *number_; }
  const BallNumber& number() const { return *number_; }

 private:
  std::unique_ptr<BallNumber> number_;
};

}  // namespace hottel

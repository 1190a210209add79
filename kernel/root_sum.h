// Exact sums of square roots: what every direct exchange area in the plane is.
#pragma once

#include <string>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

class Ball;

// A real number q_1 sqrt(r_1) + ... + q_n sqrt(r_n), with rational q_k and integers r_k > 0.
//
//   (1) canonical: no r_i r_j (i != j) is a perfect square and no q_k is 0, so the number is zero iff there are no
//       terms (square roots of different classes are linearly independent over the rationals: Besicovitch 1940)
//   (2) radicals are grouped by integer square roots; nothing is ever factored to decide anything
//   (3) the text of a sum does not depend on the order in which its terms were added (of radicands that differ by the
//       square of a prime above 1000 it may show another one where terms cancelled on the way)
//
// COST: add is O(number of classes) integer square roots; sign refines balls until zero is excluded.
class RootSum {
 public:
  // A rational multiple of the square root of a positive integer; the rational part of a sum has the radicand 1.
  struct Term {
    Rational coefficient;
    Integer radicand;
  };

  RootSum() = default;
  explicit RootSum(const Rational& rational) { add(rational, 1); }

  // Adds coefficient * sqrt(radicand); a zero adds no term. Throws ContractViolation unless radicand >= 0.
  void add(const Rational& coefficient, const Rational& radicand);
  // Exact, and canonical again; a sum may be added to or taken from itself.
  RootSum& operator+=(const RootSum& other);
  RootSum& operator-=(const RootSum& other);
  RootSum& operator*=(const Rational& factor);

  // Decided by the canonical form, without rounding.
  bool is_zero() const { return terms_.empty(); }
  int sign() const;  // -1, 0, 1
  // Returns a ball that contains the number. COST: a square root and a product a term at that precision.
  Ball ball(long precision) const;
  const std::vector<Term>& terms() const { return terms_; }

  // Returns the sum for people, e.g. "-2*sqrt(2) + 1*sqrt(10)", "3/2", "0". Squares of small primes are taken out of
  // the radicands; terms ascend by radicand, the rational part first.
  std::string to_string() const;

 private:
  std::vector<Term> terms_;
};

inline RootSum operator-(RootSum a, const RootSum& b) { return a -= b; }
inline RootSum operator+(RootSum a, const RootSum& b) { return a += b; }
inline RootSum operator*(RootSum a, const Rational& q) { return a *= q; }

}  // namespace hottel

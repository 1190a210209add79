// Sums of square roots in a normal form found by factoring: slow, and sharing nothing with kernel/root_sum.h.
#pragma once

#include <gmpxx.h>

#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace hottel::oracle {

// The number sum over (r, q) of q sqrt(r).
//
//   (1) no product of two radicands is a perfect square and no coefficient is 0: the number is zero iff there are no
//       terms, and two sums are equal as numbers iff ==
//   (2) radicands are square-free, so equal numbers have equal texts; this is certain while what trial division by
//       small primes leaves of a radicand has at most kFactoredBits bits
// COST: adding a term factors its radicand by trial division and Pollard's rho, and compares it with every other term.
class ExactSum {
 public:
  ExactSum() = default;

  // The sum of coefficient sqrt(radicand) over the terms. REQUIRES radicands >= 0.
  explicit ExactSum(const std::vector<std::pair<mpq_class, mpq_class>>& terms);

  void add(const mpq_class& coefficient, const mpq_class& radicand);
  ExactSum& operator+=(const ExactSum& other);
  ExactSum& operator*=(const mpq_class& factor);
  friend bool operator==(const ExactSum& a, const ExactSum& b);

  const std::map<mpz_class, mpq_class>& terms() const { return terms_; }  // radicand -> coefficient

  // "-2*sqrt(2) + 1*sqrt(10)", "3/2", "0": radicands ascend, the rational part first.
  std::string to_string() const;
  friend std::ostream& operator<<(std::ostream& out, const ExactSum& sum) { return out << sum.to_string(); }

  // The value with `bits` bits of working precision: absolute error about 2^-bits times the largest term.
  mpf_class value(unsigned bits = 256) const;
  double to_double() const { return value().get_d(); }

 private:
  void add_reduced(const mpq_class& coefficient, const mpz_class& radicand);

  std::map<mpz_class, mpq_class> terms_;
};

inline constexpr std::size_t kFactoredBits = 80;

// Returns root and rest with n = root^2 rest, rest square-free within the limit of (2). REQUIRES n > 0.
struct SquareFree {
  mpz_class root, rest;
};
SquareFree take_out_squares(const mpz_class& n);

}  // namespace hottel::oracle

#include "tests/oracle/exact_sum.h"

#include <utility>

namespace hottel::oracle {

namespace {

constexpr unsigned long kTrialLimit = 2000;

bool is_prime(const mpz_class& n) { return mpz_probab_prime_p(n.get_mpz_t(), 40) != 0; }

// Returns a proper divisor of the composite odd n: Pollard's rho with the step x^2 + c.
mpz_class divisor(const mpz_class& n) {
  for (unsigned long c = 1;; ++c) {
    mpz_class slow = 2, fast = 2, common = 1, difference;
    while (common == 1) {
      slow = (slow * slow + c) % n;
      fast = (fast * fast + c) % n;
      fast = (fast * fast + c) % n;
      difference = abs(slow - fast);
      common = gcd(difference, n);
    }
    if (common != n) return common;
  }
}

// Counts the prime factors of n, which has none up to kTrialLimit.
void factor(const mpz_class& n, std::map<mpz_class, int>& primes) {
  if (n == 1) return;
  if (is_prime(n)) {
    ++primes[n];
    return;
  }
  const mpz_class d = mpz_perfect_square_p(n.get_mpz_t()) ? mpz_class(sqrt(n)) : divisor(n);
  factor(d, primes);
  factor(n / d, primes);
}

}  // namespace

SquareFree take_out_squares(const mpz_class& n) {
  if (mpz_perfect_square_p(n.get_mpz_t())) return {sqrt(n), 1};
  SquareFree result{1, 1};
  mpz_class left = n;
  for (unsigned long p = 2; p <= kTrialLimit && left > p; p += p == 2 ? 1 : 2) {
    unsigned power = 0;
    for (; mpz_divisible_ui_p(left.get_mpz_t(), p); ++power) left /= p;
    for (; power >= 2; power -= 2) result.root *= p;
    if (power == 1) result.rest *= p;
  }
  // With all primes above the limit, a number below its cube is a square, or has no square in it. One that is
  // too long to factor is left as it is.
  const mpz_class limit = kTrialLimit;
  if (mpz_perfect_square_p(left.get_mpz_t())) {
    result.root *= sqrt(left);
  } else if (left < limit * limit * limit || mpz_sizeinbase(left.get_mpz_t(), 2) > kFactoredBits) {
    result.rest *= left;
  } else {
    std::map<mpz_class, int> primes;
    factor(left, primes);
    for (auto [p, power] : primes) {
      for (; power >= 2; power -= 2) result.root *= p;
      if (power == 1) result.rest *= p;
    }
  }
  return result;
}

ExactSum::ExactSum(const std::vector<std::pair<mpq_class, mpq_class>>& terms) {
  for (const auto& [coefficient, radicand] : terms) add(coefficient, radicand);
}

void ExactSum::add(const mpq_class& coefficient, const mpq_class& radicand) {
  if (coefficient == 0 || radicand == 0) return;
  // p and q are coprime, p = s^2 f and q = t^2 g: sqrt(p/q) = (s / (t g)) sqrt(f g)
  const SquareFree top = take_out_squares(radicand.get_num()), bottom = take_out_squares(radicand.get_den());
  mpq_class factor(top.root, bottom.root * bottom.rest);
  factor.canonicalize();
  add_reduced(coefficient * factor, top.rest * bottom.rest);
}

void ExactSum::add_reduced(const mpq_class& coefficient, const mpz_class& radicand) {
  for (auto& [r, q] : terms_) {
    const mpz_class product = r * radicand;
    if (!mpz_perfect_square_p(product.get_mpz_t())) continue;
    mpq_class ratio(sqrt(product), r);  // sqrt(radicand) = ratio sqrt(r)
    ratio.canonicalize();
    q += coefficient * ratio;
    if (q == 0) terms_.erase(r);
    return;
  }
  terms_.emplace(radicand, coefficient);
}

bool operator==(const ExactSum& a, const ExactSum& b) {
  ExactSum difference = b;
  difference *= -1;
  difference += a;
  return difference.terms_.empty();
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
  const std::map<mpz_class, mpq_class> added = other.terms_;
  for (const auto& [radicand, coefficient] : added) add_reduced(coefficient, radicand);
  return *this;
}

ExactSum& ExactSum::operator*=(const mpq_class& factor) {
  if (factor == 0) terms_.clear();
  for (auto& [radicand, coefficient] : terms_) coefficient *= factor;
  return *this;
}

std::string ExactSum::to_string() const {
  if (terms_.empty()) return "0";
  std::string text;
  for (const auto& [radicand, coefficient] : terms_) {
    const bool is_negative = coefficient < 0;
    if (text.empty())
      text += is_negative ? "-" : "";
    else
      text += is_negative ? " - " : " + ";
    text += mpq_class(abs(coefficient)).get_str();
    if (radicand != 1) text += "*sqrt(" + radicand.get_str() + ")";
  }
  return text;
}

mpf_class ExactSum::value(unsigned bits) const {
  mpf_class sum(0, bits);
  for (const auto& [radicand, coefficient] : terms_)
    sum += mpf_class(coefficient, bits) * sqrt(mpf_class(radicand, bits));
  return sum;
}

}  // namespace hottel::oracle

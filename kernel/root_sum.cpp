#include "kernel/root_sum.h"

#include <algorithm>

#include "kernel/ball.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Takes squares of small primes out of the radicand, so that people recognise 4*sqrt(2) in sqrt(32).
RootSum::Term with_small_squares_taken_out(RootSum::Term term) {
  for (unsigned long p = 2; p < 1000; ++p) {
    const unsigned long square = p * p;
    if (term.radicand < square) break;
    while (mpz_divisible_ui_p(term.radicand.get_mpz_t(), square)) {
      term.radicand /= square;
      term.coefficient *= p;
    }
  }
  if (mpz_perfect_square_p(term.radicand.get_mpz_t())) {
    term.coefficient *= Integer(sqrt(term.radicand));
    term.radicand = 1;
  }
  return term;
}

}  // namespace

void RootSum::add(const Rational& coefficient, const Rational& radicand) {
  HOTTEL_REQUIRE(radicand >= 0);
  if (coefficient == 0 || radicand == 0) return;
  // sqrt(p/q) = sqrt(p q) / q
  Rational q = coefficient / radicand.get_den();
  Integer r = radicand.get_num() * radicand.get_den();
  Integer product;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    Term& term = terms_[k];
    product = term.radicand * r;
    if (!mpz_perfect_square_p(product.get_mpz_t())) continue;
    // sqrt(r) = sqrt(r r_k) / r_k * sqrt(r_k); the smaller radicand is kept
    const Integer root = sqrt(product);
    if (r < term.radicand) {
      term.coefficient = term.coefficient * Rational(root) / r + q;
      term.radicand = std::move(r);
    } else {
      term.coefficient += q * Rational(root) / term.radicand;
    }
    if (term.coefficient == 0) terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(k));
    return;
  }
  if (mpz_perfect_square_p(r.get_mpz_t())) {
    q *= Integer(sqrt(r));
    r = 1;
  }
  terms_.push_back({std::move(q), std::move(r)});
}

RootSum& RootSum::operator+=(const RootSum& other) {
  if (&other == this) return *this *= 2;
  for (const Term& term : other.terms_) add(term.coefficient, Rational(term.radicand));
  return *this;
}

RootSum& RootSum::operator-=(const RootSum& other) {
  if (&other == this) return *this *= 0;
  for (const Term& term : other.terms_) add(-term.coefficient, Rational(term.radicand));
  return *this;
}

RootSum& RootSum::operator*=(const Rational& factor) {
  if (factor == 0) terms_.clear();
  for (Term& term : terms_) term.coefficient *= factor;
  return *this;
}

Ball RootSum::ball(long precision) const {
  Ball result;
  for (const Term& term : terms_)
    result.add_product(Ball::root(term.radicand, precision), Ball::of(term.coefficient, precision), precision);
  return result;
}

int RootSum::sign() const {
  if (terms_.empty()) return 0;
  for (long precision = 64;; precision *= 2)
    if (const int s = ball(precision).sign(); s != 0) return s;
}

std::string RootSum::to_string() const {
  if (terms_.empty()) return "0";
  std::vector<Term> terms;
  for (const Term& term : terms_) terms.push_back(with_small_squares_taken_out(term));
  std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.radicand < b.radicand; });
  std::string text;
  for (const Term& term : terms) {
    const bool negative = sgn(term.coefficient) < 0;
    if (text.empty())
      text += negative ? "-" : "";
    else
      text += negative ? " - " : " + ";
    text += hottel::to_string(Rational(abs(term.coefficient)));
    if (term.radicand != 1) text += "*sqrt(" + term.radicand.get_str() + ")";
  }
  return text;
}

}  // namespace hottel

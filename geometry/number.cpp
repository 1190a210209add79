#include "geometry/number.h"

#include <cmath>

#include "geometry/name.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// True for a decimal that would be read if its exponent were smaller.
bool has_large_exponent(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  if (e == std::string_view::npos || text.find('/') != std::string_view::npos) return false;
  const std::string_view digits = text.substr(e + 1);
  if (digits.find_first_not_of("+-0123456789") != std::string_view::npos) return false;
  const auto exponent = parse_rational(digits);
  return parse_rational(text.substr(0, e)) && exponent && abs(*exponent) > kMaxNumberExponent;
}

NumberProblem problem_of_unread(std::string_view text) {
  if (text.size() > kMaxNumberLength)
    return {"has " + std::to_string(text.size()) + " characters; a number may have " + std::to_string(kMaxNumberLength),
            ""};
  if (has_large_exponent(text))
    return {"is beyond the range in which numbers are read: " + quoted_name(text),
            "an exponent is at most " + std::to_string(kMaxNumberExponent) + " in absolute value"};
  return {"is not a number: " + quoted_name(text),
          "numbers are written like 12, -0.1, 2.5e-3 or 4/3, with an exponent of at most " +
              std::to_string(kMaxNumberExponent)};
}

}  // namespace

NumberProblem number_problem(std::string_view text) {
  return parse_rational(text) ? NumberProblem{} : problem_of_unread(text);
}

bool is_in_lowest_terms(const Rational& value) {
  const Integer &p = value.get_num(), &q = value.get_den();
  return q == 1 || (q > 0 && gcd(p, q) == 1);
}

Number::Number(double value) {
  if (std::isfinite(value))
    value_ = exact_value(value);
  else
    problem_ = {"is not a number: '" + shortest(value) + "'", ""};
}

Number::Number(std::string_view text) {
  if (auto value = parse_rational(text))
    value_ = *std::move(value);
  else
    problem_ = problem_of_unread(text);
}

Number::Number(Exactly, Rational value) : value_(std::move(value)) {
  if (value_.get_den() != 0)
    value_.canonicalize();
  else
    problem_ = {"is not a number: its denominator is 0", ""};
}

const Rational& Number::value() const {
  if (!problem_.text.empty()) throw UsageError("what should be a number " + problem_.text);
  return value_;
}

}  // namespace hottel

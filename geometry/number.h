// Numbers as callers write them: exact, in whatever type they come.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "kernel/rational.h"

namespace hottel {

// Why a text is no number that parse_rational reads: the end of a sentence ("is not a number: '1/0'"), and what helps.
// Both are empty where it is one.
struct NumberProblem {
  std::string text, hint;
};
NumberProblem number_problem(std::string_view text);

// True iff a number is as arithmetic leaves it: numerator and denominator without a common factor, the denominator
// positive. mpq_class(2, 4) is not.
bool is_in_lowest_terms(const Rational& value);

// A number in a call: an integer, a double, a text, or a Rational. It converts from all of them by itself.
//
//   (1) exact: an integer and a double are what they are, a text is what parse_rational reads: 0.1 is the double
//       nearest to one tenth, "0.1" is one tenth, "1/3" a third
//   (2) what is no number (NaN, an infinity, "1/0", "wide", a Rational with the denominator 0) can be written, and is
//       refused by who reads it: problem() says why
//   (3) truth values, characters and long doubles are refused by the compiler
class Number {
  template <class T>
  static constexpr bool kIsNoNumber =
      std::same_as<T, bool> || std::same_as<T, char> || std::same_as<T, wchar_t> || std::same_as<T, char8_t> ||
      std::same_as<T, char16_t> || std::same_as<T, char32_t> || std::same_as<T, long double>;
  struct Exactly {};

 public:
  template <std::signed_integral T>
  requires(!kIsNoNumber<T>) Number(T value) : value_(static_cast<long>(value)) {}
  template <std::unsigned_integral T>
  requires(!kIsNoNumber<T>) Number(T value) : value_(static_cast<unsigned long>(value)) {}
  Number(double value);
  Number(const char* text) : Number(std::string_view(text)) {}
  Number(const std::string& text) : Number(std::string_view(text)) {}
  Number(std::string_view text);
  // A Rational or an Integer, or an expression of them; in lowest terms or not.
  template <class T, class U>
  Number(const __gmp_expr<T, U>& value) : Number(Exactly{}, Rational(value)) {}

  template <class T>
  requires kIsNoNumber<T> Number(T)
  = delete;

  // Empty where it is a number.
  const NumberProblem& problem() const { return problem_; }
  // The value, in lowest terms. Throws UsageError where it is no number.
  const Rational& value() const;

 private:
  Number(Exactly, Rational value);

  Rational value_;
  NumberProblem problem_;
};

}  // namespace hottel

// The one tolerance of scenes: how far points may be off what they are said to lie in. It decides how input is read,
// never a predicate.
#pragma once

#include <optional>
#include <string_view>

#include "kernel/rational.h"

namespace hottel {

// The finest decimal digit of numbers that are read one after another.
class FinestDigit {
 public:
  // A number as parse_rational reads it. A fraction has no last digit; that of "1.50" is a hundredth, of "2e3" a
  // thousand.
  void take(std::string_view number);
  // What the finest stands for; 0 where there is none.
  Rational unit() const;

 private:
  std::optional<long> exponent_;
};

// True iff points of that diameter may lie that far off: by at most 2^-40 of the diameter, or by at most 4 units and
// 1e-4 of the diameter. `unit` is what the last digit of the coordinates stands for, 0 where they have none.
bool is_within_planarity(const Rational& squared_distance, const Rational& squared_diameter, const Rational& unit);

}  // namespace hottel

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

// True iff a patch of one diameter may be put onto a base of another one from so far off: within the planarity of the
// larger of the two, for a narrow window on a wall typed to four digits is off as the wall is; and by at most a
// hundredth of the patch, which then turns by half a degree at most.
bool is_within_seat(const Rational& squared_distance, const Rational& squared_patch, const Rational& squared_base,
                    const Rational& unit);

}  // namespace hottel

// What is guaranteed of a number, in its type.
#pragma once

#include <cmath>
#include <limits>

namespace hottel {

// kExact:     the double is the correctly rounded value of the real number.
// kEnclosed:  the given interval contains the real number and the double, proven.
// kEstimated: the given interval, however wide, contains the real number, proven. The double is an estimate without
//             proof.
// Each is weaker than the one before it.
enum class Guarantee : unsigned char { kExact, kEnclosed, kEstimated };

// The word that files and reports print.
constexpr const char* to_string(Guarantee guarantee) {
  switch (guarantee) {
    case Guarantee::kExact:
      return "exact";
    case Guarantee::kEnclosed:
      return "enclosed";
    case Guarantee::kEstimated:
      return "estimated";
  }
  return "";
}

// A closed interval that contains the real number. Its ends may be infinite: then nothing is known on that side.
//
//   (1) contains() is true at both ends, and false for NaN
//   (2) width() is the difference of the ends, rounded to nearest
struct Enclosure {
  double lower;
  double upper;

  double width() const { return upper - lower; }
  bool contains(double value) const { return lower <= value && value <= upper; }
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

// Returns an interval that contains the sum of two numbers that are not negative, given an interval of each.
//
//   (1) the ends are not below 0; to add zero ({0, 0}) changes nothing
inline Enclosure sum_of_nonnegative(const Enclosure& a, const Enclosure& b) {
  constexpr double kBeyond = std::numeric_limits<double>::infinity();
  const auto add = [](double x, double y, double outward) {
    return x == 0 ? y : y == 0 ? x : std::nextafter(x + y, outward);
  };
  const double lower = add(a.lower, b.lower, -kBeyond);
  return {lower > 0 ? lower : 0, add(a.upper, b.upper, kBeyond)};
}

// A real number, correctly rounded, with the knowledge on which side of the double it lies.
//
//   (1) value is the double nearest to the real number, ties to even
//   (2) side < 0: the real number is below value, > 0: above, 0: equal
//   (3) enclosure() contains the real number: from value to the next double on that side, or value alone where equal
struct Rounded {
  double value = 0;
  signed char side = 0;

  Enclosure enclosure() const {
    constexpr double kBeyond = std::numeric_limits<double>::infinity();
    return {side < 0 ? std::nextafter(value, -kBeyond) : value, side > 0 ? std::nextafter(value, kBeyond) : value};
  }
  friend bool operator==(const Rounded&, const Rounded&) = default;
};

}  // namespace hottel

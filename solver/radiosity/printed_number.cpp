#include "solver/radiosity/printed_number.h"

#include <cmath>

#include "kernel/doubles.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

// The double nearest to a number, or its neighbour where that is on the wrong side.
double below(double nearest, const Rational& value) {
  if (nearest == -kInfinity) return nearest;
  return nearest == kInfinity || exact_value(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}

double above(double nearest, const Rational& value) {
  if (nearest == kInfinity) return nearest;
  return nearest == -kInfinity || exact_value(nearest) < value ? std::nextafter(nearest, kInfinity) : nearest;
}

}  // namespace

double rounded_down(const Rational& value) { return below(to_double(value), value); }
double rounded_up(const Rational& value) { return above(to_double(value), value); }

Printed::Printed(const RationalEnclosure& number) {
  if (number.is_exact()) {
    nearest = to_double(number.lower);
    lower = below(nearest, number.lower);
    upper = above(nearest, number.lower);
  } else {
    nearest = to_double(Rational((number.lower + number.upper) / 2));
    lower = rounded_down(number.lower);
    upper = rounded_up(number.upper);
  }
}

}  // namespace hottel

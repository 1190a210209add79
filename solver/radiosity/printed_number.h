// Exact numbers as doubles, and doubles around them.
#pragma once

#include "kernel/rational.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// The largest double that is not above a number, the smallest that is not below it; infinite beyond the last double on
// that side.
double rounded_down(const Rational& value);
double rounded_up(const Rational& value);

// A number as it is printed, with doubles around it.
//
//   (1) nearest is the double nearest to a number that is exact, else to the middle of the enclosure; lower and upper
//       enclose all that the enclosure does, and no double between them does
struct Printed {
  double nearest = 0, lower = 0, upper = 0;

  Printed() = default;
  explicit Printed(const RationalEnclosure& number);
};

}  // namespace hottel

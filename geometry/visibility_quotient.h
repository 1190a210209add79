// From the quotient of two direct exchange areas to the visibility that is printed.
#pragma once

#include "kernel/enclosure.h"

namespace hottel {

// Returns Vis from the correctly rounded S / S0.
//
//   (1) the double nearest to the quotient, with two exceptions
//   (2) where the quotient is below 1 and would round to 1: the largest double below 1, since something hides a part
//   (3) where the quotient is above 0 and would round to 0: the least positive double, since something is seen
double visibility_of(const Rounded& quotient);

}  // namespace hottel

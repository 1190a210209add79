// From the quotient of two exchange measures to the visibility that is printed.
#pragma once

#include "kernel/enclosure.h"

namespace hottel {

// Vis of the correctly rounded S / S0: below 1 whenever something hides a part, above 0 whenever something is seen. A
// quotient that would round to 1 from below or to 0 from above keeps its distance.
double visibility_of(const Rounded& quotient);

}  // namespace hottel

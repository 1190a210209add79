// Between doubles and exact numbers: the one place where either becomes the other by GMP.
//
// GMP ends the process by a signal where it is given an infinity or what is no number, and says nothing of what it
// returns where a number does not fit. So nothing else constructs an Integer or a Rational from a double, compares one
// with a double, or calls get_d; tests/layers asks the object files. to_double (kernel/rational.h) rounds to nearest.
#pragma once

#include "kernel/rational.h"

namespace hottel {

// Returns the number that a double is, exactly. Throws RequestError where it is infinite or no number: whoever has a
// name for it asks before.
Rational exact_value(double value);
// Returns the double itself where it is a number, and throws as exact_value does: for other types of GMP.
double finite(double value);
// The same of a double without its fraction, which is cut off towards 0.
Integer exact_integer(double value);

// Returns a number as a double, cut off towards 0; an infinity of its sign where it is beyond the largest double by an
// ulp or more, and 0 of no sign where it is below the least.
double truncated_double(const Integer& value);
double truncated_double(const Rational& value);

}  // namespace hottel

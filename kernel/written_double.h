// Numbers as the doubles that files hold: what a double cannot tell is refused, and never becomes 0 or inf in silence.
#pragma once

#include <string>

#include "kernel/enclosure.h"
#include "kernel/rational.h"

namespace hottel {

// Returns the double nearest to a number; NaN where that is 0 and the number is not.
double written_double(const Rational& value);
// The same of a number that is rounded already.
double written_double(const Rounded& value);

// What doubles leave of a number, as the end of a sentence about it ("is beyond the range of doubles"); empty where the
// double tells it: of an infinity, and of the NaN of written_double.
std::string written_problem(double value);

// Throws RequestError, "WHAT is beyond the range of doublesMORE" or "is below" it, where that is not empty.
void require_double(double value, const std::string& what, const std::string& more = "");
// Returns the number as a double that tells it, and throws as require_double does.
double required_double(const Rounded& value, const std::string& what);

}  // namespace hottel

// Quotients of integers as doubles.
#pragma once

#include <gmpxx.h>

namespace hottel {

// Returns the double nearest to numerator / denominator, ties to even, whatever their common factors: 0 or an infinity
// where that is beyond the range of doubles.
// REQUIRES denominator > 0.
double nearest_double(const mpz_class& numerator, const mpz_class& denominator);

}  // namespace hottel

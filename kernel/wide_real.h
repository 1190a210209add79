// Floating-point numbers of some hundred digits, for the rare sums that lose all those of long doubles.
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <limits>

namespace hottel {

// A number of fixed precision, without memory of its own. Every operation, square root, logarithm and arc tangent is
// rounded correctly (MPFR); exponents are as good as unbounded.
using WideReal =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<96, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

inline constexpr int kWideBits = std::numeric_limits<WideReal>::digits;

}  // namespace hottel

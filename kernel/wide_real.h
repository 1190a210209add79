// Floating-point numbers of some forty and some hundred digits, for the rare sums that lose all those of long doubles.
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <limits>

namespace hottel {

// Numbers of fixed precision, without memory of their own. Every operation, square root, logarithm and arc tangent is
// rounded correctly (MPFR); exponents are as good as unbounded. One of forty digits costs a fraction of one of a
// hundred.
template <unsigned kDigits>
using RealOfDigits = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<kDigits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using LongerReal = RealOfDigits<38>;
using WideReal = RealOfDigits<96>;

inline constexpr int kWideBits = std::numeric_limits<WideReal>::digits;

}  // namespace hottel

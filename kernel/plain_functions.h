// Logarithms, exponentials, angles and sines of doubles that are the same bits
// on every processor.
#pragma once

#include <cmath>

// The C library chooses among several ways to compute them by what the processor can do, and these differ in the last
// bit. Here are sums, differences, products, quotients and square roots of doubles, as written, each rounded to
// nearest.
//
//   (1) the same bits wherever doubles are those of IEEE 754 and nothing is contracted (-ffp-contract=off)
//   (2) a result is off by no more than its comment says, in units of the last place of the true value
//   (3) special values are those of the C standard: NaN of NaN, log(0) = -inf, exp(-inf) = 0, the signs of zeros
//
// REQUIRES: rounding to nearest.
// COST, of one of many independent calls: logarithms and exponentials 5 to 7 ns, log1p, sines and cosines 13 ns,
// angles 20 ns, powers 25 ns, tangents and acos 30 ns. The library's take 6 to 8, 10, 8 to 14, 15 and 8 ns. SEE: Tang,
// Table-driven implementation of the logarithm function in IEEE floating-point arithmetic, 1990, and of the exponential
// function, 1989. What remains of x after the entry of the table is taken out is exact, or held in two doubles.
namespace hottel::same_bits {

// The natural logarithm. Off by at most 0.51 units.
double log(double x);
// To the bases 2 and 10: exact for powers of the base. Off by at most 0.51 units.
double log2(double x);
double log10(double x);
// log(1 + x), also where x is small. Off by at most 0.7 units.
double log1p(double x);

// e to the power of x. Off by at most 0.52 units, 0.76 where the result is subnormal.
double exp(double x);
// exp(x) - 1, also where x is small. Off by at most 0.62 units.
double expm1(double x);

// x to the power of y: exact for powers of 10 up to 10^22. Off by at most 0.57 units, 0.8 where the result is
// subnormal. NaN if x is negative, also where the C function has a value.
double pow(double x, double y);

// The angle of the vector (x, y) in [-pi, pi]. Off by at most 0.51 units.
double atan2(double y, double x);
// The angle of (1, x).
inline double atan(double x) { return atan2(x, 1); }
// The angle in [0, pi] with this cosine; NaN beyond -1..1. Off by at most 1.6 units.
double acos(double x);

// Sine and cosine of an angle in radians. Off by at most 0.62 units. COST: beyond 2^20 some microseconds.
double sin(double x);
double cos(double x);
// Off by at most 2 units.
inline double tan(double x) { return sin(x) / cos(x); }

// For templates over kinds of reals. These are calls of the C library, whose long doubles are computed by instructions
// of the processor: the same bits on processors that round these alike.
inline long double log(long double x) { return std::log(x); }
inline long double atan(long double x) { return std::atan(x); }
inline long double atan2(long double y, long double x) { return std::atan2(y, x); }

}  // namespace hottel::same_bits

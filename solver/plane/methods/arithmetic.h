// The exact method in other arithmetic: what exactness costs, and what becomes of the factors without it.
#pragma once

#include <memory>

#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// All of them receive the same exact arrangement and triangulation, and follow the same gaps in the same order; the
// time is that of the sweep, of the sums and of the matrix, without visibilities.
//
//   kNaive    orientations as signs of doubles, of coordinates rounded to doubles as they stand in the scene; lengths
//             and sums in doubles. Its sweep may follow what is not there: after a number of steps that no right sweep
//             takes, a view is cut off (a note counts these). Another note, from a pass that is not timed, counts the
//             orientations that differ from the exact ones.
//   kDoubles  orientations exact (filtered), lengths and sums in doubles
//   kBounds   orientations exact, sums in 128-bit fixed point with proven bounds; quotients in doubles, none is
//             rounded correctly, and a sum that may be zero is taken for what it is in fixed point, or for half of
//             what it may be where that is not positive (a note counts these, another bounds the error of all factors);
//             ExchangeMatrix::bounds() are proven, and the factor lies in them
//   kRounded  orientations exact, every factor correctly rounded: the exact method
//   kCgal     orientations and squared lengths in CGAL::Exact_predicates_exact_constructions_kernel, then std::sqrt of
//             CGAL::to_double and sums in doubles
enum class ArithmeticKind2 : unsigned char { kNaive, kDoubles, kBounds, kRounded, kCgal };

// Guarantee: kExact for kRounded, kEnclosed for kBounds, kEstimated else. An element whose ends fall on one point of
// doubles (kNaive) has an empty row.
std::unique_ptr<ExchangeMethod2> arithmetic_method_2(ArithmeticKind2 arithmetic);

}  // namespace hottel

// An approximate inverse that is cheap to make and cheaper to use: LU in single precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "solver/radiosity/approximate_inverse.h"

namespace hottel {

// kAuto factors systems of up to so many unknowns like this, where they lose enough light: for one light, where that
// takes no longer than to iterate; and for many (RadiosityOptions), where it pays after two or three.
inline constexpr std::uint32_t kMostUnknownsFactoredForOne = 900, kMostUnknownsFactoredForMany = 2000;

// What each row loses at least of the light that reaches it, for an elimination in single precision to be of use.
inline constexpr double kLeastLossForSinglePrecision = 0x1p-8;

// Returns the LU of I - rho F without pivoting, its entries in single precision, solved in doubles and corrected once;
// null where the magnitudes of some row of rho F sum to more than 1 - 2^-8.
//
//   (1) such rows are dominated by their diagonal: no pivot is below 2^-8. A solution has some ten digits of its
//       largest value
//   (2) the same bits for any number of threads
//   (3) numbers that leave the range of single precision are 0 in the factors, not in what is solved for
// COST: 2/3 n^3 operations over all threads, 4 n^2 bytes; a solution 4 n^2 operations and a pass over the system.
// Throws Interrupted when asked to stop. REQUIRES that the system outlives it.
std::unique_ptr<const ApproximateInverse> make_single_precision_lu(const PlainSystem& system, std::size_t components);

}  // namespace hottel

// What doubles are.
#pragma once

#include <limits>

namespace hottel {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
// No sum, difference, product, quotient or root in doubles is off by more than this part of itself, where it is a
// normal one.
inline constexpr double kUnitRoundoff = 0x1p-53;

}  // namespace hottel

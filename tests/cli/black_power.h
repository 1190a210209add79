// What black bodies send out, for tests.
#pragma once

#include <cmath>

namespace hottel::testing_cli {

inline constexpr double kSigma = 5.670374419e-8;

inline double power_of(double temperature) { return kSigma * temperature * temperature * temperature * temperature; }
inline double temperature_of(double power) { return std::sqrt(std::sqrt(power / kSigma)); }

}  // namespace hottel::testing_cli

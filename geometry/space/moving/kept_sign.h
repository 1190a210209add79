// Whether a polynomial keeps its sign. Internal to geometry/space.
#pragma once

#include <array>

#include "kernel/rational.h"

namespace hottel {

// Whether c[0] + c[1] s + c[2] s^2 surely has a sign from s = -left to s = right, but for where a double root is.
//
//   (1) never true where it has another one, whatever the numbers within `error` of the coefficients are
//   (2) of integers: false only where it has another one, or is zero at an end
//
// REQUIRES left, right from 0 to 1.
bool keeps_sign_3(const std::array<double, 3>& c, const std::array<double, 3>& error, int sign, double left,
                  double right);
bool keeps_sign_3(const std::array<Integer, 3>& c, int sign, double left, double right);

}  // namespace hottel

// An integral of powers of cosines that has no closed form. Internal to kernel: it shows Arb.
#pragma once

#include "kernel/real_ball.h"

namespace hottel {

// Returns the integral of (1 - c^k) / (1 - c^2) du from low to high, where c = c0 cos u: a ball that contains it.
//
// By adaptive Gauss quadrature whose error is bounded on ellipses around the path (Petras). c^k is e^(k log c), and the
// quotient that of two means of powers, which are smooth where c is 1: e^(k log c) - 1 is k log c times the mean of
// c^(kx) over x from 0 to 1.
//
// REQUIRES 0 < c0 <= 1, k >= 1, and -pi/2 < low <= high < pi/2. COST: some milliseconds at 128 bits; more where an end
// is near a quarter turn.
// SEE: Johansson, Numerical integration in arbitrary-precision ball arithmetic, 2018.
Real integral_of_power_ratio_3(const Real& c0, const Real& k, const Real& low, const Real& high);

}  // namespace hottel

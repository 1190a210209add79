// Integers of any length as floating-point numbers of a chosen precision. Internal to geometry/space/exchange.
#pragma once

#include "kernel/determinant.h"
#include "kernel/wide_real.h"

namespace hottel::integer_reals {

// Sets result to top / bottom * 2^-bits, off by at most 2 units of its last place. REQUIRES bottom > 0.
void set_quotient(const Integer& top, const Integer& bottom, long bits, long double& result);
void set_quotient(const Integer& top, const Integer& bottom, long bits, LongerReal& result);
void set_quotient(const Integer& top, const Integer& bottom, long bits, WideReal& result);

}  // namespace hottel::integer_reals

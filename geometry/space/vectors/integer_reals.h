// Integers of any length as floating-point numbers of a chosen precision. Internal to geometry/space/exchange.
#pragma once

#include "kernel/determinant.h"
#include "kernel/wide_real.h"

namespace hottel::integer_reals {

// Sets result to top / bottom * 2^-bits, off by at most 2 units of its last place. REQUIRES bottom > 0.
inline void set_quotient(const Integer& top, const Integer& bottom, long bits, double& result) {
  result = rounded_quotient(top, bottom, bits);
}
void set_quotient(const Integer& top, const Integer& bottom, long bits, long double& result);
void set_quotient(const Integer& top, const Integer& bottom, long bits, LongerReal& result);
void set_quotient(const Integer& top, const Integer& bottom, long bits, WideReal& result);

// The same of each component. Vector is Direction3 or LocalVector3.
template <class Vector>
Vector quotient(const IntegerVector& top, const Integer& bottom, long bits) {
  Vector result;
  set_quotient(top.x, bottom, bits, result.x);
  set_quotient(top.y, bottom, bits, result.y);
  set_quotient(top.z, bottom, bits, result.z);
  return result;
}

}  // namespace hottel::integer_reals

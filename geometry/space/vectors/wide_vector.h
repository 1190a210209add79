// Vectors that depend on how far a point has moved, with more digits than doubles have. Internal to
// geometry/space/exchange.
#pragma once

#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// A vector that depends on t: first + s second + s^2 third, s = t - base, each right to the last digits.
template <class Real>
struct WideVector3 {
  LocalVector3<Real> first, second, third;
  double base = 0;

  // At t = from + offset.
  LocalVector3<Real> at(double from, const Real& offset) const {
    const Real s = (Real(from) - Real(base)) + offset;
    return first + s * (second + s * third);
  }
};

}  // namespace hottel

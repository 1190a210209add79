// Two straight edges in local coordinates.
#pragma once

#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// Two straight edges, e(s) = s u and f(t) = d + t v for s and t in [0, 1], about 1 in size or smaller.
template <class Real>
struct EdgePair3 {
  LocalVector3<Real> d, u, v;
  double error = 0;  // f(t) - e(s) is off by at most this, for all s and t; 0: and all differences of ends are exact

  EdgePair3 swapped() const { return {-d, v, u, error}; }
  // The same edges, each run through from its other end.
  EdgePair3 reversed(bool is_e_reversed, bool is_f_reversed) const {
    EdgePair3 result = *this;
    if (is_e_reversed) {
      result.d = d - u;
      result.u = -u;
    }
    if (is_f_reversed) {
      result.d = result.d + v;
      result.v = -v;
    }
    if (error > 0) result.error += 2 * kRoundoff<Real> * static_cast<double>(length(d) + length(u) + length(v));
    return result;
  }
};

}  // namespace hottel

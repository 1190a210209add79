#include "geometry/visibility_quotient.h"

#include <cmath>
#include <limits>

namespace hottel {

double visibility_of(const Rounded& quotient) {
  if (quotient.value == 1.0 && quotient.side < 0) return std::nextafter(1.0, 0.0);
  if (quotient.value == 0.0 && quotient.side > 0) return std::numeric_limits<double>::denorm_min();
  return quotient.value;
}

}  // namespace hottel

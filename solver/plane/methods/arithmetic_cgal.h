// Exchange measures by CGAL's kernel with exact constructions.
#pragma once

#include "solver/plane/methods/arithmetic_sweep.h"

namespace hottel {

struct CgalExchange2 {
  PlainSums2 sums;
  std::vector<double> lengths;
  double seconds = 0;  // without the making of CGAL's points
};

CgalExchange2 cgal_exchange(const Arrangement2& arrangement, const ElementTable2& table);

}  // namespace hottel

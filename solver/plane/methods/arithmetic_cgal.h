// Direct exchange areas by CGAL's kernel with exact constructions.
#pragma once

#include "solver/plane/methods/arithmetic_sweep.h"

namespace hottel {

// Sums of distances and lengths, both in one unit, and the time they took.
//
//   (1) sums are 2 S(i, j) as plain_sums() returns them; lengths are by element (arithmetic_sweep.h)
struct CgalExchange2 {
  PlainSums2 sums;
  std::vector<double> lengths;
  double seconds = 0;  // without the making of CGAL's points
};

// Runs the sweep of the exact method with CGAL's exact orientations; distances are the square roots of CGAL's squared
// distances, which are exact before they become doubles. The arrangement and its triangulation are ours.
// REQUIRES the table of this arrangement. COST: that of the sweep, whose signs are CGAL's filtered ones.
CgalExchange2 cgal_exchange(const Arrangement2& arrangement, const ElementTable2& table,
                            const std::function<void(double)>& progress = {});

}  // namespace hottel

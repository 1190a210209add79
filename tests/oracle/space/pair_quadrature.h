// The exchange of two polygons by quadrature over points of the first.
#pragma once

#include <cstdint>

#include "tests/oracle/space/flat_polygon.h"

namespace hottel::oracle {

struct QuadratureResult {
  double measure = 0;
  double error = 0;  // an estimate: what two rules differ by, summed
  std::uint64_t points = 0;
};

// Integrates PointFactor over i. The polygon is cut along all lines on which a corner of one of the polygons is seen on
// a side of another, and along their planes: within its cells the factor is smooth, but for curves on which three sides
// are seen in one point. Cells are triangles, with the rule of Gauss in each; the worst is halved until the error is
// below tolerance * (area of i), or max_points are spent.
//
// It has nothing in common with integrals along edges. From j to i it takes other cells, so that pair.reversed() is
// a check of its own.
// COST: a millisecond to a second.
// SEE: docs/design/space/visibility_map.md for what is seen from a point.
QuadratureResult exchange_by_quadrature(const FlatPair& pair, double tolerance, std::uint64_t max_points = 3'000'000);

}  // namespace hottel::oracle

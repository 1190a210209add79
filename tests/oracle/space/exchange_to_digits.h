// The exchange of two polygons, whatever stands between, to thirty digits.
#pragma once

#include <gmpxx.h>

#include <string>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

struct DigitsResult {
  std::string measure;  // S = A F of polygon 0 to polygon 1, in scene units, to 34 decimals
  double error = 0;     // an estimate: the sum of what rules differ by
  std::size_t pieces = 0;
};

// All other polygons are opaque. With x on polygon 0 and y(t) on the edges where what x sees of polygon 1 ends,
//
//   2 pi S = - sum over edges  integral dt  sum over borders  count  integral of ln |x - y(t)|  y'(t) . dx
//
// where the borders are those of the points x from which the way past y(t) is free on one side of the edge and not on
// the other. (The sum of angles of Lambert, integrated over x by the theorem of Gauss; the inner integral has a closed
// form.) Between events of PlaneLines nothing changes; there rules of Gauss are halved until they agree.
//
// It shares nothing with integrals along edges but the edges: no moments, no origin, no cones of directions; whether
// ways are free is tried point by point, and there are no feet on polygon 0. From 1 to 0 all of it is different.
// Where borders are the same at five places, all events between are taken to change nothing: asks_all makes sure. What
// that could miss, the sum from 1 to 0 would tell.
// REQUIRES no two polygons that share an area of one plane.
// COST: half a second to a minute.
DigitsResult exchange_to_digits(const std::vector<SpacePolygon>& polygons, bool asks_all = false);

}  // namespace hottel::oracle

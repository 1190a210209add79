// The exchange of two polygons with nothing between them, to almost all digits of a long double.
#pragma once

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

struct FineMeasure {
  long double measure = 0;
  long double error = 0;  // an estimate: what two rules differ by
};

// Integrates Lambert's formula for points of i over the part of i in front of j, cut exactly. Around every corner of
// its outline, and around every corner of j on it, triangles have their apex there: what is not smooth is at their
// boundaries, where the rule (double exponential) does not mind.
// COST: some 10 milliseconds.
FineMeasure exchange_of_pair_alone(const SpacePolygon& i, const SpacePolygon& j);

// The part of a polygon in front of the plane of another one; nothing where that has no area.
SpacePolygon part_in_front(const SpacePolygon& polygon, const SpacePolygon& other);

}  // namespace hottel::oracle

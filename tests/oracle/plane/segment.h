// Whether two points of plane edges see each other, by moving the segment between them and looking at every edge.
// Rational coordinates, no data structure, nothing shared with what it checks.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "tests/oracle/plane/split.h"

namespace hottel::oracle {

// A point at parameter t of an edge, on its right side or (looks_left) its left side.
struct EdgePoint {
  InputSegment edge;
  mpq_class t;
  bool looks_left = false;
};

// The segment between the points is moved to either side by 2^-300, and cut off at the lines of the two edges. The
// points see each other iff both lie before the other's side and a moved segment crosses no edge.
// REQUIRES coordinates and parameters of less than some 30 bits, so that 2^-300 is as good as nothing.
bool see_each_other(const std::vector<InputSegment>& edges, const EdgePoint& p, const EdgePoint& q);

}  // namespace hottel::oracle

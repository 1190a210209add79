// The direct exchange areas of a plane scene, straight from the sum over the gaps of all lines through two vertices.
// Rational coordinates, no data structure, nothing shared with what it checks.
#pragma once

#include <gmpxx.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "tests/oracle/exact_sum.h"

namespace hottel::oracle {

inline constexpr int kInfinity = -1;  // the label of what lies beyond an open scene

// A closed segment from a to b with the labels of the faces on its left and on its right (>= 0; equal labels are one
// face). Segments given together have pairwise disjoint interiors; shared end points, T-junctions and collinear
// neighbours are fine.
struct Segment {
  mpq_class ax, ay, bx, by;
  int left, right;
};

using ElementPair = std::pair<int, int>;      // first <= second
using LengthSum = std::map<mpq_class, long>;  // squared length of a gap -> coefficient != 0
using Measures = std::map<ElementPair, LengthSum>;

// A free stretch of line between two consecutive vertices on it, and what it adds to the measures.
struct Gap {
  struct Term {
    int f, g, sign;  // M(f,g) and M(g,f) each change by sign times the length of the gap
  };
  mpq_class squared_length;
  bool is_covered;  // a segment lies along it
  int left, right;  // then: its labels, left and right of the gap's direction
  std::vector<Term> terms;
};

// Visits every gap that adds something, once.
//
//   (1) over the terms of one gap the signs in the row of every label cancel (a term with f = g counts twice), except
//       that each label of a covering segment keeps +2
void for_each_gap(const std::vector<Segment>& segments, const std::function<void(const Gap&)>& visit);

// Returns M(f,g) for all pairs of labels, kInfinity included, as coefficients of the lengths of gaps: the measure of
// the lines that carry a free segment with one end on f and the other on g. M = 2 S = 2 A_f F_fg.
//
//   (1) a missing pair exchanges nothing; of a pair that is there the lengths may still cancel: exact_measures decides
//   (2) a line with both ends on the same label counts twice in M(f,f), so sum over g of M(f,g) is twice the length of
//       f (3) (kInfinity, kInfinity) is left out: it has no finite measure
// COST: O(V^3) orientation tests for V vertices, in doubles with an error bound and else in rationals.
Measures exchange_measures(const std::vector<Segment>& segments);

// Returns the same in normal form, without the pairs that are zero.
ExactSum exact_sum(const LengthSum& lengths);
std::map<ElementPair, ExactSum> exact_measures(const std::vector<Segment>& segments);

}  // namespace hottel::oracle

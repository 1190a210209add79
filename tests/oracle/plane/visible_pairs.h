// Which vertices of a plane scene see each other: every pair against every piece, over rationals.
#pragma once

#include <gmpxx.h>

#include <tuple>
#include <utility>
#include <vector>

#include "tests/oracle/plane/split.h"

namespace hottel::oracle {

struct VisiblePair {
  std::pair<mpq_class, mpq_class> v, w;  // v < w
  bool is_along = false;                 // a piece lies between them
  friend bool operator==(const VisiblePair&, const VisiblePair&) = default;
  friend bool operator<(const VisiblePair& p, const VisiblePair& q) { return std::tie(p.v, p.w) < std::tie(q.v, q.w); }
};

// Returns all pairs of ends of pieces with nothing between them, ascending: no vertex lies between, no piece crosses,
// and the middle lies in no solid; or a piece joins them, and not both its sides are covered. REQUIRES pieces that meet
// in their ends only. COST: O(V^2 n) for V vertices and n pieces.
std::vector<VisiblePair> visible_pairs(const std::vector<Segment>& pieces);

}  // namespace hottel::oracle

// What one gap adds to the direct exchange areas: the sum rule of docs/design/plane/exchange.md, in one place.
#pragma once

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/visibility/visible_lines.h"

namespace hottel {

// Calls add(i, j, sign) for the terms sign * |v w| that a gap adds to 2 S(i, j) of labels i and j (in either order; a
// label with itself counts twice, once for each direction of the line). Pairs of which neither has a row are left out.
//
// Over all gaps of a scene the terms of a pair sum to 2 S(i, j): the crossed strings less the uncrossed ones, taken
// apart gap by gap (docs/design/plane/exchange.md).
//
//   (1) the signs of all terms of one row cancel, except on a covered gap, where each side of the piece gets +2 in all
//   (2) a free gap adds at most four terms, and none where one of its two ends meets the same element on both sides
//   (3) a covered gap adds at most six
template <class Add>
void for_each_term(const Gap2& gap, const ElementTable2& table, const Add& add) {
  const auto term = [&](std::uint32_t i, std::uint32_t j, int sign) {
    if (table.has_row(i) || table.has_row(j)) add(i, j, sign);
  };
  const std::uint32_t behind_left = table.of(gap.behind_left), behind_right = table.of(gap.behind_right);
  const std::uint32_t ahead_left = table.of(gap.ahead_left), ahead_right = table.of(gap.ahead_right);
  if (gap.covered_left == kNoPiece) {
    if (behind_left == behind_right || ahead_left == ahead_right) return;
    term(behind_left, ahead_right, 1);
    term(behind_right, ahead_left, 1);
  } else {
    const std::uint32_t left = table.of(gap.covered_left), right = table.of(gap.covered_right);
    term(behind_left, right, 1);
    term(right, ahead_left, 1);
    term(behind_right, left, 1);
    term(left, ahead_right, 1);
  }
  term(behind_left, ahead_left, -1);
  term(behind_right, ahead_right, -1);
}

}  // namespace hottel

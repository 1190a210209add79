// The cells of a grid that a triangle may reach.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/plane/light/cell_frame.h"

namespace hottel {

// A range of x; empty (min > max) until something is included.
struct Columns2 {
  double min = HUGE_VAL, max = -HUGE_VAL;
  void include(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};
// Returns the x that a triangle takes between two heights; empty when it takes none. REQUIRES bottom <= top.
Columns2 columns_of(const Vector2 (&corners)[3], double bottom, double top);

// Calls visit(ix, iy) for the cells of some rows that come within `slack` of a triangle, and for some near them.
//
//   (1) no cell that comes within `slack` is left out; each is visited at most once
//   (2) row by row, from the left
// Degenerate: two corners of the triangle may be equal. REQUIRES finite corners, slack >= 0. COST: the cells visited.
template <class Visit>
void for_each_cell_near(const Vector2 (&corners)[3], double slack, const CellFrame2& frame, std::uint32_t first_row,
                        std::uint32_t end_row, const Visit& visit) {
  // Index of the cell that a place lies in, kept within [0, count].
  const auto index_in = [](double place, std::uint32_t count) {
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, static_cast<double>(count))) : 0;
  };
  const double height = frame.height();
  const double lowest = std::min({corners[0].y, corners[1].y, corners[2].y});
  const double highest = std::max({corners[0].y, corners[1].y, corners[2].y});
  const std::uint32_t begin = std::max(first_row, index_in((lowest - slack) / height, frame.ny()));
  const std::uint32_t end = std::min(end_row, index_in((highest + slack) / height + 1, frame.ny()));
  for (std::uint32_t iy = begin; iy < end; ++iy) {
    const Columns2 x = columns_of(corners, iy * height - slack, (iy + 1) * height + slack);
    const std::uint32_t left = index_in(x.min - slack, frame.nx()), right = index_in(x.max + slack + 1, frame.nx());
    for (std::uint32_t ix = left; ix < right; ++ix) visit(ix, iy);
  }
}

}  // namespace hottel

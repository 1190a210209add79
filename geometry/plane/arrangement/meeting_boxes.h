// Boxes that meet.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace hottel {

// A closed box with its sides along the axes; it may be a segment or a point. REQUIRES: low <= high
// in both coordinates.
struct NumberedBox2 {
  std::array<double, 2> low, high;  // along x, along y
  std::uint32_t number;
};

// Calls visit(one, two) with the numbers of every box of the first list and every box of the second that have a point
// in common, their borders included; in no order.
//
//   (1) every such pair is visited once
//   (2) a box meets its own copy in the other list
//   (3) boxes of one list are not compared with each other; numbers need not be unique
//
// COST: O(n log n + k) for k pairs that meet.
// SEE: Zomorodian, Edelsbrunner, Fast software for box intersections, 2002 (by CGAL).
void for_each_meeting(const std::vector<NumberedBox2>& first, const std::vector<NumberedBox2>& second,
                      const std::function<void(std::uint32_t one, std::uint32_t two)>& visit);

}  // namespace hottel

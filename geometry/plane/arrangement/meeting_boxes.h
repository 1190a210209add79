// Boxes that meet.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace hottel {

struct NumberedBox2 {
  std::array<double, 2> low, high;  // along x, along y
  std::uint32_t number;
};

// Calls visit(one, two) with the numbers of every box of the first list and every box of the second that have a point
// in common, their borders included; in no order.
// COST: O(n log n + k) for k pairs that meet.
void for_each_meeting(const std::vector<NumberedBox2>& first, const std::vector<NumberedBox2>& second,
                      const std::function<void(std::uint32_t one, std::uint32_t two)>& visit);

}  // namespace hottel

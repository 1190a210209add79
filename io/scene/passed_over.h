// What is passed over in maps, drawings and meshes because there is no geometry in it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace hottel {

// Counts what readers of formats that are not hottel's own passed over.
struct PassedOver {
  std::size_t repeated_points = 0;   // equal to the one before; of a face or a closed outline also to its first
  std::size_t empty_geometries = 0;  // null, EMPTY, or a list of no positions

  // "2 repeated points and 1 empty geometry passed over"; empty where nothing was.
  std::string note() const;
};

// Takes out every point that is the same as the one before it, and those at the end of a ring that are the same as its
// first. Returns how many there were. COST: linear.
template <class Point, class Same>
std::size_t drop_repeated(std::vector<Point>& points, bool is_ring, const Same& same) {
  const std::size_t before = points.size();
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  while (is_ring && points.size() > 1 && same(points.back(), points.front())) points.pop_back();
  return before - points.size();
}

}  // namespace hottel

// A tree of boxes, for finding all that meet a given box.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/point.h"

namespace hottel {

// Boxes around whatever is to be found. For several threads at once.
//
// COST: O(n log n) to build; a question about as much as it finds.
class BoxTree3 {
 public:
  explicit BoxTree3(std::vector<Box3> boxes);

  // Appends the numbers of the boxes that meet this one, in no order.
  void find(const Box3& box, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    Box3 box;
    std::uint32_t begin, end;        // places in order_
    std::uint32_t second_child = 0;  // the first child is the next node; 0: a leaf
  };
  void build(std::size_t begin, std::size_t end, int depth);

  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

// Makes a box contain a point of the scene, each coordinate as the nearest double. Rounding keeps the order of numbers:
// where things meet, their boxes do.
void include_rounded(const Point3& point, Box3& box);

// Makes a box larger by so much on all sides, and a little more for what is rounded in doing so.
void grow(Box3& box, double by);

}  // namespace hottel

#include "geometry/plane/arrangement/meeting_boxes.h"

#include <CGAL/box_intersection_d.h>

namespace hottel {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const NumberedBox2*>;

// CGAL takes boxes with one handle for one box, which does not meet itself: each has a handle of its own.
std::vector<Box> boxes_of(const std::vector<NumberedBox2>& boxes) {
  std::vector<Box> result;
  result.reserve(boxes.size());
  for (const NumberedBox2& box : boxes) {
    double low[2] = {box.low[0], box.low[1]}, high[2] = {box.high[0], box.high[1]};
    result.emplace_back(low, high, &box);
  }
  return result;
}

}  // namespace

void for_each_meeting(const std::vector<NumberedBox2>& first, const std::vector<NumberedBox2>& second,
                      const std::function<void(std::uint32_t one, std::uint32_t two)>& visit) {
  std::vector<Box> ones = boxes_of(first), twos = boxes_of(second);
  CGAL::box_intersection_d(ones.begin(), ones.end(), twos.begin(), twos.end(),
                           [&](const Box& one, const Box& two) { visit(one.handle()->number, two.handle()->number); });
}

}  // namespace hottel

#include "geometry/space/contacts/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/doubles.h"

namespace hottel {
namespace {

constexpr std::size_t kLeaf = 4;

}  // namespace

BoxTree3::BoxTree3(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!boxes_.empty()) build(0, boxes_.size(), 0);
}

void BoxTree3::build(std::size_t begin, std::size_t end, int depth) {
  const std::size_t at = nodes_.size();
  Node node{{}, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  for (std::size_t k = begin; k < end; ++k) node.box.include(boxes_[order_[k]]);
  const int axis = depth % 3;
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return;
  const auto place = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  const auto center = [&](std::uint32_t k) { return boxes_[k].low[axis] + boxes_[k].high[axis]; };
  const std::size_t half = begin + (end - begin) / 2;
  std::nth_element(place(begin), place(half), place(end),
                   [&](std::uint32_t a, std::uint32_t b) { return center(a) < center(b); });
  build(begin, half, depth + 1);
  nodes_[at].second_child = static_cast<std::uint32_t>(nodes_.size());
  build(half, end, depth + 1);
}

void BoxTree3::find(const Box3& box, std::vector<std::uint32_t>& found) const {
  if (nodes_.empty()) return;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const Node& node = nodes_[n];
    if (!node.box.meets(box)) continue;
    if (node.second_child != 0) {
      open.push_back(node.second_child);
      open.push_back(n + 1);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      if (boxes_[order_[k]].meets(box)) found.push_back(order_[k]);
  }
}

void include_rounded(const Point3& point, Box3& box) {
  box.include(BoundedVector{to_double(point.x), to_double(point.y), to_double(point.z), 0, 0});
}

void grow(Box3& box, double by) {
  for (int a = 0; a < 3; ++a) {
    box.low[a] = std::nextafter(box.low[a] - by, -kInfinity);
    box.high[a] = std::nextafter(box.high[a] + by, kInfinity);
  }
}

}  // namespace hottel

#include "solver/plane/methods/place_tree.h"

#include <algorithm>
#include <cmath>

namespace hottel {

double LocalBox2::reach(const LocalVector2& along) const {
  return half.x * std::fabs(along.x) + half.y * std::fabs(along.y);
}

PlaceTree2::PlaceTree2(const ElementGeometry2& geometry, std::size_t vertices)
    : order_(IdRange<VertexId>(vertices).begin(), IdRange<VertexId>(vertices).end()) {
  if (vertices > 0) build(geometry, 0, 0, vertices);
}

void PlaceTree2::build(const ElementGeometry2& geometry, std::size_t node, std::size_t begin, std::size_t end) {
  const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin),
             last = order_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto x = [&](VertexId v) { return geometry.place(v).x; };
  const auto y = [&](VertexId v) { return geometry.place(v).y; };
  const auto by_x = [&](VertexId v, VertexId w) { return x(v) < x(w); };
  const auto by_y = [&](VertexId v, VertexId w) { return y(v) < y(w); };
  const auto [left, right] = std::minmax_element(first, last, by_x);
  const auto [low, high] = std::minmax_element(first, last, by_y);
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  LocalBox2& box = boxes_[node];
  box = {{(x(*left) + x(*right)) / 2, (y(*low) + y(*high)) / 2},
         {(x(*right) - x(*left)) / 2, (y(*high) - y(*low)) / 2}};
  if (end - begin <= kLeaf) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto cut = order_.begin() + static_cast<std::ptrdiff_t>(middle);
  if (box.half.x > box.half.y)
    std::nth_element(first, cut, last, by_x);
  else
    std::nth_element(first, cut, last, by_y);
  build(geometry, 2 * node + 1, begin, middle);
  build(geometry, 2 * node + 2, middle, end);
}

bool PlaceTree2::visit(std::size_t node, std::size_t begin, std::size_t end, const Enters& enters,
                       const Visit& visit_vertex) const {
  if (!enters(boxes_[node])) return true;
  if (end - begin <= kLeaf)
    return std::all_of(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                       order_.begin() + static_cast<std::ptrdiff_t>(end), visit_vertex);
  const std::size_t middle = begin + (end - begin) / 2;
  return visit(2 * node + 1, begin, middle, enters, visit_vertex) &&
         visit(2 * node + 2, middle, end, enters, visit_vertex);
}

bool PlaceTree2::visit_before(const ElementRun2& run, const Visit& visit_vertex) const {
  if (order_.empty()) return true;
  const LocalVector2 up = run.normal(), from{run.from.x, run.from.y};
  const auto enters = [&](const LocalBox2& box) {
    return dot({box.middle.x - from.x, box.middle.y - from.y}, up) + box.reach(up) >= -kSlack;
  };
  return visit(0, 0, order_.size(), enters, visit_vertex);
}

bool PlaceTree2::visit_near(const LocalPoint2& from, const LocalVector2& along, double distance,
                            const Visit& visit_vertex) const {
  if (order_.empty()) return true;
  const double size = length(along), reach = distance + kSlack;
  if (!(size > 0))
    return visit(
        0, 0, order_.size(), [](const LocalBox2&) { return true; }, visit_vertex);
  const LocalVector2 direction{along.x / size, along.y / size}, across{-direction.y, direction.x};
  const auto enters = [&](const LocalBox2& box) {
    const LocalVector2 way{box.middle.x - from.x, box.middle.y - from.y};
    const double t = dot(way, direction), slack = box.reach(direction) + reach;
    return std::fabs(dot(way, across)) <= box.reach(across) + reach && t >= -slack && t <= size + slack;
  };
  return visit(0, 0, order_.size(), enters, visit_vertex);
}

}  // namespace hottel

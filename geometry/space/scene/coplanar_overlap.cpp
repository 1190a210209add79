#include "geometry/space/scene/coplanar_overlap.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

namespace hottel {
namespace {

// a x + b y + c z = d in integers without a common divisor, the first of a, b, c that is not 0 positive: one for each
// plane.
using PlaneKey3 = std::array<Integer, 4>;

PlaneKey3 plane_of(const Polygon3& polygon) {
  const Vector3 normal = doubled_area(polygon);
  const Point3& at = polygon.points[0];
  const std::array<Rational, 4> typed{normal.x, normal.y, normal.z,
                                      normal.x * at.x + normal.y * at.y + normal.z * at.z};
  Integer denominator = 1, divisor = 0;
  for (const Rational& value : typed) denominator = lcm(denominator, value.get_den());
  PlaneKey3 key;
  for (std::size_t k = 0; k < 4; ++k) {
    key[k] = typed[k].get_num() * (denominator / typed[k].get_den());
    divisor = gcd(divisor, key[k]);
  }
  if (*std::find_if(key.begin(), key.end(), [](const Integer& value) { return value != 0; }) < 0) divisor = -divisor;
  for (Integer& value : key) value /= divisor;
  return key;
}

bool precedes(const PlaneKey3& a, const PlaneKey3& b) {
  for (std::size_t k = 0; k < 4; ++k)
    if (const int order = cmp(a[k], b[k])) return order < 0;
  return false;
}

// A point in coordinates of its plane.
struct Flat {
  Rational u, v;
};

// The polygon without the coordinate along which its plane's normal is not 0, counter-clockwise.
std::vector<Flat> flattened(const Polygon3& polygon, const PlaneKey3& plane, const Point3& origin) {
  const auto axis = std::find_if(plane.begin(), plane.end(), [](const Integer& value) { return value != 0; });
  const auto dropped = axis - plane.begin();
  std::vector<Flat> flat;
  for (const Point3& point : polygon.points) {
    Vector3 way = point - origin;
    flat.push_back({std::move(dropped == 0 ? way.y : way.x), std::move(dropped == 2 ? way.y : way.z)});
  }
  const Vector3 normal = doubled_area(polygon);
  const int side = dropped == 0 ? sgn(normal.x) : dropped == 1 ? -sgn(normal.y) : sgn(normal.z);
  if (side < 0) std::reverse(flat.begin(), flat.end());
  return flat;
}

// True iff no point lies left of some edge of the convex polygon, which goes around counter-clockwise.
bool an_edge_parts(const std::vector<Flat>& polygon, const std::vector<Flat>& points) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Flat &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const Rational du = to.u - from.u, dv = to.v - from.v;
    const auto is_left = [&](const Flat& p) { return du * (p.v - from.v) > dv * (p.u - from.u); };
    if (std::none_of(points.begin(), points.end(), is_left)) return true;
  }
  return false;
}

// Interiors of convex polygons are disjoint iff a line through an edge of one of them parts them.
bool share_an_area(const std::vector<Flat>& a, const std::vector<Flat>& b) {
  return !an_edge_parts(a, b) && !an_edge_parts(b, a);
}

// The box of a polygon, rounded. Rounding keeps the order of numbers: where polygons meet, their boxes do.
struct Box {
  std::array<double, 2> low, high;
};

Box box_of(const std::vector<Flat>& polygon) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Flat& point : polygon)
    for (const std::size_t axis : {0u, 1u}) {
      const double value = to_double(axis == 0 ? point.u : point.v);
      box.low[axis] = std::min(box.low[axis], value);
      box.high[axis] = std::max(box.high[axis], value);
    }
  return box;
}

bool meet(const Box& a, const Box& b) {
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
}

// A tree of boxes, asked which of those before a number meet a box.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(boxes.size());
    build(0, boxes.size(), 0);
  }

  // Calls visit(k) for each box k < end that meets the box, in no order.
  template <class Visit>
  void for_each_before(std::uint32_t end, const Box& box, const Visit& visit) const {
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (node.first >= end || !meet(node.box, box)) continue;
      if (node.second_child != 0) {
        open.push_back(node.second_child);
        open.push_back(static_cast<std::uint32_t>(&node - nodes_.data()) + 1);
        continue;
      }
      for (std::size_t k = node.begin; k < node.end; ++k)
        if (order_[k] < end && meet(boxes_[order_[k]], box)) visit(order_[k]);
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first;             // the least number in it
    std::uint32_t begin, end;        // places in order_
    std::uint32_t second_child = 0;  // the first child is the next node; 0: a leaf
  };

  // Makes the node of a range of order_, and those below it.
  void build(std::size_t begin, std::size_t end, std::size_t axis) {
    constexpr std::size_t kLeaf = 4;
    const std::size_t at = nodes_.size();
    Node node{boxes_[order_[begin]], order_[begin], static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    for (std::size_t k = begin; k < end; ++k) {
      node.first = std::min(node.first, order_[k]);
      for (const std::size_t a : {0u, 1u}) {
        node.box.low[a] = std::min(node.box.low[a], boxes_[order_[k]].low[a]);
        node.box.high[a] = std::max(node.box.high[a], boxes_[order_[k]].high[a]);
      }
    }
    nodes_.push_back(node);
    if (end - begin <= kLeaf) return;
    const auto place = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(place(begin), place(middle), place(end),
                     [&](std::uint32_t a, std::uint32_t b) { return boxes_[a].low[axis] < boxes_[b].low[axis]; });
    build(begin, middle, 1 - axis);
    nodes_[at].second_child = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end, 1 - axis);
  }

  const std::vector<Box>& boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;  // a polygon, and one after it

// The first overlap among polygons of one plane, whose numbers ascend.
std::optional<Pair> first_in_plane(const std::vector<Polygon3>& polygons, std::span<const std::uint32_t> numbers,
                                   const PlaneKey3& plane) {
  std::vector<std::vector<Flat>> flat;
  std::vector<Box> boxes;
  for (const std::uint32_t number : numbers) {
    flat.push_back(flattened(polygons[number], plane, polygons[numbers[0]].points[0]));
    boxes.push_back(box_of(flat.back()));
  }
  const BoxTree tree(boxes);
  for (std::uint32_t second = 1; second < numbers.size(); ++second) {
    std::uint32_t first = second;
    tree.for_each_before(second, boxes[second], [&](std::uint32_t k) {
      if (k < first && share_an_area(flat[k], flat[second])) first = k;
    });
    if (first < second) return Pair{numbers[first], numbers[second]};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::pair<std::uint32_t, std::uint32_t>> first_overlap(const std::vector<Polygon3>& polygons) {
  std::vector<PlaneKey3> planes;
  planes.reserve(polygons.size());
  for (const Polygon3& polygon : polygons) planes.push_back(plane_of(polygon));
  std::vector<std::uint32_t> order(polygons.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return precedes(planes[a], planes[b]); });
  std::optional<Pair> result;
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end =
        std::find_if(begin, order.end(), [&](std::uint32_t k) { return precedes(planes[*begin], planes[k]); });
    const auto found = first_in_plane(polygons, {begin, end}, planes[*begin]);
    if (found && (!result || found->second < result->second)) result = found;
    begin = end;
  }
  return result;
}

}  // namespace hottel

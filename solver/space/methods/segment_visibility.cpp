#include "solver/space/methods/segment_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/exact_double.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

using Point = LocalVector3<double>;
constexpr std::uint32_t kNone = 0xffffffff;

struct ExactVector {
  Rational x, y, z;
};

ExactVector exact_difference(const Point& a, const Point& b) {
  return {exact_value(a.x) - exact_value(b.x), exact_value(a.y) - exact_value(b.y),
          exact_value(a.z) - exact_value(b.z)};
}
ExactVector exact_cross(const ExactVector& a, const ExactVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The sign of the product with (e, e^2, e^3) for an infinitesimal e.
int shifted_sign(const ExactVector& a) {
  for (const Rational* component : {&a.x, &a.y, &a.z})
    if (const int s = sgn(*component); s != 0) return s;
  return 0;
}

double largest(const Point& a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }

// The sign of a determinant of three differences that are rounded once each, or 0 where roundings may decide: six
// products of three factors, each off by 5 roundings, and their sum.
int filtered_sign(const Point& a, const Point& b, const Point& c) {
  const double value = dot(a, cross(b, c));
  const double error = 0x1p-47 * largest(a) * largest(b) * largest(c) + 0x1p-1000;
  return value > error ? 1 : value < -error ? -1 : 0;
}

// On which side of the plane of a, b, c the moved point p is: +1, -1, or 0 where the three are on one line.
int side_of_plane(const Point& a, const Point& b, const Point& c, const Point& p) {
  if (const int sign = filtered_sign(p - a, b - a, c - a); sign != 0) return sign;
  const ExactVector normal = exact_cross(exact_difference(b, a), exact_difference(c, a)), way = exact_difference(p, a);
  if (const int sign = sgn(Rational(way.x * normal.x + way.y * normal.y + way.z * normal.z)); sign != 0) return sign;
  return shifted_sign(normal);
}

// On which side of the line from a to b the moved line from p to q passes: 0 where they are parallel.
int side_of_line(const Point& p, const Point& q, const Point& a, const Point& b) {
  if (const int sign = filtered_sign(q - p, a - p, b - p); sign != 0) return sign;
  const ExactVector way = exact_difference(q, p);
  const ExactVector normal = exact_cross(exact_difference(a, p), exact_difference(b, p));
  if (const int sign = sgn(Rational(way.x * normal.x + way.y * normal.y + way.z * normal.z)); sign != 0) return sign;
  return shifted_sign(exact_cross(way, exact_difference(b, a)));
}

}  // namespace

SegmentVisibility3::SegmentVisibility3(const Occluders3& occluders) : occluders_(occluders) {
  const Vertices3& vertices = occluders.vertices();
  for (const VertexId3 v : IdRange<VertexId3>(vertices.size())) {
    const BoundedVector& place = vertices.approximate(v);
    corners_.push_back({place.x, place.y, place.z});
  }
  const auto& nodes = occluders.nodes();
  boxes_.resize(nodes.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  for (std::size_t n = nodes.size(); n-- > 0;) {
    Box& box = boxes_[n] = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    const auto add = [&box](const std::array<double, 3>& low, const std::array<double, 3>& high) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], low[k]);
        box.high[k] = std::max(box.high[k], high[k]);
      }
    };
    if (nodes[n].left != 0) {
      for (const std::uint32_t child : {nodes[n].left, nodes[n].right}) add(boxes_[child].low, boxes_[child].high);
      continue;
    }
    for (std::uint32_t k = nodes[n].begin; k < nodes[n].end; ++k)
      for (const VertexId3 v : occluders.outline(occluders.order()[k])) {
        const Point& p = corners_[v.index()];
        add({p.x, p.y, p.z}, {p.x, p.y, p.z});
      }
  }
  if (!boxes_.empty()) {
    const Box& all = boxes_.front();
    diagonal_ = length(Point{all.high[0] - all.low[0], all.high[1] - all.low[1], all.high[2] - all.low[2]});
  }
}

bool SegmentVisibility3::see_each_other(const SurfacePoint3& p, const SurfacePoint3& q) const {
  return is_free(p.at, q.at, p.surface, q.surface);
}

bool SegmentVisibility3::sees_sky(const SurfacePoint3& p, const LocalVector3<double>& direction) const {
  return is_free(p.at, p.at + 4 * diagonal_ * direction, p.surface, kNone);
}

bool SegmentVisibility3::is_free(const Point& p, const Point& q, std::uint32_t own, std::uint32_t other) const {
  const std::array<double, 3> from{p.x, p.y, p.z}, way{q.x - p.x, q.y - p.y, q.z - p.z};
  const double slack = 0x1p-40 * (diagonal_ + largest(q - p));
  const auto meets = [&](const Box& box) {
    double begin = 0, end = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = box.low[k] - slack - from[k], high = box.high[k] + slack - from[k];
      if (way[k] == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const double at_low = low / way[k], at_high = high / way[k];
      begin = std::max(begin, std::min(at_low, at_high));
      end = std::min(end, std::max(at_low, at_high));
    }
    return begin <= end;
  };
  if (boxes_.empty()) return true;
  std::array<std::uint32_t, 128> waiting;  // the tree halves its polygons: never so deep
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t n = waiting[--count];
    if (!meets(boxes_[n])) continue;
    const Occluders3::Node& node = occluders_.nodes()[n];
    if (node.left != 0) {
      waiting[count++] = node.left;
      waiting[count++] = node.right;
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      const std::uint32_t surface = occluders_.order()[k];
      if (surface != own && surface != other && hides(surface, p, q)) return false;
    }
  }
  return true;
}

bool SegmentVisibility3::hides(std::uint32_t surface, const Point& p, const Point& q) const {
  const auto outline = occluders_.outline(surface);
  const auto corner = [&](std::size_t k) -> const Point& { return corners_[outline[k].index()]; };
  const int before = side_of_plane(corner(0), corner(1), corner(2), p);
  if (before == 0 || before == side_of_plane(corner(0), corner(1), corner(2), q)) return false;
  // The line passes all edges on one side.
  int side = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    // Always from the same end: then both polygons at an edge answer alike.
    const VertexId3 a = outline[k], b = outline[k + 1 == outline.size() ? 0 : k + 1];
    const int here = a.index() < b.index() ? side_of_line(p, q, corners_[a.index()], corners_[b.index()])
                                           : -side_of_line(p, q, corners_[b.index()], corners_[a.index()]);
    if (here == 0 || (side != 0 && here != side)) return false;
    side = here;
  }
  return true;
}

}  // namespace hottel

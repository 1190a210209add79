#include "geometry/plane/visibility/point_location.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace hottel {

PointLocation2::PointLocation2(const Vertices2& vertices, const Triangulation2& triangulation)
    : vertices_(vertices), triangulation_(triangulation) {
  const std::size_t triangles = triangulation.triangle_count();
  if (triangles == 0) return;
  double x1 = -HUGE_VAL, y1 = -HUGE_VAL;
  x0_ = y0_ = HUGE_VAL;
  for (const VertexId v : vertices.ids()) {
    const auto& p = vertices.approximate(v);
    x0_ = std::min(x0_, p.x);
    y0_ = std::min(y0_, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
  cells_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(triangles) / 2)), 1, 2048);
  cells_per_length_ = cells_ / (std::max(x1 - x0_, y1 - y0_) * 1.0000001);
  start_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_), TriangleId::none());
  std::unordered_map<VertexId, HalfEdgeId> hull_from;
  for (const TriangleId t : triangulation.triangles()) {
    double x = 0, y = 0;
    for (const HalfEdgeId h : half_edges_of(t)) {
      x += vertices.approximate(triangulation.corner(h)).x / 3;
      y += vertices.approximate(triangulation.corner(h)).y / 3;
      if (triangulation.across(h).is_none()) hull_from[triangulation.origin(h)] = h;
    }
    start_[cell(x, y)] = t;
  }
  // Cells without a triangle of their own start from the nearest one before them.
  TriangleId last(0);
  for (TriangleId& start : start_) {
    if (start.is_none()) start = last;
    last = start;
  }
  HalfEdgeId h = hull_from.begin()->second;
  do {
    hull_.push_back(h);
    h = hull_from.at(triangulation.target(h));
  } while (h != hull_.front());
}

std::size_t PointLocation2::cell(double x, double y) const {
  const auto index = [this](double distance) {
    const double position = distance * cells_per_length_;
    return position > 0 ? static_cast<std::size_t>(std::min(position, cells_ - 1.0)) : std::size_t{0};
  };
  return index(y - y0_) * static_cast<std::size_t>(cells_) + index(x - x0_);
}

Location2 PointLocation2::locate(const Eye2& eye) const {
  TriangleId near = TriangleId::none();
  return locate(eye, near);
}

Location2 PointLocation2::locate(const Eye2& eye, TriangleId& near) const {
  using Kind = Location2::Kind;
  if (start_.empty()) {  // every vertex on one line: no triangle
    for (const VertexId v : vertices_.ids())
      if (eye.coincides_with(v)) return {Kind::kOnVertex, HalfEdgeId::none(), v};
    return {};
  }
  TriangleId triangle = !near.is_none() ? near : start_[cell(eye.x(), eye.y())];
  std::uint32_t chance = 12345;
  for (;;) {
    // Which edges have the point on their outer side or on them? The first one to be looked at changes by chance, so
    // that the walk cannot go in circles for ever.
    chance = chance * 1664525u + 1013904223u;
    const int first = static_cast<int>((chance >> 16) % 3);
    HalfEdgeId on[3];
    int on_count = 0;
    HalfEdgeId leave = HalfEdgeId::none();
    for (int k = 0; k < 3 && leave.is_none(); ++k) {
      const HalfEdgeId h = half_edge(triangle, (first + k) % 3);
      const int side = eye.orientation(triangulation_.origin(h), triangulation_.target(h));
      if (side < 0) leave = h;
      if (side == 0) on[on_count++] = h;
    }
    near = triangle;
    if (leave.is_none()) {
      if (on_count == 0) return {Kind::kInTriangle, half_edge(triangle, 0)};
      if (on_count == 1) {
        const HalfEdgeId twin = triangulation_.across(on[0]);
        return {Kind::kOnEdge, twin.is_none() ? on[0] : std::min(on[0], twin)};
      }
      // On two edges: their common corner, which is opposite to the third.
      const int third = 3 - place_in_triangle(on[0]) - place_in_triangle(on[1]);
      return {Kind::kOnVertex, HalfEdgeId::none(), triangulation_.corner(half_edge(triangle, third))};
    }
    const HalfEdgeId next = triangulation_.across(leave);
    if (next.is_none()) return {};
    triangle = triangle_of(next);
  }
}

Location2 PointLocation2::look_around(const Eye2& eye, View2& view) const {
  TriangleId near = TriangleId::none();
  return look_around(eye, view, near);
}

Location2 PointLocation2::look_around(const Eye2& eye, View2& view, TriangleId& near) const {
  using Kind = Location2::Kind;
  const Location2 place = locate(eye, near);
  if (place.kind == Kind::kOnVertex) {
    hottel::look_around(vertices_, triangulation_, place.vertex, view);
    return place;
  }
  view.seen.clear();
  if (place.kind == Kind::kOutside) {
    look_around_outside(eye, view);
    return place;
  }
  const PlainEye look([&eye](VertexId j, VertexId k) { return eye.orientation(j, k); });
  const auto through = [&](HalfEdgeId h, PieceSideId left, PieceSideId right) {
    const VertexId from = triangulation_.origin(h), to = triangulation_.target(h);
    view.seen.push_back({from, kSky, left, right});
    expand_cone_through(triangulation_, h, from, to, look, view);
  };
  if (place.kind == Kind::kInTriangle) {
    for (const HalfEdgeId h : half_edges_of(triangle_of(place.half_edge))) through(h, kNoPiece, kNoPiece);
    return place;
  }
  // On an edge: the other two edges of the triangle on each side. Towards its target the inner side lies on the left.
  const HalfEdgeId h = place.half_edge, twin = triangulation_.across(h);
  const PieceSideId inner = triangulation_.is_piece(h) ? triangulation_.side(h) : kNoPiece;
  const PieceSideId outer = inner == kNoPiece ? kNoPiece : opposite(inner);
  through(next_half_edge(h), inner, outer);
  through(previous_half_edge(h), kNoPiece, kNoPiece);
  if (!twin.is_none()) {
    through(next_half_edge(twin), outer, inner);
    through(previous_half_edge(twin), kNoPiece, kNoPiece);
  } else {
    view.seen.push_back({triangulation_.origin(h), kSky, outer, inner});
  }
  return place;
}

void PointLocation2::look_around_outside(const Eye2& eye, View2& view) const {
  const PlainEye outside([&eye](VertexId j, VertexId k) { return eye.orientation(j, k); });
  if (hull_.empty()) {
    // A scene on one line, seen from beside it or from a point of the line.
    std::vector<VertexId> order(vertices_.ids().begin(), vertices_.ids().end());
    std::sort(order.begin(), order.end(), [&](VertexId i, VertexId j) { return vertices_.precedes(i, j); });
    if (order.size() < 2) return;
    const int turn = eye.orientation(order.front(), order.back());
    if (turn < 0) std::reverse(order.begin(), order.end());
    const auto between = [&](VertexId right, VertexId left) {
      for (const StarEntry2& entry : triangulation_.star(right))
        if (entry.neighbour == left) return entry.left;
      return kNoPiece;
    };
    if (turn != 0) {
      for (std::size_t k = 0; k < order.size(); ++k) {
        const PieceSideId side = k + 1 < order.size() ? between(order[k], order[k + 1]) : kNoPiece;
        view.seen.push_back({order[k], side == kNoPiece ? kSky : side, kNoPiece, kNoPiece});
      }
      return;
    }
    // On the line: the nearest vertex on either side; the piece between them, if any, covers both directions.
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      if (eye.direction_sign(order[k], order[k + 1]) > 0) continue;
      const PieceSideId left = between(order[k], order[k + 1]);
      const PieceSideId right = left == kNoPiece ? kNoPiece : opposite(left);
      view.seen.push_back({order[k], kSky, right, left});
      view.seen.push_back({order[k + 1], kSky, left, right});
      return;
    }
    // Beyond one end, which is the only vertex seen.
    const Point2 at = eye.exact(), first = vertices_.exact(order.front()), last = vertices_.exact(order.back());
    const Rational ahead = (last.x - first.x) * (first.x - at.x) + (last.y - first.y) * (first.y - at.y);
    view.seen.push_back({ahead > 0 ? order.front() : order.back(), kSky, kNoPiece, kNoPiece});
    return;
  }
  // The hull edges that turn their outer side to the eye form one chain; seen from outside it runs clockwise.
  const std::size_t n = hull_.size();
  const auto is_visible = [&](std::size_t k) {
    const HalfEdgeId h = hull_[k % n];
    return eye.orientation(triangulation_.origin(h), triangulation_.target(h)) < 0;
  };
  std::size_t last = 0;
  while (last < n && !(is_visible(last) && !is_visible(last + 1))) ++last;
  std::size_t k = last + n;
  for (; is_visible(k); --k) {
    const HalfEdgeId h = hull_[k % n];
    const VertexId left = triangulation_.origin(h), right = triangulation_.target(h);
    view.seen.push_back({right, kSky, kNoPiece, kNoPiece});
    if (triangulation_.is_piece(h))
      view.seen.back().behind = opposite(triangulation_.side(h));
    else
      expand_cone(triangulation_, h, outside.ray(right), outside.ray(left), outside, view);
  }
  const HalfEdgeId first = hull_[(k + 1) % n];
  view.seen.push_back({triangulation_.origin(first), kSky, kNoPiece, kNoPiece});
}

}  // namespace hottel

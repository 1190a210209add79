#include "geometry/plane/visibility/first_hit.h"

#include <algorithm>
#include <cmath>

#include "kernel/exact_double.h"

namespace hottel {
namespace {

// The line that carries a ray, directed.
class RayLine {
 public:
  RayLine(const Vertices2& vertices, const Segment2& piece, const PieceRay2& ray)
      : vertices_(vertices), piece_(piece), ray_(ray) {
    const Vertices2::Approximate &a = vertices.approximate(piece.a), &b = vertices.approximate(piece.b);
    x_ = a.x + ray.s * (b.x - a.x);
    y_ = a.y + ray.s * (b.y - a.y);
    // Of the origin: three roundings, each of a number below twice the largest coordinate. Of a vertex and of the
    // piece's ends: their approximation.
    const double largest = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
    const double error = 0x1p-50 * largest + 2 * vertices.approximation_error();
    bound_ = error * (std::fabs(ray.dx) + std::fabs(ray.dy));
  }

  // +1: the vertex lies left of the line, -1: right of it, or on it.
  int side(VertexId v) const {
    const Vertices2::Approximate& p = vertices_.approximate(v);
    const double left = ray_.dx * (p.y - y_), right = ray_.dy * (p.x - x_), cross = left - right;
    const double bound = 0x1p-51 * (std::fabs(left) + std::fabs(right)) + bound_;
    if (cross > bound) return 1;
    if (cross < -bound) return -1;
    return exact_side(v);
  }

 private:
  int exact_side(VertexId v) const {
    const Point2 a = vertices_.exact(piece_.a), b = vertices_.exact(piece_.b), p = vertices_.exact(v);
    const Rational s = exact_value(ray_.s), dx = exact_value(ray_.dx), dy = exact_value(ray_.dy);
    const Rational cross = dx * (p.y - a.y - s * (b.y - a.y)) - dy * (p.x - a.x - s * (b.x - a.x));
    return cross > 0 ? 1 : -1;
  }

  const Vertices2& vertices_;
  const Segment2 piece_;
  const PieceRay2& ray_;
  double x_, y_, bound_;
};

}  // namespace

FirstHit2::FirstHit2(const Arrangement2& arrangement)
    : arrangement_(arrangement), gate_(arrangement.side_count(), Beyond2(kSky)) {
  const Triangulation2& triangulation = arrangement.triangulation();
  for (const HalfEdgeId h : triangulation.half_edges())
    if (triangulation.is_piece(h)) gate_[triangulation.side(h).index()] = Beyond2(h);
}

PieceSideId FirstHit2::operator()(const PieceRay2& ray) const {
  const Triangulation2& triangulation = arrangement_.triangulation();
  const RayLine line(arrangement_.vertices(), arrangement_.piece(ray.from), ray);
  Beyond2 beyond = gate_[ray.from.index()];
  while (beyond.is_open()) {
    const Passage2& passage = triangulation.passage(beyond.entry());
    beyond = line.side(passage.corner) > 0 ? passage.on_right : passage.on_left;
  }
  return beyond.side();
}

}  // namespace hottel

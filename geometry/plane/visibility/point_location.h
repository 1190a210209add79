// Where a point lies in the triangulation of a scene.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/triangulation.h"
#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// Where a point lies: the part of the triangulation of least dimension that holds it, or outside the convex hull.
struct Location2 {
  enum class Kind { kInTriangle, kOnEdge, kOnVertex, kOutside };
  Kind kind = Kind::kOutside;
  HalfEdgeId half_edge =
      HalfEdgeId::none();  // of the triangle (the first of three), or the edge the point lies on (the lower of two)
  VertexId vertex{0};      // kOnVertex
};

// Finds points by walking through triangles from one near by.
//
//   (1) exact: on an edge or vertex means exactly on it
//   (2) what is found does not depend on where the walk began
//
// Degenerate: where all vertices lie on one line there are no triangles; a point is then a vertex or outside.
// REQUIRES: the vertices and the triangulation outlive it, and the eyes are made with these vertices.
// COST: O(1) steps on average from a grid of starting triangles, about one for every two triangles; from the place of
// a point near by as many as there are triangles between.
class PointLocation2 {
 public:
  PointLocation2(const Vertices2& vertices, const Triangulation2& triangulation);

  // Returns where the point lies; the walk begins at the triangle kept for its cell of the grid.
  Location2 locate(const Eye2& eye) const;
  // The same, from a triangle near by: `near` is where the walk begins and is changed to where it ends.
  // None: nowhere yet.
  Location2 locate(const Eye2& eye, TriangleId& near) const;

  const Triangulation2& triangulation() const { return triangulation_; }

  // Fills the view from the eye; from a point on an edge or vertex both sides are seen, the edges at it edge-on.
  // Returns where the eye is. With `near` it is found as by locate().
  Location2 look_around(const Eye2& eye, View2& view) const;
  Location2 look_around(const Eye2& eye, View2& view, TriangleId& near) const;

 private:
  void look_around_outside(const Eye2& eye, View2& view) const;
  std::size_t cell(double x, double y) const;

  const Vertices2& vertices_;
  const Triangulation2& triangulation_;
  std::vector<TriangleId> start_;  // by grid cell: some triangle near it
  std::vector<HalfEdgeId> hull_;   // half-edges on the hull, counter-clockwise
  double x0_ = 0, y0_ = 0, cells_per_length_ = 0;
  int cells_ = 1;
};

}  // namespace hottel

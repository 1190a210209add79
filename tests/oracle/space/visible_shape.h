// The shape of what a point sees of a polygon past others: the corners of the visible part, by brute force in doubles.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "tests/oracle/space/flat_polygon.h"

namespace hottel::oracle {

// Corners by what makes them: two edges that are seen to cross, or a vertex.
class VisibleShape {
 public:
  // Edges as ends that polygons share are one edge.
  VisibleShape(FlatPolygon target, std::vector<FlatPolygon> between);

  // The lower number of two edges first; -1 and the number of a vertex. Each vertex, and each crossing of two edges, is
  // tried as it is seen on the plane of the target: between any two neighbouring edges that are seen to run into it a
  // point next to it is followed back past all polygons.
  using Corner = std::pair<int, int>;
  std::set<Corner> seen_from(const Vector& eye) const;

 private:
  struct Edge {
    int from, to;  // vertices
  };
  void add(const FlatPolygon& polygon);
  int vertex_of(const Vector& place);
  bool is_visible(const Vector& eye, const Vector& place) const;
  bool is_corner(const Vector& eye, const Vector& place, const std::vector<Vector>& ways) const;

  FlatPolygon target_;
  std::vector<FlatPolygon> between_;
  FlatPlane plane_;
  std::vector<Vector> vertices_;
  std::vector<Edge> edges_;
};

}  // namespace hottel::oracle

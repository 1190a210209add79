// The corners of a scene in space, each once, and what meets there.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/predicates/vertices.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {

// The corners of polygons, numbered in the order in which they first occur.
//
//   (1) points with equal coordinates are one corner
//   (2) of_polygon[s] are the corners of polygon s in its order (corners_of), sides[s] the two of each side;
//       at[c] are the polygons that have c, ascending
//   (3) lengths in doubles are in the unit of `vertices`
//
// COST: O(n log n) comparisons of rational numbers.
struct CornerTable3 {
  explicit CornerTable3(const std::vector<Polygon3>& polygons);

  std::vector<Point3> points;
  std::vector<std::vector<std::uint32_t>> of_polygon, at;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> sides;
  Vertices3 vertices;
  std::vector<BoundedVector> normals;  // of polygons, on one of their sides

  Box3 box_of_corner(std::uint32_t c) const;
  Box3 box_of_polygon(std::uint32_t s) const;
  // Whether a corner lies on the side between two others, exactly.
  bool lies_on(std::uint32_t c, std::uint32_t from, std::uint32_t to) const;

  // The sides of all polygons without regard to their direction, each once: its corners, and the polygons that have it.
  struct Edge {
    std::uint32_t a, b;  // a < b
    std::vector<std::uint32_t> polygons;
  };
  std::vector<Edge> edges() const;

 private:
  void add_sides(const Polygon3& polygon);
};

// Returns a number that is not below the width of a polygon. COST: quadratic in its corners.
double width_above(const CornerTable3& corners, std::uint32_t s);

// Returns how high a corner lies over the plane of a polygon, times the length of its normal in `normals`.
BoundedValue height(const CornerTable3& corners, std::uint32_t s, std::uint32_t c);

// Returns a number that is not above the distance of a corner from the plane of a polygon.
double distance_below(const CornerTable3& corners, std::uint32_t s, std::uint32_t c);

// Returns a number that is not above the distance of the lines through two edges.
double distance_below(const CornerTable3& corners, const CornerTable3::Edge& e, const CornerTable3::Edge& f);

}  // namespace hottel

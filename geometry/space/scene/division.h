// Polygons divided into elements.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/scene/scene.h"
#include "kernel/determinant.h"

namespace hottel {

// Divides every polygon by n. Throws ContractViolation unless n > 0.
void divide_into(Scene3& scene, std::uint32_t n);

// Divides every polygon by the least n for which its longest side is no longer than n h. Exact: a square of side 3 h is
// divided by 3. Returns nothing; or the first polygon whose n is more than `most`: then it and those after it stay as
// they are.
// Throws ContractViolation unless h > 0.
std::optional<std::uint32_t> divide_by_length(Scene3& scene, const Rational& h, std::uint32_t most);

// The same of a valid scene, which stays valid. Throw ContractViolation also where n or `most` is above kMaxElements,
// or a surface has trees.
void divide_into(ValidScene3& scene, std::uint32_t n);
std::optional<std::uint32_t> divide_by_length(ValidScene3& scene, const Rational& h, std::uint32_t most);

// Returns the triangles of a polygon that is not convex, in which it is divided into elements: those of its
// constrained Delaunay triangulation, their fronts as the polygon's; of one that is nearly plane its facets.
std::vector<std::array<Point3, 3>> triangles_of(const Polygon3& polygon);

// Returns how many elements a polygon has that is divided by n: a convex one as PolygonDivision3 does, another one as
// its triangles.
std::uint64_t element_count(const Polygon3& polygon, std::uint32_t n);

// Returns how many trees a polygon has that is divided by n, one under each element; where it is not divided, one of a
// triangle and of a quad, and of another polygon one for each of the triangles that it is divided into.
std::uint32_t root_count(const Polygon3& polygon, std::uint32_t n);

// Whether a polygon that is divided by 1 is to be divided further.
enum class HasTrees3 : bool { kNo, kYes };

// A convex polygon divided by n, its points as they are listed: three are a triangle, four a quad, even where one of
// them is in the middle of a side; of more, those in the middle of sides are left out, and it is divided into the
// triangles of a fan from the first point that is left.
//
//      3 +-----+-----+ 2                2 +
//        |  2  |  3  |                   / \          .
//        +-----+-----+                  / 3 \         .
//        |  0  |  1  |                 +-----+
//      0 +-----+-----+ 1              / \ 1 / \       .
//                                    / 0 \ / 2 \      .
//       a quad by 2               0 +-----+-----+ 1     a triangle by 2
//
//   (1) a quad: n x n elements by equal parts of its sides; row by row from its first point, along its first side first
//   (2) a triangle: n^2 similar ones, in rows from its first side; in a row up, down, up, ...
//   (3) n = 1: the polygon itself, whatever its corners, unless it has trees; else all elements of the first triangle
//       of a fan come first
//   (4) corner c of an element lies at c / weight(): exactly. Corners go around as the polygon does; no three in a row
//       are on one line (of a quad that is a triangle one element is, too)
//   (5) the elements share no area, and together they are the polygon
//   (6) a node of a tree has four children: of a quad by halves of its sides, digit c at corner c, which is its own
//       corner c; of a triangle by the middles of its sides, digit c at corner c, and 3 in the middle, turned by half a
//       turn. Those of one depth are what elements by 2^depth are
class PolygonDivision3 {
 public:
  // REQUIRES integer coordinates of a convex polygon (is_convex), and n > 0.
  PolygonDivision3(std::vector<IntegerVector> points, std::uint32_t n, HasTrees3 has_trees = HasTrees3::kNo);

  std::uint64_t count() const;
  Integer weight(int depth = 0) const;  // of nodes at a depth
  // Of an element, or of a node of the tree under it. COST: about a microsecond.
  std::vector<IntegerVector> corners(std::uint64_t k, const TreePath& path = {}) const;  // REQUIRES k < count()

 private:
  enum class Shape : unsigned char { kWhole, kQuad, kTriangles };

  std::vector<IntegerVector> quad_child(const std::vector<IntegerVector>& quad, int digit) const;
  std::vector<IntegerVector> quad_element(std::uint64_t k) const;
  std::vector<IntegerVector> triangle_element(std::uint64_t triangle, std::uint64_t k) const;

  std::uint64_t n_;
  Shape shape_ = Shape::kWhole;
  bool is_parallelogram_ = false, has_straight_corner_ = false;
  std::vector<IntegerVector> points_;  // of a quad as listed, else without those in the middle of sides
  Integer weight_ = 1;
};

}  // namespace hottel

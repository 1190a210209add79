// Segments of one plane, cut by each other, and the triangles between them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/scene/flat_region.h"

namespace hottel {

// The constrained Delaunay triangulation of segments of a plane.
//
//   (1) every segment is a union of edges that say so (is_border); the first points are the given ends, each once, in
//       the order in which they first occur; those after them are where segments cross
//   (2) triangles go around counter-clockwise, share no area, and cover the convex hull of all ends
//   (3) exact, whatever the coordinates
//
// Where all ends are on one line there are no triangles.
// SEE: CGAL, 2D Triangulations (by rational numbers). COST: some 20 microseconds a segment; more for each crossing.
class PlaneTriangulation3 {
 public:
  using Segment = FlatSegment3;

  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    // Beyond the side opposite to each corner: a triangle, or kNone.
    std::array<std::uint32_t, 3> neighbours;
    std::array<bool, 3> is_border;  // that side lies on a segment
  };
  static constexpr std::uint32_t kNone = 0xffffffff;

  explicit PlaneTriangulation3(const std::vector<Segment>& segments);

  const std::vector<FlatPoint3>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::size_t given_points() const { return given_; }  // beyond them: crossings

  FlatPoint3 centre(std::uint32_t triangle) const;
  std::vector<FlatPoint3> corners_of(std::uint32_t triangle) const;
  Rational doubled_area_of(std::uint32_t triangle) const;

 private:
  std::vector<FlatPoint3> points_;
  std::vector<Triangle> triangles_;
  std::size_t given_ = 0;
};

// Convex polygons, counter-clockwise, that together are some of the triangles; no three points in a row are on one
// line. Triangles are joined where that leaves them convex, in the order of their numbers.
std::vector<std::vector<FlatPoint3>> convex_pieces(const PlaneTriangulation3& triangulation,
                                                   const std::vector<char>& is_in);

// The same of a region by itself: only its own corners are corners of pieces.
std::vector<std::vector<FlatPoint3>> convex_pieces(const FlatRegion3& region);

// The closed lines around some of the triangles, those with the inside on their left; no three points in a row are on
// one line.
FlatRegion3 region_of(const PlaneTriangulation3& triangulation, const std::vector<char>& is_in);

}  // namespace hottel

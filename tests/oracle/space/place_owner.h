// Who has the two sides of a place of a polygon in space, point by point.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// A plane polygon: its outline, counter-clockwise seen from its front, then its holes, in any sense.
struct PlaceFace {
  std::vector<SpacePolygon> loops;
  int front = 0;                 // its material
  std::optional<int> back = {};  // none: black, without a claim
  std::size_t body = 0;
};

// kSolid: a closed mesh with fronts outward; kRoom: one with fronts inward; kNothing: any other polygons.
enum class PlaceBody { kSolid, kRoom, kNothing };

// The sides of points that lie on faces: what a solid contains, and whose the rest is. Whether a point is in a solid is
// told by the solid angle, in doubles, that a mesh has around the point moved a little to that side; which polygons are
// at a point is exact. Coordinates are small: moved are points by 1e-5.
class Places {
 public:
  Places(std::vector<PlaceFace> faces, std::vector<PlaceBody> bodies);

  struct Side {
    bool is_covered = false;
    std::size_t owner = 0;  // 2 * face, + 1 for its back; means nothing where it is covered
    bool is_disputed = false;
  };
  struct Place {
    SpacePoint at;
    Side front, back;  // of the face that was asked for
  };

  // True iff the point lies within the face, and no border of a face of its plane, nor another face, is near to it.
  bool is_clear(std::size_t face, const SpacePoint& point) const;
  // REQUIRES a clear point of the face.
  Place place(std::size_t face, const SpacePoint& point) const;

  // Points of the face that are clear, by number: some of `tries` drawn at random.
  std::vector<SpacePoint> points(std::size_t face, unsigned long number, int tries) const;

 private:
  struct Triangle {
    double a[3], b[3], c[3];
  };
  double winding(std::size_t body, const double (&at)[3]) const;
  bool lies_in(std::size_t room, std::size_t solid) const;
  bool is_in(std::size_t body, const double (&at)[3]) const;  // a solid, less the rooms in it
  bool is_coplanar(std::size_t face, std::size_t other) const;
  Side side(std::size_t face, const SpacePoint& point, bool is_back) const;

  std::vector<PlaceFace> faces_;
  std::vector<PlaceBody> bodies_;
  std::vector<SpacePoint> normals_;
  std::vector<std::vector<Triangle>> triangles_;  // by body
  std::vector<std::vector<std::size_t>> rooms_;   // by body
};

// The normal of a plane loop, twice its area long.
SpacePoint normal_of_loop(const SpacePolygon& loop);

// True iff a point of its plane is inside loops, by the parity of a ray. REQUIRES a point on no side.
bool is_inside_loops(const std::vector<SpacePolygon>& loops, const SpacePoint& point);

}  // namespace hottel::oracle

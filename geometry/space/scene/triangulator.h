// Polygons that are not plane, in triangles.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns triangles in place of a polygon whose corners do not lie in one plane; none where they do, and where it
// cannot be cut: it has holes, or crosses itself as seen along the axis of the largest component of its area.
//
//   (1) corners of triangles are corners of the polygon; each side of it is a side of one triangle, and triangles that
//       share another side are on both sides of it: nothing is between them
//   (2) seen along that axis they go around as the polygon does and share no area
//   (3) of a polygon that is convex, seen so, all have its first corner, in the order of the corners; of another one
//       they are the constrained Delaunay triangulation of what is seen
//
// COST: some 20 microseconds a corner.
std::vector<Polygon3> triangles_of_not_plane(const Polygon3& polygon);

// Puts what is not plane into scenes as triangles, and remembers it.
class Triangulator3 {
 public:
  // Adds the triangles of a polygon as surfaces NAME[k] that are otherwise the given one, k from 0. False, and adds
  // nothing, where there are none (triangles_of_not_plane).
  bool add(Scene3& scene, const Surface& surface, const Polygon3& polygon);

  // One sentence without a full stop: how many polygons were cut, into how many triangles, which, and how far the first
  // is from being plane. Empty where none was.
  std::string note() const;

 private:
  std::vector<std::string> names_;
  std::string first_problem_;
  std::size_t triangles_ = 0;
};

}  // namespace hottel

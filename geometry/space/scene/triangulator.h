// Polygons that are not plane, in triangles.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns triangles in place of a polygon whose corners do not lie in one plane, as triangles_of_loops has them; none
// where they do, and where it cannot be cut.
std::vector<Polygon3> triangles_of_not_plane(const Polygon3& polygon);

// Puts what is not plane into scenes as triangles, and remembers it.
class Triangulator3 {
 public:
  // Adds the triangles of a polygon as surfaces NAME[k] that are otherwise the given one, k from 0. False, and adds
  // nothing, where there are none (triangles_of_not_plane), or it is nearly plane: then it stands for them itself.
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

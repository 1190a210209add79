// What lies under the mouse in a scene in space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/scene/scene.h"
#include "viewer/edit/space/pointer.h"

namespace hottel {

// Where the ray from the eye through the mouse first meets a polygon. The ray is exact: that of the doubles in the
// pointer.
struct Pick3 {
  Face face;     // the side that is seen
  Point3 place;  // exactly
};

// Picks from one scene, often. It keeps the scene's address: the scene must stay where it is, and as it is.
class ScenePick3 {
 public:
  // COST: linear.
  explicit ScenePick3(const Scene3& scene);
  explicit ScenePick3(Scene3&&) = delete;

  // Returns what the ray meets first, decided exactly; borders count.
  //
  //   (1) of polygons that it meets at one place a patch before what it lies on, else one whose front is seen, else the
  //       first that is listed
  // is_left_out: by surface, which do not count; empty: none. COST: linear in doubles, exact near the ray.
  std::optional<Pick3> at(const Pointer3& pointer, const std::vector<bool>& is_left_out = {}) const;

 private:
  struct Ball {
    Direction3 middle;
    double radius = 0;
  };

  const Scene3* scene_;
  std::vector<Ball> balls_;  // around each polygon
};

// Returns the corner of some polygons that is seen nearest to the mouse, within reach, of what is equally near the one
// nearest to the eye; nothing where none is.
std::optional<Point3> corner_at(const Scene3& scene, const std::vector<std::uint32_t>& surfaces,
                                const Pointer3& pointer);

}  // namespace hottel

// Exact places near what a hand drags in space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/edit/space/pick.h"
#include "viewer/edit/space/placing.h"

namespace hottel {

// An exact place, and what it was snapped to.
struct Snap3 {
  enum class To : unsigned char { kDecimals, kVertex, kEdge, kPlane };

  Point3 at;
  To to = To::kDecimals;
  std::optional<std::uint32_t> surface = {};  // the first whose corner, side or plane it is; nothing for decimals
};

// Snaps to one scene, often. It keeps the scene's address: the scene must stay where it is, and as it is.
class Snapper3 {
 public:
  // is_moved: by surface, what is being moved: it is no goal, and hides none.
  Snapper3(const Scene3& scene, std::vector<bool> is_moved);

  // Returns the place to which the mouse has brought a point that is free as that says.
  //
  //   (1) a corner that is seen within reach of the mouse wins, the nearest: the result is that point, or where it is
  //       not free to go there, the place nearest to it
  //   (2) else a side that is: the same of a point that lies exactly on it, the part of it being a short decimal
  //   (3) else a polygon to which the place comes nearer than the reach is long there, and over which it is: the result
  //       lies exactly in its plane, where it is free to
  //   (4) else it is what the freedom rounds it to (Freedom3::rounded)
  // What is near is decided in doubles. COST: linear, in doubles.
  Snap3 at(const Pointer3& pointer, const Freedom3& freedom) const;

 private:
  std::optional<Snap3> corner(const Pointer3& pointer) const;
  std::optional<Snap3> side(const Pointer3& pointer, int decimals) const;
  std::optional<std::uint32_t> plane(const Direction3& place, double reach) const;
  bool is_seen(const Direction3& place, const Pointer3& pointer) const;

  const Scene3* scene_;
  std::vector<bool> is_moved_;
  ScenePick3 pick_;
};

}  // namespace hottel

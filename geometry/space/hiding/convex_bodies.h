// Surfaces that bound convex bodies. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/space/arrangement/occluders.h"

namespace hottel {

// A plane that a body has on one side: through a vertex, with a normal that points away from the body.
struct BodyPlane3 {
  VertexId3 at;
  IntegerVector outward;
};

// A convex body. Its surfaces are all of its boundary, or all but one face: the lid.
struct ConvexBody3 {
  std::vector<std::uint32_t> surfaces;  // ascending
  std::vector<VertexId3> corners;       // ascending
  std::vector<BodyPlane3> planes;       // of the surfaces that are not in the plane of the lid
  std::vector<std::uint32_t> plane_of;  // for each surface the number of its plane; kNone: that of the lid
  std::optional<BodyPlane3> lid;

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
};

// The convex bodies among surfaces that share edges: boxes, prisms, wedges, with or without a bottom.
//
//   (1) a body is all that hangs together by edges: every surface has all corners on one side of its plane, and one off
//       it; no edge has more than two surfaces; edges of one surface are none, or all in one plane that has all corners
//       on one side
//   (2) so its surfaces are the boundary of its convex hull, or all but the face in the plane of the lid
//   (3) exact
//
// What hangs together by more than kMostSurfaces is left out.
//
// REQUIRES: no two surfaces share an area of one plane. COST: O(n log n), and for each body a sign for each surface and
// corner.
class ConvexBodies3 {
 public:
  static constexpr std::size_t kMostSurfaces = 256;

  explicit ConvexBodies3(const Occluders3& occluders);

  const std::vector<ConvexBody3>& bodies() const { return bodies_; }
  // The number of the body of a surface; ConvexBody3::kNone where it has none.
  std::uint32_t body_of(std::uint32_t surface) const { return body_of_[surface]; }

 private:
  std::vector<ConvexBody3> bodies_;
  std::vector<std::uint32_t> body_of_;
};

}  // namespace hottel

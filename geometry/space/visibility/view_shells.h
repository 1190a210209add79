// What hides: polygons that an eye sees side by side, as one convex cone. Internal to geometry/space/visibility.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/visibility/cone_fragment.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/eye_planes.h"
#include "geometry/space/visibility/view_cones.h"

namespace hottel {

// Polygons whose cones fill one convex cone. What an eye sees of a box is one shell, and so is a polygon by itself.
struct ViewShell3 {
  std::span<const std::uint32_t> polygons;
  ConeBounds3 cone;  // all corners
  ViewCone3 around;
  bool is_round = false;  // true only where each polygon is on or beyond the planes of the others
};

// True only where all that is in a round cone, between its distances, is behind the shell: the rounding of all doubles
// included.
bool hides_all(const ViewShell3& shell, const ViewCone3& target);

// The shells of all polygons that the eye is not in the plane of: each is in one.
//
//   (1) a polygon is_buried() only where a shell next to it, or to one of its neighbours, hides all of it, as the near
//       sides of a box hide the far ones: then that shell also hides whatever the polygon does. Exact
//
// COST: some 15 signs a polygon.
class ViewShells3 {
 public:
  ViewShells3(EyePlanes3& planes, const ViewCones3& cones);

  std::size_t size() const { return shells_.size(); }
  const ViewShell3& operator[](std::size_t k) const { return shells_[k]; }
  // REQUIRES facing(s) != 0.
  std::uint32_t shell_of(std::size_t s) const { return shell_of_[s]; }
  bool is_buried(std::size_t s) const { return hiders_[s] != kNone; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  // The polygons at an edge, and on which side of its plane their cones are.
  struct Neighbours {
    std::uint32_t polygons[2] = {kNone, kNone};
    bool are_opposite[2] = {false, false};
    bool are_more = false;
  };
  PlaneSide3 side_of(std::size_t s, const DirectedEdge3& edge) const {
    return {PlaneId3(edge.edge.number()), edge.is_backward != (planes_.facing(s) > 0)};
  }
  void find_neighbours();
  std::uint32_t neighbour(std::uint32_t s, PlaneSide3 side, bool goes_on) const;
  bool is_beyond(std::uint32_t s, std::uint32_t other);
  bool bulges(std::uint32_t s, DirectedEdge3 edge, std::uint32_t next);
  bool is_convex(const ViewShell3& shell);
  bool is_round(std::span<const std::uint32_t> polygons);
  bool is_hidden_by(std::uint32_t s, const ViewShell3& shell);
  void find_buried();
  void gather(std::uint32_t first);
  bool add_shell(std::span<const std::uint32_t> polygons);

  EyePlanes3& planes_;
  const ViewCones3& cones_;
  std::vector<Neighbours> neighbours_;  // of edges
  std::vector<ViewShell3> shells_;
  std::vector<std::uint32_t> shell_of_;
  std::vector<std::uint32_t> hiders_;  // the shell that a polygon is buried by
  // What shells are made of.
  std::vector<std::uint32_t> polygons_;
  std::vector<VertexId3> corners_;
  std::vector<PlaneSide3> sides_;
  std::vector<Direction3> inward_;

  std::vector<std::uint32_t> gathered_;
};

}  // namespace hottel

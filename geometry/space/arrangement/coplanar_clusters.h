// Polygons of one plane that share an area. Internal to geometry/space/arrangement.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/polygon.h"

namespace hottel {

// Polygons of one plane that overlap, one with the next; or a single one.
struct CoplanarCluster3 {
  struct Member {
    std::uint32_t surface;
    FlatRegion3 region;
    std::vector<std::vector<FlatPoint3>> parts;  // convex ones, counter-clockwise in the frame
    bool is_front_up, is_convex;
  };
  PlaneFrame3 frame;
  std::vector<Member> members;  // ascending

  const Member& member(std::uint32_t surface) const;  // REQUIRES that it is one
};

// Returns the clusters of all polygons, each polygon in one.
//
//   (1) two convex polygons of one plane that share an area are in one cluster: exactly. Of others it is enough that
//       their boxes meet
//   (2) clusters are in the order of their first members
//
// REQUIRES polygons without a problem (polygon_problem).
// COST: n log n, and some 10 µs for each pair of one plane whose boxes meet.
std::vector<CoplanarCluster3> coplanar_clusters(const std::vector<Polygon3>& polygons);

}  // namespace hottel

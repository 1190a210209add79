// What many eyes near each other see, found together.
#pragma once

#include <array>
#include <vector>

#include "geometry/plane/predicates/eye_tile.h"
#include "geometry/plane/visibility/point_location.h"

namespace hottel {

// The views from the eyes of a tile. Eyes have the numbers that they have in the tile (EyeTile2): 8 * row + column.
//
//   (1) view(k) and location(k) are what PointLocation2::look_around gives for eye k, entry by entry
//
// Neighbours see nearly the same, so they look around together: by triangular expansion (view.h), but with cones that
// many eyes share. Where a line through two vertices passes between the eyes of a cone it is divided; cones between
// the same two vertices are united again.
// Eyes on an edge, at a vertex or outside the convex hull look around by themselves, and so do those that are few in
// their triangles.
//
// REQUIRES: the tile and the location have the same vertices.
// COST: that of the view from one eye, of what changes between the eyes, and about 3 ns for each vertex an eye sees.
class TileViews2 {
 public:
  // Fills the views of all eyes of the tile; those of the tile before are lost, their memory is used again.
  void look_around(const PointLocation2& location, const EyeTile2& tile);

  // REQUIRES: k is an eye of the tile that was last looked around from.
  const View2& view(std::size_t k) const { return views_[k]; }
  const Location2& location(std::size_t k) const { return places_[k]; }

 private:
  // What each eye of a group sees between two vertices.
  struct Cone {
    VertexId right, left;
    EyeTile2::Group group;
    EyeTile2::Set passing_left, divided;  // the eyes for which it passes left of the next apex, or on both sides
  };
  // An edge to look through, and the cones that do: those from here to where the next opening begins.
  struct Opening {
    HalfEdgeId half_edge;
    std::size_t first_cone;
  };
  // The eyes in a triangle.
  struct Home {
    TriangleId triangle;
    EyeTile2::Set eyes;
  };
  // A cone that leaves the joined homes through one of their borders.
  struct CrossedBorder {
    HalfEdgeId half_edge;
    Cone cone;
  };

  void locate(const PointLocation2& location, const EyeTile2& tile);
  void join_homes(const Triangulation2& triangulation);
  bool are_few_in_joined_homes() const;
  void look_around_alone(const PointLocation2& location, const EyeTile2& tile);
  void leave_homes(const Triangulation2& triangulation, const EyeTile2& tile);
  void expand(const Triangulation2& triangulation, const EyeTile2& tile);
  void enter(const Triangulation2& triangulation, const EyeTile2& tile, HalfEdgeId entry);
  void open(HalfEdgeId half_edge) { openings_.push_back({half_edge, cones_.size()}); }
  void add(const EyeTile2& tile, VertexId right, VertexId left, const EyeTile2::Group& group);
  void see(const Cone& cone, PieceSideId behind);
  void begin_at_home(const Triangulation2& triangulation);

  std::array<View2, EyeTile2::kSide * EyeTile2::kSide> views_;
  std::array<Location2, EyeTile2::kSide * EyeTile2::kSide> places_;
  std::vector<Home> homes_;          // those not yet looked around from
  std::vector<Home> joined_;         // some that are connected
  std::vector<HalfEdgeId> borders_;  // of the joined ones, counter-clockwise, as seen from inside
  std::vector<CrossedBorder> crossed_;
  std::vector<Opening> openings_;  // those looked through next are last
  std::vector<Cone> cones_, entering_;
};

}  // namespace hottel

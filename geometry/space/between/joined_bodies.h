// Bodies that hang together by edges and hide as one. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/visibility/direction.h"
#include "kernel/support/disjoint_sets.h"

namespace hottel {

// Joins bodies of a pair to groups, as seen from a point: the two triangles of a quad that is not plane, or all of a
// dish that is seen from one side.
//
// Polygons that share an edge are side by side where they are seen on different sides of it. Directions that meet them
// are then covered as often as their outline goes around: the sides that none of the others shares. So where the
// outline is one convex polygon they hide just what is within it, whether they belong to a body or not.
//
// Which bodies are joined is chosen in doubles. What is said of a group is exact:
//
//   (1) its outline is made of all sides that are not shared, each once, as its body is seen
//   (2) where every body is seen as `facings` say, the outline turns left at each of its corners, and is_before_once():
//       then the group hides what is within the outline, and nothing else; so it does as long as these signs stay,
//       wherever the eye moves
//   (3) the choice depends on the eye and the bodies alone
//
// For one thread.
class JoinedBodies3 {
 public:
  // Side `side` of a body, from a point to a point; what is hidden is to the left, seen along directions from the eye.
  struct Side {
    std::uint32_t body, side, from, to;
  };
  struct Group {
    std::vector<std::uint32_t> bodies;
    std::vector<signed char> facings;  // of these: +1 where the front is seen, else -1
    std::vector<Side> outline;         // in order
  };

  // REQUIRES: the bodies outlive this.
  explicit JoinedBodies3(const PairGeometry3& bodies) : bodies_(bodies) {}

  // Sets the groups of two bodies or more among those in a list, which may stand between. `toward`: the ways from the
  // eye to all points, each times a positive number. COST: some 100 ns a side.
  void join(std::span<const std::uint32_t> list, std::span<const BoundedVector> toward, std::vector<Group>& groups);
  // Whether all of a group is surely on one side of the eye, so that it hides nothing on the other one, and its outline
  // goes around once: whole numbers, which doubles tell. COST: some 10 ns a corner.
  bool is_before_once(const Group& group, std::span<const BoundedVector> toward) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // A side as it is seen.
  struct Seen {
    std::uint32_t from, to;
    std::uint32_t partner = kNone;                 // the same side of the other body, passed in the other direction
    std::uint32_t next = kNone, previous = kNone;  // along the outline that it is on; kNone where it is on none
  };
  void number_sides();
  void look(std::span<const std::uint32_t> list);
  void pair_sides(std::span<const std::uint32_t> list);
  bool join_all(std::vector<Group>& groups);
  void join_some(std::vector<Group>& groups);
  bool join_at(std::uint32_t side);
  bool turns(std::uint32_t side, std::uint32_t next) const;
  Side side_of(std::uint32_t side) const;
  Direction3 way(std::uint32_t point) const { return way_of(toward_[point]); }
  static Direction3 way_of(const BoundedVector& w) { return {w.x, w.y, w.z}; }

  const PairGeometry3& bodies_;
  std::span<const BoundedVector> toward_;
  std::vector<std::uint32_t> first_;       // the sides of body k have numbers from first_[k] to first_[k + 1]
  std::vector<std::uint32_t> body_of_;     // of a side
  std::vector<std::uint32_t> same_next_;   // the sides of one edge in a circle
  std::vector<Seen> seen_;                 // of sides
  std::vector<signed char> facings_;       // of bodies; 0 where it is not in the list
  DisjointSets sets_;                      // of bodies that have one outline
  std::vector<std::uint32_t> component_;   // bodies that hang together, as seen
  std::vector<char> is_reached_;           // of bodies
  std::vector<std::uint32_t> open_sides_;  // of the component
};

}  // namespace hottel

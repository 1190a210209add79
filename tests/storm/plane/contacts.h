// How edges of a lattice meet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/storm/plane/lattice_scene.h"

namespace hottel::storm {

// Of two edges:
//   apart           no common point, not on one line
//   tips meet       an end of one is an end of the other, not on one line
//   T-junction      an end of one lies inside the other
//   crossing        an inner point of both
//   end to end      on one line, with one common end and nothing else
//   collinear apart on one line, without a common point
//   equal, partial, contained    on one line, with a piece in common
// Of three: a point inside all, no two on one line; and ends of different edges on one line that is none of theirs.
// Of scenes: something is solid; a face with a material looks into a solid; a front of a solid makes no claim for such
// a face; a room is in a solid; something is solid because an edge or open polyline says so.
enum class Contact {
  kApart,
  kTipsMeet,
  kTJunction,
  kCrossing,
  kEndToEnd,
  kCollinearApart,
  kEqual,
  kPartialOverlap,
  kContained,
  kThreeThroughOnePoint,
  kThreeTipsOnOneLine,
  kSolid,
  kCoveredFace,
  kSilentFront,
  kRoomInSolid,
  kSolidBehind,
};
inline constexpr std::size_t kContactKinds = 16;
const char* to_string(Contact contact);

using ContactCounts = std::array<std::uint64_t, kContactKinds>;

Contact contact_of(const LatticeEdge& e, const LatticeEdge& f);

// Adds every pair and triple of the edges.
void count_contacts(const std::vector<LatticeEdge>& edges, ContactCounts& counts);
// Adds one for each kind that is in the scene.
void count_solids(const LatticeScene& scene, ContactCounts& counts);

}  // namespace hottel::storm

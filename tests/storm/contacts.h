// How edges of a lattice meet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/storm/lattice_scene.h"

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
};
inline constexpr std::size_t kContactKinds = 11;
const char* to_string(Contact contact);

using ContactCounts = std::array<std::uint64_t, kContactKinds>;

Contact contact_of(const LatticeEdge& e, const LatticeEdge& f);

// Adds every pair and triple of the edges.
void count_contacts(const std::vector<LatticeEdge>& edges, ContactCounts& counts);

}  // namespace hottel::storm

// What touches what in scenes of space: whether a storm saw every kind of contact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/storm/space/lattice_scene.h"

namespace hottel::storm {

// What touches what in a scene: each counts a scene at most once.
//   kPierced:    a side of one polygon runs through the inside of another one
//   kStands:     a side of one lies in the plane of another one, partly inside it
//   kCornerIn:   a corner of one is inside another one
//   kSharedSide: two have a side in common
//   kInLine:     sides of two are on one line and have a piece in common, but are not the same
//   kCoplanar:   two are in one plane
//   kCorner:     two have a corner in common
//   kCornerOnSide: a corner of one is within a side of another one
enum class Contact3 { kPierced, kStands, kCornerIn, kSharedSide, kInLine, kCoplanar, kCorner, kCornerOnSide };
inline constexpr std::size_t kContactKinds3 = 8;
using ContactCounts3 = std::array<std::uint64_t, kContactKinds3>;
const char* to_string(Contact3 contact);
void count_contacts_3(const Polygons3& polygons, ContactCounts3& counts);

// Of a point: +1 before the plane of a polygon, 0 in it, -1 behind it.
int side_of(const oracle::SpacePolygon& polygon, const oracle::SpacePoint& p);
// +1 inside, 0 on the outline, -1 outside. REQUIRES a point of its plane.
int place_in(const oracle::SpacePolygon& polygon, const oracle::SpacePoint& p);

}  // namespace hottel::storm

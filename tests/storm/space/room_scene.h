// Furnished rooms: cupboards along walls and in corners, tables, shelves, all but touching, as people type them.
#pragma once

#include <cstdint>
#include <functional>

#include "tests/storm/space/solid_scene.h"

namespace hottel::storm {

// The most polygons of a furnished room.
inline constexpr long kMostRoomPolygons = 40;

// How the numbers of a room came about.
//   kExact: as they are meant, parallel to the axes; kTurned: turned about the vertical by an angle whose sine and
//   cosine are fractions; kTyped: turned, then rounded to six decimals, quads that are not plane any more being nearly
//   so; kTilted: the same about all axes; kFloats: turned, cut into triangles and rounded to single precision
enum class RoomNumbers3 { kExact, kTurned, kTyped, kTilted, kFloats };
inline constexpr std::size_t kRoomNumbers3 = 5;
const char* to_string(RoomNumbers3 numbers);

// A furnished room by its number: any number gives the same on every platform.
struct FurnishedRoom3 {
  RoomNumbers3 numbers = RoomNumbers3::kExact;
  SolidBodies3 bodies;
};

// Returns a room of four to six walls and its furniture, 14 to kMostRoomPolygons polygons at most. Cupboards stand
// along a wall, in a corner, on each other; prisms and boxes stand turned; there are tables with legs, shelves (sheets
// and thin boxes), sheets before a wall, needles. The gaps between neighbours, to walls, floor and ceiling, and the
// steps between fronts, are 0, or 2^-1 to 2^-50, or 1e-3 to 1e-15, or ordinary; where the room has a material on its
// outside too they may be negative: what stands there overlaps.
//
//   (1) sheets have a material on both sides, and so has a room that anything may stand out of: no face sees a black
//       back
//   (2) all have one material, or the furniture another one than walls and sheets
FurnishedRoom3 furnished_room_3(std::uint64_t number);

// Leaves out bodies; makes sheets with two sides of the faces of a body; leaves out faces of these; writes coordinates
// with fewer digits, all that are equal alike; and begins anew, as long as what is left is valid and still fails. Gives
// up after so many tries as take minutes. REQUIRES fails(bodies).
SolidBodies3 shrunk_room_3(SolidBodies3 bodies, const std::function<bool(const SolidBodies3&)>& fails);

}  // namespace hottel::storm

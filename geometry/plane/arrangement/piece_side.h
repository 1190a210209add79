// Sides of pieces by number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/support/id.h"

namespace hottel {

// One side of a piece a -> b: its left side or its right side. What is looked at is a side or the sky.
//
//   (1) opposite(opposite(side)) == side, and piece_of is the same for both
//   (2) sides_of(p) is {left_side(p), right_side(p)}, with is_right false and true
//   (3) place_after_sky is 0 for the sky and 1, 2, 3, ... for the sides of pieces 0, 0, 1, ...
using PieceSideId = Id<struct PieceSideTag>;
inline constexpr PieceSideId kNoPiece = PieceSideId::none();
inline constexpr PieceSideId kSky{-1};

constexpr PieceSideId left_side(std::size_t piece) { return PieceSideId(2 * piece); }
constexpr PieceSideId right_side(std::size_t piece) { return PieceSideId(2 * piece + 1); }
constexpr std::array<PieceSideId, 2> sides_of(std::size_t piece) { return {left_side(piece), right_side(piece)}; }
// REQUIRES a side, neither the sky nor none.
constexpr std::size_t piece_of(PieceSideId side) { return static_cast<std::size_t>(side.number() / 2); }
constexpr bool is_right(PieceSideId side) { return side.number() % 2 == 1; }
// REQUIRES a side, neither the sky nor none.
constexpr PieceSideId opposite(PieceSideId side) { return PieceSideId(side.number() ^ 1); }
// The place in a table of the sky, which comes first, and of all sides.
constexpr std::size_t place_after_sky(PieceSideId side) { return static_cast<std::size_t>(side.number() + 1); }

// No solid, where one is told by the group that makes it.
inline constexpr std::uint32_t kNoSolid = 0xffffffff;

}  // namespace hottel

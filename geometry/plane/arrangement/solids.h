// Which regions of an arrangement are solid, and what makes them so.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/plane/arrangement/claims.h"
#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/scene/closed_groups.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// An arrangement before it is known who owns its sides.
struct BarePieces2 {
  const Scene2& scene;
  const Overlay2& overlay;
  const FreeRegions2& regions;
  const std::vector<ClosedGroup2>& closed;                        // closed_groups(scene)
  std::function<std::vector<PieceSource2>(std::size_t)> sources;  // of a piece, in the order of the scene
};

// The solid regions: nothing is seen there, and the sides of pieces that look into them belong to no face.
//
//   (1) a group encloses a solid when its surfaces follow each other, the last ends where the first begins, none has a
//       "back", and its winding number (counter-clockwise +) is 0 or 1 in every region. The solid is where it is 1,
//       less where the winding number of a room in it is -1. A room is a group that closes with winding number 0 or -1
//       everywhere; it is in a solid when the inner sides of all its walls are
//   (2) a group with "behind": "solid" makes solid also the bounded regions that a back of it without material looks
//       into and none of its fronts. With "behind": "open" it makes none solid
//   (3) a region is solid iff some group makes it so
// COST: linear in the sides of pieces, plus the solids around each room; nothing where no group can enclose anything.
class Solids2 {
 public:
  static constexpr std::uint32_t kNone = kNoSolid;

  Solids2() = default;  // nothing is solid

  // Throws InputError for a "behind": "solid" that bounds nothing, naming the gap, and for two groups of which one
  // says that a region is solid and the other that it is open. Nothing of `pieces` is kept.
  explicit Solids2(const BarePieces2& pieces);

  bool is_empty() const { return maker_.empty(); }
  // The first listed group that makes the region that a side looks into solid; kNone where it is free. REQUIRES: a
  // side, not the sky.
  std::uint32_t maker(PieceSideId side) const { return maker_.empty() ? kNone : maker_[side.index()]; }
  bool is_covered(PieceSideId side) const { return maker(side) != kNone; }
  // True iff the side looks into a solid that this group makes, and a back of the group is on that side.
  bool is_inside_of(PieceSideId side, std::uint32_t group) const;

  // The sides of some pieces, in their order: as if the other pieces had never been there, but covered as before.
  Solids2 restricted_to(const std::vector<std::uint32_t>& pieces) const;
  // The sides of parts of pieces: `whole` says of each which piece it is a part of; all pieces have some.
  Solids2 cut_into(const std::vector<std::uint32_t>& whole) const;

 private:
  std::vector<std::uint32_t> maker_;                             // by side; empty where nothing is solid
  std::vector<std::pair<PieceSideId, std::uint32_t>> bounding_;  // side and group, sorted
};

// Returns for each group the free regions, ascending, that "behind": "solid" would make solid if the group said so:
// none where it says something already or would be refused. REQUIRES pieces that Solids2 accepts. COST: linear in the
// sides of pieces.
std::vector<std::vector<std::uint32_t>> regions_behind(const BarePieces2& pieces);

// True iff the scene has a group that may enclose a solid, or that says what is behind it: only then are regions
// needed. REQUIRES: `closed` is closed_groups(scene).
bool may_have_solids(const Scene2& scene, const std::vector<ClosedGroup2>& closed);

}  // namespace hottel

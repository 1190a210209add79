// What the surfaces on a piece claim of its two sides, and who gets them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/patch_bases.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A face, or one part of a face that carries elements.
struct FacePart2 : Face {
  std::uint32_t part = 0;  // 0 .. parts - 1, from the surface's first to its second point
  friend bool operator==(const FacePart2&, const FacePart2&) = default;
};

// An input segment (part of a surface) that covers a piece.
struct PieceSource2 {
  std::uint32_t surface = 0, part = 0;
  bool is_reversed = false;  // the surface runs against the piece
};

// A face that lies on one side of a piece. Without a material it is an opaque black back, which claims nothing.
struct Claim2 {
  FacePart2 face;
  const Material* material = nullptr;
};

// Who has one side of a piece.
struct SideOwner2 {
  Claim2 owner;
  std::optional<Claim2> rival;  // the first claim for another material: then the scene is refused
};

// Groups whose fronts on a side make no claim there.
using SilentGroups2 = std::function<bool(std::uint32_t group)>;

// Returns the owner of the right (left) side of a piece.
//
//   (1) the owner is the first face there that has a material; where none has one, the first black back
//   (2) the rival is the first later face with a material that acts otherwise (Material); nothing where all act alike
//   (3) a front of a group that is_silent names is passed over; its back is not. So is the front of a patch on it
//   (4) faces without a place beside patches are passed over (PatchBases::has_place)
//
// The materials pointed to are those of the scene, which must outlive the result. Throws ContractViolation when
// nothing is left to own the side.
// REQUIRES: `covering` is in the order of the scene, of which `patches` are the bases.
SideOwner2 owner_of_side(const Scene2& scene, const PatchBases& patches, const std::vector<PieceSource2>& covering,
                         bool right, const SilentGroups2& is_silent = {});

// True iff a face with a material is on the right (left) side of a piece, silent or not, but for patches on one of
// those groups, by way of others too: these are parts of what the group is.
bool has_material_on(const Scene2& scene, const PatchBases& patches, const std::vector<PieceSource2>& covering,
                     bool right, const SilentGroups2& is_silent);

}  // namespace hottel

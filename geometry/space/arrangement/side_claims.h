// What the polygons at a place claim of its two sides, and who gets them. Internal to geometry/space/arrangement.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/patch_bases.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A polygon that covers a place of a plane.
struct PlaceSource3 {
  std::uint32_t surface = 0;
  bool is_front_up = false;  // on which side of the plane its front is
};

// Who has one side of a place, and the first later face there with a material that acts otherwise.
struct SideOwner3 {
  Face owner;
  std::optional<Face> rival;
};

// Returns the owner of the upper or the lower side.
//
//   (1) the owner is the first face there that has a material; where none has one, the first black back
//   (2) fronts of groups that is_silent names are passed over, and those of patches on them; and those of masks and of
//       what they mask there
//   (3) faces without a place beside patches are passed over (PatchBases::has_place)
//
// REQUIRES: sources in the order of the scene, of which `patches` are the bases; one is not passed over.
SideOwner3 owner_of_side(const Scene3& scene, const PatchBases& patches, const std::vector<PlaceSource3>& sources,
                         bool is_up, const std::function<bool(std::uint32_t group)>& is_silent);

// A mask that lies where it may not: beside its base, or where `other` masks that too, or is a patch on it.
struct MisplacedMask3 {
  Mask3 mask;
  std::optional<std::uint32_t> other;
};

// Returns the first mask among the sources that is misplaced, or nothing.
std::optional<MisplacedMask3> misplaced_mask(const Scene3& scene, const PatchBases& patches,
                                             const std::vector<PlaceSource3>& sources);

// True iff a face with a material is on that side, silent or not, but for patches on one of those groups, by way of
// others too: these are parts of what the group is.
bool has_material_on(const Scene3& scene, const PatchBases& patches, const std::vector<PlaceSource3>& sources,
                     bool is_up, const std::function<bool(std::uint32_t group)>& is_silent);

}  // namespace hottel

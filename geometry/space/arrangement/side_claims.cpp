#include "geometry/space/arrangement/side_claims.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool is_there(const std::vector<PlaceSource3>& sources, std::uint32_t surface) {
  return std::any_of(sources.begin(), sources.end(),
                     [surface](const PlaceSource3& source) { return source.surface == surface; });
}

// The faces of some sources on one side.
std::vector<Face> faces_on(const std::vector<PlaceSource3>& sources, bool is_up) {
  std::vector<Face> faces;
  for (const PlaceSource3& source : sources) faces.push_back({source.surface, source.is_front_up != is_up});
  return faces;
}

// Whether the front of a surface faces another one at no distance there.
bool is_masked(const Scene3& scene, const std::vector<PlaceSource3>& sources, std::uint32_t surface) {
  return std::any_of(scene.masks.begin(), scene.masks.end(), [&](const Mask3& mask) {
    return (mask.surface == surface && is_there(sources, mask.base)) ||
           (mask.base == surface && is_there(sources, mask.surface));
  });
}

}  // namespace

SideOwner3 owner_of_side(const Scene3& scene, const PatchBases& patches, const std::vector<PlaceSource3>& sources,
                         bool is_up, const std::function<bool(std::uint32_t group)>& is_silent) {
  const auto material = [&scene](const Face& face) -> const Material* {
    const std::optional<std::uint32_t> m = scene.surfaces[face.surface].material_of(face.is_back);
    return m ? &scene.materials[*m] : nullptr;
  };
  const std::vector<Face> there = faces_on(sources, is_up);
  const std::vector<Face> silent =
      silent_fronts(patches, there, [&](std::uint32_t s) { return is_silent(scene.surfaces[s].group); });
  std::optional<SideOwner3> side;
  for (const Face& face : there) {
    if (std::ranges::find(silent, face) != silent.end() || !patches.has_place(face, there)) continue;
    if (!face.is_back && is_masked(scene, sources, face.surface)) continue;
    if (!side)
      side = {face, std::nullopt};
    else if (material(face) != nullptr && material(side->owner) == nullptr)
      side->owner = face;
    else if (material(face) != nullptr && !side->rival && !(*material(face) == *material(side->owner)))
      side->rival = face;
  }
  HOTTEL_REQUIRE(side.has_value());
  return *side;
}

std::optional<MisplacedMask3> misplaced_mask(const Scene3& scene, const PatchBases& patches,
                                             const std::vector<PlaceSource3>& sources) {
  for (const Mask3& mask : scene.masks) {
    if (!is_there(sources, mask.surface)) continue;
    if (!is_there(sources, mask.base)) return MisplacedMask3{mask, std::nullopt};
    for (const Mask3& other : scene.masks)
      if (other.base == mask.base && other.surface > mask.surface && is_there(sources, other.surface))
        return MisplacedMask3{mask, other.surface};
    for (const PlaceSource3& source : sources)
      if (const auto front = patches.face_under(source.surface, mask.base);
          front && (!front->is_back || scene.surfaces[source.surface].back))
        return MisplacedMask3{mask, source.surface};
  }
  return std::nullopt;
}

bool has_material_on(const Scene3& scene, const PatchBases& patches, const std::vector<PlaceSource3>& sources,
                     bool is_up, const std::function<bool(std::uint32_t group)>& is_silent) {
  const std::vector<Face> there = faces_on(sources, is_up);
  return std::ranges::any_of(there, [&](const Face& face) {
    return scene.surfaces[face.surface].material_of(face.is_back) &&
           !is_part_of_silent(patches, face.surface, there,
                              [&](std::uint32_t s) { return is_silent(scene.surfaces[s].group); });
  });
}

}  // namespace hottel

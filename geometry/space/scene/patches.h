// Patches of space: polygons that lie on others.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/patch_bases.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// What the patches of a scene lie on, where they are. It keeps the scene's address: the scene must stay where and as it
// is. COST: linear; each question a comparison of doubles for each polygon of the base, and exact ones near the patch.
class PatchCarriers3 {
 public:
  // What a polygon lies in, rounding included, and a little more where the base of a patch may be.
  struct Box {
    std::array<double, 3> low, high;
    explicit Box(const std::vector<Point3>& points);
    bool meets(const Box& other) const;
  };

  // REQUIRES validate_patches(scene).
  explicit PatchCarriers3(const Scene3& scene);

  const Scene3& scene() const { return *scene_; }
  const PatchBases& bases() const { return bases_; }
  // The surfaces on which a patch lies somewhere, ascending; of one plane those whose boxes there meet it.
  std::vector<std::uint32_t> of(std::uint32_t patch) const;
  // The patches that may take something of a face: those on it, and those with a back that are on the other face of its
  // surface, by way of others too.
  std::vector<std::uint32_t> on(const Face& face) const;

 private:
  const Scene3* scene_;
  PatchBases bases_;
  std::vector<Box> boxes_;  // by surface; none without patches
};

// Returns the patches that lie on some surfaces somewhere, and those on them, ascending.
std::vector<std::uint32_t> patches_on(const Scene3& scene, const std::vector<std::uint32_t>& surfaces);

// A scene without its patches: surface_of[s] is the surface of the first scene that surface s is.
struct BareScene3 {
  Scene3 scene;
  std::vector<std::uint32_t> surface_of;
};
// Returns nothing where there are no patches.
std::optional<BareScene3> without_patches(const Scene3& scene);

// Returns what the patches on a face leave of it: convex polygons that look as its front does, none where they cover
// all, the polygon itself where none lies on it. Of a patch with a back that is what it takes of the other face too.
std::vector<Polygon3> beside_patches(const PatchCarriers3& carriers, const Face& face);

}  // namespace hottel

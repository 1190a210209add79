// Patches of the plane: edges that lie on others.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/patch_bases.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// What the patches of a scene lie on, where they are. It keeps the scene's address: the scene must stay where and as it
// is. COST: linear; each question a comparison of doubles for each edge of the base.
class PatchCarriers2 {
 public:
  // What an edge lies in, rounding included, and a little more where the base of a patch may be.
  struct Box {
    double low_x, high_x, low_y, high_y;
    explicit Box(const Edge2& edge);
    bool meets(const Box& other) const {
      return low_x <= other.high_x && other.low_x <= high_x && low_y <= other.high_y && other.low_y <= high_y;
    }
  };

  explicit PatchCarriers2(const Scene2& scene);

  const PatchBases& bases() const { return bases_; }
  // The surfaces on which a patch lies along some way, ascending; exact.
  std::vector<std::uint32_t> of(std::uint32_t patch) const;

 private:
  const Scene2* scene_;
  PatchBases bases_;
  std::vector<Box> boxes_;  // by surface; none without patches
};

// Returns the patches that lie on some surfaces somewhere, and those on them, ascending.
std::vector<std::uint32_t> patches_on(const Scene2& scene, const std::vector<std::uint32_t>& surfaces);

// Returns patch_hint of two faces: the shorter one may be a patch on the other.
std::string shorter_patch_hint(const Scene2& scene, const Face& a, const Face& b);

// A scene without its patches: surface_of[s] is the surface of the first scene that surface s is.
struct BareScene2 {
  Scene2 scene;
  std::vector<std::uint32_t> surface_of;
};
// Returns nothing where there are no patches.
std::optional<BareScene2> without_patches(const Scene2& scene);

// Takes patches along where edges went from `before` to `after`, which have the same surfaces.
//
//   (1) an end of a patch keeps its part of the way along the edge that it lies on, where that moved
//   (2) a patch that moved while what it lies on did not slides along that, as far as its ends: an end that moved alone
//       alone
//   (3) what this does not put onto its base stays as it is in `after`
void carry_patches(const Scene2& before, Scene2& after);

// Gives the bases of patches other names, where surfaces or groups of `before` are called otherwise in `after` or are
// no more: then the name of the surface that a patch lies on, the first of several. place[s] is where surface s of
// `before` is in `after`; nothing where it is no more.
void rename_bases(const Scene2& before, const std::vector<std::optional<std::uint32_t>>& place, Scene2& after);

}  // namespace hottel

// Patches of the plane: edges that lie on others.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/patch_bases.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Puts patches onto what they lie on: their ends onto the line of the base, exactly, where both are within the
// planarity tolerance of it (is_within_planarity, by the longer of the two); and what then is beyond an end of the
// base by no more than that onto the end. Pieces of a polyline that followed each other do so after.
//
//   (1) a patch whose ends lie on the line of its base and within it stays as it is; so does one that is farther off
//   (2) patches on patches come after what they lie on
//
// `unit` is what the last digit of the coordinates stands for, 0 where they have none.
void seat_patches(Scene2& scene, const Rational& unit);

// Throws InputError naming file, line, patch, base and place, with the remedy, for a patch that does not lie on the
// line of its base exactly, that looks the other way, or that leaves its base. REQUIRES validate_bases(scene). COST:
// for each patch linear in the edges of its base.
void validate_patches(const Scene2& scene);

// What the patches of a scene lie on, where they are. It keeps the scene's address: the scene must stay where and as it
// is. COST: linear; each question a comparison of doubles for each edge of the base.
class PatchCarriers2 {
 public:
  explicit PatchCarriers2(const Scene2& scene);

  const PatchBases& bases() const { return bases_; }
  // The surfaces on which a patch lies along some way, ascending; exact.
  std::vector<std::uint32_t> of(std::uint32_t patch) const;

 private:
  friend class PatchSupports2;
  // What an edge lies in, rounding included, and a little more where the base of a patch may be.
  struct Box {
    double low_x, high_x, low_y, high_y;
    bool meets(const Box& other) const {
      return low_x <= other.high_x && other.low_x <= high_x && low_y <= other.high_y && other.low_y <= high_y;
    }
  };
  static Box box_of(const Edge2& edge);

  const Scene2* scene_;
  PatchBases bases_;
  std::vector<Box> boxes_;  // by surface; none without patches
};

// Returns the patches that lie on some surfaces somewhere, and those on them, ascending.
std::vector<std::uint32_t> patches_on(const Scene2& scene, const std::vector<std::uint32_t>& surfaces);

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

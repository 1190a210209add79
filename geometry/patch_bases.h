// What the patches of a scene lie on, and which faces give way to them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/face.h"
#include "geometry/scene_table.h"

namespace hottel {

// What patches lie on: a base is the surface of its name, or the surfaces of the group of its name but for those that
// lie on that name themselves.
//
//   (1) a face lies on a side as it looks there; a patch looks as its base does, or as the back of that does
//   (2) a patch whose front is on a side takes the place of the base's face there; one with a `back` that of the base's
//       other face on the other side, and of what that lies on; one without has no face there
//
// REQUIRES a table with valid indices. It need not outlive this. COST: linear.
class PatchBases {
 public:
  PatchBases() = default;  // no patches
  explicit PatchBases(const SceneTable& table);

  bool is_empty() const { return base_of_.empty(); }
  bool is_patch(std::uint32_t surface) const { return !is_empty() && base_of_[surface] >= 0; }
  // The surfaces that a patch lies on, ascending; none where there is no surface or group of the name. REQUIRES a
  // patch.
  const std::vector<std::uint32_t>& under(std::uint32_t patch) const { return surfaces_[index_of(patch)]; }
  // Whether a patch lies on the backs of those. REQUIRES a patch.
  bool is_on_backs(std::uint32_t patch) const { return bases_[index_of(patch)].is_back; }
  bool lies_on(std::uint32_t patch, std::uint32_t surface) const;
  // The same by way of others too. REQUIRES that no patch lies on itself.
  bool rests_on(std::uint32_t patch, std::uint32_t surface) const;
  // The face of a surface that the front of a patch is on, by way of others too; nothing where it does not rest on it.
  std::optional<Face> face_under(std::uint32_t patch, std::uint32_t surface) const;

  // Whether a face has a place on a side where it and others lie: not where it is the back without a material of a
  // patch, or another one there is that of a patch that takes its place. REQUIRES all faces on one side of a place.
  bool has_place(const Face& face, std::span<const Face> there) const;
  // The faces among some on one side of which the first is a patch on the second, as its front.
  bool is_front_on(const Face& patch, const Face& base) const;

  // The patches, each after those that it lies on; nothing where some lie on themselves.
  std::optional<std::vector<std::uint32_t>> outermost_first() const;
  // The patches that lie on some of these surfaces, also by way of others, ascending; none where some lie on
  // themselves. `carriers`: what a patch touches of what it lies on.
  std::vector<std::uint32_t> resting_on(
      std::span<const std::uint32_t> surfaces,
      const std::function<std::vector<std::uint32_t>(std::uint32_t patch)>& carriers) const;

 private:
  std::size_t index_of(std::uint32_t patch) const { return static_cast<std::size_t>(base_of_[patch]); }
  bool visit(std::uint32_t patch, std::vector<char>& state, std::vector<std::uint32_t>& order) const;

  std::vector<PatchBase> bases_;
  std::vector<std::vector<std::uint32_t>> surfaces_;  // by base
  std::vector<std::int64_t> base_of_;                 // by surface, -1 for what is no patch; empty without patches
  std::vector<char> has_back_;                        // by surface
};

// Returns those faces on one side of a place that are fronts of surfaces that is_silent names, or of patches on such.
std::vector<Face> silent_fronts(const PatchBases& patches, std::span<const Face> there,
                                const std::function<bool(std::uint32_t surface)>& is_silent);

// Whether a surface is a patch that rests on a surface there that is_silent names: then it is a part of what that is.
bool is_part_of_silent(const PatchBases& patches, std::uint32_t surface, std::span<const Face> there,
                       const std::function<bool(std::uint32_t surface)>& is_silent);

// Lists the bases anew in the order in which surfaces first name them, each once and no others: as a file is read.
void settle_bases(SceneTable& table);

// Returns what patches lie on as messages call it: "'wall'", "the back of 'wall'".
std::string base_text(const PatchBase& base);

// Returns a hint for two faces with different materials on one side: that one may be a patch on the other, and how to
// say so. `patch` is that of the smaller surface.
std::string patch_hint(const SceneTable& table, const Face& patch, const Face& base);

// Throws InputError about a patch: "'window' looks ...", with file and line; of one that looks the other way than what
// it lies on.
[[noreturn]] void refuse_patch(const SceneTable& table, std::uint32_t patch, const std::string& what,
                               const std::string& remedy);
[[noreturn]] void refuse_turned_patch(const SceneTable& table, std::uint32_t patch);

// Throws InputError naming file, line and patch for one whose base is not there or is itself, by way of others too, and
// for an obstruction that is one. REQUIRES valid indices of bases.
void validate_bases(const SceneTable& table);

}  // namespace hottel

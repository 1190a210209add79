// All of a scene but its shape, in either dimension.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/element.h"
#include "geometry/face.h"
#include "geometry/light.h"
#include "geometry/material.h"
#include "kernel/support/failure.h"

namespace hottel {

// The most elements that one surface may be divided into.
inline constexpr std::uint32_t kMaxElements = 1'000'000;

// Where a face of a mesh stands in a file. It never makes two surfaces different: all places compare equal.
struct MeshPlace {
  std::uint32_t file = 0;  // SceneTable::sources[file - 1]; 0: it is no face of a mesh
  int line = 0;            // 0 in a binary file
  friend bool operator==(const MeshPlace&, const MeshPlace&) { return true; }
};

// One edge (in the plane) or polygon (in space) of the input, but for its points. A back without a material is opaque
// and black and makes no claim on an overlap.
struct Surface {
  std::string name;
  std::uint32_t material = 0;         // of the front; index into SceneTable::materials
  std::optional<std::uint32_t> back;  // of the back
  std::uint32_t elements = 1;         // equal parts it is divided into
  std::uint32_t group = 0;            // index into SceneTable::groups
  int line = 0;                       // where it stands in the file, 0 if nowhere; of a face where its mesh does
  // In space only: it has no material at all. Both sides are opaque and black and have no row; `material` means
  // nothing.
  bool is_obstruction = false;
  MeshPlace in_mesh{};  // of a face of a mesh
  // It is a patch: it lies on what SceneTable::bases has there, and takes its part of that.
  std::optional<std::uint32_t> on{};
  // Elements below the equal parts. No file has any: they come of what is simulated.
  SurfaceTrees trees{};

  bool is_divided() const { return elements > 1 || !trees.is_empty(); }
  // Whether two are one but for how they are divided; are divided alike.
  static bool is_alike_undivided(const Surface& a, const Surface& b) {
    return a.name == b.name && a.material == b.material && a.back == b.back && a.group == b.group && a.line == b.line &&
           a.in_mesh.file == b.in_mesh.file && a.in_mesh.line == b.in_mesh.line &&
           a.is_obstruction == b.is_obstruction && a.on == b.on;
  }
  static bool is_divided_alike(const Surface& a, const Surface& b) {
    return a.elements == b.elements && a.trees == b.trees;
  }

  // The material of its front or its back; nothing for a back without one, and for obstructions.
  std::optional<std::uint32_t> material_of(bool is_back) const {
    if (is_obstruction) return std::nullopt;
    return is_back ? back : std::optional(material);
  }
  friend bool operator==(const Surface&, const Surface&) = default;
};

// What patches lie on: the fronts or the backs of the surface of that name; or of the surfaces of the group of that
// name, without those that are patches on this group themselves (PatchBases).
using PatchBase = SideName;

// What is behind the backs of a group. It is obeyed, or refused, when the scene is prepared (InputError).
enum class Behind : unsigned char {
  kByOutline,  // nothing is said: a solid where the group is a closed outline or mesh, fronts outward, and no back has
               // a material
  kSolid,  // in the plane: the bounded regions that a back without a material, and no front of the group, looks into;
           // in space: what the group or its body encloses, which has to be closed with its fronts outward
  kOpen,   // the group makes nothing solid
};

// A single surface, or the surfaces of one polyline or mesh. It has a name and says what is behind its backs; its
// surfaces refer to it by their `group`. In space several groups may name the same body: if none of them is closed by
// itself, they are tested together for being closed.
struct Group {
  std::string name;
  Behind behind = Behind::kByOutline;
  std::string body{};  // empty: none

  Group(std::string n, Behind b = Behind::kByOutline) : name(std::move(n)), behind(b) {}
  Group(const char* n) : name(n) {}
  friend bool operator==(const Group&, const Group&) = default;
};

// An expectation that a scene file carries about itself: a value that a reader can check, and why it holds.
struct Expectation {
  std::string name;             // of the reference value, e.g. "strip_parallel_h1"; may be empty
  std::string kind;             // "exact", "rounded", "limit", "point", ...
  std::string quantity;         // "factor", "radiosity", ...
  std::vector<std::string> of;  // names the quantity is about, e.g. {from, to}
  std::string at;               // of a point quantity: t in [0,1] from the first to the second point of of[0]
  std::string value;            // p/q or decimal where exact, otherwise at least 21 significant digits
  std::string form;             // closed form for people, e.g. "-1 + 1*sqrt(2)"
  std::string derivation;
  int line = 0;
};

// Names, materials, groups and lines: all that plans, verdicts, reports and net fluxes know of a scene. `closed` is a
// promise of its author: no front with a material sees the sky.
//
//   (1) names are not empty, unique after expansion, none is "sky"; see docs/scene_format.md
//   (2) every material, group and base index is valid; an obstruction has no material, on either side, and is no patch
//   (3) the unit is a name (unit_problem): coordinates are as typed; unit_of_length.h says what it is in metres
//   (4) bases name surfaces or groups, and no patch lies on itself, by way of others neither (validate_bases)
struct SceneTable {
  std::string file;                  // for messages; may be a description when the scene was not read from a file
  std::vector<std::string> sources;  // files of meshes that surfaces stand in, and what these name: it was read too
  std::string about;
  std::vector<Material> materials;
  std::vector<Surface> surfaces;  // in the order of the file
  std::vector<Group> groups;
  std::vector<PatchBase> bases;  // of patches, used or not
  std::vector<Light> lights;     // but for where they are, which the scene of each dimension knows
  Spectrum sky_emission;
  bool closed = false;
  std::vector<Expectation> expect;
  std::string unit;  // what coordinates are in, by its name; empty: m
  // Two bands, solar and thermal, instead of one channel or r, g, b: of all materials, lights and the sky.
  bool has_bands = false;

  // Returns the index of the first surface of exactly that name, or nothing. COST: linear.
  std::optional<std::uint32_t> find(const std::string& name) const;
};

// If a front has a two-sided material and the back of its surface has no material, gives the back that material; not
// for patches, whose backs have what the file says.
// REQUIRES materials that are defined. COST: linear.
void settle_two_sided(SceneTable& table);

// Returns where a surface stands, for messages: a face of a mesh in the file of that.
FileLine place_of(const SceneTable& table, const Surface& surface);

// The most bytes that the name of a unit may have.
inline constexpr std::size_t kMaxUnitLength = 16;
// Returns why a unit of length may not be called so, as the end of a sentence ("must not be empty"); empty when it may.
std::string_view unit_problem(std::string_view unit);
// Returns what lengths of the scene are in, for people: its unit, or m.
std::string length_unit(const SceneTable& table);

// Throws InputError naming file, line and surface unless the names of surfaces are allowed (name_problem) and unique,
// the indices of their materials, groups and bases are valid and their elements from 1 to kMaxElements, and spectra are
// in their ranges (Material), of one value where they are scalars, and unless no light has a problem (light_problem)
// and no two the same name, and unless patches have bases (validate_bases). Where two surfaces share a name, the later
// one is refused and the line of the first is told. COST: linear.
void validate_table(const SceneTable& table);

// Turns spectra of materials and lights that were added to a scene of two bands into spectra of two bands: the emission
// of a lamp or a light becomes solar. Does nothing in a scene without bands, nor to spectra of two bands.
void settle_bands(SceneTable& table);

// Returns how many surfaces each group has. Throws ContractViolation for a surface of a group that is not there.
std::vector<std::size_t> group_sizes(const SceneTable& table);

// True iff some surface is divided into elements. In the plane rows are then those of elements by default.
bool is_divided(const SceneTable& table);

// Returns how many channels the spectra of a scene need: 2 in two bands; 1 when the sky, all materials and lights are
// scalars, else 3. Materials that no surface has count too.
int channel_count(const SceneTable& table);
// Returns what they are called: "all"; "solar", "thermal"; or "r", "g", "b".
std::vector<std::string> channel_names(const SceneTable& table);

}  // namespace hottel

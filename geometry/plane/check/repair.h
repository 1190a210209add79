// A scene whose near misses are closed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/scene/scene.h"
#include "geometry/repair_step.h"

namespace hottel {

// A repaired scene, and how it came from the one that was given.
struct Repair2 {
  Scene2 scene;
  // "merged", "snapped", "dropped", "reversed", "solid", "renumbered", "split", "not-repaired".
  std::vector<RepairStep> steps;
  std::vector<std::string> former_names;  // by surface: what it was called before the repair
  // The surfaces, as they were numbered before, of which an end moved; those whose ends moved together in one list.
  std::vector<std::vector<std::uint32_t>> moved{};
  std::vector<std::uint32_t> origins{};  // by surface, as close_gaps leaves them: which one it was before
};

// Returns the scene as it is, without any step.
Repair2 unrepaired(const Scene2& scene);

// Returns what an element of the repaired scene was called before; factor_changes() asks for it.
std::string former_name(const Repair2& repair, const Element& element);

// Returns the scene with ends that are within `distance` of each other merged (into the one listed first), ends within
// `distance` of a surface put exactly onto it, and surfaces that became points, or the same as an earlier one in
// everything but the name, dropped. Pieces of an outline that may be a solid or a room in one, and of groups that say
// what is behind them, are not dropped as repetitions (not-repaired): it would be open.
//
//   (1) no end point moves farther than `distance`; without a gap, stub or repetition the scene is returned as it is
//   (2) names, materials, order and all else stay (restore_polylines follows)
//   (3) an end that meets a surface exactly and stays within reach meets it afterwards
//   (4) an end of a surface that makes an angle with another at their common end is not put onto it: the angle may be
//       meant (not-repaired)
//   (5) of contacts, near misses and needles no more is found afterwards than before, and no more that is not a note
//       (notes of needles and crossings count, others do not: they tell how things are that touch); and nothing that
//       moved would move again. Where it would, what moves together stays as it was (not-repaired)
//   (6) patches and what they lie on stay as they are
// REQUIRES distance > 0. COST: O(n log n) and exact arithmetic near ends.
Repair2 close_gaps(const Scene2& scene, const Rational& distance);

// Reverses surfaces that are certainly the wrong way round (RegionFindings2::certainly_reversed), with the patches on
// them, and adds a step for each. Nothing is done where claims conflict or a "behind" cannot be obeyed. Groups that say
// what is behind them stay as they are.
void reverse_inside_out(Repair2& repair);

// Says "behind": "solid" of groups whose black backs are told of (BlackBacks2::surfaces of the repaired scene) and adds
// a step for each group.
//
//   (1) only where that is accepted, and makes all of the back's surroundings solid
//   (2) no face with a material is covered wholly by all of it together, and none emits in what becomes solid
//   (3) none where groups listed before have made all of it solid already
//   (4) a region that (2) forbids is told of once (not-repaired)
// REQUIRES a scene that is accepted, if there are any backs.
void state_solids(Repair2& repair, const std::vector<std::uint32_t>& black_backs);

// Makes polylines of the pieces of polylines again after the other repairs.
//
//   (1) pieces that still follow each other, in their order or against it, are a polyline of the same name: its pieces
//       are NAME[0], NAME[1], ... in the order in which they follow each other now (renumbered)
//   (2) pieces of others keep their names as edges of their own, which stand before all polylines (split)
//   (3) polylines that were not changed stay as they are
//   (4) patches lie on what they lay on, by its name now (rename_bases)
void restore_polylines(Repair2& repair);

}  // namespace hottel

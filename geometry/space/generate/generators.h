// Scenes in space made to order: seeded, of any size, the same on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/generate/generator_request.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A kind of scene, as help tells of it.
struct GeneratorKind3 {
  std::string name;
  std::string description;  // one line
  std::string count;        // what --n N counts and how many polygons come out, one line
  std::uint64_t min_n;
  std::uint64_t usual_n;  // what is made where no n is given
  bool stands;            // bodies stand on something, and may do so without bottoms
};

// The kinds, in the order in which help lists them. None has the name of a kind in the plane.
const std::vector<GeneratorKind3>& generator_kinds_3();

inline constexpr std::uint64_t kMaxGeneratedBodies = 100'000;

// Returns the scene of that kind.
//
//   (1) the same request gives the same scene, on every platform: integers and std::mt19937_64 decide, no floating
//       point and no library distribution
//   (2) every polygon is exactly plane and convex, whatever it is turned by: rotations are of rational numbers
//   (3) every group but those of "triangle-soup" and the ground of kinds under a sky is a closed mesh: each of its
//       sides is a side of two of its polygons, in opposite senses. Boxes have their fronts outward, rooms inward. A
//       body without a bottom is open there and nowhere else. The ground of "terrain" is open along its border only
//   (4) every kind but "street-blocks", "town" and "terrain" is closed: no front with a material sees the sky
//   (5) no two polygons share an area in the kinds "room-floating", "room-turned", "room-piercing", "terrain",
//       "nested-cubes" and "triangle-soup", nor, without bottoms, in "room-boxes", "room-stacked", "street-blocks",
//       "town", "furnished-room" and "flat". In the others a box shares area with what it stands on or touches
//   (6) "lattice-boxes" is full of coincidences; one material, so that no two claims on a piece differ
//   (7) n decides the number of polygons, as GeneratorKind3::count says, and something always emits
//   (8) polygons are called GROUP[k], k from 0 in each group, as the faces of a mesh are; no back has a material
//
// Throws UsageError for an unknown kind or a request out of range. COST: O(n log n); 10^5 boxes take about 3 s and
// 1 GB.
Scene3 generate_3(const GeneratorRequest3& request);

}  // namespace hottel

// What writes what many points of space see, whatever the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/point.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/point_bounds.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// A point, and what it sees (faces_seen_from); nothing in a solid, which is told by its number in Solids3::meshes().
// Without pieces a map may be without corners and fragments.
struct SeenByPoint3 {
  Point3 eye;
  std::optional<std::uint32_t> solid;
  VisibilityMap3 map;
  std::optional<PointBounds3> bounds;  // of the shares of the map, in their order
};

// What all points of a file have in common.
struct SeenFileOptions3 {
  const Scene3& scene;
  const Solids3& solids;
  bool has_pieces = false;             // the arrays have those of each face too; a .vtu always has them, a .csv never
  bool has_bounds = false;             // of what every point sees; never in a .vtu
  std::filesystem::path folder = ".";  // where arrays are put aside until their lengths are known
};

// Writes what points see, in their order; they are numbered from 0. docs/visibility_files.md says what stands where.
//
//   (1) memory does not grow with the number of points: lines are written as they come, arrays are put aside on disk
//   (2) faces are in the order of the scene, the sky last. What rounding leaves of a sky that is not seen is none
//
// Throws OutputError where the disk has no room, RequestError where a place is beyond the range of doubles.
class SeenWriter3 {
 public:
  virtual ~SeenWriter3() = default;
  virtual void add(const SeenByPoint3& seen) = 0;
  virtual void finish() = 0;
};

}  // namespace hottel

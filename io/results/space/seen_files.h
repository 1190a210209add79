// What many points of space see, as files: in lines, as NumPy's arrays, as the pieces themselves for ParaView.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/point.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// A point, and what it sees (faces_seen_from); nothing in a solid, which is told by its number in Solids3::meshes().
// Without pieces a map may be without corners and fragments.
struct SeenFrom3 {
  Point3 eye;
  std::optional<std::uint32_t> solid;
  VisibilityMap3 map;
};

enum class SeenFormat3 { kCsv, kNpz, kVtu };

// Returns the format of a file by its ending, .csv, .npz or .vtu; nothing for others.
std::optional<SeenFormat3> seen_format_3(const std::filesystem::path& file);

// What all points of a file have in common.
struct SeenFileOptions3 {
  const Scene3& scene;
  const Solids3& solids;
  bool has_pieces = false;             // the arrays have those of each face too; a .vtu always has them, a .csv never
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
  virtual void add(const SeenFrom3& seen) = 0;
  virtual void finish() = 0;
};

// REQUIRES that scene and solids outlive it. sink: takes the bytes of the file.
std::unique_ptr<SeenWriter3> seen_writer_3(SeenFormat3 format, const SeenFileOptions3& options,
                                           std::function<void(std::string_view)> sink);

}  // namespace hottel

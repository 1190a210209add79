// What is passed over in maps, drawings and meshes, since nothing of it can be seen.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {

// What readers of formats that are not hottel's own pass over.
enum class PassedKind : unsigned char {
  kRepeatedPoint,         // equal to the one before; of a face or a closed outline also to its first
  kEmptyGeometry,         // null, EMPTY, or a list of no positions
  kFaceWithoutArea,       // of a mesh: fewer than three points that differ, or all on one line
  kLineWithoutLength,     // of a map or a drawing: all its points are the same
  kPoint,                 // of a map or a mesh
  kLine,                  // of a mesh
  kThirdCoordinate,       // of a position in a map
  kMissingMaterialsFile,  // that a mesh names: no material of it is needed
};

// Counts them, and remembers the first of each kind.
class PassedOver {
 public:
  // Something that stands there; `name` is what it is called, where it has a name. REQUIRES a name that is fit for a
  // message (quoted_name).
  void add(PassedKind kind, const FileLine& where, const std::string& name = "", std::size_t count = 1);

  // All of another one after its own.
  void add(const PassedOver& other);

  std::size_t count(PassedKind kind) const { return all_[static_cast<std::size_t>(kind)].count; }

  // A line for each kind that there was, in the order above; empty where nothing was passed over.
  //
  //   (1) it counts them and names the first: "2 faces without area passed over, the first 'a[3]' at room.stl:9"
  std::string note() const;

 private:
  static constexpr std::size_t kKinds = 8;
  struct Kind {
    std::size_t count = 0;
    std::string first;
  };
  std::array<Kind, kKinds> all_;
};

// Takes out every point that is the same as the one before it, and those at the end of a ring that are the same as its
// first. Returns how many there were. COST: linear.
template <class Point, class Same>
std::size_t drop_repeated(std::vector<Point>& points, bool is_ring, const Same& same) {
  const std::size_t before = points.size();
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  while (is_ring && points.size() > 1 && same(points.back(), points.front())) points.pop_back();
  return before - points.size();
}

}  // namespace hottel

// Elements: what carries one unknown each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "geometry/element_tree.h"
#include "kernel/enclosure.h"

namespace hottel {

// What one row and column of the exchange matrix stands for.
// kFace:    a face, whole
// kElement: one of the equal parts of a face with a material, or a leaf of the trees under them; a black back is never
//           divided
// kGroup:   all fronts, or all backs, of one polyline
enum class Granularity : unsigned char { kFace, kElement, kGroup };
inline constexpr std::size_t kGranularities = 3;

// One row or column of an exchange matrix: a face, a part of one, or a group of faces.
//
//   (1) part < parts, and parts == 1 for what is not divided into equal parts; the path leads on from the part
//   (2) an element without a material, or with area 0, has no row
struct Element {
  std::string name;                   // "wall", "wall:back", "wall#2", "wall#2/01"
  std::uint32_t surface = 0;          // index into the scene's surfaces (the first one of a group)
  std::uint32_t part = 0, parts = 1;  // which of how many equal parts
  bool is_back = false;
  std::optional<std::uint32_t> material;  // none: an opaque black back, which has a column but no row
  Rounded area;                           // length in 2D [scene unit], 0 when other surfaces own all of it
  TreePath path{};                        // under its part

  // True iff it is not the whole face.
  bool is_part() const { return parts > 1 || path.depth() > 0; }
  TreeNode node() const { return {part, path}; }
};

// What an element is called: its face's name, and where it is a part of it, "#2" or "#2/01".
std::string element_name(const std::string& face, std::uint32_t parts, const TreeNode& node);

// Two elements by number, the smaller first, or an element and the sky.
using ElementPair = std::pair<std::uint32_t, std::uint32_t>;

}  // namespace hottel

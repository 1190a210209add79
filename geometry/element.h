// Elements: what carries one unknown each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "kernel/enclosure.h"

namespace hottel {

// What one row and column of the exchange matrix stands for.
// kFace:    a face, whole
// kElement: one of the equal parts of a face with a material; a black back is never divided
// kGroup:   all fronts, or all backs, of one polyline
enum class Granularity : unsigned char { kFace, kElement, kGroup };

// One row or column of an exchange matrix: a face, a part of one, or a group of faces.
//
//   (1) part < parts, and parts == 1 for what is not divided
//   (2) an element without a material, or with area 0, has no row
struct Element {
  std::string name;                   // "wall", "wall:back", "wall#2"
  std::uint32_t surface = 0;          // index into the scene's surfaces (the first one of a group)
  std::uint32_t part = 0, parts = 1;  // which of how many equal parts
  bool is_back = false;
  std::optional<std::uint32_t> material;  // none: an opaque black back, which has a column but no row
  Rounded area;                           // length in 2D [scene unit], 0 when other surfaces own all of it
};

// Two elements by number, the smaller first, or an element and the sky.
using ElementPair = std::pair<std::uint32_t, std::uint32_t>;

}  // namespace hottel

// Elements merged along the faces, as a division half as fine has them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"

namespace hottel {

// Which elements are merged.
//
//   (1) `of` has one number for each element, that of a merged one, and one for the sky, which is their count
struct ElementMerging {
  std::vector<std::uint32_t> of{};
  std::vector<Element> merged{};  // areas are the sums of those of their elements
  std::string why_none{};         // where the elements cannot be merged: a sentence; the others are empty then
};

// Where an element of a face that is divided evenly lies in a division half as fine.
struct CoarsePart {
  std::uint32_t part = 0, parts = 1;
};

// Merges elements, as coarse_part tells it of those of divided faces.
//
//   (1) there is none where a face with a row is one element, is divided by an odd number, or has trees
//   (2) what has no row and cannot be merged stays as it is
ElementMerging merged_elements(const SceneTable& scene, std::span<const Element> elements,
                               const std::function<CoarsePart(const Element&)>& coarse_part);

}  // namespace hottel

// What a square matrix without names may be of: sizes that have two meanings in a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "io/external/external_file.h"

namespace hottel {

// One of them: the elements that the rows and columns stand for, the sky by the number of elements.
struct SizeMeaning {
  std::string words;                  // "all faces and the sky"
  std::vector<std::uint32_t> places;  // empty: of faces that the scene divides, which are not compared
  double asymmetry = 0;               // of A_i F_ij over all pairs of rows, from 0 to 1
};

// Returns what a square matrix of this size may be of, in this order: all elements, with the sky, those with a
// material, with the sky; where the scene divides faces, the same four of whole faces. COST: a sort of the entries for
// each.
std::vector<SizeMeaning> size_meanings(const ExternalMatrix& external, const std::vector<Element>& elements);

}  // namespace hottel

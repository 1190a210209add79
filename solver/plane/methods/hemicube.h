// The hemicube, in the plane: an item buffer on a half-square about each element's centre.
#pragma once

#include <cstdint>
#include <memory>

#include "solver/plane/methods/exchange_method.h"
#include "solver/plane/methods/item_buffer.h"

namespace hottel {

// F_ij is the weight of the pixels in which j is seen from the centre of i; what no item covers is sky. An element of
// several runs is seen from the centre of each, weighted by their lengths. Rows sum to 1 but for rounding.
//
// Two errors remain: the pixels, one over the resolution for each piece of j that is seen; and the centre, which stands
// for the mean over the element: not small for elements near others, whatever the resolution.
//
// Pieces that end at the eye itself are seen edge-on and cover nothing.
struct HemicubeOptions2 {
  std::uint32_t resolution = 256;  // pixels on the front edge. REQUIRES an even number, 2 <= resolution <= 2^20
  bool is_uniform = false;         // every pixel weighs the same: plain counts, wrong whatever the resolution
};

// declared_error: half a pixel for each vertex in front of an element, and the variation of what is seen along the
// element. Of the software buffer, which takes depths that differ by less than roundings as they come: nothing where
// pieces are nearer to each other than 2^-16 of the scene, nor where another edge touches an element, pixels are plain
// counts, or 2 R vertices and more stand in front of an element. COST: at most 2 R vertices for each element, besides
// a tree of all of them.
std::unique_ptr<ExchangeMethod2> hemicube_method_2(const HemicubeOptions2& options,
                                                   MakeItemBuffer2 make_buffer = software_item_buffer_2);

}  // namespace hottel

// The hemicube: an item buffer on half a cube about the centre of each patch.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/space/methods/exchange_method.h"

namespace hottel {

// F_ij is the weight of the pixels in which j is seen from the centre of i; what no item covers is sky. An element of
// several patches is seen from the centre of each, weighted by their areas. Rows sum to 1 but for rounding.
//
// Two errors remain: the pixels; and the centre, which stands for the mean over the element: not small for elements
// near others, whatever the resolution.
//
// Pixels are those of an ItemBuffer3 (item_buffer.h).
struct HemicubeOptions3 {
  std::uint32_t resolution = 128;  // pixels on the long edges. REQUIRES an even number, 2 <= resolution <= 4096
  bool is_uniform = false;         // every pixel weighs the same: plain counts, wrong whatever the resolution
  bool by_egl = false;             // pixels by OpenGL, not in software: not the same on every machine
};

// COST: that of the pixels covered, some milliseconds an element at 256 pixels; in parallel.
std::unique_ptr<ExchangeMethod3> hemicube_method_3(const HemicubeOptions3& options);

// The view factor of pixels of a hemicube from its centre: of the top first, resolution x resolution of them row by
// row, then of one side, resolution / 2 rows from the horizon up. Those of the top and of four sides sum to 1 but for
// rounding. (The usual delta form factor is the same by the midpoint rule.)
// SEE: Cohen, Greenberg, The hemi-cube: a radiosity solution for complex environments, 1985.
std::vector<double> hemicube_weights_3(std::uint32_t resolution);

}  // namespace hottel

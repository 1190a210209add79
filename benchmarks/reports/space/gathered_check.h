// Pictures of gathered light held against full sampling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "benchmarks/reports/space/full_sampling.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/pixel_values.h"

namespace hottel {

// Which pixels are looked at.
struct GatheredSample3 {
  std::uint32_t width = 240;      // of the picture
  std::size_t pixels = 10'000;    // drawn from all
  std::size_t borders = 100'000;  // drawn from those with borders beside; all, where there are no more
  std::uint64_t seed = 1;
};

// A pixel as it is, and as full sampling has it.
struct GatheredPixel3 {
  std::uint32_t x = 0, y = 0;
  bool is_drawn = false;  // from all pixels
  PixelBorders3 borders;
  double steps = 0;  // of 256, the picture from full sampling, by the curve of the picture
  double part =
      0;  // the same of the picture for numbers, as a part of the larger light, of the channel where it is most
};

struct GatheredCheck3 {
  PixelValues3 picture;  // its light
  std::vector<GatheredPixel3> pixels;
  std::uint64_t all_borders = 0;  // pixels with a border
  double seconds_of_picture = 0, seconds_of_sampling = 0;
};

// Makes the pictures of the light of a scene's camera, gathered, as `solve --render` does to .png and to .npy, and some
// of their pixels by full sampling.
//
//   (1) a pixel has one point for each side that is seen in it, 4 x 4 of direct light; one with a border 3 x 3, 16 x 16
//       of direct light. Where that differs from a picture by more than half a step, or by half the tolerance of
//       numbers, it is taken again by 6 x 6, and where it is still off by half a step, direct light by 64 x 64
//   (2) the same pixels for the same seed
//
// REQUIRES a request for elements. COST: that of FullSampling3.
GatheredCheck3 check_gathered_3(const Simulation3& simulation, const GatheredSample3& sample);

}  // namespace hottel

// Light in the rooms of a scene in the plane as a picture, under the plan of the scene.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/plane/simulation/simulation.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

struct IlluminationGrid2;
class ToneCurve;
struct PreparedScene2;

// How the light of a grid becomes a picture.
struct IlluminationPicture2 {
  Tone tone = kUsualTone2;
  double exposure = 1;                       // what the light is multiplied by; ToneCurve says relative to what
  std::uint32_t wanted_side = 1400;          // pixels of the longer side: rounded to whole pixels a cell
  std::uint32_t wanted_width = 0;            // pixels across instead, where not 0
  std::shared_ptr<const ToneCurve> curve{};  // instead of one that is fitted to the light of the grid
  bool has_axes = false;                     // coordinates along the frame and a scale bar, in margins around the light
  int contours = 0;                          // about so many lines of equal light, at most (light_contours_2)
};

// Returns the levels of lines of equal light for a picture of a grid: round ones, at most so many (contour_levels),
// in what the grid holds; of three channels their mean counts. None for 0.
std::vector<double> light_contours_2(const IlluminationGrid2& grid, int contours);

// Returns the bytes of the picture file, and what the tone curve multiplied values by.
LightPicture2 illumination_picture_2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                                     const IlluminationPicture2& picture, PictureFormat format);

// The same for a simulation to call.
std::shared_ptr<const LightPainter2> light_painter_2(const IlluminationPicture2& picture, PictureFormat format);

}  // namespace hottel

// Light on a planar grid in space as a picture.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

struct GridPicture3 {
  Tone tone = kUsualTone3;
  double exposure = 1;             // what the light is multiplied by; ToneCurve says relative to what
  std::uint32_t wanted_width = 0;  // pixels across, rounded to whole pixels a cell; 0: the longer side has about 800
  bool has_axes = false;           // margins with axes along u and v, and a scale bar
  std::string length_unit = "m";   // of coordinates
  int contours = 0;                // about so many lines of equal light, at most (light_contours)
};

// Returns the bytes of a PNG: u to the right, v upwards, as long as they are; each cell is the same number of whole
// pixels in the colour of its value, grey where it is in a solid. Axes are coordinates of the scene where a side of the
// grid runs along one, else the way from the grid's origin. Contours run where light that is blended between the
// centres of cells has their level; none enters a solid.
std::string grid_picture_3(const IlluminationGrid3& light, const GridPicture3& picture);

// The same of values on a scale, one a cell, in place of the light, with a footer below that has bar, unit and range.
// Tone and exposure mean nothing; contours are of the values.
std::string grid_picture_3(const Grid3& grid, const ShownValues& shown, const GridPicture3& picture);

// The same for a simulation to call.
std::shared_ptr<const LightPainter3> grid_painter_3(const GridPicture3& picture);

}  // namespace hottel

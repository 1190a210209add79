// Where the light of another program on a grid is off.
#pragma once

#include <string>

#include "io/results/grid_report.h"
#include "solver/compare/grid_errors.h"

namespace hottel {

// A PNG: a pixel, or a square of them, a cell, coloured by the largest |error| over the channels on a logarithmic scale
// of four decades, the highest row on top; grey where one of the two has no value. A bar beneath tells the scale, a
// heading above names the file. quantity: what the values are, "mean irradiance".
//
//   (1) cells without error have a colour of their own (scale_colour)
std::string grid_error_picture(const GridValues& found, const GridValues& exact, const std::string& file,
                               const GridPlace& place, const std::string& quantity);

}  // namespace hottel

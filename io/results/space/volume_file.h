// Light in a volume as VTK's XML, for ParaView.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// The numbers of the cells of a volume: in the order of IlluminationGrid3, as many a cell as there are components.
struct VolumeValues {
  std::string name;
  std::vector<std::string> components;  // their names; of one number none
  std::span<const double> values;
};

// Returns the ending of a file of a volume: ".vti", cells by an origin and their sizes, where u, v and w run along x, y
// and z, all of them upwards; else ".vts", cells by their corners.
std::string_view volume_ending(const Grid3& grid);

// Writes such a file through a sink: numbers of cells as float64, in binary at the end of the file; NaN stays NaN.
// Throws RequestError where a place is beyond doubles. REQUIRES a volume, and as many values as its cells have.
void write_volume(const Grid3& grid, std::span<const VolumeValues> values,
                  const std::function<void(std::string_view)>& sink);

}  // namespace hottel

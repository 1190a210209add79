// Numbers of the cells of a grid as a file of OpenEXR.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace hottel {

// Numbers in the order of illumination.npy: the lowest row first, channels of a cell beside each other.
struct GridNumbers {
  std::size_t columns = 0, rows = 0;
  std::vector<std::string> channels;
  std::vector<double> values;
  std::string unit, about;  // about: what stands beside the array, FILE.npy.json
};

// Returns the bytes of the file, a pixel a cell, the topmost row first; unit and about are the attributes `unit` and
// `hottel`. Throws as exr_file() does.
std::string grid_exr(const GridNumbers& numbers);

}  // namespace hottel

// What the files of grids are called, in the plane and in space.
#pragma once

#include <string>
#include <vector>

namespace hottel {

// Returns the name of a file of a grid: that one, or with the name of a grid that has one before its ending:
// illumination-NAME.npy.json. Folders before it stay.
std::string grid_file(const std::string& file, const std::string& grid);

// Returns the names of the files of all these grids, for messages.
template <class AnyGrid>
std::string names_of_grid_files(const std::string& file, const std::vector<AnyGrid>& grids) {
  std::string names;
  for (const AnyGrid& grid : grids) names += (names.empty() ? "" : ", ") + grid_file(file, grid.name);
  return names;
}

}  // namespace hottel

// Light on a grid that another program computed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/external/facts_beside.h"
#include "solver/compare/method_report.h"

namespace hottel {

// A value for each cell and channel of a file, in C order (ny, nx, channels), row 0 the lowest y (in space: at the
// origin). NaN and infinities are kept: cells of which the program says nothing.
struct ExternalGrid {
  std::string file;
  std::uint32_t ny = 0, nx = 0, channels = 1;
  std::vector<double> values;
  WrittenDigits digits;       // of float32 or float64
  bool has_channels = false;  // the file has a third index

  // Where FILE.json says that the cells lie, as hottel writes it beside illumination.npy.
  std::optional<std::array<std::array<double, 2>, 2>> region;  // in the plane: min, max of the outermost cells
  std::optional<RegionFacts3> region_in_space;
};

// Reads a NumPy array of the shape (ny, nx) or (ny, nx, channels), float64 or float32, in C or in Fortran order. Throws
// InputError for anything else. COST: the file and its numbers in memory.
ExternalGrid read_external_cells(const std::filesystem::path& file);

// The same with the region of FILE.json if there is one. Throws InputError too where that says that the numbers are
// something else than mean irradiances at the centres of cells, such as averages.
ExternalGrid read_external_grid(const std::filesystem::path& file);

}  // namespace hottel

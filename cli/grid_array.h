// An array of numbers of the cells of a grid, as the files that hottel solve writes of it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cli/solve_files.h"
#include "cli/streams.h"
#include "io/files/output_file.h"

namespace hottel {

// STEM.npy, STEM.npy.json that says what it holds, and where it is asked for STEM.exr; of a grid with a name
// STEM-NAME.npy and so on.
class GridArray {
 public:
  // Opens the files. stem: one that solve has ("illumination").
  GridArray(const std::string& stem, const std::string& grid, bool has_exr, SolveFiles& files);

  // Writes them. shape: rows and columns first, the last number that of channels where there are some. about: the text
  // of STEM.npy.json. REQUIRES a planar grid where there is an .exr.
  void write(std::span<const std::size_t> shape, const std::vector<double>& values,
             const std::vector<std::string>& channels, const std::string& unit, const std::string& about);

 private:
  OutputFile &npy_, &sidecar_;
  OutputFile* exr_ = nullptr;
};

// Tells where no cell of a grid has light. grid: its name, which may be empty.
void note_cells_without_light(const std::string& grid, std::span<const double> light, const Streams& streams);

}  // namespace hottel

// The files of light in a volume, which hottel solve writes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cli/grid_array.h"
#include "cli/solve_files.h"
#include "cli/solve_options.h"
#include "cli/streams.h"
#include "geometry/space/scene/scene.h"
#include "io/files/output_file.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

// Throws UsageError where --illumination asks for averages over cells, and a grid of the scene is a volume.
void refuse_averages_in_volumes(const std::string& illumination, const Scene3& scene);

// Throws UsageError where an option asks a volume of the scene for what it has not: averages of cells; or asks for what
// planar grids have alone and there are none (contours, .exr).
void require_sense_of_volumes(const SolveOptions& options, const Scene3& scene);

// illumination.npy and what stands beside it; the same for VTK; and shown.npy where --show asks for the temperature.
class VolumeFiles {
 public:
  // REQUIRES a volume.
  VolumeFiles(const Shown& shown, const Grid3& where, SolveFiles& files);

  // Asks for the light, and writes it. seconds: what was spent on it is added.
  void write(const Simulation3& all, const Shown& shown, const Streams& streams,
             std::map<std::string, double>& seconds);

 private:
  void write_numbers(const IlluminationGrid3& light, const std::vector<std::string>& channels);
  void write_vtk(const IlluminationGrid3& light, const std::vector<std::string>& channels, const SceneTable& scene);
  void write_shown(const ShownValues& values);

  Grid3 grid_;
  GridArray light_;
  OutputFile& vtk_;
  std::optional<GridArray> shown_;
};

}  // namespace hottel

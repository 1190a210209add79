// The files of light on a planar grid of a scene in space, which hottel solve writes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/grid_array.h"
#include "cli/solve_files.h"
#include "cli/solve_options.h"
#include "cli/streams.h"
#include "geometry/space/scene/scene.h"
#include "io/files/output_file.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/shown_values.h"
#include "viewer/picture/space/grid_picture.h"

namespace hottel {

// How pictures of light on a grid, and of what --show has there, are drawn.
GridPicture3 light_picture_3(const SolveOptions& options, const Scene3& scene);

// illumination.npy and what stands beside it, what --show has at the centres of cells, a picture.
class SpaceGridFiles {
 public:
  // REQUIRES a planar grid.
  SpaceGridFiles(const SolveOptions& options, const Shown& shown, const Grid3& grid, SolveFiles& files);

  // Asks for the light, and for its picture where there is a file for it. seconds: what was spent on it is added.
  // Returns the largest error of averages.
  std::optional<double> write(const Simulation3& all, const Shown& shown, const GridPicture3& how,
                              const Streams& streams, std::map<std::string, double>& seconds);

 private:
  void write_light(const IlluminationGrid3& light, const std::vector<std::string>& channels);
  void write_shown(const Simulation3& simulation, const Shown& shown, const GridPicture3& how, const Streams& streams,
                   std::map<std::string, double>& seconds);

  Grid3 grid_;
  GridArray light_;
  std::optional<GridArray> error_, shown_;
  OutputFile* png_ = nullptr;
};

}  // namespace hottel

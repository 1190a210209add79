// The files of light on a grid of a scene in the plane, which hottel solve writes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cli/grid_array.h"
#include "cli/solve_files.h"
#include "cli/solve_options.h"
#include "cli/streams.h"
#include "cli/views.h"
#include "geometry/plane/scene/scene.h"
#include "io/files/output_file.h"
#include "solver/plane/simulation/simulation.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/shown_picture.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

// How pictures of light, and of what --show has on faces, are drawn.
IlluminationPicture2 light_picture_2(const SolveOptions& options);
ShownPlan2 faces_plan_2(const SolveOptions& options);

// What is asked of the grids of a scene.
struct AskedOfGrids2 {
  Shown shown{};              // by pictures
  bool shows_cells = false;   // and by the grids: at the centres of their cells
  bool has_pictures = false;  // light, or cells and faces in one scale
};

// What a report says of a grid.
struct ToldOfGrid2 {
  std::optional<double> max_error{};  // of averages
  std::optional<PictureLight> light{};
  std::optional<PictureRange> range{};
};

// illumination.npy and what stands beside it, what --show has at the centres of cells, pictures, what the cells see.
class PlaneGridFiles {
 public:
  PlaneGridFiles(const SolveOptions& options, const AskedOfGrids2& asked, const Grid2& grid, SolveFiles& files);

  // Asks for the light, and writes it. seconds: what was spent on it is added.
  // REQUIRES a painter of light in the request of `all` where pictures of light are asked for.
  ToldOfGrid2 write(const SolveOptions& options, const Simulation2& all, const Streams& streams,
                    std::map<std::string, double>& seconds);

 private:
  struct Found;

  Found found(const Simulation2& simulation, const Streams& streams) const;
  std::string picture(const SolveOptions& options, const Simulation2& simulation, const Found& found,
                      PictureFormat format) const;
  void write_numbers(const SolveOptions& options, const Simulation2& simulation, const Found& found);
  void write_pictures(const SolveOptions& options, const Simulation2& simulation, const Found& found);
  ToldOfGrid2 told(const SolveOptions& options, const Found& found) const;

  AskedOfGrids2 asked_;
  Grid2 grid_;
  GridArray light_;
  std::optional<GridArray> shown_;
  OutputFile *png_ = nullptr, *render_ = nullptr;
  std::optional<ViewsOutput> views_;
};

}  // namespace hottel

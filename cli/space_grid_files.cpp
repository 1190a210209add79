#include "cli/space_grid_files.h"

#include <cstddef>
#include <span>

#include "geometry/scene_names.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/space/light_region.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/light/oriented_lights.h"

namespace hottel {

GridPicture3 light_picture_3(const SolveOptions& options, const Scene3& scene) {
  return {.tone = tone_asked(options.tone, kUsualTone3),
          .exposure = options.exposure,
          .wanted_width = options.size,
          .has_axes = options.axes,
          .length_unit = length_unit(scene),
          .contours = options.contours};
}

SpaceGridFiles::SpaceGridFiles(const SolveOptions& options, const Shown& shown, const Grid3& grid, SolveFiles& files)
    : grid_(grid), light_("illumination", grid.name, options.exr, files) {
  if (options.illumination == "average") error_.emplace("illumination_error", grid.name, false, files);
  if (is_of_points(shown)) shown_.emplace("shown", grid.name, options.exr, files);
  if (!options.no_picture) png_ = &files.add("illumination.png", grid_file("illumination.png", grid.name));
}

std::optional<double> SpaceGridFiles::write(const Simulation3& all, const Shown& shown, const GridPicture3& how,
                                            const Streams& streams, std::map<std::string, double>& seconds) {
  SimulationRequest3 request = all.request();
  request.light.grid = grid_;
  const Simulation3 simulation = all.with_request(request);
  const auto light = simulation.light(streams.stages());
  seconds["illumination"] += light->seconds;
  note_cells_without_light(grid_.name, light->values, streams);
  write_light(*light, simulation.radiosities()->channel_names);
  if (shown_) {
    write_shown(simulation, shown, how, streams, seconds);
  } else if (png_) {
    const auto picture = simulation.picture(streams.stages());
    seconds["picture"] += picture->seconds;
    png_->write(picture->bytes);
  }
  return light->max_error();
}

void SpaceGridFiles::write_light(const IlluminationGrid3& light, const std::vector<std::string>& channels) {
  const std::size_t shape[3] = {grid_.nv, grid_.nu, light.channels};
  light_.write(shape, light.values, channels, kRadiosityUnit,
               illumination_sidecar(region_of(grid_), channels, light.max_error()));
  if (error_)
    error_->write(std::span(shape).first(2), light.errors, {}, kRadiosityUnit, average_error_sidecar(region_of(grid_)));
}

// What is shown at the centres of cells, on areas that look along u x v.
void SpaceGridFiles::write_shown(const Simulation3& simulation, const Shown& shown, const GridPicture3& how,
                                 const Streams& streams, std::map<std::string, double>& seconds) {
  Stopwatch watch;
  const auto solution = simulation.radiosities();
  const std::vector<OrientedLight> lights =
      oriented_lights_on_grid(*simulation.prepared(), simulation.request().factors.granularity, *solution, grid_,
                              streams.progress("light on the grid"));
  const ShownValues values = shown_at_points(shown, lights, solution->channel_names);
  seconds["illumination"] += watch.lap();
  const std::size_t shape[2] = {grid_.nv, grid_.nu};
  shown_->write(shape, values.numbers(), {values.name}, values.unit,
                shown_sidecar(region_of(grid_), values.name, values.unit));
  if (!png_) return;
  png_->write(grid_picture_3(grid_, values, how));
  seconds["picture"] += watch.lap();
}

}  // namespace hottel

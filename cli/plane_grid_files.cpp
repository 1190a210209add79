#include "cli/plane_grid_files.h"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/grid_exr.h"
#include "io/results/exr.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/plane/light_region.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/light/oriented_lights.h"

namespace hottel {
namespace {

const char* unit_of_light_2(const SolveOptions& options) {
  return options.illumination == "inverse-square" ? "W/m³" : kRadiosityUnit;
}

std::string light_exr_2(const SolveOptions& options, const IlluminationGrid2& light,
                        const std::vector<std::string>& channels) {
  return grid_exr({light.grid.nx, light.grid.ny, channels, light.values, unit_of_light_2(options),
                   illumination_sidecar(region_of(light.grid), channels, options.illumination)});
}

}  // namespace

IlluminationPicture2 light_picture_2(const SolveOptions& options) {
  return {.tone = tone_asked(options.tone, kUsualTone2),
          .exposure = options.exposure,
          .wanted_width = options.size,
          .has_axes = options.axes,
          .contours = options.contours};
}

ShownPlan2 faces_plan_2(const SolveOptions& options) {
  return {.width = options.size,
          .has_axes = options.axes,
          .shading = *shading_of(options.shading),
          .contours = options.contours};
}

// What came of it on one grid.
struct PlaneGridFiles::Found {
  std::shared_ptr<const SolvedLight2> light;
  std::shared_ptr<const LightPicture2> picture;  // null: not wanted, or of something else than light
  std::optional<ShownCells2> cells;              // of something else, at the centres of cells
  std::optional<ShownValues> faces;              // of the same on faces, in one scale with them
};

PlaneGridFiles::PlaneGridFiles(const SolveOptions& options, const AskedOfGrids2& asked, const Grid2& grid,
                               SolveFiles& files)
    : asked_(asked), grid_(grid), light_("illumination", grid.name, options.exr, files) {
  if (asked.shows_cells) shown_.emplace("shown", grid.name, options.exr, files);
  if (asked.has_pictures) png_ = &files.add("illumination.png", grid_file("illumination.png", grid.name));
  if (asked.has_pictures && !options.render.empty())
    render_ = &files.add_elsewhere(grid_file(options.render, grid.name));
  if (options.views.empty()) return;
  views_.emplace(grid_file(options.views, grid.name));
  files.add(views_->mtx);
  files.add(views_->faces);
}

ToldOfGrid2 PlaneGridFiles::write(const SolveOptions& options, const Simulation2& all, const Streams& streams,
                                  std::map<std::string, double>& seconds) {
  SimulationRequest2 request = all.request();
  request.grid = grid_;
  const Simulation2 simulation = all.with_request(std::move(request));
  const Found its = found(simulation, streams);
  seconds["illumination"] += its.light->seconds;
  if (its.picture) seconds["picture"] += its.picture->seconds;
  note_cells_without_light(grid_.name, its.light->grid.values, streams);
  Stopwatch watch;
  write_numbers(options, simulation, its);
  write_pictures(options, simulation, its);
  if (views_)
    write_views_2(*simulation.prepared(), grid_,
                  {simulation.scene(), simulation.factors()->matrix, simulation.granularity(), {}, {}},
                  options.memory.value_or(0), streams, *views_);
  seconds["write"] += watch.lap();
  return told(options, its);
}

PlaneGridFiles::Found PlaneGridFiles::found(const Simulation2& simulation, const Streams& streams) const {
  Found result;
  result.light = simulation.light(streams.stages());
  if (asked_.has_pictures && asked_.shown.is_light()) result.picture = simulation.picture(streams.stages());
  if (!asked_.shows_cells) return result;
  const RadiositySolution& solution = *simulation.radiosities();
  const std::vector<OrientedLight> lights =
      lights_around_cells(*simulation.prepared(), result.light->grid, streams.progress("light on the grid"));
  result.cells = ShownCells2{result.light->grid.grid, shown_at_points(asked_.shown, lights, solution.channel_names)};
  if (!asked_.has_pictures) return result;
  result.faces = shown_values(asked_.shown, simulation.scene(), simulation.factors()->matrix, solution);
  share_scale(asked_.shown, *result.faces, result.cells->values);
  return result;
}

std::string PlaneGridFiles::picture(const SolveOptions& options, const Simulation2& simulation, const Found& found,
                                    PictureFormat format) const {
  if (found.faces)
    return shown_picture_2(*simulation.prepared(), *found.faces, faces_plan_2(options), format, &*found.cells);
  return illumination_picture_2(*simulation.prepared(), found.light->grid, light_picture_2(options), format).bytes;
}

void PlaneGridFiles::write_numbers(const SolveOptions& options, const Simulation2& simulation, const Found& found) {
  const std::vector<std::string>& channels = simulation.radiosities()->channel_names;
  const IlluminationGrid2& light = found.light->grid;
  const std::size_t shape[3] = {grid_.ny, grid_.nx, light.channels};
  light_.write(shape, light.values, channels, unit_of_light_2(options),
               illumination_sidecar(region_of(grid_), channels, options.illumination));
  if (!shown_) return;
  const ShownValues& values = found.cells->values;
  shown_->write(std::span(shape).first(2), values.numbers(), {values.name}, values.unit,
                shown_sidecar(region_of(grid_), values.name, values.unit));
}

void PlaneGridFiles::write_pictures(const SolveOptions& options, const Simulation2& simulation, const Found& found) {
  if (png_)
    png_->write(found.picture ? found.picture->bytes : picture(options, simulation, found, PictureFormat::kPng));
  if (render_)
    render_->write(is_exr(options.render)
                       ? light_exr_2(options, found.light->grid, simulation.radiosities()->channel_names)
                       : picture(options, simulation, found, *picture_format(options.render)));
}

ToldOfGrid2 PlaneGridFiles::told(const SolveOptions& options, const Found& found) const {
  ToldOfGrid2 result{.max_error = found.light->max_error};
  if (found.picture)
    result.light = PictureLight{grid_.name, found.picture->scale, to_string(tone_asked(options.tone, kUsualTone2)),
                                options.exposure, light_contours_2(found.light->grid, options.contours)};
  if (found.faces) result.range = range_of(*found.faces, grid_.name);
  return result;
}

}  // namespace hottel

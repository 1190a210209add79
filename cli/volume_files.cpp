#include "cli/volume_files.h"

#include <algorithm>

#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/space/light_region.h"
#include "io/results/space/volume_file.h"
#include "io/results/temperature_files.h"
#include "kernel/support/failure.h"
#include "solver/space/light/oriented_lights.h"

namespace hottel {
namespace {

ShownValues temperatures_in(const IlluminationGrid3& light, const std::vector<std::string>& channels) {
  return shown_at_points(shown_by("temperature"), lights_around(light), channels);
}

OutputFile& vtk_file(const Grid3& grid, SolveFiles& files) {
  const std::string kind = "illumination" + std::string(volume_ending(grid));
  return files.add(kind, grid_file(kind, grid.name));
}

}  // namespace

void refuse_averages_in_volumes(const std::string& illumination, const Scene3& scene) {
  if (illumination == "average" && std::ranges::any_of(scene.grids, &Grid3::is_volume))
    throw UsageError("--illumination average is the irradiance of cells on a side, and a grid with \"w\" has none");
}

void require_sense_of_volumes(const SolveOptions& options, const Scene3& scene) {
  refuse_averages_in_volumes(options.illumination, scene);
  if (scene.grids.empty() || !std::ranges::all_of(scene.grids, &Grid3::is_volume)) return;
  if (options.contours > 0)
    throw UsageError("--contours are lines in the picture of a planar grid, and " + options.scene + " has none");
  if (options.exr) throw UsageError("--exr is for light on a planar grid, and " + options.scene + " has none");
}

VolumeFiles::VolumeFiles(const Shown& shown, const Grid3& where, SolveFiles& files)
    : grid_(where), light_("illumination", where.name, false, files), vtk_(vtk_file(where, files)) {
  if (is_of_points(shown) && !needs_a_side(shown)) shown_.emplace("shown", where.name, false, files);
}

void VolumeFiles::write(const Simulation3& all, const Shown& shown, const Streams& streams,
                        std::map<std::string, double>& seconds) {
  SimulationRequest3 request = all.request();
  request.light.grid = grid_;
  const Simulation3 simulation = all.with_request(request);
  const auto light = simulation.light(streams.stages());
  const std::vector<std::string>& channels = simulation.radiosities()->channel_names;
  seconds["illumination"] += light->seconds;
  note_cells_without_light(grid_.name, light->values, streams);
  write_numbers(*light, channels);
  write_vtk(*light, channels, all.scene());
  if (shown_) write_shown(shown_at_points(shown, lights_around(*light), channels));
}

void VolumeFiles::write_numbers(const IlluminationGrid3& light, const std::vector<std::string>& channels) {
  std::vector<std::size_t> shape = array_shape(grid_);
  shape.push_back(light.channels);
  light_.write(shape, light.values, channels, kRadiosityUnit, illumination_sidecar(region_of(grid_), channels));
}

void VolumeFiles::write_vtk(const IlluminationGrid3& light, const std::vector<std::string>& channels,
                            const SceneTable& scene) {
  std::vector<VolumeValues> values{{"mean_irradiance", channels, light.values}};
  std::vector<double> temperatures;
  if (has_temperatures(scene)) {
    temperatures = temperatures_in(light, channels).numbers();
    values.push_back({"mean_radiant_temperature", {}, temperatures});
  }
  write_volume(grid_, values, [this](std::string_view bytes) { vtk_.write(bytes); });
}

void VolumeFiles::write_shown(const ShownValues& values) {
  shown_->write(array_shape(grid_), values.numbers(), {values.name}, values.unit,
                shown_sidecar(region_of(grid_), values.name, values.unit));
}

}  // namespace hottel

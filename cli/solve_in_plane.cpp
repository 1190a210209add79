#include "cli/solve_in_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/methods.h"
#include "cli/plane_grid_files.h"
#include "cli/room_for_elements.h"
#include "cli/solve_run.h"
#include "io/external/plane/external_matrix.h"
#include "io/results/grid_file.h"
#include "io/sums/plane/exact_on_disk.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/refined.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/shown_picture.h"

namespace hottel {
namespace {

void require_what_the_plane_has(const SolveOptions& options, const Shown& shown) {
  if (options.tolerance)
    throw UsageError("--tolerance is for scenes in space: in the plane every factor is correctly rounded");
  options.guarantee.refuse_in_plane();
  options.sky.refuse_in_plane();
  if (options.outlines || options.no_outlines)
    throw UsageError("--outlines and --no-outlines are for scenes in space: in the plane walls are lines");
  if (options.shading == "gathered") throw UsageError("--shading gathered is for scenes in space");
  if (!options.texels.empty()) throw UsageError("--texels is for scenes in space");
  if (renders_array(options))
    throw UsageError("--render writes numbers of scenes in space: in the plane they are in illumination.npy");
  if (shown.is_light() && options.shading != "flat")
    throw UsageError("--shading in the plane is for the values of --show: light between the faces has no elements");
  if (!shown.is_light() && options.size > 0 && options.size < kMinPictureWidth)
    throw UsageError(fmt::format("--size of --show {} is {} at least", options.show, kMinPictureWidth));
}

// Whether the picture has what --show has on a grid.
bool shows_cells_2(const SolveOptions& options, const Shown& shown, const Scene2& scene) {
  return is_of_points(shown) && !options.no_illumination && options.illumination != "inverse-square" &&
         (!scene.grids.empty() || !options.grid.empty());
}

// Throws UsageError where the picture has no cells that contours could be of.
void require_sense_of_contours(const SolveOptions& options, const Shown& shown, const Scene2& scene) {
  if (options.contours == 0 || shown.is_light() || shows_cells_2(options, shown, scene)) return;
  if (!is_of_points(shown))
    throw UsageError("--contours are for what a grid shows, light, " + words_to_show_at_points() + ", not for " +
                     options.show);
  throw UsageError("--contours are for light or for what a grid shows: --show " + options.show +
                   " is on the faces alone " +
                   (options.illumination == "inverse-square" ? "with --illumination inverse-square"
                                                             : "without a grid in the scene or --grid"));
}

// What the picture of a run has, where there is one.
struct Pictured {
  Shown shown{};
  bool is_wanted = false;    // a picture of anything
  bool shows_cells = false;  // on a grid, of something else than light

  Pictured(const SolveOptions& options, const Scene2& scene)
      : shown(shown_of(options)),
        is_wanted(wants_picture(options, shown)),
        shows_cells(shows_cells_2(options, shown, scene)) {}

  bool is_of_grids() const { return is_wanted && (shown.is_light() || shows_cells); }
};

// The picture of what --show has on the faces alone, which no grid has to do with.
struct FacesPicture {
  OutputFile *png = nullptr, *render = nullptr;

  FacesPicture(const SolveOptions& options, SolveFiles& files) : png(&files.add("illumination.png")) {
    if (!options.render.empty()) render = &files.add_elsewhere(options.render);
  }

  PictureRange write(const SolveOptions& options, const Shown& shown, const Simulation2& simulation) {
    const ShownValues values =
        shown_values(shown, simulation.scene(), simulation.factors()->matrix, *simulation.radiosities());
    const auto picture = [&](PictureFormat format) {
      return shown_picture_2(*simulation.prepared(), values, faces_plan_2(options), format, nullptr);
    };
    png->write(picture(PictureFormat::kPng));
    if (render) render->write(picture(*picture_format(options.render)));
    return range_of(values);
  }
};

// The files of a scene in the plane beside the tables: light on its grids, and a picture of it or of the faces.
class PlaneOutputs {
 public:
  PlaneOutputs(const SolveRun<Simulation2>& run, const Pictured& pictured, const std::vector<Grid2>& grids)
      : run_(run), pictured_(pictured), grids_(grids) {
    for (const Grid2& grid : grids)
      grid_files_.emplace_back(run.options, AskedOfGrids2{pictured.shown, pictured.shows_cells, pictured.is_of_grids()},
                               grid, run.files);
    if (pictured.is_wanted && !pictured.is_of_grids()) faces_.emplace(run.options, run.files);
  }

  void write_elements(const Solved&, SolveReport& report) {
    if (faces_) report.picture_ranges.push_back(faces_->write(run_.options, pictured_.shown, run_.simulation));
  }

  void write_light(const Solved&, SolveReport& report) {
    for (PlaneGridFiles& each : grid_files_) {
      const ToldOfGrid2 told = each.write(run_.options, run_.simulation, run_.streams, report.seconds);
      if (told.light) report.picture_lights.push_back(*told.light);
      if (told.range) report.picture_ranges.push_back(*told.range);
      if (told.max_error)
        report.illumination_max_error = std::max(report.illumination_max_error.value_or(0), *told.max_error);
    }
  }

  std::string told() const {
    const SolveOptions& options = run_.options;
    return told_elsewhere(options, grids_,
                          pictured_.is_of_grids() ? names_of_grid_files(options.render, grids_) : options.render);
  }

 private:
  const SolveRun<Simulation2>& run_;
  const Pictured& pictured_;
  const std::vector<Grid2>& grids_;
  std::deque<PlaneGridFiles> grid_files_;
  std::optional<FacesPicture> faces_;
};

// REQUIRES a scene with the grids on which light is asked for.
SimulationRequest2 request_of(const SolveOptions& options, const Scene2& scene, const Pictured& pictured,
                              std::shared_ptr<const ExactOnDisk2> on_disk) {
  SimulationRequest2 request;
  request.method = on_disk;
  if (!on_disk) request.method = all_methods_2().make(options.method);
  request.everything = options.simulate == "everything";
  request.system = system_asked(options, options.method == "exact");
  request.wants_light = !options.no_illumination;
  request.wants_picture = pictured.is_wanted;
  request.light = *light_kind_2(options.illumination);
  request.lights = light_test_of(options, scene);
  if (pictured.is_wanted && pictured.shown.is_light())
    request.painter = light_painter_2(light_picture_2(options), PictureFormat::kPng);
  request.memory = options.memory.value_or(0);
  request.store = options.store.open(options.method);
  return request;
}

}  // namespace

void solve_in_plane(const SolveOptions& options, ValidScene2 scene, double seconds_to_read, Streams& streams) {
  const Pictured pictured(options, *scene);
  require_what_the_plane_has(options, pictured.shown);
  require_shown(pictured.shown, *scene);
  require_sense_of_contours(options, pictured.shown, *scene);
  options.elements.apply_to(scene);
  require_room_for_solving(*scene, options.memory, options.levels, options.sums.is_given());
  scene.set_grids(grids_of(*scene, options.grid));
  const std::filesystem::path directory = output_folder(options.out, options.scene);
  const std::vector<Grid2> grids = options.no_illumination ? std::vector<Grid2>() : scene->grids;
  require_room_for_grids(options, grids, *scene, directory);
  const auto on_disk = options.sums.is_given() ? std::make_shared<const ExactOnDisk2>(options.sums.request()) : nullptr;
  SimulationRequest2 request = request_of(options, *scene, pictured, on_disk);
  const Simulation2 simulation =
      refined(Simulation2(std::move(scene), std::move(request)), options.levels.levels(), streams.stages());
  const Plan plan = told_plan(options, simulation, streams);
  SolveFiles files(directory, simulation.scene());
  const SolveRun<Simulation2> run{options, simulation, plan, seconds_to_read, files, streams};
  PlaneOutputs outputs(run, pictured, grids);
  solve_and_write(run, outputs);
  if (!on_disk) return;
  options.sums.tell(on_disk->bytes_of_sums(), streams);
  on_disk->forget();
}

}  // namespace hottel

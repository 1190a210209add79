#include "cli/solve_in_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cli/room_for_elements.h"
#include "cli/solve_run.h"
#include "cli/space_grid_files.h"
#include "cli/views.h"
#include "cli/volume_files.h"
#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "io/external/space/external_matrix.h"
#include "io/files/output_file.h"
#include "io/results/exr.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/space/light_region.h"
#include "io/results/space/radiosity_vtu.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/simulation/refined.h"
#include "viewer/picture/space/gathered_source.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/space/grid_picture.h"
#include "viewer/picture/space/render_picture.h"
#include "viewer/picture/space/texels.h"

namespace hottel {
namespace {

// Throws UsageError where an option is about the cells of a grid and the scene has no grid.
void require_grid(const SolveOptions& options, const Scene3& scene) {
  require_sense_of_volumes(options, scene);
  if (!scene.grids.empty()) return;
  if (options.illumination != SolveOptions().illumination)
    throw UsageError("--illumination is for light on a grid, and " + options.scene + " has none");
  if (options.contours > 0)
    throw UsageError("--contours are lines in the picture of a grid, and " + options.scene + " has none");
  if (options.exr) throw UsageError("--exr is for light on a grid, and " + options.scene + " has none");
  if (!options.views.empty())
    throw UsageError("--views is what the cells of a grid see, and " + options.scene + " has none");
}

void require_what_space_has(const SolveOptions& options) {
  const auto refuse = [](const std::string& option) { throw UsageError(option + " is only for scenes in the plane"); };
  const SolveOptions usual;
  if (options.method != usual.method) {
    if (options.tolerance) throw UsageError("--tolerance is for the method exact only, not for " + options.method);
    options.guarantee.refuse_of_method(options.method);
  }
  if (options.illumination == "inverse-square") refuse("--illumination inverse-square");
  if (options.contours > 0 && options.show != usual.show && !is_of_points(shown_by(options.show)))
    throw UsageError("--contours are for what a grid shows, light, " + words_to_show_at_points() + ", not for " +
                     options.show);
  if (options.shading == "gathered" && !options.render.empty() && !renders_numbers(options) &&
      picture_format(options.render) != PictureFormat::kPng)
    throw UsageError("gathered light is of pixels: --render writes it as .png, .exr or .npy, not '" + options.render +
                     "'");
  if (options.no_outlines && options.show == usual.show)
    throw UsageError("--no-outlines goes with --show of something else than light, which has none");
}

// What the cells of a grid see.
struct GridViews {
  Grid3 grid;
  ViewsOutput output;
};

// The name of a face and its texels.
struct TexelChoice {
  Face face;
  std::string name;
  Grid3 grid;
};

// Throws before any work what makes no sense, and where there is no room.
std::optional<TexelChoice> texels_of(const SolveOptions& options, const Scene3& scene) {
  if (options.texels.empty()) return std::nullopt;
  const TexelOption asked = texel_option(options.texels);
  TexelChoice choice{face_of(scene, asked.name), asked.name, {}};
  choice.grid = texel_grid_3(scene, choice.face, asked.nu, asked.nv);
  const std::uint64_t bytes = choice.grid.cells() * static_cast<std::uint64_t>(channel_count(scene)) * sizeof(double);
  if (const std::uint64_t allowed = memory_allowed(options.memory.value_or(0)); bytes > allowed)
    throw RequestError(fmt::format("{} texels take {} bytes of memory; allowed are {}; take fewer",
                                   cells_text(choice.grid), bytes, allowed));
  return choice;
}

// The files of light on texels.
struct TexelFiles {
  TexelChoice choice;
  OutputFile &npy, &sidecar;
  OutputFile* png = nullptr;

  TexelFiles(const SolveOptions& options, TexelChoice asked, SolveFiles& files)
      : choice(std::move(asked)), npy(files.add("texels.npy")), sidecar(files.add("texels.npy.json")) {
    if (!options.no_picture) png = &files.add("texels.png");
  }

  void write(const Simulation3& simulation, const Shown& shown, const GridPicture3& how, const Streams& streams) {
    const auto solution = simulation.radiosities();
    const GatheredSource3 source(*simulation.prepared(), simulation.request().factors.granularity, *solution,
                                 responses_3(shown, *solution), *simulation.light_shares());
    const IlluminationGrid3 light =
        texels_3(*simulation.prepared(), source, choice.face, choice.grid, streams.progress("light of texels"));
    std::vector<std::size_t> shape{choice.grid.nv, choice.grid.nu};
    if (shown.is_light()) shape.push_back(light.channels);
    write_npy(shape, light.values, [this](std::string_view bytes) { npy.write(bytes); });
    if (shown.is_light()) {
      std::vector<std::string> channels = solution->channel_names;
      channels.resize(light.channels);
      sidecar.write(texel_sidecar(region_of(choice.grid), choice.name, channels));
      if (png) png->write(grid_picture_3(light, how));
      return;
    }
    ShownValues values = shown_values(shown, simulation.scene(), simulation.factors()->matrix, *solution);
    sidecar.write(texel_sidecar(region_of(choice.grid), choice.name, values.name, values.unit));
    values.elements.clear();
    for (const double value : light.values)
      values.elements.push_back(std::isnan(value) ? std::nullopt : std::optional(value));
    if (png) png->write(grid_picture_3(choice.grid, values, how));
  }
};

// The light of pixels as numbers, and what they are.
struct PixelFiles {
  OutputFile &npy, &sidecar;

  PixelFiles(const SolveOptions& options, SolveFiles& files)
      : npy(files.add_elsewhere(options.render)), sidecar(files.add_elsewhere(options.render + ".json")) {}

  void write(const PixelValues3& pixels, std::vector<std::string> channels) {
    const std::size_t shape[3] = {pixels.height, pixels.width, pixels.channels};
    write_npy(shape, pixels.values, [this](std::string_view bytes) { npy.write(bytes); });
    channels.resize(pixels.channels);
    sidecar.write(pixel_sidecar(pixels.height, pixels.width, channels));
  }
};

// What a camera sees of what is asked for.
std::unique_ptr<const RenderedView3> view_of(const SolveOptions& options, const Shown& shown,
                                             const Simulation3& simulation, const Streams& streams) {
  const auto factors = simulation.factors();
  const auto solution = simulation.radiosities();
  RenderOptions3 asked{.tone = tone_asked(options.tone, kUsualTone3),
                       .exposure = options.exposure,
                       .wanted_width = options.size,
                       .shading = *shading_of(options.shading),
                       .has_outlines = options.outlines || (!shown.is_light() && !options.no_outlines),
                       .has_axes = options.axes,
                       .asked = shown,
                       .light_shares = simulation.light_shares(),
                       .is_for_numbers = renders_numbers(options),
                       .progress = streams.progress("gathered light")};
  if (!shown.is_light()) asked.shown = shown_values(shown, simulation.scene(), factors->matrix, *solution);
  return with_file_context(options.scene, [&] {
    return std::make_unique<const RenderedView3>(*simulation.prepared(), simulation.request().factors.granularity,
                                                 *solution, std::move(asked));
  });
}

// What the camera sees, before any tone curve.
std::string linear_picture(const RenderedView3& view, const std::vector<std::string>& channels) {
  const PixelValues3& pixels = view.pixels();
  return exr_file({.width = pixels.width,
                   .height = pixels.height,
                   .channels = channels,
                   .values = pixels.values,
                   .attributes = {{"unit", kRadiosityUnit}}});
}

PictureLight light_told(const RenderedView3& view, const SolveOptions& options) {
  return {"", view.scale(), to_string(tone_asked(options.tone, kUsualTone3)), options.exposure};
}

PictureView picture_view_of(const RenderedView3& view, const Scene3& scene) {
  const Camera3& camera = view.camera();
  return {to_doubles(camera.eye), to_doubles(camera.target), to_doubles(camera.up), to_double(camera.field_of_view),
          !scene.camera.has_value()};
}

SimulationRequest3 request_of(const SolveOptions& options, const Scene3& scene, const std::vector<Grid3>& grids,
                              std::uint64_t texels) {
  const GridPicture3 picture = light_picture_3(options, scene);
  return {.factors = {.method = options.method == "exact" ? nullptr : all_methods_3().make(options.method),
                      .granularity = is_divided(scene) || options.levels.levels().is_any() ? Granularity::kElement
                                                                                           : Granularity::kFace,
                      .tolerance = tolerance_of(options.tolerance, FactorsRequest3().tolerance),
                      .sky = options.sky.in_space(options.method),
                      .must_be_enclosed = options.guarantee.must_be_enclosed(),
                      .memory = options.memory.value_or(0),
                      .store = options.store.open(options.method)},
          .system = system_asked(options, false),
          .light = {.painter = options.no_picture ? nullptr : grid_painter_3(picture),
                    .is_average = options.illumination == "average"},
          .lights = light_test_of(options, scene),
          .plan = {.everything = options.simulate == "everything",
                   .grid_cells = cells_of(grids),
                   .is_average = options.illumination == "average",
                   .is_gathered = options.shading == "gathered" && !options.no_picture,
                   .texels = texels,
                   .has_picture = !options.no_picture}};
}

// The files of a scene in space beside the tables: the mesh of its elements, light on grids, in volumes and on texels,
// and what a camera sees.
class SpaceOutputs {
 public:
  SpaceOutputs(const SolveRun<Simulation3>& run, const Shown& shown, const std::vector<Grid3>& grids,
               const std::optional<TexelChoice>& texels)
      : run_(run), shown_(shown), grids_(grids), vtu_(run.files.add("radiosity.vtu")) {
    const SolveOptions& options = run.options;
    for (const Grid3& grid : grids) {
      if (grid.is_volume())
        volume_files_.emplace_back(shown, grid, run.files);
      else
        grid_files_.emplace_back(options, shown, grid, run.files);
    }
    if (!options.views.empty())
      for (const Grid3& grid : grids) add_views(grid);
    if (texels) texels_.emplace(options, *texels, run.files);
    if (wants_picture(options, shown)) png_ = &run.files.add("render.png");
    if (renders_array(options))
      numbers_.emplace(options, run.files);
    else if (!options.render.empty())
      render_ = &run.files.add_elsewhere(options.render);
  }

  void write_elements(const Solved& solved, SolveReport&) {
    with_file_context(run_.options.scene, [&] {
      write_radiosity_vtu(*run_.simulation.prepared(), granularity(), solved.matrix, solved.solution,
                          [this](std::string_view text) { vtu_.write(text); });
    });
  }

  void write_light(const Solved& solved, SolveReport& report) {
    write_grids(report);
    for (GridViews& each : views_)
      write_views_3(*run_.simulation.prepared(), each.grid, {solved.scene, solved.matrix, granularity(), {}, {}},
                    run_.options.memory.value_or(0), run_.streams, each.output);
    Stopwatch watch;
    if (texels_) {
      texels_->write(run_.simulation, shown_, how(), run_.streams);
      report.seconds["texels"] = watch.lap();
    }
    if (!png_) return;
    write_picture(solved, report);
    report.seconds["picture"] += watch.lap();
  }

  std::string told() const { return told_elsewhere(run_.options, grids_, run_.options.render); }

 private:
  Granularity granularity() const { return run_.simulation.request().factors.granularity; }
  GridPicture3 how() const { return light_picture_3(run_.options, run_.simulation.scene()); }

  void add_views(const Grid3& grid) {
    views_.push_back({grid, ViewsOutput(grid_file(run_.options.views, grid.name))});
    run_.files.add(views_.back().output.mtx);
    run_.files.add(views_.back().output.faces);
  }

  void write_grids(SolveReport& report) {
    std::optional<double>& max_error = report.illumination_max_error;
    for (SpaceGridFiles& each : grid_files_)
      if (const auto error = each.write(run_.simulation, shown_, how(), run_.streams, report.seconds))
        max_error = std::max(max_error.value_or(0), *error);
    for (VolumeFiles& each : volume_files_) each.write(run_.simulation, shown_, run_.streams, report.seconds);
  }

  void write_picture(const Solved& solved, SolveReport& report) {
    const SolveOptions& options = run_.options;
    const std::vector<std::string>& channels = solved.solution.channel_names;
    const auto view = view_of(options, shown_, run_.simulation, run_.streams);
    png_->write(view->file(PictureFormat::kPng));
    if (numbers_)
      numbers_->write(view->pixels(), channels);
    else if (render_)
      render_->write(is_exr(options.render) ? linear_picture(*view, channels)
                                            : view->file(*picture_format(options.render)));
    if (view->shown())
      report.picture_ranges.push_back(range_of(*view->shown()));
    else
      report.picture_lights.push_back(light_told(*view, options));
    report.picture_view = picture_view_of(*view, run_.simulation.scene());
  }

  const SolveRun<Simulation3>& run_;
  const Shown& shown_;
  const std::vector<Grid3>& grids_;
  OutputFile& vtu_;
  std::deque<SpaceGridFiles> grid_files_;
  std::deque<VolumeFiles> volume_files_;
  std::deque<GridViews> views_;
  std::optional<TexelFiles> texels_;
  OutputFile *png_ = nullptr, *render_ = nullptr;
  std::optional<PixelFiles> numbers_;  // in place of `render`
};

}  // namespace

void solve_in_space(const SolveOptions& options, ValidScene3 scene, double seconds_to_read, Streams& streams) {
  require_what_space_has(options);
  require_grid(options, *scene);
  const Shown shown = shown_of(options);
  if (options.shading == "gathered" || !options.texels.empty()) require_gathered_3(shown);
  require_shown(shown, *scene);
  const std::optional<TexelChoice> texels = texels_of(options, *scene);
  options.elements.apply_to(scene);
  options.sums.refuse_in_space();
  require_room_for_solving(*scene, options.memory, options.levels);
  const std::filesystem::path directory = output_folder(options.out, options.scene);
  const std::vector<Grid3> grids = options.no_illumination ? std::vector<Grid3>() : grids_of(*scene, options.grid);
  require_room_for_grids(options, grids, *scene, directory);
  const SimulationRequest3 request = request_of(options, *scene, grids, texels ? texels->grid.cells() : 0);
  const Simulation3 simulation =
      refined(Simulation3(std::move(scene), request), options.levels.levels(), streams.stages());
  const Plan plan = told_plan(options, simulation, streams);
  SolveFiles files(directory, simulation.scene());
  const SolveRun<Simulation3> run{options, simulation, plan, seconds_to_read, files, streams};
  SpaceOutputs outputs(run, shown, grids, texels);
  solve_and_write(run, outputs);
}

}  // namespace hottel

// hottel solve: radiosities of elements with proven bounds, light between faces in the plane, a picture of it.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "cli/command.h"
#include "cli/machine_speed.h"
#include "cli/methods.h"
#include "cli/plane_grid_files.h"
#include "cli/room_for_elements.h"
#include "cli/solve_files.h"
#include "cli/solve_in_space.h"
#include "cli/solve_options.h"
#include "cli/unit_notes.h"
#include "cli/views.h"
#include "io/external/plane/external_matrix.h"
#include "io/files/output_file.h"
#include "io/results/exr.h"
#include "io/results/grid_file.h"
#include "io/results/plane/check_report.h"
#include "io/results/short_digits.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "io/sums/plane/exact_on_disk.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plan_speed.h"
#include "solver/plane/simulation/refined.h"
#include "solver/store_plan.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/shown_picture.h"

namespace hottel {
namespace {

// What is asked for, once names and combinations of options are found to make sense.
struct Request {
  SimulationRequest2 simulation;  // all but the grids, which need the scene
  bool wants_picture = true;
  Shown shown{};  // by the picture
  std::filesystem::path directory;
  std::shared_ptr<const ExactOnDisk2> on_disk;  // the method of --out-of-core or --checkpoint; null where none is given
};

// Without light there is a picture of what --show has on faces, and none of the light.
void require_picture_of_faces(const SolveOptions& options, const Shown& shown) {
  if (!options.no_illumination || !shown.is_light()) return;
  const SolveOptions usual;
  for (const auto& [is_given, option] : {std::pair(options.size != usual.size, "--size"),
                                         {options.axes, "--axes"},
                                         {!options.channel.empty(), "--channel"},
                                         {!options.bar.empty(), "--bar"},
                                         {options.shading != usual.shading, "--shading"},
                                         {!options.render.empty(), "--render"}})
    if (is_given)
      throw UsageError(std::string(option) +
                       " excludes --no-illumination: without light there is a picture with --show of something else");
}

// What is on disk is one exact matrix, whose rows are read one after the other.
void require_sense_of_sums(const SolveOptions& options) {
  if (!options.sums.is_given()) return;
  const bool is_fit = options.solver == "auto" || options.solver == "cg";
  if (options.method != "exact" || !is_fit || options.store.is_given() || options.levels.levels().is_any())
    throw UsageError(std::string(options.sums.name()) +
                     " is for the method exact with --solver auto or cg, without --store and --levels");
}

Request request_of(const SolveOptions& options) {
  options.levels.require_sense();
  Request request;
  SimulationRequest2& asked = request.simulation;
  asked.solver = solver_of(options, options.method == "exact");
  asked.iterations = options.iterations;
  asked.until = options.until;
  asked.everything = options.simulate == "everything";
  asked.light = *light_kind_2(options.illumination);
  asked.memory = options.memory.value_or(0);
  tone_asked(options.tone, kUsualTone2);
  if (options.exr) require_exr("--exr");
  if (options.memory && options.method != "exact")
    throw UsageError("--memory is kept to by the method exact only, not by " + options.method);
  if (options.no_illumination && asked.everything)
    throw UsageError("--simulate everything and --no-illumination exclude each other");
  if (!options.views.empty()) require_sense_of_views(options.views, options.illumination);
  require_sense_of_sums(options);
  if (options.sums.is_given()) request.on_disk = std::make_shared<const ExactOnDisk2>(options.sums.request());
  asked.wants_light = !options.no_illumination;
  request.shown = shown_of(options);
  require_picture_of_faces(options, request.shown);
  request.wants_picture = !options.no_picture && (asked.wants_light || !request.shown.is_light());
  asked.wants_picture = request.wants_picture;
  if (request.wants_picture && request.shown.is_light())
    asked.painter = light_painter_2(light_picture_2(options), PictureFormat::kPng);
  request.directory = output_folder(options.out, options.scene);
  return request;
}

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

// The scene as it is asked for, on its own grids or on one over its surfaces, ready to be simulated.
Simulation2 simulation_of(const SolveOptions& options, ValidScene2 scene, Request request) {
  options.elements.apply_to(scene);
  require_room_for_solving(*scene, options.memory, options.levels, options.sums.is_given());
  request.simulation.lights = light_test_of(options, *scene);
  scene.set_grids(grids_of(*scene, options.grid));
  if (request.simulation.wants_light)
    for (const Grid2& grid : scene->grids)
      require_room_for_light(options, cells_text(grid), grid.cells(), channel_count(*scene), "take a coarser --grid",
                             request.directory);
  request.simulation.method = request.on_disk;
  if (!request.on_disk) request.simulation.method = all_methods_2().make(options.method);
  request.simulation.store = options.store.open(options.method);
  return Simulation2(std::move(scene), std::move(request.simulation));
}

// Whether a picture in the plane has what --show has on a grid.
bool shows_cells_2(const SolveOptions& options, const Request& request, bool has_own_grids) {
  return is_of_points(request.shown) && request.simulation.wants_light && options.illumination != "inverse-square" &&
         (has_own_grids || !options.grid.empty());
}

// Throws UsageError where the picture in the plane has no cells that contours could be of.
void require_sense_of_contours(const SolveOptions& options, const Request& request, bool has_own_grids) {
  if (options.contours == 0 || request.shown.is_light() || shows_cells_2(options, request, has_own_grids)) return;
  if (!is_of_points(request.shown))
    throw UsageError("--contours are for what a grid shows, light, " + words_to_show_at_points() + ", not for " +
                     options.show);
  throw UsageError("--contours are for light or for what a grid shows: --show " + options.show +
                   " is on the faces alone " +
                   (options.illumination == "inverse-square" ? "with --illumination inverse-square"
                                                             : "without a grid in the scene or --grid"));
}

void solve_in_plane(const SolveOptions& options, ValidScene2 scene, const Request& request, double seconds_to_read,
                    Streams& streams) {
  if (options.tolerance)
    throw UsageError("--tolerance is for scenes in space: in the plane every factor is correctly rounded");
  options.guarantee.refuse_in_plane();
  options.sky.refuse_in_plane();
  require_shown(request.shown, *scene);
  if (options.outlines || options.no_outlines)
    throw UsageError("--outlines and --no-outlines are for scenes in space: in the plane walls are lines");
  require_sense_of_contours(options, request, !scene->grids.empty());
  if (options.shading == "gathered") throw UsageError("--shading gathered is for scenes in space");
  if (!options.texels.empty()) throw UsageError("--texels is for scenes in space");
  if (renders_array(options))
    throw UsageError("--render writes numbers of scenes in space: in the plane they are in illumination.npy");
  if (request.shown.is_light() && options.shading != "flat")
    throw UsageError("--shading in the plane is for the values of --show: light between the faces has no elements");
  if (!request.shown.is_light() && options.size > 0 && options.size < kMinPictureWidth)
    throw UsageError(fmt::format("--size of --show {} is {} at least", options.show, kMinPictureWidth));
  const bool has_own_grids = !scene->grids.empty();
  Stopwatch watch;
  const Simulation2 simulation =
      refined(simulation_of(options, std::move(scene), request), options.levels.levels(), streams.stages());
  auto plan = std::make_shared<const Plan>(plan_at_speed(*simulation.plan(), machine_speed()));
  if (options.store.is_given()) plan = std::make_shared<const Plan>(plan_with_store(*plan, false, options.method));
  streams.note(plan_text(*plan));
  const Scene2& asked = simulation.scene();
  const bool shows_cells = shows_cells_2(options, request, has_own_grids);
  const bool has_grid_pictures = request.wants_picture && (request.shown.is_light() || shows_cells);
  const std::vector<Grid2> grids = request.simulation.wants_light ? asked.grids : std::vector<Grid2>();
  SolveFiles files(request.directory, asked);
  std::deque<PlaneGridFiles> grid_outputs;
  for (const Grid2& grid : grids)
    grid_outputs.emplace_back(options, AskedOfGrids2{request.shown, shows_cells, has_grid_pictures}, grid, files);
  std::optional<FacesPicture> faces;
  if (request.wants_picture && !has_grid_pictures) faces.emplace(options, files);
  const auto factors = simulation.factors(streams.stages());
  const ExchangeMatrix& matrix = factors->matrix;
  const auto lost_light = simulation.lost_light(streams.stages());
  if (!lost_light->empty()) streams.note(findings_text(asked, *lost_light));
  const auto solution = simulation.radiosities(streams.stages());
  const auto dividing = simulation.dividing(streams.stages());
  watch.lap();
  const NetFluxes fluxes(asked, matrix, *solution, *simulation.light_shares());
  const Solved solved{asked, matrix, *solution, fluxes};
  std::map<std::string, double> seconds = factors->report.counts.seconds;
  seconds.insert(solution->seconds.begin(), solution->seconds.end());
  if (dividing->seconds > 0) seconds["dividing"] = dividing->seconds;
  seconds["read"] = seconds_to_read;
  files.write_tables(solved, options.digits);
  SolveReport report{.scene = options.scene,
                     .plan = plan.get(),
                     .factors = factor_counts(factors->report.counts),
                     .solution = solution.get(),
                     .fluxes = &fluxes,
                     .insulated = insulated_groups(asked, matrix, *solution),
                     .given_flux = given_flux_groups(asked, matrix, *solution),
                     .unit = asked.unit,
                     .store = options.store.report(simulation.request().store),
                     .dividing = dividing.get(),
                     .warnings = with_unit_note(asked, finding_notes(*lost_light))};
  if (faces) report.picture_ranges.push_back(faces->write(options, request.shown, simulation));
  seconds["write"] = watch.lap();
  for (PlaneGridFiles& each : grid_outputs) {
    const ToldOfGrid2 told = each.write(options, simulation, streams, seconds);
    if (told.light) report.picture_lights.push_back(*told.light);
    if (told.range) report.picture_ranges.push_back(*told.range);
    if (told.max_error)
      report.illumination_max_error = std::max(report.illumination_max_error.value_or(0), *told.max_error);
  }
  report.seconds = seconds;
  const std::string pictures = has_grid_pictures ? names_of_grid_files(options.render, grids) : options.render;
  files.finish(options, report, solved,
               (options.views.empty() ? "" : "\nwhat the cells see: " + names_of_grid_files(options.views, grids)) +
                   (options.render.empty() ? "" : "\nthe picture: " + pictures),
               streams);
  if (request.on_disk) {
    options.sums.tell(request.on_disk->bytes_of_sums(), streams);
    request.on_disk->forget();
  }
}

ExitCode solve(const SolveOptions& options, Streams& streams) {
  const Request request = request_of(options);
  Stopwatch watch;
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  const double seconds_to_read = watch.lap();
  require_light_in_watts(scene);
  note_unknown_unit(scene, streams);
  if (auto* space = std::get_if<ValidScene3>(&scene))
    solve_in_space(options, std::move(*space), seconds_to_read, streams);
  else
    solve_in_plane(options, std::move(std::get<ValidScene2>(scene)), request, seconds_to_read, streams);
  return ExitCode::kDone;
}

void add_light_options(CLI::App& command, SolveOptions& options) {
  command
      .add_option(
          "--lights", options.lights,
          "how the scene's lights fall on elements: exact; centroid: wholly where the centroid is lit; vertices: "
          "as many parts as vertices are lit. The last two are estimates, to compare with")
      ->check(CLI::IsMember({"exact", "centroid", "vertices"}))
      ->capture_default_str();
  command
      .add_option(
          "--grid", options.grid,
          "cells of the illumination: of each of the scene's grids; in the plane, where it has none, over its region")
      ->type_name("NXxNY");
  command
      .add_option(
          "--illumination", options.illumination,
          "point: mean irradiance at cell centres, exact visibility; average: its mean over each cell, in "
          "closed form with a proven bound (in space the irradiance of the cell, by view factors); inverse-square: in "
          "the plane, the source formula")
      ->check(CLI::IsMember({"point", "average", "inverse-square"}))
      ->capture_default_str();
  command
      .add_option(
          "--tone", options.tone,
          "linear, reinhard, log or max (the largest value is 1); without it log in the plane, reinhard in space")
      ->type_name("TONE");
  command.add_option("--exposure", options.exposure, "multiply the light by E before the tone curve")
      ->type_name("E")
      ->check(positive_number())
      ->capture_default_str();
  command
      .add_option(
          "--contours", options.contours,
          "lines of equal light in the picture of the plane or of a grid in space, about N of them at most, at round "
          "levels; of what --show has on a grid too")
      ->type_name("N")
      ->transform(whole_number(1, 100));
  command.add_flag(
      "--axes", options.axes,
      "coordinates along the frame of the picture, and a scale bar in the scene's unit; in space so around the "
      "grid, and below what the camera sees the axes and how far the scene reaches along each");
  CLI::Option* outlines = command.add_flag(
      "--outlines", options.outlines,
      "in space: lines where surfaces end, bend or hide others, hidden ones left out; of --show light too");
  command.add_flag("--no-outlines", options.no_outlines, "in space: no such lines, which --show has of all but light")
      ->excludes(outlines);
  CLI::Option* size =
      command.add_option("--size", options.size, "pixels of the picture across, rounded to whole pixels a cell");
  size->type_name("W")->check(CLI::Range(1u, kMaxPictureSide));
  CLI::Option* no_picture =
      command.add_flag("--no-picture", options.no_picture, "no illumination.png; one that is there stays as it is");
  CLI::Option* no_illumination = command.add_flag(
      "--no-illumination", options.no_illumination,
      "no light between the faces: no illumination.npy, and illumination.png with --show of faces only");
  command
      .add_option("--show", options.show,
                  "what the picture shows: light; or, on the faces in colours of a scale, " + words_to_show() +
                      ". In space a grid shows " + words_to_show_at_points() +
                      " too (of temperatures the mean radiant one), in shown.npy and its picture")
      ->type_name("WHAT")
      ->capture_default_str();
  command
      .add_option(
          "--channel", options.channel,
          "of radiosity, irradiance or net: r, g or b, without it the mean of all; solar or thermal, without it "
          "their sum")
      ->check(CLI::IsMember({"r", "g", "b", "solar", "thermal"}));
  command
      .add_option(
          "--bar", options.bar,
          "of all but light: the ends of the colour bar, each fitted to the values where it is left out, as both "
          "are without; `log`: logarithmic")
      ->type_name("LOW:HIGH[:log]");
  command
      .add_option(
          "--shading", options.shading,
          "flat: each element has its value; smooth: values are blended over flat surfaces, in the plane along "
          "faces (of --show); parents: the same, the finest elements by the mean of each four, in the plane of each "
          "two (--levels, --light-levels); gathered: in space each point has what arrives there, by exact visibility")
      ->check(CLI::IsMember({"flat", "smooth", "parents", "gathered"}))
      ->capture_default_str();
  command
      .add_option(
          "--render", options.render,
          "the picture as this file too: .png, .svg or .pdf (in space polygons, sharp at any size), .exr (linear "
          "light as floats, in the plane a pixel a cell), or in space .npy: the light of its pixels as numbers")
      ->type_name("FILE");
  command
      .add_option("--texels", options.texels,
                  "in space: texels.npy and texels.png, the gathered light of a face at the middles of NX by NY "
                  "parts, or what --show has")
      ->type_name("NAME=NXxNY");
  for (const char* of_picture : {"--size", "--tone", "--exposure", "--contours", "--axes", "--show", "--channel",
                                 "--bar", "--shading", "--render", "--outlines", "--no-outlines"})
    no_picture->excludes(command.get_option(of_picture));
  for (const char* of_light : {"--tone", "--exposure", "--contours"})
    no_illumination->excludes(command.get_option(of_light));
  command
      .add_option("--views", options.views,
                  "write what the cells see: a matrix whose product with the radiosities is the light, columns "
                  "named in FILE.mtx.faces.csv")
      ->type_name("FILE.mtx");
  command.add_flag("--exr", options.exr,
                   "light on a grid as illumination.exr too, what --show has there as shown.exr: 32-bit floats");
  for (const char* of_light : {"--grid", "--illumination", "--views", "--exr"})
    no_illumination->excludes(command.get_option(of_light));
}

}  // namespace

void add_solve(Commands& commands) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App& command = commands.add(
      "solve",
      "Radiosities of elements with proven bounds, the light in the rooms, and a picture of it\n\n"
      "In space: radiosities, net fluxes, what a camera sees (render.png), and light on the scene's grid. Bounds are "
      "of\n"
      "these elements, and of the factors as computed where some are not enclosed; what finer elements would change "
      "is\n"
      "estimated beside them.",
      {"hottel solve scenes/showcase/apartment.json -o /tmp/apartment",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --grid 64x64 --tone max --size 320",
       "hottel solve scenes/showcase/museum.json -o /tmp/museum --no-illumination",
       "hottel solve scenes/showcase/apartment.json -o /tmp/apartment --grid 32x32 --views /tmp/views.mtx",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --solver jacobi --iterations 20 --json",
       "hottel solve scenes/space/cube.json -o /tmp/cube",
       "hottel solve scenes/space/cube.json -o /tmp/cube --elements 3 --show irradiance --shading smooth --render "
       "/tmp/cube.pdf"},
      [options](Streams& streams) { return solve(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option("--method", options->method,
                  "how to compute the factors, each also as METHOD:normalised" + methods_text())
      ->type_name("METHOD")
      ->capture_default_str();
  command.add_option("--solver", options->solver, "auto cholesky cg lu bicgstab jacobi gauss-seidel shooting")
      ->type_name("SOLVER")
      ->capture_default_str();
  command
      .add_option("--iterations", options->iterations,
                  "stop an iterative solver (of which auto is one then) after N iterations")
      ->type_name("N")
      ->transform(whole_number(0, 1'000'000'000));
  command
      .add_option("--until", options->until, "stop it when the largest residual is below R times the largest source")
      ->type_name("R")
      ->check(number_not_below_zero());
  add_light_options(command, *options);
  command
      .add_option("--simulate", options->simulate,
                  "auto: what the scene calls for; everything: all effects, same numbers")
      ->check(CLI::IsMember({"auto", "everything"}))
      ->capture_default_str();
  options->elements.add_to(command);
  options->levels.add_to(command);
  options->polygons.add_to(command);
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what each pair may be off, relative to the smaller of both areas (1e-9)")
      ->type_name("T");
  options->guarantee.add_to(
      command, "every factor is proven, so that the bounds of radiosities are those of the true factors; ");
  options->sky.add_to(command);
  options->store.add_to(command);
  options->sums.add_to(
      command,
      "in the plane: view factors go to files in this folder while the run lasts, so that factors and radiosities keep "
      "to --memory beside the scene, however many pairs there are; the same result",
      "the same, and the files stay where the run is ended: the same command goes on from there");
  command.add_option("--memory", options->memory, "bytes the factors may take; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  command
      .add_option("--digits", options->digits,
                  "numbers of the csv files rounded to N significant digits, lower bounds down and upper bounds up")
      ->type_name("N")
      ->transform(whole_number(1, kMostDigits));
  command.add_flag("--json", options->json, "report.json on standard output too");
}

}  // namespace hottel

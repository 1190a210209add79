// hottel solve: radiosities with proven bounds, light in space, a picture of it.
#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/methods.h"
#include "cli/scene_input.h"
#include "cli/views.h"
#include "geometry/near_names.h"
#include "geometry/plane/check/sight_findings.h"
#include "io/files/disk_space.h"
#include "io/files/output_file.h"
#include "io/results/npy.h"
#include "io/results/plane/check_report.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/light/solved_light.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/scene_plan.h"
#include "solver/radiosity/a_priori_bounds.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"
#include "viewer/picture/plane/illumination_picture.h"

namespace hottel {
namespace {

struct SolveOptions {
  std::string scene, out;
  std::string method = "exact", solver = "auto", simulate = "auto";
  std::optional<int> iterations;
  std::optional<double> until;
  std::string grid, illumination = "point", tone = "log", views;
  double exposure = 1;
  std::uint32_t size = 0;
  bool no_picture = false, no_illumination = false;
  std::optional<std::uint64_t> memory;
  ElementOptions elements;
  bool json = false;
};

// The solver asked for. With --iterations or --until, auto is one that iterates: cg, or bicgstab where rows of other
// methods need not be symmetric.
Solver solver_of(const SolveOptions& options) {
  const auto solver = solver_named(options.solver);
  if (!solver) {
    std::vector<std::string> known;
    for (int k = 0; k <= static_cast<int>(Solver::kShooting); ++k) known.push_back(to_string(static_cast<Solver>(k)));
    throw UnknownName("there is no solver called '" + options.solver + "'", options.solver, known);
  }
  if (!options.iterations && !options.until) return *solver;
  if (*solver == Solver::kCholesky || *solver == Solver::kLu)
    throw UsageError("--iterations and --until do not apply to " + options.solver + ", which is direct");
  if (*solver == Solver::kAuto) return options.method == "exact" ? Solver::kCg : Solver::kBicgstab;
  return *solver;
}

// Throws RequestError where the light of a grid needs more memory or disk than there is.
void require_room_for(const Grid2& grid, int channels, const SolveOptions& options,
                      const std::filesystem::path& directory) {
  const std::uint64_t bytes = std::uint64_t{grid.nx} * grid.ny * static_cast<std::uint64_t>(channels) * sizeof(double);
  const std::string what = fmt::format("{}: light on {} x {} cells", options.scene, grid.nx, grid.ny);
  const std::string advice = "; take a coarser --grid, or --no-illumination";
  if (const std::uint64_t allowed = memory_allowed(options.memory.value_or(0)); bytes > allowed)
    throw RequestError(fmt::format("{} takes {} bytes of memory; allowed are {}{}", what, bytes, allowed, advice));
  require_space(directory / "illumination.npy", bytes, what + " takes", advice);
}

// View factors by another method than the exact one; what is to be said of it.
ExchangeMatrix approximate_factors(const ExchangeMethod2& method, const PreparedScene2& prepared,
                                   Granularity granularity, ExchangeReport& exchange, std::vector<std::string>& notes) {
  ComputedFactors2 computed = factors_by(method, prepared, granularity);
  require_not_negative(computed.matrix, prepared, method);
  exchange = computed.counts;
  notes = computed.report.notes;
  return std::move(computed.matrix);
}

// What is asked for, once names and combinations of options are found to make sense.
struct Request {
  std::unique_ptr<ExchangeMethod2> method;
  Solver solver = Solver::kAuto;
  Tone tone = Tone::kLog;
  bool is_exact = true, wants_light = true, wants_picture = true;
  std::filesystem::path directory;
};

Request request_of(const SolveOptions& options) {
  Request request;
  request.method = program_methods().make(options.method);
  request.solver = solver_of(options);
  const auto tone = tone_of(options.tone);
  if (!tone)
    throw UnknownName("there is no tone curve called '" + options.tone + "': linear, reinhard, log, max", options.tone,
                      std::vector<std::string>{"linear", "reinhard", "log", "max"});
  request.tone = *tone;
  request.is_exact = options.method == "exact";
  if (options.memory && !request.is_exact)
    throw UsageError("--memory is kept to by the method exact only, not by " + options.method);
  if (options.no_illumination && options.simulate == "everything")
    throw UsageError("--simulate everything and --no-illumination exclude each other");
  if (!options.views.empty()) require_sense_of_views(options.views, options.illumination);
  request.wants_light = !options.no_illumination;
  request.wants_picture = request.wants_light && !options.no_picture;
  request.directory = output_folder(options.out, options.scene);
  return request;
}

// The files of a run, opened before the work: a path that cannot be written is found at once.
struct Outputs {
  OutputFolder folder;
  OutputFile csv, flux, json;
  std::optional<OutputFile> npy, sidecar, png;
  std::optional<ViewsOutput> views;

  Outputs(const SolveOptions& options, const Request& request)
      : folder(request.directory),
        csv(request.directory / "radiosity.csv"),
        flux(request.directory / "flux.csv"),
        json(request.directory / "report.json") {
    if (request.wants_light) {
      npy.emplace(request.directory / "illumination.npy");
      sidecar.emplace(request.directory / "illumination.npy.json");
    }
    if (request.wants_picture) png.emplace(request.directory / "illumination.png");
    if (!options.views.empty()) views.emplace(options.views);
  }

  // In the order in which they take their names.
  std::vector<OutputFile*> all() {
    std::vector<OutputFile*> files{&csv, &flux};
    for (std::optional<OutputFile>* file : {&sidecar, &npy, &png})
      if (*file) files.push_back(&**file);
    if (views) files.insert(files.end(), {&views->faces, &views->mtx});
    files.push_back(&json);
    return files;
  }
  std::string names() const {
    return std::string(" radiosity.csv flux.csv") + (npy ? " illumination.npy illumination.npy.json" : "") +
           (png ? " illumination.png" : "") + " report.json";
  }
};

// A scene, what is done about it, and what came of it, stage by stage.
struct Run {
  Grid2 grid;
  Plan plan;
  Granularity granularity = Granularity::kFace;
  PreparedScene2 prepared;
  ExchangeReport exchange{};
  std::vector<std::string> notes{};  // of the method
  ExchangeMatrix matrix{};
  Findings2 lost_light{};
  RadiositySolution solution{};
  std::optional<SolvedLight2> light{};
  std::string pixels{};
  std::optional<double> picture_scale{};
  std::map<std::string, double> seconds{};
};

Run planned(const SolveOptions& options, const Request& request, Streams& streams) {
  Stopwatch watch;
  Scene2 scene = read_scene_2(options.scene);
  options.elements.apply_to(scene);
  const Grid2 grid = grid_of(scene, options.grid);
  const double seconds = watch.lap();
  if (request.wants_light) require_room_for(grid, channel_count(scene), options, request.directory);
  const Plan plan =
      plan_scene(scene, {options.simulate == "everything", request.wants_light ? std::uint64_t{grid.nx} * grid.ny : 0});
  streams.note(plan_text(plan));
  const bool is_divided = plan.uses(Plan::kSubdivision);
  Run run{grid, plan, is_divided ? Granularity::kElement : Granularity::kFace,
          prepare(std::move(scene), is_divided ? Divided2::kYes : Divided2::kNo)};
  run.seconds["read"] = seconds;
  return run;
}

void compute_factors(const SolveOptions& options, const Request& request, Streams& streams, Run& run) {
  const auto exact_factors = [&] {
    return exact_exchange(run.prepared,
                          {.granularity = run.granularity,
                           .wants_visibility = false,
                           .occlusion = run.plan.uses(Plan::kOcclusion),
                           .memory = memory_allowed(options.memory.value_or(0)),
                           .progress = streams.progress("view factors")},
                          &run.exchange);
  };
  run.matrix = request.is_exact
                   ? naming_file(options.scene, exact_factors)
                   : approximate_factors(*request.method, run.prepared, run.granularity, run.exchange, run.notes);
  if (request.is_exact) require_closed(run.prepared.scene, run.matrix);  // an error of the method is none of the scene
  run.seconds.insert(run.exchange.seconds.begin(), run.exchange.seconds.end());
  run.lost_light = lost_light_warnings(run.prepared, run.matrix);
  if (!run.lost_light.empty()) streams.note(findings_text(run.prepared.scene, run.lost_light));
}

void compute_radiosities(const SolveOptions& options, const Request& request, Streams& streams, Run& run) {
  const ExchangeMatrix& matrix = run.matrix;
  const std::vector<Material>& materials = run.prepared.scene.materials;
  const Spectrum& sky = run.prepared.scene.sky_emission;
  RadiositySolution solution = naming_file(options.scene, [&] {
    RadiositySolution result = solve_radiosity(matrix, materials, sky,
                                               {.solver = request.solver,
                                                .iterations = options.iterations,
                                                .until = options.until,
                                                .progress = streams.progress("radiosity")});
    require_doubles(matrix, sky, result);
    return result;
  });
  if (matrix.guarantee() == Guarantee::kEnclosed) {
    run.notes.push_back("the bounds hold for all factors within their enclosures that sum to 1");
    set_a_priori_bounds(matrix, materials, sky, solution);
  }
  if (solution.guarantee == Guarantee::kEstimated)
    run.notes.push_back(
        "view factors are estimates: the bounds are those of the radiosities of these factors, and say "
        "nothing of the scene");
  solution.notes.insert(solution.notes.begin(), run.notes.begin(), run.notes.end());
  run.seconds.insert(solution.seconds.begin(), solution.seconds.end());
  run.solution = std::move(solution);
}

void compute_light(const SolveOptions& options, const Request& request, Streams& streams, Run& run) {
  Stopwatch watch;
  if (request.wants_light) {
    run.light = naming_file(options.scene, [&] {
      return illuminate(options.illumination, run.prepared, run.grid, run.granularity, run.solution,
                        streams.progress("illumination"));
    });
    run.seconds["illumination"] = watch.lap();
  }
  if (request.wants_picture) {
    run.pixels =
        illumination_picture_2(run.prepared, run.light->grid,
                               {.tone = request.tone, .exposure = options.exposure, .wanted_width = options.size},
                               PictureFormat::kPng, &run.picture_scale.emplace());
    run.seconds["picture"] = watch.lap();
  }
}

GridRegion region_of(const Grid2& grid) {
  const auto rounded = [](const Point2& p) -> std::array<double, 2> { return {to_double(p.x), to_double(p.y)}; };
  return {rounded(grid.min), rounded(grid.max), grid.nx, grid.ny};
}

void write_results(const SolveOptions& options, const Run& run, const NetFluxes& fluxes, Outputs& outputs) {
  const RadiositySolution& solution = run.solution;
  write_radiosity_csv(run.prepared.scene, run.matrix, solution,
                      [&outputs](std::string_view text) { outputs.csv.write(text); });
  write_flux_csv(fluxes, solution.channel_names, [&outputs](std::string_view text) { outputs.flux.write(text); });
  if (outputs.npy) {
    const IlluminationGrid2& light = run.light->grid;
    const std::size_t shape[3] = {light.grid.ny, light.grid.nx, light.channels};
    write_npy(shape, light.values, [&outputs](std::string_view bytes) { outputs.npy->write(bytes); });
    outputs.sidecar->write(illumination_sidecar(region_of(light.grid), solution.channel_names, options.illumination));
  }
  if (outputs.png) outputs.png->write(run.pixels);
}

ExitCode solve(const SolveOptions& options, Streams& streams) {
  const Request request = request_of(options);
  Run run = planned(options, request, streams);
  Outputs outputs(options, request);
  compute_factors(options, request, streams, run);
  compute_radiosities(options, request, streams, run);
  const NetFluxes fluxes(run.prepared.scene, run.matrix, run.solution);
  compute_light(options, request, streams, run);
  Stopwatch watch;
  write_results(options, run, fluxes, outputs);
  if (outputs.views)
    write_views_2(run.prepared, run.grid, {run.prepared.scene, run.matrix, run.granularity, {}, {}},
                  options.memory.value_or(0), streams, *outputs.views);
  run.seconds["write"] = watch.lap();

  const SolveReport report{options.scene,
                           &run.plan,
                           &run.exchange,
                           &run.solution,
                           &fluxes,
                           run.seconds,
                           run.picture_scale,
                           run.light ? run.light->max_error : std::nullopt,
                           finding_notes(run.lost_light)};
  outputs.json.write(solve_json(report));
  // All files are whole before the first one takes its name.
  const std::vector<OutputFile*> files = outputs.all();
  for (OutputFile* file : files) file->finish();
  if (options.json) streams.write("", solve_json(report));
  for (OutputFile* file : files) file->commit();
  streams.note(solve_text(report) + small_scene_text(run.prepared.scene, run.matrix, run.solution) + "\nin " +
               request.directory.string() + ":" + outputs.names() +
               (outputs.views ? "\nwhat the cells see: " + options.views : ""));
  return ExitCode::kDone;
}

void add_light_options(CLI::App& command, SolveOptions& options) {
  command.add_option("--grid", options.grid, "cells of the illumination over the scene's region")->type_name("NXxNY");
  command
      .add_option("--illumination", options.illumination,
                  "point: mean irradiance at cell centres, exact visibility; average: its mean over each cell, in "
                  "closed form with a proven bound; inverse-square: the source formula")
      ->check(CLI::IsMember({"point", "average", "inverse-square"}))
      ->capture_default_str();
  command.add_option("--tone", options.tone, "linear, reinhard, log or max (the largest value is 1)")
      ->type_name("TONE")
      ->capture_default_str();
  command.add_option("--exposure", options.exposure, "multiply the light by E before the tone curve")
      ->type_name("E")
      ->check(positive_number())
      ->capture_default_str();
  CLI::Option* size =
      command.add_option("--size", options.size, "pixels of the picture across, rounded to whole pixels a cell");
  size->type_name("W")->check(CLI::Range(1u, kMaxPictureSide));
  CLI::Option* no_picture =
      command.add_flag("--no-picture", options.no_picture, "no illumination.png; one that is there stays as it is");
  CLI::Option* no_illumination = command.add_flag("--no-illumination", options.no_illumination,
                                                  "no light in space: neither illumination.npy nor illumination.png");
  for (const char* of_picture : {"--size", "--tone", "--exposure"})
    for (CLI::Option* none : {no_picture, no_illumination}) none->excludes(command.get_option(of_picture));
  command
      .add_option("--views", options.views,
                  "write what the cells see: a matrix whose product with the radiosities is the light, columns "
                  "named in FILE.mtx.faces.csv")
      ->type_name("FILE.mtx");
  for (const char* of_light : {"--grid", "--illumination", "--views"})
    no_illumination->excludes(command.get_option(of_light));
}

}  // namespace

void add_solve(Commands& commands) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App& command = commands.add(
      "solve", "Radiosities with proven bounds, the light in the rooms, and a picture of it",
      {"hottel solve scenes/showcase/apartment.json -o /tmp/apartment",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --grid 64x64 --tone max --size 320",
       "hottel solve scenes/showcase/museum.json -o /tmp/museum --no-illumination",
       "hottel solve scenes/showcase/apartment.json -o /tmp/apartment --grid 32x32 --views /tmp/views.mtx",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --solver jacobi --iterations 20 --json"},
      [options](Streams& streams) { return solve(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option("--method", options->method,
                  "how to compute the factors, each also as METHOD:normalised" + methods_text(program_methods()))
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
  command.add_option("--memory", options->memory, "bytes the factors may take; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  command.add_flag("--json", options->json, "report.json on standard output too");
}

}  // namespace hottel

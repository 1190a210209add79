// hottel solve: radiosities with proven bounds, light in space, a picture of it.
#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/disk_space.h"
#include "cli/memory.h"
#include "cli/methods.h"
#include "cli/scene_input.h"
#include "cli/unknown_name.h"
#include "io/files/output_folder.h"
#include "io/results/check_report.h"
#include "io/results/factor_files.h"
#include "io/results/npy.h"
#include "io/results/npy_sidecar.h"
#include "io/results/radiosity_files.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plan.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/light/average_illumination.h"
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
  std::string grid, illumination = "point", tone = "log";
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

// The factor matrix and the radiosities in full, for scenes that fit on a screen.
std::string small_scene_text(const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  std::string text = fmt::format("\n{:<16}", "factor to");
  for (const Element& element : matrix.elements()) text += fmt::format("{:>14.14}", element.name);
  text += fmt::format("{:>14}\n", "sky");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    text += fmt::format("{:<16.16}", matrix.elements()[i].name);
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) text += fmt::format("{:>14.10g}", matrix.factor(i, j).value);
    text += "\n";
  }
  text += fmt::format("\n{:<16}{:>8}{:>24}{:>24}{:>24}\n", "radiosity", "channel", "lower", "value", "upper");
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t c = 0; matrix.has_row(i) && c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      text += fmt::format("{:<16.16}{:>8}{:>24}{:>24}{:>24}\n", matrix.elements()[i].name, solution.channel_names[c],
                          shortest(r.lower), shortest(r.radiosity), shortest(r.upper));
    }
  return text;
}

// The light on the grid by the way that was asked for, and the proven bound on its values where there is one.
struct Light {
  IlluminationGrid grid;
  std::optional<double> max_error{};
};

Light illuminate(const std::string& way, const PreparedScene2& prepared, const Grid2& grid, Granularity granularity,
                 const RadiositySolution& solution, const std::function<void(double)>& progress) {
  const auto channels = static_cast<std::uint32_t>(solution.channels.size());
  const std::vector<double> by_element = radiosity_by_element(solution);
  const std::vector<double> sky = sky_by_channel(prepared.scene.sky_emission, channels);
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, granularity);
  if (way == "inverse-square")
    return {illuminate_inverse_square(prepared, grid, table, by_element, channels, progress)};
  const FaceRadiosity2 faces(prepared.arrangement, table, by_element, sky);
  if (way == "point") return {illuminate_points(prepared, grid, faces, progress)};
  AverageIllumination averages = illuminate_averages(prepared, grid, faces, progress);
  return {std::move(averages.grid), averages.max_error};
}

// Draws the light as the bytes of a PNG file; tells what the tone curve multiplied values by.
std::string draw(const SolveOptions& options, Tone tone, const PreparedScene2& prepared, const IlluminationGrid& light,
                 std::optional<double>& scale) {
  const IlluminationPainter2 painter(prepared, light,
                                     {.tone = tone, .exposure = options.exposure, .wanted_width = options.size});
  CairoCanvas canvas(PictureFormat::kPng, painter.width(), painter.height());
  painter.draw(canvas);
  scale = painter.tone().scale();
  return canvas.finish();
}

constexpr std::size_t kFacesOnAScreen = 12;

// View factors by another method than the exact one; what is to be said of it.
ExchangeMatrix approximate_factors(const ExchangeMethod2& method, const PreparedScene2& prepared,
                                   Granularity granularity, ExchangeReport& exchange, std::vector<std::string>& notes) {
  ComputedFactors computed = factors_by(method, prepared, granularity);
  for (std::uint32_t i = 0; i < computed.matrix.size(); ++i)
    for (const FactorEntry& entry : computed.matrix.row(i))
      if (entry.factor.value < 0)
        throw RequestError(fmt::format("{}: the method {}: a factor of '{}' is negative ({}): nothing can be solved",
                                       prepared.scene.file, method.info().name, computed.matrix.elements()[i].name,
                                       shortest(entry.factor.value)));
  exchange = computed.counts;
  notes = computed.report.notes;
  return std::move(computed.matrix);
}

ExitCode solve(const SolveOptions& options, Streams& streams) {
  const std::unique_ptr<ExchangeMethod2> method = make_method(program_methods(), options.method);
  const Solver solver = solver_of(options);
  const auto tone = tone_of(options.tone);
  if (!tone)
    throw UnknownName("there is no tone curve called '" + options.tone + "': linear, reinhard, log, max", options.tone,
                      std::vector<std::string>{"linear", "reinhard", "log", "max"});
  if (options.memory && options.method != "exact")
    throw UsageError("--memory is kept to by the method exact only, not by " + options.method);

  if (options.no_illumination && options.simulate == "everything")
    throw UsageError("--simulate everything and --no-illumination exclude each other");
  const bool wants_light = !options.no_illumination, wants_picture = wants_light && !options.no_picture;
  const std::filesystem::path directory = output_folder(options.out, options.scene);

  Stopwatch watch;
  std::map<std::string, double> seconds;
  Scene2 scene = read_scene_2(options.scene);
  options.elements.apply_to(scene);
  const Grid2 grid = grid_of(scene, options.grid);
  seconds["read"] = watch.lap();

  if (wants_light) require_room_for(grid, channel_count(scene), options, directory);

  const Plan plan(scene, {options.simulate == "everything", wants_light ? std::uint64_t{grid.nx} * grid.ny : 0});
  streams.note(plan_text(plan));
  const bool is_divided = plan.uses(Plan::kSubdivision);
  const Granularity granularity = is_divided ? Granularity::kElement : Granularity::kFace;
  const PreparedScene2 prepared = prepare(std::move(scene), is_divided ? Divided::kYes : Divided::kNo);

  const OutputFolder folder(directory);
  OutputFile csv(directory / "radiosity.csv"), flux(directory / "flux.csv"), json(directory / "report.json");
  std::optional<OutputFile> npy, sidecar, png;
  if (wants_light) {
    npy.emplace(directory / "illumination.npy");
    sidecar.emplace(directory / "illumination.npy.json");
  }
  if (wants_picture) png.emplace(directory / "illumination.png");

  ExchangeReport exchange;
  std::vector<std::string> notes;
  const bool is_exact = options.method == "exact";
  const auto exact_factors = [&] {
    return exact_exchange(prepared,
                          {.granularity = granularity,
                           .wants_visibility = false,
                           .occlusion = plan.uses(Plan::kOcclusion),
                           .memory = memory_allowed(options.memory.value_or(0)),
                           .progress = streams.progress("view factors")},
                          &exchange);
  };
  const ExchangeMatrix matrix = is_exact ? naming_file(options.scene, exact_factors)
                                         : approximate_factors(*method, prepared, granularity, exchange, notes);
  if (is_exact) require_closed(prepared.scene, matrix);  // an error of the method is none of the scene
  seconds.insert(exchange.seconds.begin(), exchange.seconds.end());

  const Findings lost_light = lost_light_warnings(prepared, matrix);
  if (!lost_light.empty()) streams.note(findings_text(prepared.scene, lost_light));

  const std::vector<Material>& materials = prepared.scene.materials;
  const Spectrum& sky = prepared.scene.sky_emission;
  RadiositySolution solution = naming_file(options.scene, [&] {
    RadiositySolution result = solve_radiosity(matrix, materials, sky,
                                               {.solver = solver,
                                                .iterations = options.iterations,
                                                .until = options.until,
                                                .progress = streams.progress("radiosity")});
    require_doubles(matrix, sky, result);
    return result;
  });
  if (matrix.guarantee() == Guarantee::kEnclosed) {
    notes.push_back("the bounds hold for all factors within their enclosures that sum to 1");
    set_a_priori_bounds(matrix, materials, sky, solution);
  }
  if (solution.guarantee == Guarantee::kEstimated)
    notes.push_back(
        "view factors are estimates: the bounds are those of the radiosities of these factors, and say "
        "nothing of the scene");
  solution.notes.insert(solution.notes.begin(), notes.begin(), notes.end());
  seconds.insert(solution.seconds.begin(), solution.seconds.end());
  const NetFluxes fluxes(prepared.scene, matrix, solution);

  watch.lap();
  std::optional<Light> light;
  if (wants_light) {
    light = naming_file(options.scene, [&] {
      return illuminate(options.illumination, prepared, grid, granularity, solution, streams.progress("illumination"));
    });
    seconds["illumination"] = watch.lap();
  }
  std::string pixels;
  std::optional<double> picture_scale;
  if (wants_picture) {
    pixels = draw(options, *tone, prepared, light->grid, picture_scale);
    seconds["picture"] = watch.lap();
  }

  write_radiosity_csv(prepared.scene, matrix, solution, [&csv](std::string_view text) { csv.write(text); });
  write_flux_csv(fluxes, solution.channel_names, [&flux](std::string_view text) { flux.write(text); });
  if (npy) {
    const std::size_t shape[3] = {grid.ny, grid.nx, light->grid.channels};
    write_npy(shape, light->grid.values, [&npy](std::string_view bytes) { npy->write(bytes); });
    sidecar->write(illumination_sidecar(light->grid, solution.channel_names, options.illumination));
  }
  if (png) png->write(pixels);
  seconds["write"] = watch.lap();
  const SolveReport report{options.scene,
                           &plan,
                           &exchange,
                           &solution,
                           &fluxes,
                           seconds,
                           picture_scale,
                           light ? light->max_error : std::nullopt,
                           finding_notes(lost_light)};
  json.write(report_json(report));
  // All files are whole before the first one takes its name.
  std::vector<OutputFile*> files{&csv, &flux};
  for (std::optional<OutputFile>* file : {&sidecar, &npy, &png})
    if (*file) files.push_back(&**file);
  files.push_back(&json);
  for (OutputFile* file : files) file->finish();
  if (options.json) streams.write("", report_json(report));
  for (OutputFile* file : files) file->commit();
  std::string text = report_text(report);
  if (matrix.elements().size() <= 2 * kFacesOnAScreen && prepared.scene.surfaces.size() <= kFacesOnAScreen)
    text += small_scene_text(matrix, solution);
  streams.note(text + "\nin " + directory.string() + ": radiosity.csv flux.csv" +
               (npy ? " illumination.npy illumination.npy.json" : "") + (png ? " illumination.png" : "") +
               " report.json");
  return ExitCode::kDone;
}

}  // namespace

void add_solve(Commands& commands) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App& command = commands.add(
      "solve", "Radiosities with proven bounds, the light in the rooms, and a picture of it",
      {"hottel solve scenes/showcase/apartment.json -o /tmp/apartment",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --grid 64x64 --tone max --size 320",
       "hottel solve scenes/showcase/museum.json -o /tmp/museum --no-illumination",
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
  command.add_option("--grid", options->grid, "cells of the illumination over the scene's region")->type_name("NXxNY");
  command
      .add_option("--illumination", options->illumination,
                  "point: mean irradiance at cell centres, exact visibility; average: its mean over each cell, in "
                  "closed form with a proven bound; inverse-square: the source formula")
      ->check(CLI::IsMember({"point", "average", "inverse-square"}))
      ->capture_default_str();
  command.add_option("--tone", options->tone, "linear, reinhard, log or max (the largest value is 1)")
      ->type_name("TONE")
      ->capture_default_str();
  command.add_option("--exposure", options->exposure, "multiply the light by E before the tone curve")
      ->type_name("E")
      ->check(positive_number())
      ->capture_default_str();
  CLI::Option* size =
      command.add_option("--size", options->size, "pixels of the picture across, rounded to whole pixels a cell");
  size->type_name("W")->check(CLI::Range(1u, kMaxPictureSide));
  CLI::Option* no_picture =
      command.add_flag("--no-picture", options->no_picture, "no illumination.png; one that is there stays as it is");
  CLI::Option* no_illumination = command.add_flag("--no-illumination", options->no_illumination,
                                                  "no light in space: neither illumination.npy nor illumination.png");
  for (const char* of_picture : {"--size", "--tone", "--exposure"})
    for (CLI::Option* none : {no_picture, no_illumination}) none->excludes(command.get_option(of_picture));
  for (const char* of_light : {"--grid", "--illumination"}) no_illumination->excludes(command.get_option(of_light));
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

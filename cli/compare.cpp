// hottel compare: what accuracy costs; every method held against the exact factors of the same elements.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "cli/command.h"
#include "cli/compare_divided.h"
#include "cli/compare_grid.h"
#include "cli/compare_texels.h"
#include "cli/comparing.h"
#include "cli/room_for_elements.h"
#include "geometry/near_names.h"
#include "io/external/external_radiosity.h"
#include "io/files/output_file.h"
#include "io/results/comparison_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/compare/verdict.h"
#include "solver/compare/work_precision.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/picture/plane/error_map.h"
#include "viewer/picture/space/error_map.h"

namespace hottel {
namespace {

const std::map<std::string, PlotX> kPlotX{
    {"time", PlotX::kTime}, {"parameter", PlotX::kParameter}, {"elements", PlotX::kElements}};
const std::map<std::string, ErrorKind> kPlotY{{"max", ErrorKind::kMaxFactor},
                                              {"rms", ErrorKind::kRmsFactor},
                                              {"radiosity", ErrorKind::kRadiosity},
                                              {"faces", ErrorKind::kFaceRadiosity}};

template <class Value>
CLI::IsMember one_of(const std::map<std::string, Value>& names) {
  std::vector<std::string> keys;
  for (const auto& [name, value] : names) keys.push_back(name);
  return CLI::IsMember(keys);
}

constexpr std::array kErrorsReadOff = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9};

// What a dimension draws of the light that a method gets wrong.
void require_map(const Scene2& scene) { require_drawable(scene); }
void require_map(const Scene3&) {}
std::string error_map(const MethodComparison2& comparison, const MethodResult& result) {
  return error_map_2(comparison, result, PictureFormat::kPng);
}
std::string error_map(const MethodComparison3& comparison, const MethodResult& result) {
  return error_map_3(comparison, result, PictureFormat::kPng);
}

// Throws UsageError where an option would change nothing.
template <class Prepared>
void require_effect(const CompareOptions& options, const MethodCatalogue<Prepared>& catalogue,
                    const Methods<Prepared>& methods, const std::vector<NamedMethod>& radiosity_files) {
  std::vector<std::string> names;
  std::map<std::string, int> members;
  bool has_external = !radiosity_files.empty() || !options.grid_file.empty() || !options.texels.empty();
  bool has_parameter = false;
  for (const auto& [name, curve, method] : methods) {
    names.push_back(name);
    ++members[curve];
    has_external = has_external || is_external(method->info().name);
    has_parameter = has_parameter || method->info().parameter > 0;
  }
  if (options.plot_x == PlotX::kElements || options.plot_y == ErrorKind::kFaceRadiosity)
    throw UsageError("a plot of elements along x, or of errors of faces along y, needs --divide");
  if (options.plot_x == PlotX::kParameter && !has_parameter)
    throw UsageError(
        "--plot-x parameter needs a method with a number of rays, points or pixels, like rays:N or hemicube:R, and "
        "none of --methods has one");
  for (const NamedMethod& file : radiosity_files) names.push_back(file.name());
  if (!options.map.empty() && std::ranges::find(names, options.map) == names.end())
    throw UnknownName("--map takes one of the methods that are compared, not '" + options.map + "'", options.map,
                      names);
  if (options.beyond && !has_external)
    throw UsageError(
        "--beyond is about results of others: none of the methods is file: or run:, and there is no --grid-file and no "
        "--texels");
  if (options.at_most > 0 && std::ranges::none_of(members, [](const auto& each) { return each.second > 1; }))
    throw UsageError(
        "--at-most leaves out the rest of a family: --sweep, or several methods of one, give it something "
        "to leave out");
  if (options.sweep) {
    CompareOptions plain = options;
    plain.sweep = false;
    if (names_to_run(catalogue, plain) == names_to_run(catalogue, options))
      throw UsageError(
          "--sweep runs families through their parameters: name one that has any by its name alone, as in "
          "--methods gauss");
  }
}

// Lightmaps are of faces of space.
std::optional<TexelFile> texels_asked(const CompareOptions& options, const Scene2&) {
  if (!options.texels.empty()) throw UsageError("--texels is for scenes in space");
  return std::nullopt;
}
std::optional<TexelFile> texels_asked(const CompareOptions& options, const Scene3& scene) {
  return options.texels.empty() ? std::nullopt : std::optional(texel_file(options.texels, scene));
}
ComparedTexels judge_texels(const TexelFile&, const MethodComparison2&, double, const std::function<void(double)>&) {
  return {};
}

// What the methods came to, without their matrices.
struct Outcome {
  std::vector<MethodResult> results;
  std::vector<std::string> told;  // those whose notes were told as they came
  std::vector<ExplainedPair> worst;
  std::string map;  // bytes of errors.png
};

// Judges what others computed, and tells what is wrong with it as it is found out.
template <class Comparison>
void judge_and_tell(const Comparison& comparison, double beyond, MethodResult& result, const Streams& streams,
                    const std::function<void(double)>& progress) {
  const auto tell = [&](const std::string& sentence) { streams.note(result.info.name + ": " + sentence); };
  std::ranges::for_each(result.notes, tell);
  std::size_t told = result.notes.size();
  add_verdict(comparison, beyond, result,
              {.on_laws =
                   [&](const Verdict& verdict) {
                     const std::vector<std::string> sentences = law_sentences(verdict);
                     std::ranges::for_each(sentences, tell);
                     told += sentences.size();
                   },
               .progress = progress});
  std::for_each(result.notes.begin() + static_cast<std::ptrdiff_t>(told), result.notes.end(), tell);
}

// Runs one method after the other. A matrix is looked at from all sides here, then dropped.
template <class Kind, class SomeMethods>
Outcome run_all(const typename Kind::Comparison& comparison, const SomeMethods& methods, const CompareOptions& options,
                const Streams& streams) {
  const typename Kind::Explainer explainer(comparison.prepared(), comparison.exact());
  const auto progress = streams.progress("methods");
  Outcome outcome;
  std::set<std::string> slow;  // families that have taken too long
  for (std::size_t k = 0; k < methods.size(); ++k) {
    // Of each method half is to run it, and half to judge it.
    const auto part_of = [&, k](double begin) -> std::function<void(double)> {
      if (!progress) return {};
      return [&, k, begin](double part) {
        progress((static_cast<double>(k) + begin + part / 2) / static_cast<double>(methods.size()));
      };
    };
    const auto& [name, curve, method] = methods[k];
    if (slow.contains(curve)) {
      streams.note(name + " is left out: " + curve + " has taken longer than --at-most already");
      continue;
    }
    if (progress) part_of(0)(0);
    MethodResult result = run(comparison, methods[k], options, part_of(0));
    if (options.at_most > 0 && result.timing.median > options.at_most) slow.insert(curve);
    std::ranges::move(explained_worst_pairs(explainer, comparison.exact(), result, options.worst),
                      std::back_inserter(outcome.worst));
    if (name == options.map) outcome.map = error_map(comparison, result);
    if (result.report.written) {
      judge_and_tell(comparison, options.beyond.value_or(kBeyond), result, streams, part_of(0.5));
      outcome.told.push_back(name);
    }
    result.matrix = {};
    result.solution.reset();
    outcome.results.push_back(std::move(result));
  }
  return outcome;
}

template <class Kind>
ExitCode compare_in(CompareOptions options, typename Kind::Scene scene, Streams& streams) {
  const auto methods_there_are = Kind::methods();
  options.methods = method_names(options.methods, family_names(methods_there_are));
  std::vector<NamedMethod> named;
  for (const std::string& text : names_to_run(methods_there_are, options)) named.push_back(named_method(text));
  require_names_apart(named, family_names(methods_there_are));
  const std::vector<NamedMethod> radiosity_files = take_radiosity_files(named);
  if (named.empty() ||
      ((!options.grid_file.empty() || !options.texels.empty()) && options.methods.empty() && !options.sweep))
    named = {NamedMethod{kExactFamily, ""}}, options.has_own_method = true;
  const auto methods = methods_to_run(methods_there_are, named);
  require_effect(options, methods_there_are, methods, radiosity_files);

  const std::optional<TexelFile> texels = texels_asked(options, *scene);
  const std::filesystem::path directory = output_folder(options.out, options.scene);

  options.elements.apply_to(scene);
  require_room_for_solving(*scene, {});
  if (!options.map.empty()) require_map(*scene);
  const std::string stem = std::filesystem::path(options.scene).stem().string();
  const OutputFolder folder(directory);
  OutputFile csv(directory / "compare.csv"), worst(directory / "worst.csv"), read(directory / "readings.csv"),
      svg(directory / "compare.svg"), png(directory / "compare.png");
  std::optional<OutputFile> map, grid, grid_picture, texel_table, texel_picture;
  if (!options.map.empty()) map.emplace(directory / "errors.png");
  if (!options.grid_file.empty()) {
    grid.emplace(directory / "grid.csv");
    grid_picture.emplace(directory / "grid_errors.png");
  }
  if (texels) {
    texel_table.emplace(directory / "texels.csv");
    texel_picture.emplace(directory / "texel_errors.png");
  }

  const std::shared_ptr<FactorStore> store = options.store.open("exact");
  const typename Kind::Comparison comparison = Kind::comparison(options, std::move(scene), store, streams);
  require_closed(comparison.prepared().scene, comparison.exact());
  if (map && !comparison.exact_solution())
    throw RequestError(options.scene + ": --map draws errors of the light, and there is none to compare: " +
                       comparison.why_no_solution());
  Outcome outcome = run_all<Kind>(comparison, methods, options, streams);
  std::vector<std::string> taken = family_names(methods_there_are);
  for (const auto& method : methods) taken.push_back(method.curve);
  for (const NamedMethod& file : radiosity_files) {
    outcome.results.push_back(with_file_context(options.scene, [&] {
      return judge_radiosity_file(file.method.substr(std::string("file:").size()), comparison.exact(),
                                  comparison.required_solution(), options.beyond.value_or(kBeyond));
    }));
    MethodResult& result = outcome.results.back();
    result.info.name = file.name();
    if (file.name() == options.map) outcome.map = error_map(comparison, result);
    result.solution.reset();
    outcome.results.back().info.family = external_curve(file, taken);
    taken.push_back(outcome.results.back().info.family);
  }
  // Files of radiosities have no factors: then the plot is of what all have.
  const bool is_of_radiosities =
      !options.plot_y && !radiosity_files.empty() && std::ranges::all_of(outcome.results, [](const MethodResult& each) {
        return each.max_radiosity_error.has_value();
      });
  if (is_of_radiosities)
    streams.note("the plot is of errors of radiosities, which all have: --plot-y max draws those of view factors");
  const ErrorKind error = options.plot_y.value_or(is_of_radiosities ? ErrorKind::kRadiosity : ErrorKind::kMaxFactor);
  const std::vector<WorkCurve> curves = work_curves(outcome.results, error);
  const std::vector<WorkReading> readings = read_off(curves, kErrorsReadOff);
  const LogPlot plot = comparison_plot(outcome.results, {options.plot_x.value_or(PlotX::kTime), error},
                                       "What accuracy costs: " + stem, size_text(comparison.exact()));
  std::vector<std::string> light;  // what is said of it
  if (grid) {
    const JudgedGrid judged = with_file_context(
        options.scene, [&] { return judge_grid(options.grid_file, comparison, options.beyond.value_or(kBeyond)); });
    grid->write(judged.csv);
    grid_picture->write(judged.picture);
    light = judged.sentences;
  }
  ComparedTexels compared_texels;
  if (texels) {
    compared_texels = with_file_context(options.scene, [&] {
      return judge_texels(*texels, comparison, options.beyond.value_or(kBeyond), streams.progress("light of texels"));
    });
    texel_table->write(texel_csv(compared_texels.judged));
    texel_picture->write(compared_texels.picture);
  }
  const ComparisonReport report{options.scene,
                                comparison.prepared().scene.surfaces.size(),
                                comparison.prepared().seconds,
                                comparison.reference(),
                                comparison.exact(),
                                comparison.exact_solution() ? "" : comparison.why_no_solution(),
                                outcome.results,
                                readings,
                                error,
                                outcome.told,
                                options.grid_file,
                                light,
                                texels ? &compared_texels.judged : nullptr};
  csv.write(compare_csv(outcome.results));
  worst.write(worst_csv(outcome.worst));
  read.write(readings_csv(curves, kErrorsReadOff));
  svg.write(log_plot(plot, PictureFormat::kSvg));
  png.write(log_plot(plot, PictureFormat::kPng));
  if (map && outcome.map.empty())
    throw RequestError(options.scene + ": --at-most left out " + options.map + ", which --map draws");
  if (map) map->write(outcome.map);
  std::vector<OutputFile*> files = {&csv, &worst, &read, &svg, &png};
  for (std::optional<OutputFile>* file : {&map, &grid, &grid_picture, &texel_table, &texel_picture})
    if (*file) files.push_back(&**file);
  for (OutputFile* file : files) file->finish();
  if (options.json) streams.write("", comparison_json(report));
  for (OutputFile* file : files) file->commit();
  std::string names;
  for (const OutputFile* file : files) names += " " + std::filesystem::path(file->name()).filename().string();
  const auto kept = options.store.report(store);
  streams.note(comparison_text(report) + (kept ? "\nexact factors: " + store_text(*kept) : "") + "\nin " +
               directory.string() + ":" + names);
  return ExitCode::kDone;
}

ExitCode compare(const CompareOptions& options, Streams& streams) {
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (!options.divide.empty()) return compare_divided(options, std::move(scene), streams);
  if (auto* const in_space = std::get_if<ValidScene3>(&scene))
    return compare_in<ComparedSpace>(options, std::move(*in_space), streams);
  return compare_in<ComparedPlane>(options, std::get<ValidScene2>(std::move(scene)), streams);
}

}  // namespace

void add_compare(Commands& commands) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command =
      commands.add("compare", "Methods side by side: how wrong their view factors are, and how long they take",
                   {"hottel compare scenes/analytic/square_radiosity.json --elements 4 -o /tmp/square",
                    "hottel compare scenes/analytic/strip_obstructed.json --methods exact,gauss --sweep --worst 3 -o "
                    "/tmp/strip --json",
                    "hottel compare scenes/space/two_boxes.json --methods center,gauss:2,hemicube:128 -o /tmp/boxes",
                    "hottel compare scenes/analytic/square_radiosity.json --methods center,gauss:4 --divide 1,2,4,8 -o "
                    "/tmp/divided"},
                   [options](Streams& streams) { return compare(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option(
          "--methods", options->methods,
          "methods to compare, each also as METHOD:normalised; a file: may hold radiosities too; NAME=file:PATH "
          "and NAME=run:CMD say what it is called; without --methods one of each family" +
              methods_text())
      ->type_name("A,B,...")
      ->allow_extra_args(false);  // what follows may be the scene
  command.add_flag("--sweep", options->sweep, "run each family that is named through its parameters");
  command.add_option("--worst", options->worst, "how many of the worst pairs of each method worst.csv lists")
      ->type_name("K")
      ->transform(whole_number())
      ->capture_default_str();
  command
      .add_option("--repeat", options->repeat,
                  "time each method N times after a warm-up; without it at least 3 times and half a second")
      ->type_name("N")
      ->transform(whole_number(1, 1'000'000));
  command
      .add_option("--at-most", options->at_most,
                  "once a family takes more than S seconds, leave out what follows of it in the sweep")
      ->type_name("S")
      ->check(positive_number());
  command
      .add_option("--beyond", options->beyond,
                  "of file: and run:, call a pair off when it is wrong by more than X (without it " +
                      shortest(kBeyond) +
                      ") and the digits written; of --grid-file and --texels a cell, by X of the "
                      "largest light")
      ->type_name("X")
      ->check(number_not_below_zero());
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what A F of the exact factors may be off, relative to the smaller area (default 1e-9)")
      ->type_name("T");
  options->guarantee.add_to(command, "what methods are held against is proven; ");
  command
      .add_option("--map", options->map,
                  "draw errors.png: where this method, or file of radiosities, gets the light wrong")
      ->type_name("METHOD");
  command
      .add_option(
          "--grid-file", options->grid_file,
          "light on a grid by another program, (ny, nx) or (ny, nx, channels), the lowest row first: against the "
          "exact light of the same cells, in grid.csv and grid_errors.png; the methods are exact alone then, "
          "without --methods")
      ->type_name("FILE.npy");
  command
      .add_option("--texels", options->texels,
                  "in space: a lightmap by another program, as solve --texels writes it, of the face that FILE.json "
                  "names, or NAME: against the light gathered at the middles of the same texels, in texels.csv and "
                  "texel_errors.png; the methods are exact alone then, without --methods")
      ->type_name("[NAME=]FILE.npy");
  command
      .add_option_function<std::string>(
          "--plot-x", [options](const std::string& name) { options->plot_x = kPlotX.at(name); },
          "what the plot has along x: the time of the factors, the rays, points or pixels of a method, or of "
          "--divide the elements, which it has without it")
      ->type_name("time|parameter|elements")
      ->check(one_of(kPlotX));
  command
      .add_option_function<std::string>(
          "--plot-y", [options](const std::string& name) { options->plot_y = kPlotY.at(name); },
          "and along y: the largest error of a factor, its root mean square, the largest of a radiosity, or of "
          "--divide that of the mean radiosity of a face, which it has without it")
      ->type_name("max|rms|radiosity|faces")
      ->check(one_of(kPlotY));
  CLI::Option* const divide =
      command
          .add_option("--divide", options->divide,
                      "compare with every surface in N elements (in space a quad in N x N), for each of these numbers: "
                      "the error of dividing and that of each method, against the finest, in divide.csv and a plot")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->type_name("N,N,...")
          ->transform(whole_number(1, 1'000'000));
  options->elements.add_to(command);
  for (const char* other :
       {"--elements", "--element-size", "--worst", "--map", "--grid-file", "--texels", "--beyond", "--at-most"})
    divide->excludes(command.get_option(other));
  options->polygons.add_to(command);
  options->store.add_to(command);
  command.add_flag("--json", options->json, "a report on standard output as one JSON object");
}

}  // namespace hottel

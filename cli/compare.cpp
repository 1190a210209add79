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
#include "cli/methods.h"
#include "cli/scene_input.h"
#include "cli/store_option.h"
#include "geometry/near_names.h"
#include "io/files/output_file.h"
#include "io/foreign/foreign_method.h"
#include "io/foreign/foreign_radiosity.h"
#include "io/foreign/plane/foreign_matrix.h"
#include "io/foreign/space/foreign_matrix.h"
#include "io/results/comparison_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/naming_file.h"
#include "solver/compare/work_precision.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/plane/compare/pair_explanation.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/space/compare/method_comparison.h"
#include "solver/space/compare/pair_explanation.h"
#include "viewer/picture/log_plot.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/picture/plane/error_map.h"
#include "viewer/picture/space/error_map.h"

namespace hottel {
namespace {

constexpr double kBeyond = 1e-6;
constexpr std::array kErrorsReadOff = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9};

struct CompareOptions {
  std::string scene, out;
  std::vector<std::string> methods;
  bool sweep = false, json = false;
  std::size_t worst = 10;
  std::optional<int> repeat;
  double at_most = 0;  // seconds; 0: no limit
  std::optional<double> beyond;
  std::string map;
  std::optional<std::string> tolerance;
  ElementOptions elements;
  PolygonOptions polygons;
  StoreOption store;
};

// What comparing needs of the plane.
struct Plane {
  using Scene = Scene2;
  using Comparison = MethodComparison2;
  using Explainer = PairExplainer2;

  static MethodCatalogue2 methods() { return all_methods_2(); }
  static Comparison comparison(const CompareOptions& options, Scene scene, const std::shared_ptr<FactorStore>& store,
                               const Streams& streams) {
    if (options.tolerance)
      throw UsageError("--tolerance is for scenes in space: in the plane every factor is correctly rounded");
    return Comparison(Simulation2(std::move(scene), {.store = store}), streams.stages());
  }
  static void require_map(const Scene& scene) { require_drawable(scene); }
  static std::string map(const Comparison& comparison, const MethodResult& result) {
    return error_map_2(comparison, result, PictureFormat::kPng);
  }
};

// What it needs of space.
struct Space {
  using Scene = Scene3;
  using Comparison = MethodComparison3;
  using Explainer = PairExplainer3;

  static MethodCatalogue3 methods() { return all_methods_3(); }
  static Comparison comparison(const CompareOptions& options, Scene scene, const std::shared_ptr<FactorStore>& store,
                               const Streams& streams) {
    const double tolerance = tolerance_of(options.tolerance, FactorsRequest3().tolerance);
    return Comparison(Simulation3(std::move(scene), {.factors = {.tolerance = tolerance, .store = store}}),
                      streams.stages());
  }
  static void require_map(const Scene&) {}
  static std::string map(const Comparison& comparison, const MethodResult& result) {
    return error_map_3(comparison, result, PictureFormat::kPng);
  }
};

template <class Prepared>
using Methods = std::vector<std::unique_ptr<ExchangeMethod<Prepared>>>;

// The names to run, each once, in the order asked for: without --methods the middle of each family's sweep; with
// --sweep the whole sweep of each family that is named, in the variant (":normalised") it is named in.
template <class Prepared>
std::vector<std::string> names_to_run(const MethodCatalogue<Prepared>& methods, const CompareOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  std::vector<std::string> asked = options.methods;
  if (asked.empty())
    for (const auto& family : methods.families())
      if (!family.sweep.empty()) asked.push_back(options.sweep ? family.name : family.sweep[family.sweep.size() / 2]);
  for (const std::string& name : asked) {
    const auto [raw, normalised] = split_method_name(name);
    bool is_swept = false;
    for (const auto& family : methods.families())
      if (options.sweep && family.name == family_of_method(raw)) {
        for (const std::string& point : family.sweep) add(point + normalised);
        is_swept = !family.sweep.empty();
      }
    if (!is_swept || raw != family_of_method(raw)) add(name);
  }
  return names;
}

template <class Prepared>
Methods<Prepared> methods_to_run(const MethodCatalogue<Prepared>& catalogue, const CompareOptions& options) {
  Methods<Prepared> methods;
  for (const std::string& name : names_to_run(catalogue, options)) methods.push_back(catalogue.make(name));
  return methods;
}

// Throws UsageError where an option would change nothing.
template <class Prepared>
void require_effect(const CompareOptions& options, const MethodCatalogue<Prepared>& catalogue,
                    const Methods<Prepared>& methods, const std::vector<std::string>& radiosity_files) {
  std::vector<std::string> names;
  std::map<std::string, int> members;
  bool has_foreign = !radiosity_files.empty();
  for (const auto& method : methods) {
    names.push_back(method->info().name);
    ++members[method->info().family];
    has_foreign = has_foreign || is_foreign(method->info().name);
  }
  if (!options.map.empty() && std::ranges::find(names, options.map) == names.end())
    throw UnknownName("--map takes one of the methods that are compared, not '" + options.map + "'", options.map,
                      names);
  if (options.beyond && !has_foreign)
    throw UsageError("--beyond is about results of others: none of the methods is file: or run:");
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

template <class Comparison, class Method>
MethodResult run(const Comparison& comparison, const Method& method, const CompareOptions& options) {
  try {
    if (family_of_method(method.info().name) != "file") return comparison.run(method, options.repeat);
    // What it takes to read a file says nothing of what it took to compute it.
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    MethodResult result = comparison.run(method, 1);
    result.timing = {kUnknown, kUnknown, kUnknown, 0};
    return result;
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", options.scene, method.info().name, error.what()));
  }
}

// What the methods came to, without their matrices.
struct Outcome {
  std::vector<MethodResult> results;
  std::vector<ExplainedPair> worst;
  std::string map;  // bytes of errors.png
};

// Runs one method after the other. A matrix is looked at from all sides here, then dropped.
template <class Kind, class SomeMethods>
Outcome run_all(const typename Kind::Comparison& comparison, const SomeMethods& methods, const CompareOptions& options,
                const Streams& streams) {
  const typename Kind::Explainer explainer(comparison.prepared(), comparison.exact());
  const auto progress = streams.progress("methods");
  Outcome outcome;
  std::set<std::string> slow;  // families that have taken too long
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (progress) progress(static_cast<double>(k) / static_cast<double>(methods.size()));
    const MethodInfo& info = methods[k]->info();
    if (slow.contains(info.family)) {
      streams.note(info.name + " is left out: " + info.family + " has taken longer than --at-most already");
      continue;
    }
    MethodResult result = run(comparison, *methods[k], options);
    if (options.at_most > 0 && result.timing.median > options.at_most) slow.insert(info.family);
    std::ranges::move(explained_worst_pairs(explainer, comparison.exact(), result, options.worst),
                      std::back_inserter(outcome.worst));
    if (info.name == options.map) outcome.map = Kind::map(comparison, result);
    add_verdict(comparison, options.beyond.value_or(kBeyond), result);
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
  const std::vector<std::string> radiosity_files = take_radiosity_files(options.methods);
  if (!radiosity_files.empty() && options.methods.empty()) options.methods.push_back("exact");
  const auto methods = methods_to_run(methods_there_are, options);
  require_effect(options, methods_there_are, methods, radiosity_files);

  const std::filesystem::path directory = output_folder(options.out, options.scene);

  options.elements.apply_to(scene);
  if (!options.map.empty()) Kind::require_map(scene);
  const std::string stem = std::filesystem::path(options.scene).stem().string();
  const OutputFolder folder(directory);
  OutputFile csv(directory / "compare.csv"), worst(directory / "worst.csv"), read(directory / "readings.csv"),
      svg(directory / "compare.svg"), png(directory / "compare.png");
  std::optional<OutputFile> map;
  if (!options.map.empty()) map.emplace(directory / "errors.png");

  const std::shared_ptr<FactorStore> store = options.store.open("exact");
  const typename Kind::Comparison comparison = Kind::comparison(options, std::move(scene), store, streams);
  if (map && !comparison.exact_solution())
    throw RequestError(options.scene + ": --map draws errors of the light, and there is none to compare: " +
                       comparison.why_no_solution());
  Outcome outcome = run_all<Kind>(comparison, methods, options, streams);
  const std::vector<WorkCurve> curves = work_curves(outcome.results);
  const std::vector<WorkReading> readings = read_off(curves, kErrorsReadOff);
  const LogPlot plot = work_precision_plot(curves, "What accuracy costs: " + stem, size_text(comparison.exact()));

  for (const std::string& file : radiosity_files)
    outcome.results.push_back(naming_file(options.scene, [&] {
      return judge_radiosity_file(file, comparison.exact(), comparison.required_solution(),
                                  options.beyond.value_or(kBeyond));
    }));
  const ComparisonReport report{options.scene,
                                comparison.prepared().scene.surfaces.size(),
                                comparison.prepared().seconds,
                                comparison.reference(),
                                comparison.exact(),
                                comparison.exact_solution() ? "" : comparison.why_no_solution(),
                                outcome.results,
                                readings};
  csv.write(compare_csv(outcome.results));
  worst.write(worst_csv(outcome.worst));
  read.write(readings_csv(curves, kErrorsReadOff));
  svg.write(log_plot(plot, PictureFormat::kSvg));
  png.write(log_plot(plot, PictureFormat::kPng));
  if (map && outcome.map.empty())
    throw RequestError(options.scene + ": --at-most left out " + options.map + ", which --map draws");
  if (map) map->write(outcome.map);
  std::vector<OutputFile*> files = {&csv, &worst, &read, &svg, &png};
  if (map) files.push_back(&*map);
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
  Scene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (auto* const in_space = std::get_if<Scene3>(&scene))
    return compare_in<Space>(options, std::move(*in_space), streams);
  return compare_in<Plane>(options, std::get<Scene2>(std::move(scene)), streams);
}

}  // namespace

void add_compare(Commands& commands) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command =
      commands.add("compare", "Methods side by side: how wrong their view factors are, and how long they take",
                   {"hottel compare scenes/analytic/square_radiosity.json --elements 4 -o /tmp/square",
                    "hottel compare scenes/analytic/strip_obstructed.json --methods exact,gauss --sweep --worst 3 -o "
                    "/tmp/strip --json",
                    "hottel compare scenes/space/two_boxes.json --methods center,gauss:2,hemicube:128 -o /tmp/boxes"},
                   [options](Streams& streams) { return compare(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option("--methods", options->methods,
                  "methods to compare, each also as METHOD:normalised; a file: may hold radiosities too; without it "
                  "one of each family" +
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
                      shortest(kBeyond) + ") and the digits written")
      ->type_name("X")
      ->check(number_not_below_zero());
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what A F of the exact factors may be off, relative to the smaller area (default 1e-9)")
      ->type_name("T");
  command.add_option("--map", options->map, "draw errors.png: where this method gets the light wrong")
      ->type_name("METHOD");
  options->elements.add_to(command);
  options->polygons.add_to(command);
  options->store.add_to(command);
  command.add_flag("--json", options->json, "a report on standard output as one JSON object");
}

}  // namespace hottel

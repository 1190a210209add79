#include "cli/compare_divided.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/room_for_elements.h"
#include "geometry/face.h"
#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "io/files/output_file.h"
#include "io/results/divided_report.h"
#include "solver/compare/division_orders.h"
#include "solver/compare/face_means.h"
#include "solver/compare/work_precision.h"

namespace hottel {
namespace {

constexpr const char* kElementsWord = "{elements}";
constexpr const char* kDividing = "exact factors: error of dividing";

void require_divisions(const CompareOptions& options) {
  if (options.divide.size() < 2)
    throw UsageError(
        "--divide takes two numbers of elements at least: the last one is what the others are held against");
  if (std::ranges::adjacent_find(options.divide, std::greater_equal()) != options.divide.end())
    throw UsageError("--divide takes ascending numbers of elements");
  if (options.plot_x == PlotX::kParameter)
    throw UsageError("--plot-x parameter is not for --divide: it takes time or elements");
}

// The methods to run besides exact, which is always there, first.
template <class Prepared>
std::vector<NamedMethod> methods_besides_exact(const MethodCatalogue<Prepared>& catalogue, CompareOptions options) {
  const std::vector<std::string> families = family_names(catalogue);
  options.methods = method_names(options.methods, families);
  std::vector<NamedMethod> named;
  if (options.methods.empty() && !options.sweep) return named;
  for (const std::string& text : names_to_run(catalogue, options)) {
    named.push_back(named_method(text));
    const std::string& method = named.back().method;
    if (family_of_method(method) == "file")
      throw UsageError("--divide computes at several divisions, and " + method + " has one: run: computes each");
    if (is_external(method) && method.find(kElementsWord) == std::string::npos)
      throw UsageError("with --divide a command is told by {elements} into how many elements each surface is divided");
  }
  std::erase_if(named, [](const NamedMethod& each) { return each.method == kExactFamily; });
  require_names_apart(named, families);
  for (const NamedMethod& each : named) catalogue.make(each.method);
  return named;
}

// The method at a division: of a command with the number in it.
NamedMethod at_division(const NamedMethod& method, std::uint32_t elements) {
  NamedMethod result{method.method, method.name()};
  if (!is_external(method.method)) return result;
  for (std::size_t at = 0; (at = result.method.find(kElementsWord)) != std::string::npos;)
    result.method.replace(at, std::string_view(kElementsWord).size(), std::to_string(elements));
  return result;
}

// Sets the changes of face means since the division before, and their orders. means: of each result.
void set_orders(const std::vector<FaceMeans>& means, std::vector<DividedResult>& results) {
  for (std::size_t k = 0; k < results.size(); ++k) {
    const auto same = [&](std::size_t at) -> std::optional<std::size_t> {
      for (std::size_t b = at; b-- > 0;)
        if (results[b].result.info.name == results[k].result.info.name) return b;
      return std::nullopt;
    };
    const auto last = same(k);
    if (!last || means[*last].empty() || means[k].empty()) continue;
    results[k].change = face_mean_error(means[*last], means[k]);
    if (const auto first = same(*last); first && results[*last].change)
      results[k].order = order_of_changes(*results[*last].change, *results[k].change, results[*first].divide,
                                          results[*last].divide, results[k].divide);
  }
}

// The means of each face with a row, by method and channel, in the order of the methods. channels: their names.
std::vector<DividedMean> divided_means(const SceneTable& scene, const std::vector<DividedResult>& results,
                                       const std::vector<FaceMeans>& means, const std::vector<std::string>& channels,
                                       double relative_resolution) {
  std::vector<std::string> methods;
  double largest = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const std::string& name = results[k].result.info.name;
    if (std::ranges::find(methods, name) == methods.end()) methods.push_back(name);
    for (const auto& of_channel : means[k])
      for (const std::optional<double>& mean : of_channel) largest = std::max(largest, mean.value_or(0));
  }
  std::vector<DividedMean> result;
  for (const std::string& method : methods)
    for (std::uint32_t face = 0; face < 2 * scene.surfaces.size(); ++face)
      for (std::size_t c = 0; c < channels.size(); ++c) {
        DividedMean mean{.method = method,
                         .face = face_name(scene, Face::of(face)),
                         .channel = channels[c],
                         .resolution = relative_resolution * largest};
        for (std::size_t k = 0; k < results.size(); ++k)
          if (results[k].result.info.name == method && c < means[k].size() && face < means[k][c].size() &&
              means[k][c][face]) {
            mean.divisions.push_back(results[k].divide);
            mean.means.push_back(*means[k][c][face]);
          }
        if (!mean.means.empty()) result.push_back(std::move(mean));
      }
  return result;
}

template <class Kind>
ExitCode compare_divided_in(const CompareOptions& options, const typename Kind::Scene& scene, Streams& streams) {
  require_divisions(options);
  typename Kind::Scene finest_parts = scene;  // they take the most
  ElementOptions{options.divide.back(), {}}.apply_to(finest_parts);
  require_room_for_solving(*finest_parts, {});
  const auto catalogue = Kind::methods();
  const std::vector<NamedMethod> named = methods_besides_exact(catalogue, options);
  const std::filesystem::path directory = output_folder(options.out, options.scene);
  const OutputFolder folder(directory);
  OutputFile csv(directory / "divide.csv"), faces(directory / "divide_faces.csv"), svg(directory / "divide.svg"),
      png(directory / "divide.png");
  const std::shared_ptr<FactorStore> store = options.store.open("exact");

  std::vector<DividedResult> results;
  std::vector<FaceMeans> means;  // of each result; empty without radiosities
  FaceMeans finest;
  std::vector<std::string> channels;
  for (const std::uint32_t elements : options.divide) {
    CompareOptions divided = options;
    divided.elements.count = elements;
    typename Kind::Scene parts = scene;
    divided.elements.apply_to(parts);
    const typename Kind::Comparison comparison = Kind::comparison(options, std::move(parts), store, streams);
    if (results.empty()) require_closed(comparison.prepared().scene, comparison.exact());
    std::vector<NamedMethod> here = {{kExactFamily, ""}};
    for (const NamedMethod& each : named) here.push_back(at_division(each, elements));
    for (const NamedMethod& each : here) {
      MethodResult result =
          run(comparison,
              ComparedMethod<typename Kind::Prepared>{each.name(), each.name(), catalogue.make(each.method)}, divided);
      means.push_back(result.solution ? face_mean_radiosities(comparison.exact(), *result.solution) : FaceMeans());
      result.matrix = {};
      result.solution.reset();
      results.push_back({.divide = elements, .result = std::move(result)});
    }
    finest = comparison.exact_solution() ? face_mean_radiosities(comparison.exact(), *comparison.exact_solution())
                                         : FaceMeans();
    if (comparison.exact_solution()) channels = comparison.exact_solution()->channel_names;
    if (finest.empty())
      throw RequestError(options.scene + ": --divide compares radiosities: " + comparison.why_no_solution());
  }
  for (std::size_t k = 0; k < results.size(); ++k) {
    MethodResult& result = results[k].result;
    if (!means[k].empty() && results[k].divide != options.divide.back())
      result.face_radiosity_error = face_mean_error(means[k], finest);
  }

  set_orders(means, results);
  const std::vector<DividedMean> by_face =
      divided_means(*scene, results, means, channels, Kind::resolution_of_factors(options));

  std::vector<MethodResult> drawn;
  for (const DividedResult& each : results) {
    drawn.push_back(each.result);
    if (each.result.info.name == kExactFamily) drawn.back().info.family = kDividing;
  }
  LogPlot plot = comparison_plot(
      drawn, {options.plot_x.value_or(PlotX::kElements), options.plot_y.value_or(ErrorKind::kFaceRadiosity)},
      "What dividing gives: " + std::filesystem::path(options.scene).stem().string(),
      "against the exact factors of " + std::to_string(options.divide.back()) + " elements a surface");
  for (std::size_t k = 0; k < plot.curves.size(); ++k)
    if (plot.curves[k].name == kDividing) plot.emphasised = static_cast<int>(k);
  csv.write(divide_csv(results));
  faces.write(divide_faces_csv(by_face));
  svg.write(log_plot(plot, PictureFormat::kSvg));
  png.write(log_plot(plot, PictureFormat::kPng));
  for (OutputFile* file : {&csv, &faces, &svg, &png}) file->finish();
  if (options.json) streams.write("", divided_json(options.scene, results, by_face));
  for (OutputFile* file : {&csv, &faces, &svg, &png}) file->commit();
  streams.note(divided_text(results, by_face) + "in " + directory.string() +
               ": divide.csv divide_faces.csv divide.svg divide.png");
  return ExitCode::kDone;
}

}  // namespace

ExitCode compare_divided(const CompareOptions& options, const ValidScene& scene, Streams& streams) {
  if (const auto* const in_space = std::get_if<ValidScene3>(&scene))
    return compare_divided_in<ComparedSpace>(options, *in_space, streams);
  return compare_divided_in<ComparedPlane>(options, std::get<ValidScene2>(scene), streams);
}

}  // namespace hottel

#include "cli/compare_divided.h"

#include <filesystem>
#include <utility>

#include "cli/room_for_elements.h"
#include "geometry/name.h"
#include "io/files/output_file.h"
#include "io/results/divided_report.h"
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
    throw UsageError("--plot-x parameter is not of --divide: it takes time or elements");
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
    if (is_foreign(method) && method.find(kElementsWord) == std::string::npos)
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
  if (!is_foreign(method.method)) return result;
  for (std::size_t at = 0; (at = result.method.find(kElementsWord)) != std::string::npos;)
    result.method.replace(at, std::string_view(kElementsWord).size(), std::to_string(elements));
  return result;
}

template <class Kind>
ExitCode compare_divided_in(const CompareOptions& options, const typename Kind::Scene& scene, Streams& streams) {
  require_divisions(options);
  typename Kind::Scene finest_parts = scene;  // they take the most
  ElementOptions{options.divide.back(), {}}.apply_to(finest_parts);
  require_room_for_solving(finest_parts, {});
  const auto catalogue = Kind::methods();
  const std::vector<NamedMethod> named = methods_besides_exact(catalogue, options);
  const std::filesystem::path directory = output_folder(options.out, options.scene);
  const OutputFolder folder(directory);
  OutputFile csv(directory / "divide.csv"), svg(directory / "divide.svg"), png(directory / "divide.png");
  const std::shared_ptr<FactorStore> store = options.store.open("exact");

  std::vector<DividedResult> results;
  std::vector<FaceMeans> means;  // of each result; empty without radiosities
  FaceMeans finest;
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
      results.push_back({elements, std::move(result)});
    }
    finest = comparison.exact_solution() ? face_mean_radiosities(comparison.exact(), *comparison.exact_solution())
                                         : FaceMeans();
    if (finest.empty())
      throw RequestError(options.scene + ": --divide compares radiosities: " + comparison.why_no_solution());
  }
  for (std::size_t k = 0; k < results.size(); ++k) {
    MethodResult& result = results[k].result;
    if (!means[k].empty() && results[k].divide != options.divide.back())
      result.face_radiosity_error = face_mean_error(means[k], finest);
  }

  std::vector<MethodResult> drawn;
  for (const DividedResult& each : results) {
    drawn.push_back(each.result);
    if (each.result.info.name == kExactFamily) drawn.back().info.family = kDividing;
  }
  LogPlot plot =
      comparison_plot(drawn, {options.plot_x.value_or(PlotX::kElements), options.plot_y.value_or(PlotY::kFaceError)},
                      "What dividing gives: " + std::filesystem::path(options.scene).stem().string(),
                      "against the exact factors of " + std::to_string(options.divide.back()) + " elements a surface");
  for (std::size_t k = 0; k < plot.curves.size(); ++k)
    if (plot.curves[k].name == kDividing) plot.emphasised = static_cast<int>(k);
  csv.write(divide_csv(results));
  svg.write(log_plot(plot, PictureFormat::kSvg));
  png.write(log_plot(plot, PictureFormat::kPng));
  for (OutputFile* file : {&csv, &svg, &png}) file->finish();
  if (options.json) streams.write("", divided_json(options.scene, results));
  for (OutputFile* file : {&csv, &svg, &png}) file->commit();
  streams.note(divided_text(results) + "in " + directory.string() + ": divide.csv divide.svg divide.png");
  return ExitCode::kDone;
}

}  // namespace

ExitCode compare_divided(const CompareOptions& options, Scene scene, Streams& streams) {
  if (const auto* const in_space = std::get_if<Scene3>(&scene))
    return compare_divided_in<ComparedSpace>(options, *in_space, streams);
  return compare_divided_in<ComparedPlane>(options, std::get<Scene2>(scene), streams);
}

}  // namespace hottel

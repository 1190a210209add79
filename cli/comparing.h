// What the ways to compare methods share: options, dimensions, the methods that are asked for by their names.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/guarantee_option.h"
#include "cli/methods.h"
#include "cli/scene_input.h"
#include "cli/store_option.h"
#include "cli/streams.h"
#include "geometry/closed_promise.h"
#include "io/external/external_method.h"
#include "io/external/plane/external_matrix.h"
#include "io/external/space/external_matrix.h"
#include "kernel/support/failure.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/plane/compare/pair_explanation.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/space/compare/method_comparison.h"
#include "solver/space/compare/pair_explanation.h"
#include "viewer/picture/comparison_plot.h"

namespace hottel {

// What a pair is allowed to be off, and the digits written, without --beyond.
inline constexpr double kBeyond = 1e-6;

// The command line of compare.
struct CompareOptions {
  std::string scene, out;
  std::vector<std::string> methods;
  bool sweep = false, json = false;
  std::size_t worst = 10;
  std::optional<int> repeat;
  double at_most = 0;  // seconds; 0: no limit
  std::optional<double> beyond;
  std::string map, grid_file, texels;
  std::optional<PlotX> plot_x;
  std::optional<ErrorKind> plot_y;
  std::vector<std::uint32_t> divide;  // elements of each surface, ascending; empty: as the scene says
  std::optional<std::string> tolerance;
  GuaranteeOption guarantee;
  ElementOptions elements;
  PolygonOptions polygons;
  StoreOption store;
  bool has_own_method = false;  // no method was asked for: the exact one is there for the table
};

// What comparing needs of the plane.
struct ComparedPlane {
  using Scene = ValidScene2;
  using Prepared = PreparedScene2;
  using Comparison = MethodComparison2;
  using Explainer = PairExplainer2;

  static MethodCatalogue2 methods() { return all_methods_2(); }
  // What means by exact factors are known to, relative to the largest: changes below it tell no order.
  static double resolution_of_factors(const CompareOptions&) { return 1e-14; }
  static Comparison comparison(const CompareOptions& options, Scene scene, const std::shared_ptr<FactorStore>& store,
                               const Streams& streams) {
    if (options.tolerance)
      throw UsageError("--tolerance is for scenes in space: in the plane every factor is correctly rounded");
    options.guarantee.refuse_in_plane();
    return Comparison(Simulation2(std::move(scene), {.store = store}), streams.stages());
  }
};

// What it needs of space.
struct ComparedSpace {
  using Scene = ValidScene3;
  using Prepared = PreparedScene3;
  using Comparison = MethodComparison3;
  using Explainer = PairExplainer3;

  static MethodCatalogue3 methods() { return all_methods_3(); }
  static double resolution_of_factors(const CompareOptions& options) {
    return tolerance_of(options.tolerance, FactorsRequest3().tolerance);
  }
  static Comparison comparison(const CompareOptions& options, Scene scene, const std::shared_ptr<FactorStore>& store,
                               const Streams& streams) {
    const double tolerance = tolerance_of(options.tolerance, FactorsRequest3().tolerance);
    return Comparison(
        Simulation3(std::move(scene), {.factors = {.tolerance = tolerance,
                                                   .must_be_enclosed = options.guarantee.must_be_enclosed(),
                                                   .store = store}}),
        streams.stages());
  }
};

// A method with what it is called, in tables and in curves.
template <class Prepared>
struct ComparedMethod {
  std::string name, curve;
  std::unique_ptr<ExchangeMethod<Prepared>> method;
};

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
using Methods = std::vector<ComparedMethod<Prepared>>;

// Makes the methods, each with the name of its curve: of hottel's own their family, of others external_curve().
template <class Prepared>
Methods<Prepared> methods_to_run(const MethodCatalogue<Prepared>& catalogue, const std::vector<NamedMethod>& named) {
  Methods<Prepared> methods;
  std::vector<std::string> taken = family_names(catalogue);
  for (const NamedMethod& each : named) {
    auto method = catalogue.make(each.method);
    const std::string curve = is_external(each.method) ? external_curve(each, taken) : method->info().family;
    taken.push_back(curve);
    methods.push_back({each.name(), curve, std::move(method)});
  }
  return methods;
}

// Runs a method, called as asked for. What is read from a file has no time: what it takes to read says nothing of what
// it took to compute. Throws RequestError naming scene and method, InputError where a file has no pair to judge.
template <class Comparison, class Method>
MethodResult run(const Comparison& comparison, const Method& compared, const CompareOptions& options,
                 const std::function<void(double)>& progress = {}) {
  const bool is_file = family_of_method(compared.method->info().name) == "file";
  try {
    MethodResult result = options.has_own_method && !options.repeat
                              ? comparison.reference_as_method(*compared.method)
                              : comparison.run(*compared.method, is_file ? 1 : options.repeat, progress);
    if (result.report.written && result.errors.pairs == 0 && comparison.exact().entry_count() > 0) {
      const std::string problem = "holds no factor of any face: there is nothing to judge";
      if (is_file) throw InputError({result.info.reference, 0}, problem);
      throw RequestError("what it wrote " + problem);
    }
    result.info.name = compared.name;
    result.info.family = compared.curve;
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    if (is_file) result.timing = {kUnknown, kUnknown, kUnknown, 0};
    return result;
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", options.scene, compared.name, error.what()));
  }
}

}  // namespace hottel

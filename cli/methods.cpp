#include "cli/methods.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/unknown_name.h"
#include "io/foreign/foreign_matrix.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/methods/coarsened.h"

namespace hottel {
namespace {

std::string family_of(const std::string& name) { return name.substr(0, name.find(':')); }

}  // namespace

MethodCatalogue2 program_methods() {
  MethodCatalogue2 methods = planar_methods();
  methods.add(file_family_2());
  methods.add(run_family_2());
  return methods;
}

std::unique_ptr<ExchangeMethod2> make_method(const MethodCatalogue2& methods, const std::string& name) {
  const std::string family = family_of(name);
  std::vector<std::string> known;
  for (const MethodFamily& each : methods.families()) {
    if (each.name == family) return methods.make(name);
    known.push_back(each.name);
  }
  try {
    return methods.make(name);
  } catch (const UsageError& error) {
    throw UnknownName(error.what(), family, known);
  }
}

std::string methods_text(const MethodCatalogue2& methods) {
  std::string text;
  for (const MethodFamily& family : methods.families()) text += "\n  " + family.pattern + ": " + family.what;
  return text;
}

std::vector<std::string> method_names(const std::vector<std::string>& lists, const MethodCatalogue2& methods) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& part) {
    const bool is_method = std::any_of(methods.families().begin(), methods.families().end(),
                                       [&](const MethodFamily& family) { return family.name == family_of(part); });
    if (!is_method && !names.empty() && has_rows_of_its_own(names.back()))
      names.back() += "," + part;
    else if (part.empty())
      throw UsageError("--methods has an empty name; names are separated by single commas");
    else
      names.push_back(part);
  };
  for (const std::string& list : lists) {
    std::size_t begin = 0;
    for (std::size_t comma = 0; (comma = list.find(',', begin)) != std::string::npos; begin = comma + 1)
      add(list.substr(begin, comma - begin));
    add(list.substr(begin));
  }
  return names;
}

bool has_rows_of_its_own(const std::string& method) {
  const std::string family = family_of(method);
  return family == "file" || family == "run";
}

ComputedFactors factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared, Granularity granularity) {
  ComputedFactors result;
  Stopwatch watch;
  try {
    result.matrix = method.compute(prepared, result.report);
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", prepared.scene.file, method.info().name, error.what()));
  }
  if (granularity == Granularity::kGroup ||
      (granularity == Granularity::kFace &&
       std::any_of(prepared.division.begin(), prepared.division.end(), [](std::uint32_t parts) { return parts > 1; })))
    result.matrix = coarsened(result.matrix, prepared, granularity);
  const double seconds = watch.lap();
  result.counts.surfaces = prepared.scene.surfaces.size();
  result.counts.vertices = prepared.arrangement.vertices().size();
  result.counts.pieces = prepared.arrangement.pieces().size();
  result.counts.elements = result.matrix.size();
  result.counts.pairs = result.matrix.entry_count();
  result.counts.seconds["prepare"] = prepared.seconds;
  result.counts.seconds["factors"] = result.report.seconds.value_or(seconds);
  result.report.notes.insert(result.report.notes.begin(),
                             fmt::format("view factors by {}: {}, rows sum to 1 within {:.2g}", method.info().name,
                                         to_string(result.matrix.guarantee()), result.report.row_defect));
  return result;
}

}  // namespace hottel

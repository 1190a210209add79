#include "cli/foreign_results.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "io/foreign/foreign_radiosity.h"
#include "kernel/support/failure.h"
#include "solver/compare/radiosity_verdict.h"
#include "solver/plane/compare/verdict.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {
namespace {

constexpr std::string_view kFile = "file:";

void append(std::vector<std::string> sentences, MethodResult& result) {
  std::move(sentences.begin(), sentences.end(), std::back_inserter(result.notes));
}

}  // namespace

std::vector<std::string> take_radiosity_files(std::vector<std::string>& methods) {
  const auto first = std::stable_partition(methods.begin(), methods.end(), [](const std::string& name) {
    return !name.starts_with(kFile) || name == kFile || !split_method_name(name).normalised.empty() ||
           !holds_radiosities(name.substr(kFile.size()));
  });
  std::vector<std::string> files(first, methods.end());
  methods.erase(first, methods.end());
  return files;
}

MethodResult judge_radiosity_file(const std::string& name, const MethodComparison2& comparison, double beyond) {
  if (!comparison.exact_solution())
    throw RequestError("radiosities cannot be compared: " + comparison.why_no_solution());
  const RadiositySolution& exact = *comparison.exact_solution();
  const ForeignRadiosities foreign =
      read_foreign_radiosities(name.substr(kFile.size()), comparison.exact(), exact.channel_names);
  const RadiosityVerdict verdict =
      judge_radiosities(comparison.exact(), exact, foreign.by_channel, foreign.digits, beyond);
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  MethodResult result;
  result.info = {name, "file", 0, Guarantee::kEstimated, name.substr(kFile.size())};
  result.timing = {kUnknown, kUnknown, kUnknown, 0};
  result.errors = {kUnknown, kUnknown, kUnknown, 0};
  result.max_radiosity_error = verdict.max_error;
  append(verdict_sentences(verdict, comparison.exact(), exact), result);
  return result;
}

void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written});
  append(verdict_sentences(verdict, comparison.exact()), result);
}

}  // namespace hottel

#include "io/results/comparison_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/results/factor_files.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

// Empty for what is not known.
std::string field(const std::optional<double>& value) { return value && !std::isnan(*value) ? shortest(*value) : ""; }

// Empty also for a length beyond the range of doubles.
std::string length_field(const std::optional<double>& value) {
  return field(value && std::isfinite(*value) ? value : std::nullopt);
}

}  // namespace

std::string compare_csv(std::span<const MethodResult> results) {
  std::string text = "method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error\n";
  for (const MethodResult& each : results)
    text += fmt::format("{},{},{},{},{},{},{}\n", csv_field(each.info.name), to_string(each.info.guarantee),
                        field(each.timing.median), field(each.errors.max), field(each.errors.rms),
                        field(each.errors.closure), field(each.max_radiosity_error));
  return text;
}

std::string worst_csv(std::span<const ExplainedPair> pairs) {
  std::string text = "method,from,to,value,exact,error,visibility,distance,angle,reason\n";
  for (const auto& [method, from, to, error, explanation] : pairs)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(method), csv_field(from), csv_field(to),
                        shortest(error.value), shortest(error.exact), shortest(error.error()),
                        field(explanation.visibility), length_field(explanation.distance), field(explanation.angle),
                        csv_field(explanation.reason));
  return text;
}

std::string readings_csv(std::span<const WorkCurve> curves, std::span<const double> errors) {
  std::string text = "error,family,seconds,exact_seconds\n";
  const auto exact =
      std::find_if(curves.begin(), curves.end(), [](const WorkCurve& curve) { return curve.family == kExactFamily; });
  for (const double error : errors)
    for (const WorkCurve& curve : curves)
      text += fmt::format("{},{},{},{}\n", shortest(error), csv_field(curve.family),
                          field(seconds_to_reach(curve.points, error)),
                          exact == curves.end() ? "" : shortest(exact->points.front().seconds));
  return text;
}

}  // namespace hottel

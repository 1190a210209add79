#include "io/results/divided_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/results/csv_field.h"
#include "kernel/rational.h"
#include "kernel/version.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

std::string short_number(const std::optional<double>& value) {
  return value && !std::isnan(*value) ? fmt::format("{:.2g}", *value) : "-";
}

// Against the result of the same method at the division before; nothing where there is none, or no error, and at the
// finest, against which errors are taken.
std::optional<double> order_of(std::span<const DividedResult> results, std::size_t k) {
  const auto& here = results[k];
  if (here.divide == results.back().divide) return std::nullopt;
  for (std::size_t b = k; b-- > 0;) {
    const auto& before = results[b];
    if (before.result.info.name != here.result.info.name) continue;
    const auto &coarse = before.result.face_radiosity_error, &fine = here.result.face_radiosity_error;
    if (!coarse || !fine || !(*coarse > 0) || !(*fine > 0) || !std::isfinite(*coarse) || !std::isfinite(*fine)) break;
    return std::log(*coarse / *fine) / std::log(static_cast<double>(here.divide) / before.divide);
  }
  return std::nullopt;
}

}  // namespace

std::string divide_csv(std::span<const DividedResult> results) {
  std::string text =
      "divide,elements,method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error,face_radiosity_error\n";
  for (const auto& [divide, each] : results)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", divide, each.elements, csv_field(each.info.name),
                        to_string(each.info.guarantee), csv_number(each.timing.median), csv_number(each.errors.max),
                        csv_number(each.errors.rms), csv_number(each.errors.closure),
                        csv_number(each.max_radiosity_error), csv_number(each.face_radiosity_error));
  return text;
}

std::string divided_json(const std::string& scene, std::span<const DividedResult> results) {
  Json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = scene;
  json["results"] = Json::array();
  const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  for (const auto& [divide, each] : results)
    json["results"].push_back({{"divide", divide},
                               {"elements", each.elements},
                               {"method", each.info.name},
                               {"guarantee", to_string(each.info.guarantee)},
                               {"seconds", each.timing.median},
                               {"max_error", each.errors.max},
                               {"rms_error", each.errors.rms},
                               {"closure", each.errors.closure},
                               {"max_radiosity_error", optional(each.max_radiosity_error)},
                               {"face_radiosity_error", optional(each.face_radiosity_error)},
                               {"notes", each.notes}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string divided_text(std::span<const DividedResult> results) {
  std::size_t widest = 6;
  for (const DividedResult& each : results) widest = std::max(widest, each.result.info.name.size());
  std::string text =
      fmt::format("{:>6} {:>9}  {:<{}} {:>10} {:>10} {:>10} {:>10} {:>10} {:>6}\n", "divide", "elements", "method",
                  widest, "seconds", "max error", "rms error", "radiosity", "of faces", "order");
  for (std::size_t k = 0; k < results.size(); ++k) {
    const auto& [divide, each] = results[k];
    const std::optional<double> order = order_of(results, k);
    text += fmt::format("{:>6} {:>9}  {:<{}} {:>10} {:>10} {:>10} {:>10} {:>10} {:>6}\n", divide, each.elements,
                        each.info.name, widest, short_number(each.timing.median), short_number(each.errors.max),
                        short_number(each.errors.rms), short_number(each.max_radiosity_error),
                        short_number(each.face_radiosity_error), order ? fmt::format("{:.1f}", *order) : "-");
  }
  return text;
}

}  // namespace hottel

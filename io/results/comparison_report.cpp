#include "io/results/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/results/csv_field.h"
#include "kernel/rational.h"
#include "kernel/support/counted.h"
#include "kernel/version.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

// What a matrix does not have of the exact one, faces by name; null where nothing is missing.
Json missing_json(const MatrixErrors& errors, const ExchangeMatrix& exact) {
  const MissingFactors& missing = errors.missing;
  if (missing.rows.empty() && missing.columns.empty() && missing.pairs == 0) return {};
  const auto names = [&](const std::vector<std::uint32_t>& elements) {
    Json all = Json::array();
    for (const std::uint32_t i : elements) all.push_back(exact.name(i));
    return all;
  };
  return {{"rows", names(missing.rows)},
          {"columns", names(missing.columns)},
          {"pairs", missing.pairs},
          {"largest", missing.largest},
          {"max_error_of_others", errors.max_of_others}};
}

Json method_json(const MethodResult& each, const ExchangeMatrix& exact) {
  return {{"method", each.info.name},
          {"family", each.info.family},
          {"guarantee", to_string(each.info.guarantee)},
          {"reference", each.info.reference},
          {"seconds",
           {{"median", each.timing.median},
            {"fastest", each.timing.fastest},
            {"slowest", each.timing.slowest},
            {"runs", each.timing.runs}}},
          {"max_error", each.errors.max},
          {"rms_error", each.errors.rms},
          {"closure", each.errors.closure},
          {"row_defect_before_normalising", each.report.row_defect},
          {"pairs", each.errors.pairs},
          {"missing", missing_json(each.errors, exact)},
          {"declared_error", optional(each.declared_error)},
          {"standard_error", optional(each.report.standard_error)},
          {"max_radiosity_error", optional(each.max_radiosity_error)},
          {"notes", each.notes}};
}

Json texels_json(const JudgedTexels& texels) {
  Json channels = Json::array();
  for (std::size_t c = 0; c < texels.errors.size(); ++c) {
    const GridErrors& each = texels.errors[c];
    channels.push_back({{"channel", texels.channels[c]},
                        {"texels", each.cells},
                        {"missing", each.missing},
                        {"extra", each.extra},
                        {"off", each.off},
                        {"max_error", each.max},
                        {"rms_error", each.rms},
                        {"mean_error", each.bias},
                        {"mean", each.mean},
                        {"worst",
                         {{"texel", {each.ix, each.iy}},
                          {"st", texels.place.fractions(each.ix, each.iy)},
                          {"at", texels.place.centre(each.ix, each.iy)},
                          {"value", each.value},
                          {"exact", each.exact}}}});
  }
  return {{"file", texels.file},
          {"face", texels.face},
          {"quantity", texels.quantity},
          {"channels", channels},
          {"notes", texel_sentences(texels)}};
}

std::string compare_table(std::span<const MethodResult> results) {
  std::size_t widest = 6;
  for (const MethodResult& each : results) widest = std::max(widest, each.info.name.size());
  std::string text =
      fmt::format("{:<{}}  {:<9} {:>12} {:>17} {:>10} {:>10} {:>10} {:>10}\n", "method", widest, "guarantee", "seconds",
                  "fastest..slowest", "max error", "rms error", "closure", "radiosity");
  const auto number = [](double value, int digits) {
    return std::isnan(value) ? std::string("-") : fmt::format("{:.{}g}", value, digits);
  };
  for (const MethodResult& each : results) {
    const Timing& timing = each.timing;  // of what is read from a file there is none
    text += fmt::format("{:<{}}  {:<9} {:>12} {:>17} {:>10} {:>10} {:>10} {:>10}\n", each.info.name, widest,
                        to_string(each.info.guarantee), number(timing.median, 3),
                        std::isnan(timing.median) ? "-" : fmt::format("{:.2g}..{:.2g}", timing.fastest, timing.slowest),
                        number(each.errors.max, 2), number(each.errors.rms, 2), number(each.errors.closure, 2),
                        each.max_radiosity_error ? number(*each.max_radiosity_error, 2) : "-");
  }
  return text;
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
  Json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = report.scene;
  json["counts"] = {
      {"surfaces", report.surfaces}, {"elements", report.exact.size()}, {"entries", report.exact.entry_count()}};
  json["seconds"] = {{"prepare", report.seconds_to_prepare}};
  if (report.reference.max > 0)
    json["exact_may_be_off"] = {{"max_error", report.reference.max},
                                {"rms_error", report.reference.rms},
                                {"max_radiosity_error", report.reference.radiosity}};
  json["methods"] = Json::array();
  for (const MethodResult& each : report.results) json["methods"].push_back(method_json(each, report.exact));
  json["readings"] = Json::array();
  for (const WorkReading& reading : report.readings)
    json["readings"].push_back(
        {{"error", reading.error},
         {"exact_seconds", reading.exact_seconds},
         {"family", reading.family},
         {"seconds", optional(reading.family.empty() ? std::nullopt : std::optional(reading.seconds))}});
  if (!report.grid_file.empty()) json["light"] = {{"file", report.grid_file}, {"notes", report.light}};
  if (report.texels != nullptr) json["texels"] = texels_json(*report.texels);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string size_text(const ExchangeMatrix& matrix) {
  std::uint32_t rows = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) rows += matrix.has_row(i) ? 1 : 0;
  return counted(rows, "element") + ", " + counted(matrix.entry_count(), "view factor");
}

std::string comparison_text(const ComparisonReport& report) {
  std::string text =
      fmt::format("{}; prepared once for all in {:.3g} s\n\n", size_text(report.exact), report.seconds_to_prepare) +
      compare_table(report.results) + "\n";
  if (report.reference.max > 0)
    text += fmt::format("the exact factors may be off by {:.2g} themselves: no smaller error is told\n",
                        report.reference.max);
  if (!report.why_no_radiosities.empty()) text += "no radiosities are compared: " + report.why_no_radiosities + "\n";
  std::vector<std::pair<std::string, std::string>> notes;  // what is said, of which methods
  for (const MethodResult& each : report.results) {
    if (std::ranges::find(report.told, each.info.name) != report.told.end()) continue;
    for (const std::string& note : each.notes) {
      auto place = std::find_if(notes.begin(), notes.end(), [&](const auto& other) { return other.first == note; });
      if (place == notes.end()) place = notes.insert(place, {note, ""});
      place->second += (place->second.empty() ? "" : ", ") + each.info.name;
    }
  }
  for (const auto& [note, whose] : notes) text += whose + ": " + note + "\n";
  for (const std::string& sentence : report.light) text += report.grid_file + ": " + sentence + "\n";
  if (report.texels != nullptr)
    for (const std::string& sentence : texel_sentences(*report.texels))
      text += report.texels->file + ": " + report.texels->face + ", " + sentence + "\n";
  for (const WorkReading& reading : report.readings) text += to_sentence(reading, report.errors_read) + "\n";
  return text;
}

namespace {

// Empty for what is not known, and for a length beyond the range of doubles.
std::string length_field(const std::optional<double>& value) {
  return csv_number(value && std::isfinite(*value) ? value : std::nullopt);
}

}  // namespace

std::string compare_csv(std::span<const MethodResult> results) {
  std::string text = "method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error\n";
  for (const MethodResult& each : results)
    text += fmt::format("{},{},{},{},{},{},{}\n", csv_field(each.info.name), to_string(each.info.guarantee),
                        csv_number(each.timing.median), csv_number(each.errors.max), csv_number(each.errors.rms),
                        csv_number(each.errors.closure), csv_number(each.max_radiosity_error));
  return text;
}

std::string worst_csv(std::span<const ExplainedPair> pairs) {
  std::string text = "method,from,to,value,exact,error,visibility,distance,angle,reason\n";
  for (const auto& [method, from, to, error, explanation] : pairs)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(method), csv_field(from), csv_field(to),
                        shortest(error.value), shortest(error.exact), shortest(error.error()),
                        csv_number(explanation.visibility), length_field(explanation.distance),
                        csv_number(explanation.angle), csv_field(explanation.reason));
  return text;
}

std::string readings_csv(std::span<const WorkCurve> curves, std::span<const double> errors) {
  std::string text = "error,family,seconds,exact_seconds\n";
  const auto exact =
      std::find_if(curves.begin(), curves.end(), [](const WorkCurve& curve) { return curve.family == kExactFamily; });
  for (const double error : errors)
    for (const WorkCurve& curve : curves)
      text += fmt::format("{},{},{},{}\n", shortest(error), csv_field(curve.family),
                          csv_number(seconds_to_reach(curve.points, error)),
                          exact == curves.end() ? "" : shortest(exact->points.front().seconds));
  return text;
}

}  // namespace hottel

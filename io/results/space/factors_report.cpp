#include "io/results/space/factors_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/results/granularity_noun.h"
#include "io/results/sky_report.h"
#include "kernel/rational.h"
#include "kernel/version.h"

namespace hottel {

FactorCounts factor_counts(const ExchangeReport3& report) {
  return {report.surfaces,
          report.elements,
          report.vertices,
          report.pairs,
          {{"filter", report.signs.by_tier[0]},
           {"combinatorial", report.signs.by_tier[1]},
           {"exact", report.signs.by_tier[2]}},
          false,
          report.sky};
}

std::string factors_json(const FactorsReport3& report) {
  const ExchangeReport3& counts = report.counts;
  nlohmann::ordered_json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = report.scene;
  json["method"] = report.method;
  if (!report.notes.empty()) {
    json["counts"] = {{"surfaces", counts.surfaces},
                      {"vertices", counts.vertices},
                      {"elements", counts.elements},
                      {"entries", counts.pairs}};
    json["seconds"] = counts.seconds;
    json["closure"] = {{"max_defect", counts.max_defect}, {"exact", false}};
    json["bounds"] = {{"guarantee", to_string(report.guarantee)}};
    json["notes"] = report.notes;
    if (report.store) json["store"] = nlohmann::ordered_json::parse(store_json(*report.store));
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }
  json["counts"] = {{"surfaces", counts.surfaces}, {"vertices", counts.vertices}, {"elements", counts.elements},
                    {"pairs", counts.pairs},       {"hidden", counts.hidden},     {"clear", counts.clear},
                    {"mixed", counts.mixed},       {"maps", counts.maps},         {"pieces", counts.pieces},
                    {"nodes", counts.nodes}};
  if (counts.proof.parts + counts.proof.failures > 0)
    json["proof"] = {{"parts", counts.proof.parts},
                     {"halvings", counts.proof.halvings},
                     {"redone", counts.proof.redone},
                     {"unproven", counts.proof.failures},
                     {"narrowed", counts.proof.narrowed}};
  for (const auto& [tier, count] : factor_counts(counts).tiers) json["tiers"][tier] = count;
  json["seconds"] = counts.seconds;
  json["closure"] = {{"max_defect", counts.max_defect}, {"exact", false}};
  if (counts.sky) json["sky"] = nlohmann::ordered_json::parse(sky_json(*counts.sky));
  json["bounds"] = {{"guarantee", to_string(report.guarantee)},
                    {"tolerance", report.tolerance},
                    {"max_error", counts.max_error},
                    {"enclosed", counts.enclosed},
                    {"estimated", counts.pairs - counts.enclosed}};
  if (report.store) json["store"] = nlohmann::ordered_json::parse(store_json(*report.store));
  if (report.gray) {
    json["seconds"]["script_f"] = report.gray->seconds;
    json["script_f"] = gray_json(*report.gray);
  }
  return json.dump(2) + "\n";
}

std::string factors_text(const FactorsReport3& report) {
  const ExchangeReport3& counts = report.counts;
  double seconds = 0;
  for (const auto& [stage, time] : counts.seconds) seconds += time;
  if (!report.notes.empty())
    return fmt::format("{} of {}; {:.3f} s\n{}{}", counted(counts.pairs, "view factor"),
                       counted(counts.elements, report.granularity), seconds, fmt::join(report.notes, "\n"),
                       report.store ? "\n" + store_text(*report.store) : "");
  const std::uint64_t estimated = counts.pairs - counts.enclosed;
  std::string text =
      fmt::format("{} of {}, ", counted(counts.pairs, "visible pair"), counted(counts.elements, report.granularity));
  text += estimated == 0
              ? fmt::format("every factor enclosed within {} of the smaller area", shortest(report.tolerance))
              : fmt::format("{} enclosed and {} estimated within {} of the smaller area", counts.enclosed, estimated,
                            shortest(report.tolerance));
  text += fmt::format(
      "; rows sum to 1 within {:.1e}\n"
      "pairs of flat pieces: {} hidden from each other, {} with nothing between, {} with something between; {:.3f} s",
      counts.max_defect, counts.hidden, counts.clear, counts.mixed, seconds);
  if (counts.proof.parts + counts.proof.failures > 0)
    text += fmt::format(
        "\nparts of edges that are proven: {}, by {} halvings; {} of them with more digits, {} left to what is seen at "
        "most; rows narrow {} pairs",
        counts.proof.parts, counts.proof.halvings, counts.proof.redone, counts.proof.failures, counts.proof.narrowed);
  if (counts.sky) text += "\n" + sky_text(*counts.sky);
  if (report.store) text += "\n" + store_text(*report.store);
  if (report.gray) text += "\n" + gray_text(*report.gray);
  return text;
}

}  // namespace hottel

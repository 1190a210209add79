#include "io/results/factors_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/results/granularity_noun.h"
#include "kernel/version.h"

namespace hottel {
std::string factors_json(const FactorsReport& report) {
  const ExchangeReport& counts = report.of_method.counts;
  nlohmann::ordered_json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = report.scene;
  json["method"] = report.method;
  json["counts"] = {{"surfaces", counts.surfaces}, {"vertices", counts.vertices}, {"pieces", counts.pieces},
                    {"elements", counts.elements}, {"pairs", counts.pairs},       {"gaps", counts.gaps},
                    {"terms", counts.terms}};
  json["tiers"] = {{"double", counts.tiers.by_tier[0]},
                   {"double_double", counts.tiers.by_tier[1]},
                   {"ball", counts.tiers.by_tier[2]},
                   {"root_sum", counts.tiers.by_tier[3]}};
  json["seconds"] = counts.seconds;
  json["closure"] = {{"max_defect", 0}, {"exact", counts.closure_is_exact}};
  if (!report.is_exact()) json["closure"]["max_defect"] = report.of_method.row_defect;
  if (!report.of_method.notes.empty()) json["notes"] = report.of_method.notes;
  if (report.store) json["store"] = nlohmann::ordered_json::parse(store_json(*report.store));
  if (report.gray) {
    json["seconds"]["script_f"] = report.gray->seconds;
    json["script_f"] = gray_json(*report.gray);
  }
  return json.dump(2) + "\n";
}

std::string factors_text(const FactorsReport& report) {
  const ExchangeReport& counts = report.of_method.counts;
  const std::string rows = counted(counts.elements, report.granularity);
  double seconds = 0;
  for (const auto& [stage, time] : counts.seconds) seconds += time;
  if (!report.is_exact()) {
    std::string text = fmt::format("{} of {}; {:.3f} s", counted(counts.pairs, "factor"), rows, seconds);
    for (const std::string& note : report.of_method.notes) text += "\n" + note;
    return text + (report.store ? "\n" + store_text(*report.store) : "");
  }
  std::string text =
      fmt::format("{} of {}; every factor is correctly rounded, and before rounding rows sum to exactly 1\n",
                  counted(counts.pairs, "visible pair"), rows);
  if (report.store && report.store->use.computed == 0)
    text += fmt::format("taken from a store; {:.3f} s", seconds);
  else
    text += fmt::format(
        "numbers by the arithmetic they needed: {} integers, {} fixed point of 128 bits, {} balls (intervals), {} "
        "exact "
        "sums of roots; {:.3f} s",
        counts.tiers.by_tier[0], counts.tiers.by_tier[1], counts.tiers.by_tier[2], counts.tiers.by_tier[3], seconds);
  if (report.store) text += "\n" + store_text(*report.store);
  if (report.gray) text += "\n" + gray_text(*report.gray);
  return text;
}

}  // namespace hottel

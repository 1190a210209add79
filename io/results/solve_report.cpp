#include "io/results/solve_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/support/counted.h"
#include "kernel/version.h"

namespace hottel {
namespace {

nlohmann::ordered_json report_head(const std::string& scene, const Plan& plan) {
  nlohmann::ordered_json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = scene;
  json["plan"] = nlohmann::ordered_json::array();
  for (const PlannedEffect& effect : plan.effects())
    json["plan"].push_back({{"effect", effect.effect},
                            {"used", effect.used},
                            {"reason", effect.reason},
                            {"seconds_estimate", effect.seconds_estimate}});
  return json;
}

}  // namespace

FactorCounts factor_counts(const ExchangeReport& report) {
  return {report.surfaces,
          report.elements,
          report.vertices,
          report.pairs,
          {{"double", report.tiers.by_tier[0]},
           {"double_double", report.tiers.by_tier[1]},
           {"ball", report.tiers.by_tier[2]},
           {"root_sum", report.tiers.by_tier[3]}},
          report.closure_is_exact};
}

std::string plan_json(const std::string& scene, const Plan& plan) { return report_head(scene, plan).dump(2) + "\n"; }

std::string plan_text(const Plan& plan) {
  std::string text = "plan\n";
  for (const PlannedEffect& effect : plan.effects())
    text += fmt::format("  {:<24}{:<12}{}{}\n", effect.effect,
                        effect.used           ? "used"
                        : effect.is_simulated ? "not needed"
                                              : "not yet",
                        effect.reason,
                        effect.seconds_estimate > 0 ? fmt::format(" (about {:.2g} s)", effect.seconds_estimate) : "");
  return text;
}

std::string solve_json(const SolveReport& report) {
  nlohmann::ordered_json json = report_head(report.scene, *report.plan);
  const FactorCounts& factors = report.factors;
  const RadiositySolution& solution = *report.solution;
  json["counts"] = {{"surfaces", factors.surfaces},
                    {"elements", factors.elements},
                    {"vertices", factors.vertices},
                    {"pairs", factors.pairs}};
  for (const auto& [tier, count] : factors.tiers) json["tiers"][tier] = count;
  json["seconds"] = report.seconds;
  if (solution.factorizations > 0) {
    json["solver"] = {{"name", to_string(solution.used)},
                      {"unknowns", solution.unknowns},
                      {"components", solution.components},
                      {"factorizations", solution.factorizations}};
    for (std::size_t c = 0; c < solution.channels.size(); ++c)
      json["solver"]["residual_history"][solution.channel_names[c]] = solution.channels[c].residual_history;
  }
  json["closure"] = {{"max_defect", solution.closure_defect}, {"exact", factors.closure_is_exact}};
  json["reciprocity"] = {{"max_defect", solution.reciprocity_defect}};
  json["energy"] = {{"emitted", solution.energy.emitted},
                    {"absorbed", solution.energy.absorbed},
                    {"to_sky", solution.energy.to_sky},
                    {"defect", solution.energy.defect}};
  json["bounds"] = {{"max_relative_width", solution.max_relative_width}, {"guarantee", to_string(solution.guarantee)}};
  if (report.illumination_max_error) json["bounds"]["illumination_max_error"] = *report.illumination_max_error;
  if (report.picture_scale) json["picture"] = {{"scale", *report.picture_scale}};
  if (const auto& range = report.picture_range)
    json["picture"] = {
        {"quantity", range->quantity}, {"unit", range->unit}, {"lower", range->lower}, {"upper", range->upper}};
  if (report.store) json["store"] = nlohmann::ordered_json::parse(store_json(*report.store));
  json["notes"] = report.warnings;
  for (const std::string& note : solution.notes) json["notes"].push_back(note);
  return json.dump(2) + "\n";
}

namespace {

constexpr std::size_t kFluxesInText = 6;

// The groups with the largest net flux, summed over the channels.
std::string flux_text(const std::vector<NetFlux>& groups) {
  std::vector<std::pair<double, std::string>> largest;
  for (const NetFlux& group : groups) {
    double net = 0;
    for (const NetFlux::Power& power : group.by_channel) net += power.value;
    largest.emplace_back(net, group.name);
  }
  const std::size_t shown = std::min(largest.size(), kFluxesInText);
  std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(shown), largest.end(),
                    [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  std::string text = "net flux:";
  for (std::size_t k = 0; k < shown; ++k)
    text += fmt::format("{} {} {:.6g}", k == 0 ? "" : ",", largest[k].second, largest[k].first);
  if (shown < largest.size()) text += fmt::format(" and {} more in flux.csv", largest.size() - shown);
  return text + "\n";
}

}  // namespace

std::string solve_text(const SolveReport& report) {
  const FactorCounts& factors = report.factors;
  const RadiositySolution& solution = *report.solution;
  std::string text =
      fmt::format("{}, {}, {}, {}\n", counted(factors.surfaces, "surface"), counted(factors.elements, "element"),
                  factors.vertices == 1 ? "1 vertex" : std::to_string(factors.vertices) + " vertices",
                  counted(factors.pairs, "visible pair"));
  text +=
      solution.factorizations == 0
          ? "radiosity is emission: nothing had to be solved\n"
          : fmt::format("radiosity by {}: {} in {}, {}, bounds within {:.1e} of the value\n", to_string(solution.used),
                        counted(solution.unknowns, "unknown"), counted(solution.components, "component"),
                        counted(solution.channels.size(), "channel"), solution.max_relative_width);
  text +=
      fmt::format("energy: emitted {:.6g}, absorbed {:.6g}, to the sky {:.6g}, defect {:.1e}\n",
                  solution.energy.emitted, solution.energy.absorbed, solution.energy.to_sky, solution.energy.defect);
  text += flux_text(report.fluxes->groups);
  if (report.illumination_max_error)
    text += fmt::format("illumination: averages over cells, each within {:.1e} for these radiosities\n",
                        *report.illumination_max_error);
  if (report.store) text += store_text(*report.store) + "\n";
  for (const std::string& note : solution.notes) text += "note: " + note + "\n";
  text += "seconds:";
  double total = 0;
  for (const auto& [stage, seconds] : report.seconds) {
    text += fmt::format(" {} {:.3f}", stage, seconds);
    total += seconds;
  }
  return text + fmt::format(", all {:.3f}\n", total);
}

std::string small_scene_text(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  if (matrix.elements().size() > 2 * kFacesOnAScreen || scene.surfaces.size() > kFacesOnAScreen) return "";
  std::string text = fmt::format("\n{:<16}", "factor to");
  for (const Element& element : matrix.elements()) text += fmt::format("{:>14.14}", element.name);
  text += fmt::format("{:>14}\n", matrix.name(matrix.sky()));
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    text += fmt::format("{:<16.16}", matrix.elements()[i].name);
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) text += fmt::format("{:>14.10g}", matrix.factor(i, j).value);
    text += "\n";
  }
  text += fmt::format("\n{:<16}{:>8}{:>24}{:>24}{:>24}\n", "radiosity", "channel", "lower", "value", "upper");
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t c = 0; matrix.has_row(i) && c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      text += fmt::format("{:<16.16}{:>8}{:>24}{:>24}{:>24}\n", matrix.elements()[i].name, solution.channel_names[c],
                          shortest(r.lower), shortest(r.radiosity), shortest(r.upper));
    }
  return text;
}

}  // namespace hottel

#include "io/radiosity_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/factor_files.h"
#include "kernel/version.h"

namespace hottel {

void write_radiosity_csv(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                         const std::function<void(std::string_view)>& sink) {
  sink("face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net\n");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    const std::string face = csv_field(scene.surfaces[element.surface].name + (element.is_back ? ":back" : ""));
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      std::string line = fmt::format("{},{},{}", face, element.part, solution.channel_names[c]);
      for (const double value :
           {element.area.value, r.emission, r.reflectivity, r.radiosity, r.lower, r.upper, r.irradiance, r.net})
        line += "," + shortest(value);
      sink(line + "\n");
    }
  }
}

namespace {

nlohmann::ordered_json report_head(const std::string& scene, const Plan& plan) {
  nlohmann::ordered_json json;
  json["hottel"] = kVersion;
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

std::string plan_json(const std::string& scene, const Plan& plan) { return report_head(scene, plan).dump(2) + "\n"; }

std::string plan_text(const Plan& plan) {
  std::string text = "plan\n";
  for (const PlannedEffect& effect : plan.effects())
    text += fmt::format("  {:<24}{:<12}{}{}\n", effect.effect, effect.used ? "used" : "not needed", effect.reason,
                        effect.seconds_estimate > 0 ? fmt::format(" (about {:.2g} s)", effect.seconds_estimate) : "");
  return text;
}

std::string report_json(const SolveReport& report) {
  nlohmann::ordered_json json = report_head(report.scene, *report.plan);
  const ExchangeReport& exchange = *report.exchange;
  const RadiositySolution& solution = *report.solution;
  json["counts"] = {{"surfaces", exchange.surfaces},
                    {"elements", exchange.elements},
                    {"vertices", exchange.vertices},
                    {"pairs", exchange.pairs}};
  json["tiers"] = {{"double", exchange.tiers.by_tier[0]},
                   {"double_double", exchange.tiers.by_tier[1]},
                   {"ball", exchange.tiers.by_tier[2]},
                   {"root_sum", exchange.tiers.by_tier[3]}};
  json["seconds"] = report.seconds;
  json["solver"] = {{"name", report.solver},
                    {"unknowns", solution.unknowns},
                    {"components", solution.components},
                    {"factorizations", solution.factorizations}};
  for (std::size_t c = 0; c < solution.channels.size(); ++c)
    json["solver"]["residual_history"][solution.channel_names[c]] = solution.channels[c].residual_history;
  json["closure"] = {{"max_defect", solution.closure_defect}, {"exact", exchange.closure_is_exact}};
  json["reciprocity"] = {{"max_defect", solution.reciprocity_defect}};
  json["energy"] = {{"emitted", solution.energy.emitted},
                    {"absorbed", solution.energy.absorbed},
                    {"to_sky", solution.energy.to_sky},
                    {"defect", solution.energy.defect}};
  json["bounds"] = {{"max_relative_width", solution.max_relative_width}};
  if (report.illumination_max_error) json["bounds"]["illumination_max_error"] = *report.illumination_max_error;
  json["picture"] = {{"scale", report.picture_scale}};
  json["notes"] = solution.notes;
  return json.dump(2) + "\n";
}

std::string report_text(const SolveReport& report) {
  const ExchangeReport& exchange = *report.exchange;
  const RadiositySolution& solution = *report.solution;
  std::string text = fmt::format("{} surfaces, {} elements, {} vertices, {} visible pairs\n", exchange.surfaces,
                                 exchange.elements, exchange.vertices, exchange.pairs);
  text +=
      fmt::format("radiosity by {}: {} unknowns in {} components, {} channel{}, bounds within {:.1e} of the value\n",
                  report.solver, solution.unknowns, solution.components, solution.channels.size(),
                  solution.channels.size() == 1 ? "" : "s", solution.max_relative_width);
  text +=
      fmt::format("energy: emitted {:.6g}, absorbed {:.6g}, to the sky {:.6g}, defect {:.1e}\n",
                  solution.energy.emitted, solution.energy.absorbed, solution.energy.to_sky, solution.energy.defect);
  if (report.illumination_max_error)
    text += fmt::format("illumination: averages over cells, each within {:.1e} for these radiosities\n",
                        *report.illumination_max_error);
  for (const std::string& note : solution.notes) text += "note: " + note + "\n";
  text += "seconds:";
  double total = 0;
  for (const auto& [stage, seconds] : report.seconds) {
    text += fmt::format(" {} {:.3f}", stage, seconds);
    total += seconds;
  }
  return text + fmt::format(", all {:.3f}\n", total);
}

}  // namespace hottel

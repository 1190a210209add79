#include "io/results/radiosity_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/results/factor_files.h"
#include "kernel/version.h"

namespace hottel {

void write_radiosity_csv(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                         const std::function<void(std::string_view)>& sink) {
  sink("face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net\n");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    const std::string face = csv_field(face_name(scene, element));
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      std::string line = fmt::format("{},{},{}", face, element.part, solution.channel_names[c]);
      for (const double value :
           {element.area.value, r.emission, r.reflectivity, r.radiosity, r.lower, r.upper, r.irradiance, r.net()})
        line += "," + shortest(value);
      sink(line + "\n");
    }
  }
}

namespace {

void write_fluxes(const char* per, const std::vector<NetFlux>& fluxes, const std::vector<std::string>& channel_names,
                  const std::function<void(std::string_view)>& sink) {
  for (const NetFlux& flux : fluxes)
    for (std::size_t c = 0; c < channel_names.size(); ++c) {
      const NetFlux::Power& power = flux.by_channel[c];
      sink(fmt::format("{},{},{},{},{},{},{}\n", per, csv_field(flux.name), channel_names[c],
                       flux.area ? shortest(*flux.area) : "", shortest(power.value), shortest(power.lower),
                       shortest(power.upper)));
    }
}

}  // namespace

NetFluxes::NetFluxes(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution)
    : faces(net_flux(matrix, solution, scene.sky_emission, [&](const Element& e) { return face_name(scene, e); })),
      groups(net_flux(matrix, solution, scene.sky_emission, [&](const Element& e) {
        return scene.groups[scene.surfaces[e.surface].group].name + (e.is_back ? ":back" : "");
      })) {}

void write_flux_csv(const NetFluxes& fluxes, const std::vector<std::string>& channel_names,
                    const std::function<void(std::string_view)>& sink) {
  sink("per,name,channel,area,net,lower,upper\n");
  write_fluxes("face", fluxes.faces, channel_names, sink);
  write_fluxes("group", fluxes.groups, channel_names, sink);
}

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
  if (solution.factorizations > 0) {
    json["solver"] = {{"name", to_string(solution.used)},
                      {"unknowns", solution.unknowns},
                      {"components", solution.components},
                      {"factorizations", solution.factorizations}};
    for (std::size_t c = 0; c < solution.channels.size(); ++c)
      json["solver"]["residual_history"][solution.channel_names[c]] = solution.channels[c].residual_history;
  }
  json["closure"] = {{"max_defect", solution.closure_defect}, {"exact", exchange.closure_is_exact}};
  json["reciprocity"] = {{"max_defect", solution.reciprocity_defect}};
  json["energy"] = {{"emitted", solution.energy.emitted},
                    {"absorbed", solution.energy.absorbed},
                    {"to_sky", solution.energy.to_sky},
                    {"defect", solution.energy.defect}};
  json["bounds"] = {{"max_relative_width", solution.max_relative_width}, {"guarantee", to_string(solution.guarantee)}};
  if (report.illumination_max_error) json["bounds"]["illumination_max_error"] = *report.illumination_max_error;
  if (report.picture_scale) json["picture"] = {{"scale", *report.picture_scale}};
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

std::string report_text(const SolveReport& report) {
  const ExchangeReport& exchange = *report.exchange;
  const RadiositySolution& solution = *report.solution;
  std::string text = fmt::format("{} surfaces, {} elements, {} vertices, {} visible pairs\n", exchange.surfaces,
                                 exchange.elements, exchange.vertices, exchange.pairs);
  text += solution.factorizations == 0
              ? "radiosity is emission: nothing had to be solved\n"
              : fmt::format(
                    "radiosity by {}: {} unknowns in {} components, {} channel{}, bounds within {:.1e} of the value\n",
                    to_string(solution.used), solution.unknowns, solution.components, solution.channels.size(),
                    solution.channels.size() == 1 ? "" : "s", solution.max_relative_width);
  text +=
      fmt::format("energy: emitted {:.6g}, absorbed {:.6g}, to the sky {:.6g}, defect {:.1e}\n",
                  solution.energy.emitted, solution.energy.absorbed, solution.energy.to_sky, solution.energy.defect);
  text += flux_text(report.fluxes->groups);
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

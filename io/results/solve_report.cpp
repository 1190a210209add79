#include "io/results/solve_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/memory_text.h"
#include "geometry/name.h"
#include "io/results/sky_report.h"
#include "kernel/support/counted.h"
#include "kernel/version.h"

namespace hottel {
namespace {

nlohmann::ordered_json report_head(const std::string& scene, const Plan* plan) {
  nlohmann::ordered_json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = scene;
  json["plan"] = nlohmann::ordered_json::array();
  if (plan != nullptr)
    for (const PlannedEffect& effect : plan->effects())
      json["plan"].push_back({{"effect", effect.effect},
                              {"used", effect.used},
                              {"reason", effect.reason},
                              {"seconds_estimate", effect.seconds_estimate}});
  return json;
}

nlohmann::ordered_json memory_object(const PlannedMemory& memory) {
  nlohmann::ordered_json json;
  json["stages"] = nlohmann::ordered_json::array();
  for (const MemoryStage& stage : memory.estimate.stages())
    json["stages"].push_back(
        {{"stage", stage.name}, {"count", stage.count}, {"unit", stage.unit}, {"bytes", stage.bytes}});
  json["factors"] = memory.estimate.of_factors();
  json["peak"] = memory.estimate.peak();
  json["allowed"] = {{"factors", memory.limits.of_factors}, {"peak", memory.limits.of_all}};
  json["fits"] = memory.problem.empty();
  return json;
}

std::string memory_text(const PlannedMemory& memory) {
  std::string text = "memory\n";
  for (const MemoryStage& stage : memory.estimate.stages())
    text += fmt::format("  {:<24}{:<12}{} {}\n", stage.name, short_bytes(stage.bytes),
                        stage.count < 1e6 ? fmt::format("{:.0f}", stage.count) : fmt::format("{:.2g}", stage.count),
                        stage.unit);
  text += fmt::format("  {:<24}{:<12}at the most at one time, beside the program and the scene\n", "together",
                      short_bytes(memory.estimate.peak()));
  text += fmt::format("  {:<24}{:<12}for elements and view factors; {} for all\n", "allowed",
                      short_bytes(static_cast<double>(memory.limits.of_factors)),
                      short_bytes(static_cast<double>(memory.limits.of_all)));
  return text + (memory.problem.empty() ? "it fits\n" : "it does not fit: " + memory.problem + "\n");
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

std::string plan_json(const std::string& scene, const Plan* plan, const PlannedMemory* memory,
                      const PlannedLists* lists, const PlannedOnDisk* on_disk) {
  nlohmann::ordered_json json = report_head(scene, plan);
  if (memory != nullptr) json["memory"] = memory_object(*memory);
  if (lists != nullptr) json["lists"] = lists_object(*lists);
  if (on_disk != nullptr) json[on_disk_key(*on_disk)] = on_disk_object(*on_disk);
  return json.dump(2) + "\n";
}

std::string plan_text(const Plan* plan, const PlannedMemory* memory, const PlannedLists* lists,
                      const PlannedOnDisk* on_disk) {
  std::string text = plan != nullptr ? "plan\n" : "";
  for (const PlannedEffect& effect : plan != nullptr ? plan->effects() : std::vector<PlannedEffect>())
    text += fmt::format("  {:<24}{:<12}{}{}\n", effect.effect,
                        effect.used           ? "used"
                        : effect.is_simulated ? "not needed"
                                              : "not yet",
                        effect.reason,
                        effect.seconds_estimate > 0 ? fmt::format(" (about {:.2g} s)", effect.seconds_estimate) : "");
  if (memory != nullptr) text += memory_text(*memory);
  if (lists != nullptr) text += lists_text(*lists);
  return on_disk != nullptr ? text + on_disk_text(*on_disk) : text;
}

namespace {

double over(double value, double largest) { return largest > 0 ? value / largest : 0; }

nlohmann::ordered_json dividing_json(const DividingEstimate& estimate) {
  nlohmann::ordered_json json;
  json["elements"] = estimate.elements;
  json["looked_at"] = estimate.looked_at;
  json["pointwise"] = nullptr;
  json["face_means"] = nullptr;
  for (const DividingEstimate::Channel& channel : estimate.channels) {
    if (channel.pointwise)
      json["pointwise"][channel.name] = {{"rms", *channel.pointwise},
                                         {"relative", over(*channel.pointwise, channel.largest)}};
    if (channel.face_means)
      json["face_means"][channel.name] = {{"largest", *channel.face_means},
                                          {"relative", over(*channel.face_means, channel.largest)},
                                          {"face", channel.face}};
  }
  if (!estimate.why_no_pointwise.empty()) json["why_no_pointwise"] = estimate.why_no_pointwise;
  if (!estimate.why_no_face_means.empty()) json["why_no_face_means"] = estimate.why_no_face_means;
  return json;
}

}  // namespace

std::string dividing_text(const DividingEstimate& estimate) {
  // Of the channel in which most would change.
  const auto text_of = [&](std::optional<double> DividingEstimate::Channel::*change, const char* what, bool has_face) {
    const DividingEstimate::Channel* most = nullptr;
    for (const DividingEstimate::Channel& channel : estimate.channels)
      if (channel.*change &&
          (most == nullptr || over(*(channel.*change), channel.largest) > over(*(most->*change), most->largest)))
        most = &channel;
    if (most == nullptr) return std::string();
    return fmt::format("{} {:.2g} ({:.2g} % of the largest{}{})", what, *(most->*change),
                       100 * over(*(most->*change), most->largest),
                       estimate.channels.size() > 1 ? " in " + most->name : "",
                       has_face && !most->face.empty() ? ", " + quoted_name(most->face) : "");
  };
  const std::string places = text_of(&DividingEstimate::Channel::pointwise, "radiosities by an rms of", false);
  const std::string means = text_of(&DividingEstimate::Channel::face_means, "means of faces by up to", true);
  std::string text;
  if (estimate.looked_at == 0 && !places.empty())
    return "estimate: dividing changes no radiosity: nothing is reflected\n";
  if (!places.empty() || !means.empty())
    text = fmt::format(
        "estimate{}: dividing every element once more would change {}{}{}; it does not see shadows "
        "finer than half an element\n",
        0 < estimate.looked_at && estimate.looked_at < estimate.elements
            ? fmt::format(" from {} of {} elements", estimate.looked_at, estimate.elements)
            : "",
        places, places.empty() || means.empty() ? "" : ", ", means);
  if (places.empty() && !estimate.why_no_pointwise.empty())
    text += "no estimate of how radiosities change within elements: " + estimate.why_no_pointwise + "\n";
  if (means.empty() && !estimate.why_no_face_means.empty())
    text += "no estimate of how means of faces change, for it merges pairs of elements: " + estimate.why_no_face_means +
            "\n";
  return text;
}

namespace {

// Of all channels together; of two bands one object each, by their names.
// What of a sun passes by is infinite, and has no number: null.
// Nor has anything where nobody knows the unit of length.
nlohmann::ordered_json energy_json(const RadiositySolution& solution, const std::array<bool, 2>& has_sun,
                                   bool is_in_watts) {
  const auto object = [is_in_watts](const EnergyBalance& energy, bool is_lit_by_sun) {
    const auto told = [is_in_watts](double power) {
      return is_in_watts ? nlohmann::ordered_json(power) : nlohmann::ordered_json();
    };
    nlohmann::ordered_json json{{"emitted", told(energy.emitted)},
                                {"absorbed", told(energy.absorbed)},
                                {"to_sky", told(energy.to_sky)},
                                {"defect", told(energy.defect)}};
    if (is_lit_by_sun) json["passed"] = nullptr;
    return json;
  };
  if (solution.channels.size() != 2) return object(solution.energy, has_sun[0]);
  nlohmann::ordered_json json;
  for (std::size_t c = 0; c < 2; ++c) json[solution.channel_names[c]] = object(solution.channels[c].energy, has_sun[c]);
  return json;
}

std::string energy_text(const std::string& of, const EnergyBalance& energy, bool has_sun) {
  return fmt::format("energy{}: emitted {:.6g}, absorbed {:.6g}, to the sky {:.6g}, defect {:.1e}{}\n", of,
                     energy.emitted, energy.absorbed, energy.to_sky, energy.defect,
                     has_sun ? "; of the sun only what meets faces is counted" : "");
}

nlohmann::ordered_json picture_json(const PictureLight& light) {
  nlohmann::ordered_json json{{"scale", light.scale}, {"tone", light.tone}, {"exposure", light.exposure}};
  if (!light.contours.empty()) json["contours"] = light.contours;
  return json;
}

nlohmann::ordered_json picture_json(const PictureRange& range) {
  return {{"quantity", range.quantity}, {"unit", range.unit},           {"lower", range.lower},
          {"upper", range.upper},       {"bar_lower", range.bar_lower}, {"bar_upper", range.bar_upper}};
}

// The picture of a run, or, where grids have names, one of its pictures.
void add_picture(const std::string& grid, const nlohmann::ordered_json& picture, nlohmann::ordered_json& json) {
  if (grid.empty()) {
    json["picture"] = picture;
    return;
  }
  nlohmann::ordered_json named{{"grid", grid}};
  named.update(picture);
  json["pictures"].push_back(std::move(named));
}

}  // namespace

std::string solve_json(const SolveReport& report) {
  nlohmann::ordered_json json = report_head(report.scene, report.plan);
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
  if (factors.sky) json["sky"] = nlohmann::ordered_json::parse(sky_json(*factors.sky));
  json["reciprocity"] = {{"max_defect", solution.reciprocity_defect}};
  json["energy"] = energy_json(solution, report.fluxes->has_sun, report.fluxes->are_in_watts);
  json["bounds"] = {{"of", "these elements"},
                    {"max_relative_width", solution.max_relative_width},
                    {"guarantee", to_string(solution.guarantee)}};
  if (report.illumination_max_error) json["bounds"]["illumination_max_error"] = *report.illumination_max_error;
  if (report.dividing) json["estimate_of_dividing"] = dividing_json(*report.dividing);
  for (const PictureLight& light : report.picture_lights) add_picture(light.grid, picture_json(light), json);
  for (const PictureRange& range : report.picture_ranges) add_picture(range.grid, picture_json(range), json);
  if (const auto& view = report.picture_view)
    json["picture"]["camera"] = {{"eye", view->eye},
                                 {"target", view->target},
                                 {"up", view->up},
                                 {"field_of_view", view->field_of_view},
                                 {"chosen", view->is_chosen}};
  for (const auto& [key, groups] : {std::pair("insulated", &report.insulated), {"given_flux", &report.given_flux}})
    for (const FoundTemperatures& group : *groups)
      json[key].push_back({{"name", group.name},
                           {"channel", group.channel},
                           {"coldest", group.coldest},
                           {"warmest", group.warmest},
                           {"lower", group.lower},
                           {"upper", group.upper}});
  if (!report.unit.empty()) json["unit"] = report.unit;
  if (report.store) json["store"] = nlohmann::ordered_json::parse(store_json(*report.store));
  json["notes"] = report.warnings;
  for (const std::string& note : solution.notes) json["notes"].push_back(note);
  return json.dump(2) + "\n";
}

namespace {

constexpr std::size_t kFluxesInText = 6, kFoundInText = 6;

// The groups and lights with the largest net flux, summed over the channels.
std::string flux_text(const NetFluxes& fluxes) {
  std::vector<std::pair<double, std::string>> largest;
  for (const auto* some : {&fluxes.groups, &fluxes.lights})
    for (const NetFlux& flux : *some) {
      double net = 0;
      for (const NetFlux::Power& power : flux.by_channel) net += power.value;
      if (fluxes.channel_names.back() == "total") net = flux.by_channel.back().value;
      largest.emplace_back(net, flux.name);
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

std::string energies_text(const RadiositySolution& solution, const NetFluxes& fluxes) {
  if (solution.channels.size() != 2)
    return energy_text(solution.channels.size() > 1 ? " in r, g and b together" : "", solution.energy,
                       fluxes.has_sun[0]);
  std::string text;
  for (std::size_t c = 0; c < 2; ++c)
    text +=
        energy_text(" in the " + solution.channel_names[c] + " band", solution.channels[c].energy, fluxes.has_sun[c]);
  return text;
}

// What faces come to: "insulated: 'wall' 287.312 K, 'roof' 265.1 to 271.88 K".
std::string found_text(const char* what, const std::vector<FoundTemperatures>& groups) {
  if (groups.empty()) return "";
  std::string text = what;
  for (std::size_t k = 0; k < std::min(groups.size(), kFoundInText); ++k) {
    const FoundTemperatures& group = groups[k];
    const std::string coldest = fmt::format("{:.6g}", group.coldest), warmest = fmt::format("{:.6g}", group.warmest);
    text += fmt::format("{} {}{} {} K", k == 0 ? "" : ",", quoted_name(group.name),
                        group.channel == "all" ? "" : " (" + group.channel + ")",
                        coldest == warmest ? coldest : coldest + " to " + warmest);
  }
  if (groups.size() > kFoundInText)
    text += fmt::format(" and {} more in temperature.csv", groups.size() - kFoundInText);
  return text + "\n";
}

// What the exposure of a picture came to: all tone curves but linear fit it to the light that there is.
std::string picture_text(const PictureLight& light) {
  std::string text = fmt::format("picture{}: light times {:.6g} by the tone curve {}",
                                 light.grid.empty() ? "" : " " + quoted_name(light.grid), light.scale, light.tone);
  if (light.tone != "linear")
    text += light.exposure == 1 ? ", exposure automatic"
                                : fmt::format(", exposure {:.6g} of the automatic one", light.exposure);
  if (!light.contours.empty()) {
    text += "; contours at";
    for (const double level : light.contours) text += fmt::format(" {:.6g}", level);
  }
  return text + "\n";
}

// Where a camera was chosen, as a scene would say it.
std::string view_text(const PictureView& view) {
  const auto point = [](const std::array<double, 3>& p) {
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", p[0], p[1], p[2]);
  };
  return fmt::format("camera: chosen, as the scene has none: eye {}, target {}, field_of_view {:.4g}\n",
                     point(view.eye), point(view.target), view.field_of_view);
}

}  // namespace

std::string solve_text(const SolveReport& report) {
  const FactorCounts& factors = report.factors;
  const RadiositySolution& solution = *report.solution;
  std::string text =
      fmt::format("{}, {}, {}, {}\n", counted(factors.surfaces, "surface"), counted(factors.elements, "element"),
                  factors.vertices == 1 ? "1 vertex" : std::to_string(factors.vertices) + " vertices",
                  counted(factors.pairs, "visible pair"));
  text += solution.factorizations == 0
              ? "radiosity is emission: nothing had to be solved\n"
              : fmt::format("radiosity by {}: {} in {}, {}, bounds for these elements within {:.1e} of the value\n",
                            to_string(solution.used), counted(solution.unknowns, "unknown"),
                            counted(solution.components, "component"), counted(solution.channels.size(), "channel"),
                            solution.max_relative_width);
  if (factors.sky) text += sky_text(*factors.sky) + "\n";
  if (report.dividing) text += dividing_text(*report.dividing);
  if (report.fluxes->are_in_watts) text += energies_text(solution, *report.fluxes) + flux_text(*report.fluxes);
  text += found_text("insulated:", report.insulated) + found_text("given flux:", report.given_flux);
  if (report.illumination_max_error)
    text += fmt::format("illumination: averages over cells, each within {:.1e} for these radiosities\n",
                        *report.illumination_max_error);
  for (const PictureLight& light : report.picture_lights) text += picture_text(light);
  if (report.picture_view && report.picture_view->is_chosen) text += view_text(*report.picture_view);
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

namespace {

// How many characters a text in UTF-8 has.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// Rows of cells in columns as wide as their widest cell, two blanks apart; the first to the left, the others to the
// right.
std::string in_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], characters(row[k]));
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string blanks(widths[k] - characters(row[k]), ' ');
      text += k == 0 ? row[k] + (row.size() > 1 ? blanks : "") : "  " + blanks + row[k];
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string small_scene_text(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  if (matrix.elements().size() > 2 * kFacesOnAScreen || scene.surfaces.size() > kFacesOnAScreen) return "";
  std::vector<std::vector<std::string>> factors{{"factor to"}};
  for (std::uint32_t j = 0; j <= matrix.sky(); ++j) factors[0].push_back(matrix.name(j));
  std::vector<std::vector<std::string>> radiosities{{"radiosity", "channel", "lower", "value", "upper"}};
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    factors.push_back({matrix.name(i)});
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j)
      factors.back().push_back(fmt::format("{:.10g}", matrix.factor(i, j).value));
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      radiosities.push_back(
          {matrix.name(i), solution.channel_names[c], shortest(r.lower), shortest(r.radiosity), shortest(r.upper)});
    }
  }
  return "\n" + in_columns(factors) + "\n" + in_columns(radiosities);
}

}  // namespace hottel

#include "viewer/picture/shown_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/grey_temperature.h"
#include "geometry/near_names.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel {
namespace {

constexpr std::string_view kToward = "factor:";
constexpr std::array<std::pair<const char*, Quantity>, 5> kWords{{{"light", Quantity::kLight},
                                                                  {"radiosity", Quantity::kRadiosity},
                                                                  {"irradiance", Quantity::kIrradiance},
                                                                  {"net", Quantity::kNet},
                                                                  {"temperature", Quantity::kTemperature}}};

bool has_channels(Quantity quantity) {
  return quantity == Quantity::kRadiosity || quantity == Quantity::kIrradiance || quantity == Quantity::kNet;
}

// The faces that factors go to, by number; empty: the sky.
std::vector<bool> targets_of(const SceneTable& scene, const std::string& toward) {
  if (toward == "sky") return {};
  std::vector<bool> targets(2 * scene.surfaces.size(), false);
  if (toward.ends_with(":back")) {
    targets[face_of(scene, toward).number()] = true;
  } else {
    for (const std::uint32_t s : surfaces_matching(scene, toward)) targets[Face{s, false}.number()] = true;
  }
  return targets;
}

double of_channel(Quantity quantity, const ElementRadiosity& element) {
  switch (quantity) {
    case Quantity::kIrradiance:
      return element.irradiance;
    case Quantity::kNet:
      return element.net();
    default:
      return element.radiosity;
  }
}

// The mean of three channels, the sum of two bands.
double mean(Quantity quantity, const RadiositySolution& solution, std::uint32_t element) {
  double sum = 0;
  for (const ChannelSolution& channel : solution.channels) sum += of_channel(quantity, channel.elements[element]);
  return solution.channels.size() == 2 ? sum : sum / static_cast<double>(solution.channels.size());
}

// Of what comes out, by ElementTemperatures.
double found_temperature(const Material& material, const RadiositySolution& solution, std::uint32_t element) {
  const Rational above = material.power_above_radiosity();
  if (const ElementRadiosity* const solar = solar_of(solution, element))
    return black_temperature(std::max(
        0.0,
        black_power(above, solution.channels[kThermalBand].elements[element], material.resistance(), solar).value));
  return black_temperature(std::max(0.0, mean(Quantity::kRadiosity, solution, element) + to_double(above)));
}

// By material, where it says a temperature.
std::vector<std::optional<double>> temperatures_of(const SceneTable& scene) {
  std::vector<std::optional<double>> result;
  for (const Material& material : scene.materials) {
    const auto exact = grey_temperature(material);
    result.push_back(exact ? std::optional(to_double(*exact)) : std::nullopt);
  }
  return result;
}

// The scale of values by what was asked for (5), (6); largest_radiosity: of all channels.
ColourScale scale_of(const Shown& shown, const std::vector<std::optional<double>>& values, double largest_radiosity) {
  ColourScale scale{.about_zero = shown.quantity == Quantity::kNet};
  scale.logarithmic = shown.scale.is_logarithmic;
  bool is_first = true;
  for (const auto& value : values) {
    if (!value) continue;
    if (scale.logarithmic && !(*value > 0)) {
      scale.has_zero = true;
      continue;
    }
    scale.lower = is_first ? *value : std::min(scale.lower, *value);
    scale.upper = is_first ? *value : std::max(scale.upper, *value);
    is_first = false;
  }
  if (is_first && scale.logarithmic) scale.lower = 1;
  const auto digits = [](double value) { return fmt::format("{:.6g}", value); };
  if (scale.about_zero && std::max(-scale.lower, scale.upper) <= 1e-9 * largest_radiosity)
    scale.lower = scale.upper = 0;
  if (digits(scale.lower) == digits(scale.upper)) scale.upper = scale.lower;
  if (const auto& lower = shown.scale.lower) {
    scale.lower = *lower;
    scale.upper = std::max(scale.upper, *lower);
  }
  if (const auto& upper = shown.scale.upper) {
    scale.upper = *upper;
    scale.lower = std::min(scale.lower, *upper);
  }
  return scale;
}

// "irradiance [W/m²]: 1.2 to 34.5".
std::string title_of(const ShownValues& values) {
  const ColourScale& scale = values.scale;
  std::string title = values.name + (values.unit == "1" ? ": " : " [" + values.unit + "]: ");
  title += fmt::format("{:.6g}", scale.lower);
  if (scale.lower < scale.upper) title += fmt::format(" to {:.6g}", scale.upper);
  return title;
}

std::string name_of(const Shown& shown, const RadiositySolution& solution) {
  std::string name;
  switch (shown.quantity) {
    case Quantity::kFactor:
      return "view factor to " + (shown.toward == "sky" ? "the sky" : shown.toward);
    case Quantity::kTemperature:
      return "temperature";
    case Quantity::kNet:
      name = "net flux";
      break;
    default:
      name = shown.quantity == Quantity::kIrradiance ? "irradiance" : "radiosity";
  }
  if (solution.channels.size() == 1) return name;
  const char* const all = solution.channels.size() == 2 ? ", both bands" : ", mean of r, g, b";
  return name + (shown.channel ? ", " + solution.channel_names[*shown.channel] : all);
}

}  // namespace

Shown shown_by(const std::string& word) {
  for (const auto& [name, quantity] : kWords)
    if (word == name) return {quantity, "", std::nullopt};
  if (word == "sky") return {Quantity::kFactor, "sky", std::nullopt};
  if (word.starts_with(kToward) && word.size() > kToward.size())
    return {Quantity::kFactor, word.substr(kToward.size()), std::nullopt};
  std::vector<std::string> known{"sky"};
  for (const auto& [name, quantity] : kWords) known.emplace_back(name);
  throw UnknownName(
      "nothing that can be shown is called '" + word +
          "': light, radiosity, irradiance, net, temperature, sky, or factor:NAME for the view factor to NAME",
      word, known);
}

AskedScale scale_by(const std::string& text) {
  AskedScale scale;
  std::string ends = text;
  if (ends == "log" || ends.ends_with(":log")) {
    scale.is_logarithmic = true;
    ends.resize(ends.size() - std::min<std::size_t>(ends.size(), 4));
    if (ends.empty()) return scale;
  }
  const auto colon = ends.find(':');
  const auto end = [&](const std::string& word) -> std::optional<double> {
    if (word.empty()) return std::nullopt;
    double value = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || rest != word.data() + word.size() || !std::isfinite(value))
      throw UsageError("--bar takes LOW:HIGH, LOW:HIGH:log or log, not '" + text + "'");
    return value;
  };
  if (colon == std::string::npos) end(ends + ":");  // no number
  scale.lower = end(ends.substr(0, colon));
  scale.upper = end(ends.substr(colon + 1));
  return scale;
}

void choose_channel(Shown& shown, const std::string& word) {
  constexpr std::string_view kColours = "rgb";
  shown.is_of_band = word == "solar" || word == "thermal";
  const std::size_t colour = word.size() == 1 ? kColours.find(word) : std::string_view::npos;
  if (!shown.is_of_band && colour == std::string_view::npos)
    throw UnknownName("there is no channel called '" + word + "': r, g, b, solar, thermal", word,
                      std::vector<std::string>{"r", "g", "b", "solar", "thermal"});
  shown.channel = !shown.is_of_band ? colour : word == "solar" ? kSolarBand : kThermalBand;
}

void require_shown(const Shown& shown, const SceneTable& scene) {
  if (shown.channel && !has_channels(shown.quantity))
    throw UsageError("--channel goes with --show radiosity, irradiance or net");
  if (shown.channel && channel_count(scene) == 1)
    throw UsageError(scene.file + " has one channel for all: there is no --channel to choose");
  if (shown.channel && shown.is_of_band != scene.has_bands)
    throw UsageError(scene.file + (scene.has_bands ? " has two bands: --channel is solar or thermal"
                                                   : " has three channels: --channel is r, g or b"));
  const auto& [lower, upper, is_logarithmic] = shown.scale;
  if (shown.is_light() && (lower || upper || is_logarithmic))
    throw UsageError("a picture of light has no scale: --bar goes with what else --show takes");
  if (lower && upper && !(*lower < *upper)) throw UsageError("--bar: the first end has to be below the second one");
  if (is_logarithmic && shown.quantity == Quantity::kNet)
    throw UsageError("--bar: a net flux has a sign, so its scale is not logarithmic");
  for (const auto& end : {lower, upper})
    if (is_logarithmic && end && !(*end > 0)) throw UsageError("--bar: a logarithmic scale has its ends above 0");
  if (shown.quantity == Quantity::kFactor) targets_of(scene, shown.toward);
  if (shown.quantity != Quantity::kTemperature) return;
  const std::vector<std::optional<double>> temperatures = temperatures_of(scene);
  const auto is_warm = [&](std::optional<std::uint32_t> material) {
    return material && (scene.materials[*material].is_insulated() || scene.materials[*material].has_given_flux() ||
                        (temperatures[*material] && *temperatures[*material] > 0));
  };
  if (std::none_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
        return is_warm(surface.material_of(false)) || is_warm(surface.material_of(true));
      }))
    throw UsageError(
        "--show temperature: no face of " + scene.file +
        " has one; materials with \"emissivity\" and \"temperature\" or \"flux\" have, or \"insulated\" ones");
}

ShownValues shown_values(const Shown& shown, const SceneTable& scene, const ExchangeMatrix& matrix,
                         const RadiositySolution& solution, const std::string& unit) {
  HOTTEL_REQUIRE(!shown.is_light());
  const std::vector<bool> targets =
      shown.quantity == Quantity::kFactor ? targets_of(scene, shown.toward) : std::vector<bool>();
  const std::vector<std::optional<double>> temperatures = temperatures_of(scene);
  const auto factor = [&](std::uint32_t i) {
    if (shown.toward == "sky") return matrix.factor(i, matrix.sky()).value;
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) {
      if (entry.to == matrix.sky()) continue;
      const Element& to = matrix.elements()[entry.to];
      if (targets[Face{to.surface, to.is_back}.number()]) sum += entry.factor.value;
    }
    return sum;
  };
  const auto value = [&](std::uint32_t i) -> std::optional<double> {
    const std::uint32_t material = *matrix.elements()[i].material;
    if (shown.quantity == Quantity::kFactor) return factor(i);
    if (shown.quantity != Quantity::kTemperature)
      return shown.channel ? of_channel(shown.quantity, solution.channels[*shown.channel].elements[i])
                           : mean(shown.quantity, solution, i);
    if (scene.materials[material].is_adiabatic() || scene.materials[material].has_given_flux())
      return found_temperature(scene.materials[material], solution, i);
    return temperatures[material];
  };

  ShownValues result;
  result.elements.resize(matrix.size());
  double largest_radiosity = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    result.elements[i] = value(i);
    for (const ChannelSolution& channel : solution.channels)
      largest_radiosity = std::max(largest_radiosity, channel.elements[i].radiosity);
  }
  result.scale = scale_of(shown, result.elements, largest_radiosity);
  result.name = name_of(shown, solution);
  result.unit = shown.quantity == Quantity::kFactor ? "1" : shown.quantity == Quantity::kTemperature ? "K" : unit;
  result.title = title_of(result);
  return result;
}

std::vector<double> ShownValues::numbers() const {
  std::vector<double> result;
  for (const std::optional<double>& value : elements)
    result.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  return result;
}

bool is_of_points(const Shown& shown) {
  return shown.quantity == Quantity::kIrradiance || shown.quantity == Quantity::kTemperature ||
         (shown.quantity == Quantity::kFactor && shown.toward == "sky");
}

namespace {

double value_at_point(const Shown& shown, const OrientedLight& light) {
  if (shown.quantity == Quantity::kTemperature) return mean_radiant_temperature(light.mean_irradiance);
  if (shown.quantity == Quantity::kFactor) return light.sky_view_factor;
  if (shown.channel) return light.irradiance[*shown.channel];
  const double sum = std::accumulate(light.irradiance.begin(), light.irradiance.end(), 0.0);
  return light.irradiance.size() == 2 ? sum : sum / static_cast<double>(light.irradiance.size());
}

std::string name_at_points(const Shown& shown, const std::vector<std::string>& channel_names) {
  if (shown.quantity == Quantity::kTemperature) return "mean radiant temperature";
  if (shown.quantity == Quantity::kFactor) return "sky view factor";
  if (channel_names.size() == 1) return "irradiance";
  const char* const all = channel_names.size() == 2 ? ", both bands" : ", mean of r, g, b";
  return "irradiance" + (shown.channel ? ", " + channel_names[*shown.channel] : std::string(all));
}

}  // namespace

ShownValues shown_at_points(const Shown& shown, const std::vector<OrientedLight>& lights,
                            const std::vector<std::string>& channel_names, const std::string& unit) {
  HOTTEL_REQUIRE(is_of_points(shown));
  ShownValues result;
  for (const OrientedLight& light : lights) {
    const double value = value_at_point(shown, light);
    result.elements.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
  }
  result.scale = scale_of(shown, result.elements, 0);
  result.name = name_at_points(shown, channel_names);
  result.unit = shown.quantity == Quantity::kFactor ? "1" : shown.quantity == Quantity::kTemperature ? "K" : unit;
  result.title = title_of(result);
  return result;
}

void share_scale(const Shown& shown, ShownValues& faces, ShownValues& points) {
  std::vector<std::optional<double>> all = faces.elements;
  all.insert(all.end(), points.elements.begin(), points.elements.end());
  faces.scale = points.scale = scale_of(shown, all, 0);
  faces.title = title_of(faces);
}

}  // namespace hottel

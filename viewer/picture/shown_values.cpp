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

#include "geometry/face.h"
#include "geometry/gray_temperature.h"
#include "geometry/near_names.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "kernel/support/word_list.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel {
namespace {

constexpr std::string_view kToward = "factor:";

// What a quantity is called, and how it is had.
struct QuantityRow {
  Quantity quantity;
  const char* word;                                         // of --show
  const char* name;                                         // of its bar
  double (*of_element)(const ElementRadiosity&) = nullptr;  // by channel; null: there is one value for all
  const char* unit = kRadiosityUnit;
  bool has_sign = false;                 // colours part at 0
  const char* name_at_points = nullptr;  // null: it is none of points
};

// The one place that says so. A factor is asked for by `sky` or `factor:NAME`.
constexpr std::array<QuantityRow, 6> kQuantities{{
    {.quantity = Quantity::kLight, .word = "light", .name = "light"},
    {.quantity = Quantity::kRadiosity,
     .word = "radiosity",
     .name = "radiosity",
     .of_element = [](const ElementRadiosity& element) { return element.radiosity; }},
    {.quantity = Quantity::kIrradiance,
     .word = "irradiance",
     .name = "irradiance",
     .of_element = [](const ElementRadiosity& element) { return element.irradiance; },
     .name_at_points = "irradiance"},
    {.quantity = Quantity::kNet,
     .word = "net",
     .name = "net flux",
     .of_element = [](const ElementRadiosity& element) { return element.net(); },
     .has_sign = true},
    {.quantity = Quantity::kTemperature,
     .word = "temperature",
     .name = "temperature",
     .unit = "K",
     .name_at_points = "mean radiant temperature"},
    {.quantity = Quantity::kFactor,
     .word = "sky",
     .name = "view factor",
     .unit = "1",
     .name_at_points = "sky view factor"},
}};

const QuantityRow& row_of(const Shown& shown) {
  return *std::ranges::find(kQuantities, shown.quantity, &QuantityRow::quantity);
}

// "radiosity, irradiance or net": those that fit.
std::string words_of(bool (*fits)(const QuantityRow&), const std::string& before_last) {
  std::vector<std::string> words;
  for (const QuantityRow& row : kQuantities)
    if (fits(row)) words.emplace_back(row.word);
  return word_list(words, before_last);
}

// The faces that factors go to, by number; empty: the sky.
std::vector<bool> targets_of(const SceneTable& scene, const std::string& toward) {
  if (toward == "sky") return {};
  std::vector<bool> targets(2 * scene.surfaces.size(), false);
  const SideName side = side_named(toward);
  for (const std::uint32_t s : surfaces_matching(scene, side.name)) targets[Face{s, side.is_back}.number()] = true;
  return targets;
}

// The mean of three channels, the sum of two bands.
double mean(double (*of_element)(const ElementRadiosity&), const RadiositySolution& solution, std::uint32_t element) {
  double sum = 0;
  for (const ChannelSolution& channel : solution.channels) sum += of_element(channel.elements[element]);
  return solution.channels.size() == 2 ? sum : sum / static_cast<double>(solution.channels.size());
}

// Of what comes out, by ElementTemperatures.
double found_temperature(const Material& material, const RadiositySolution& solution, std::uint32_t element) {
  const Rational above = material.power_above_radiosity();
  if (const ElementRadiosity* const solar = solar_of(solution, element))
    return black_temperature(std::max(
        0.0,
        black_power(above, solution.channels[kThermalBand].elements[element], material.resistance(), solar).value));
  return black_temperature(
      std::max(0.0, mean([](const ElementRadiosity& e) { return e.radiosity; }, solution, element) + to_double(above)));
}

// By material, where it says a temperature.
std::vector<std::optional<double>> temperatures_of(const SceneTable& scene) {
  std::vector<std::optional<double>> result;
  for (const Material& material : scene.materials) {
    const auto exact = gray_temperature(material);
    result.push_back(exact ? std::optional(to_double(*exact)) : std::nullopt);
  }
  return result;
}

// Of the elements that have one.
std::vector<AreaValue> area_values(const ShownValues& shown) {
  std::vector<AreaValue> result;
  for (std::size_t k = 0; k < shown.elements.size(); ++k)
    if (shown.elements[k]) result.push_back({*shown.elements[k], shown.areas.empty() ? 1 : shown.areas[k]});
  return result;
}

// The same, all areas together 1.
std::vector<AreaValue> shares(const ShownValues& shown) {
  std::vector<AreaValue> result = area_values(shown);
  double all = 0;
  for (const AreaValue& each : result) all += each.area;
  for (AreaValue& each : result) each.area = all > 0 ? each.area / all : 1.0 / static_cast<double>(result.size());
  return result;
}

// largest_radiosity: of all channels.
void fit(const Shown& shown, std::vector<AreaValue> values, double largest_radiosity, ShownValues& result) {
  const FittedScale fitted = fitted_scale(std::move(values), shown.scale,
                                          {.has_sign = row_of(shown).has_sign, .noise = 1e-9 * largest_radiosity});
  result.scale = fitted.scale;
  result.least = fitted.least;
  result.greatest = fitted.greatest;
}

// "irradiance [W/m²]: 1.2 to 34.5", and where the scale is cut ", values to 980".
std::string title_of(const ShownValues& values) {
  const ColourScale& scale = values.scale;
  std::string title = values.name + (values.unit == "1" ? ": " : " [" + values.unit + "]: ");
  title += fmt::format("{:.6g}", scale.lower);
  if (scale.lower < scale.upper) title += fmt::format(" to {:.6g}", scale.upper);
  if (scale.cuts_lower || scale.cuts_upper) title += ", values";
  if (scale.cuts_lower) title += fmt::format(" from {:.6g}", values.least);
  if (scale.cuts_upper) title += fmt::format(" to {:.6g}", values.greatest);
  return title;
}

// "irradiance, mean of r, g, b", where a quantity has several channels.
std::string with_channel(const Shown& shown, const char* name, const std::vector<std::string>& channel_names) {
  if (row_of(shown).of_element == nullptr || channel_names.size() == 1) return name;
  const char* const all = channel_names.size() == 2 ? ", both bands" : ", mean of r, g, b";
  return name + (shown.channel ? ", " + channel_names[*shown.channel] : std::string(all));
}

std::string name_of(const Shown& shown, const std::vector<std::string>& channel_names) {
  const std::string toward = shown.quantity != Quantity::kFactor ? ""
                             : shown.toward == "sky"             ? " to the sky"
                                                                 : " to " + shown.toward;
  return with_channel(shown, row_of(shown).name, channel_names) + toward;
}

}  // namespace

std::optional<Shown> shown_called(const std::string& name, const std::vector<std::string>& channel_names) {
  for (const Quantity quantity : {Quantity::kRadiosity, Quantity::kIrradiance, Quantity::kNet}) {
    Shown shown{.quantity = quantity};
    if (name_of(shown, channel_names) == name) return shown;
    for (std::size_t c = 0; c < channel_names.size(); ++c) {
      shown.channel = c;
      if (name_of(shown, channel_names) == name) return shown;
    }
  }
  return std::nullopt;
}

std::string words_to_show() {
  return words_of([](const QuantityRow& row) { return row.quantity != Quantity::kLight; }, ", ") +
         " (view factor to it), factor:NAME (view factor to a face, a group, or all that a pattern like 'win*' or "
         "'w[1-3]' describes)";
}

std::string words_to_show_at_points() {
  return words_of([](const QuantityRow& row) { return row.name_at_points != nullptr; }, " and ");
}

Shown shown_by(const std::string& word) {
  for (const QuantityRow& row : kQuantities)
    if (word == row.word) return {row.quantity, row.quantity == Quantity::kFactor ? word : "", std::nullopt};
  if (word.starts_with(kToward) && word.size() > kToward.size())
    return {Quantity::kFactor, word.substr(kToward.size()), std::nullopt};
  std::vector<std::string> known;
  for (const QuantityRow& row : kQuantities) known.emplace_back(row.word);
  throw UnknownName("nothing that can be shown is called '" + word +
                        "': " + words_of([](const QuantityRow&) { return true; }, ", ") +
                        ", or factor:NAME for the view factor to NAME",
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
  if (shown.channel && row_of(shown).of_element == nullptr)
    throw UsageError("--channel goes with --show " +
                     words_of([](const QuantityRow& row) { return row.of_element != nullptr; }, " or "));
  if (shown.channel && channel_count(scene) == 1)
    throw UsageError(scene.file + " has one channel for all: there is no --channel to choose");
  if (shown.channel && shown.is_of_band != scene.has_bands)
    throw UsageError(scene.file + (scene.has_bands ? " has two bands: --channel is solar or thermal"
                                                   : " has three channels: --channel is r, g or b"));
  const auto& [lower, upper, is_logarithmic] = shown.scale;
  if (shown.is_light() && (lower || upper || is_logarithmic))
    throw UsageError("a picture of light has no scale: --bar goes with what else --show takes");
  if (lower && upper && !(*lower < *upper)) throw UsageError("--bar: the first end has to be below the second one");
  if (is_logarithmic && row_of(shown).has_sign)
    throw UsageError(fmt::format("--bar: a {} has a sign, so its scale is not logarithmic", row_of(shown).name));
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
                         const RadiositySolution& solution) {
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
    if (const auto of_element = row_of(shown).of_element)
      return shown.channel ? of_element(solution.channels[*shown.channel].elements[i]) : mean(of_element, solution, i);
    if (shown.quantity == Quantity::kFactor) return factor(i);
    HOTTEL_REQUIRE(shown.quantity == Quantity::kTemperature);
    const std::uint32_t material = *matrix.elements()[i].material;
    if (scene.materials[material].is_adiabatic() || scene.materials[material].has_given_flux())
      return found_temperature(scene.materials[material], solution, i);
    return temperatures[material];
  };

  ShownValues result;
  result.elements.resize(matrix.size());
  result.areas.resize(matrix.size());
  double largest_radiosity = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    result.elements[i] = value(i);
    result.areas[i] = matrix.elements()[i].area.value;
    for (const ChannelSolution& channel : solution.channels)
      largest_radiosity = std::max(largest_radiosity, channel.elements[i].radiosity);
  }
  fit(shown, area_values(result), largest_radiosity, result);
  result.name = name_of(shown, solution.channel_names);
  result.unit = row_of(shown).unit;
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
  return row_of(shown).name_at_points != nullptr && (shown.quantity != Quantity::kFactor || shown.toward == "sky");
}

bool needs_a_side(const Shown& shown) { return is_of_points(shown) && shown.quantity != Quantity::kTemperature; }

namespace {

double value_at_point(const Shown& shown, const OrientedLight& light) {
  if (shown.quantity == Quantity::kTemperature) return mean_radiant_temperature(light.mean_irradiance);
  if (shown.quantity == Quantity::kFactor) return light.sky_view_factor;
  HOTTEL_REQUIRE(shown.quantity == Quantity::kIrradiance);
  if (shown.channel) return light.irradiance[*shown.channel];
  const double sum = std::accumulate(light.irradiance.begin(), light.irradiance.end(), 0.0);
  return light.irradiance.size() == 2 ? sum : sum / static_cast<double>(light.irradiance.size());
}

}  // namespace

ShownValues shown_at_points(const Shown& shown, const std::vector<OrientedLight>& lights,
                            const std::vector<std::string>& channel_names) {
  HOTTEL_REQUIRE(is_of_points(shown));
  ShownValues result;
  for (const OrientedLight& light : lights) {
    const double value = value_at_point(shown, light);
    result.elements.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
  }
  fit(shown, area_values(result), 0, result);
  result.name = with_channel(shown, row_of(shown).name_at_points, channel_names);
  result.unit = row_of(shown).unit;
  result.title = title_of(result);
  return result;
}

void share_scale(const Shown& shown, ShownValues& faces, ShownValues& points) {
  std::vector<AreaValue> all = shares(faces);
  const std::vector<AreaValue> of_points = shares(points);
  all.insert(all.end(), of_points.begin(), of_points.end());
  fit(shown, std::move(all), 0, faces);
  points.scale = faces.scale;
  points.least = faces.least;
  points.greatest = faces.greatest;
  faces.title = title_of(faces);
}

}  // namespace hottel

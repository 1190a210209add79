#include "solver/radiosity/element_temperatures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/gray_temperature.h"
#include "geometry/name.h"
#include "kernel/decimal.h"
#include "kernel/doubles.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/printed_number.h"

namespace hottel {
namespace {

// What a black body of 1 K sends out: sigma.
const Rational& stefan_boltzmann() {
  static const Rational sigma = black_emission(Spectrum::scalar(1)).value[0];
  return sigma;
}

// What a black body of this temperature sends out, exactly.
Rational power_of(double temperature) {
  const Rational t = exact_value(temperature);
  return stefan_boltzmann() * t * t * t * t;
}

}  // namespace

// Where a quotient would have fewer digits than doubles have, 2^200 times the power is asked, exactly.
double black_temperature(double power) {
  static const double sigma = to_double(stefan_boltzmann());
  if (power < 0x1p-900) return std::ldexp(std::sqrt(std::sqrt(std::ldexp(power, 200) / sigma)), -50);
  return std::sqrt(std::sqrt(power / sigma));
}

BoundedTemperature black_temperature(double power, const Enclosure& bounds) {
  HOTTEL_REQUIRE(0 <= bounds.lower && bounds.contains(power));
  BoundedTemperature result;
  result.lower = black_temperature(bounds.lower);
  if (std::isfinite(result.lower)) {
    const Rational least = exact_value(bounds.lower);
    while (result.lower > 0 && power_of(result.lower) > least) result.lower = std::nextafter(result.lower, 0);
    for (double above; power_of(above = std::nextafter(result.lower, kInfinity)) <= least;) result.lower = above;
  }
  result.upper = black_temperature(bounds.upper);
  if (std::isfinite(result.upper)) {
    const Rational most = exact_value(bounds.upper);
    while (power_of(result.upper) < most) result.upper = std::nextafter(result.upper, kInfinity);
    for (double below; result.upper > 0 && power_of(below = std::nextafter(result.upper, 0)) >= most;)
      result.upper = below;
  }
  result.value = std::clamp(black_temperature(power), result.lower, result.upper);
  return result;
}

ElementTemperatures::ElementTemperatures(const std::vector<Material>& materials) {
  for (const Material& material : materials) {
    const auto exact = gray_temperature(material);
    const bool is_in_range = exact && std::isfinite(to_double(*exact));
    if (is_in_range) {
      const double nearest = to_double(*exact);
      const Rational rounded = exact_value(nearest);
      typed_.push_back(BoundedTemperature{nearest, rounded > *exact ? std::nextafter(nearest, 0) : nearest,
                                          rounded < *exact ? std::nextafter(nearest, HUGE_VAL) : nearest});
    } else {
      typed_.push_back(std::nullopt);
    }
    comes_out_.push_back(material.is_adiabatic() || material.has_given_flux());
    is_known_.push_back(material.is_insulated() || material.has_given_flux() || (exact && *exact > 0));
    above_radiosity_.push_back(material.power_above_radiosity());
    resistance_.push_back(material.resistance());
  }
}

std::optional<BoundedTemperature> ElementTemperatures::of(std::uint32_t material, const ElementRadiosity& element,
                                                          const ElementRadiosity* solar) const {
  if (!comes_out_[material]) return typed_[material];
  const BlackPower power = black_power(above_radiosity_[material], element, resistance_[material], solar);
  // Below 0 by roundings, or because nothing is proven and some factors are below 0.
  const bool is_nearly_zero = power.value < 0 && power.bounds.upper >= 0 && std::isfinite(power.bounds.upper);
  if (!(power.value >= 0) && !is_nearly_zero) return std::nullopt;
  return black_temperature(std::max(power.value, 0.0), {std::max(power.bounds.lower, 0.0), power.bounds.upper});
}

std::optional<BoundedTemperature> ElementTemperatures::of(std::uint32_t material, const RadiositySolution& solution,
                                                          std::size_t channel, std::uint32_t i) const {
  const ElementRadiosity* const solar = solar_of(solution, i);
  if (solar && channel == kSolarBand) return std::nullopt;
  return of(material, solution.channels[channel].elements[i], solar);
}

BlackPower black_power(const Rational& above_radiosity, const ElementRadiosity& element, const Rational& resistance,
                       const ElementRadiosity* solar) {
  // What is gained in the solar band is the opposite of the net flux there.
  const auto shifted = [&](double radiosity, double solar_net, auto rounded) {
    const bool is_gain = solar && resistance != 0 && solar_net != 0;
    if (is_gain && !std::isfinite(solar_net)) return solar_net > 0 ? -HUGE_VAL : HUGE_VAL;
    if ((above_radiosity == 0 && !is_gain) || !std::isfinite(radiosity)) return radiosity;
    const Rational gain = is_gain ? Rational(resistance * exact_value(solar_net)) : Rational(0);
    return rounded(exact_value(radiosity) + above_radiosity - gain);
  };
  const ElementRadiosity none;
  const ElementRadiosity& gained = solar ? *solar : none;
  const double value = shifted(element.radiosity, gained.net_value, [](const Rational& sum) { return to_double(sum); });
  // Where little is proven, as of factors that do not close, bounds may be open, or none at all.
  const double lower = std::isnan(element.lower) ? -HUGE_VAL : shifted(element.lower, gained.net_upper, rounded_down);
  const double upper = std::isnan(element.upper) ? HUGE_VAL : shifted(element.upper, gained.net_lower, rounded_up);
  return {value, {std::min(lower, value), std::max(upper, value)}};
}

std::optional<std::uint32_t> first_without_emissivity(const ExchangeMatrix& matrix,
                                                      const std::vector<Material>& materials,
                                                      const RadiositySolution& solution) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Material& material = materials[*matrix.elements()[i].material];
    const ElementRadiosity* const solar = solar_of(solution, i);
    if (!solar || !material.keeps_gains() || material.has_given_flux()) continue;
    if (solar->net_lower != 0 || solar->net_upper != 0) return i;
  }
  return std::nullopt;
}

std::string text_without_emissivity(const Element& element, const std::vector<Material>& materials) {
  return fmt::format(
      "no temperature: '{}' is insulated and gains light in the solar band, which it has to give away by radiation: "
      "give its material {} an \"emissivity\" beside \"insulated\"",
      element.name, quoted_name(materials[*element.material].name));
}

namespace {

// Visits sigma T⁴ of all elements whose temperature comes out, in each channel, until one visit says that it is enough.
template <class Visit>
void for_each_found_power(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                          const RadiositySolution& solution, const Visit& is_enough) {
  std::vector<Rational> above, resistance;  // by material
  for (const Material& material : materials) {
    above.push_back(material.power_above_radiosity());
    resistance.push_back(material.resistance());
  }
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const std::uint32_t m = *matrix.elements()[i].material;
    if (!materials[m].has_given_flux() && !materials[m].is_adiabatic()) continue;
    const ElementRadiosity* const solar = solar_of(solution, i);
    for (std::size_t c = solar ? kThermalBand : 0; c < solution.channels.size(); ++c)
      if (is_enough(i, black_power(above[m], solution.channels[c].elements[i], resistance[m], solar))) return;
  }
}

}  // namespace

std::optional<ElementBelowZero> coldest_below_zero(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                                   const RadiositySolution& solution) {
  std::optional<ElementBelowZero> coldest;
  for_each_found_power(matrix, materials, solution, [&](std::uint32_t i, const BlackPower& power) {
    const double most = power.bounds.upper;
    if (most < 0 && (!coldest || most < coldest->power)) coldest = ElementBelowZero{i, most};
    return false;
  });
  return coldest;
}

std::optional<BeyondDoubles> temperature_beyond_doubles(const ExchangeMatrix& matrix,
                                                        const std::vector<Material>& materials,
                                                        const RadiositySolution& solution) {
  std::optional<BeyondDoubles> beyond;
  for_each_found_power(matrix, materials, solution, [&](std::uint32_t i, const BlackPower& power) {
    if (std::isinf(power.value) && power.value > 0)
      beyond =
          BeyondDoubles{fmt::format("sigma T^4 of '{}' is beyond the range of doubles", matrix.elements()[i].name), i};
    return beyond.has_value();
  });
  return beyond;
}

std::string text_of(const ElementBelowZero& cold, const ExchangeMatrix& matrix,
                    const std::vector<Material>& materials) {
  const Element& element = matrix.elements()[cold.element];
  const Material& material = materials[*element.material];
  return fmt::format(
      "no temperature: '{}' would have to be colder than 0 K, sigma T^4 {:.6g}, to {}", element.name, cold.power,
      material.has_given_flux() ? fmt::format("have the net flux {}", short_text(material.thermal(material.emission)))
                                : std::string("send back what it receives"));
}

}  // namespace hottel

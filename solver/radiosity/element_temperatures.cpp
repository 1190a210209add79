#include "solver/radiosity/element_temperatures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/grey_temperature.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

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

double black_temperature(double power) {
  static const double sigma = to_double(stefan_boltzmann());
  return std::sqrt(std::sqrt(power / sigma));
}

BoundedTemperature black_temperature(double power, const Enclosure& bounds) {
  HOTTEL_REQUIRE(0 <= bounds.lower && bounds.contains(power));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
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
    const auto exact = grey_temperature(material);
    const bool is_in_range = exact && std::isfinite(to_double(*exact));
    if (is_in_range) {
      const double nearest = to_double(*exact);
      const Rational rounded = exact_value(nearest);
      typed_.push_back(BoundedTemperature{nearest, rounded > *exact ? std::nextafter(nearest, 0) : nearest,
                                          rounded < *exact ? std::nextafter(nearest, HUGE_VAL) : nearest});
    } else {
      typed_.push_back(std::nullopt);
    }
    is_adiabatic_.push_back(material.is_adiabatic());
    is_known_.push_back(material.is_insulated() || (exact && *exact > 0));
  }
}

std::optional<BoundedTemperature> ElementTemperatures::of(std::uint32_t material,
                                                          const ElementRadiosity& element) const {
  if (!is_adiabatic_[material]) return typed_[material];
  if (!(element.radiosity >= 0)) return std::nullopt;
  // Where little is proven, as of factors that do not close, bounds may be open, or none at all.
  const double lower = element.lower > 0 ? std::min(element.lower, element.radiosity) : 0;
  const double upper = std::isnan(element.upper) ? HUGE_VAL : std::max(element.upper, element.radiosity);
  return black_temperature(element.radiosity, {lower, upper});
}

}  // namespace hottel

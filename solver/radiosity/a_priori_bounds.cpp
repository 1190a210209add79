#include "solver/radiosity/a_priori_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/irradiance.h"

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double rounded_down(const Rational& value) {
  const double nearest = to_double(value);
  return Rational(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}

double rounded_up(const Rational& value) {
  const double nearest = to_double(value);
  return std::isfinite(nearest) && Rational(nearest) < value ? std::nextafter(nearest, kInfinity) : nearest;
}

// The most that anything in the scene sends out; nothing when there is no bound.
std::optional<Rational> most_sent(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, std::size_t channel) {
  Rational most = sky_emission.value[channel];
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Material& material = materials[*matrix.elements()[i].material];
    const Rational& emission = material.emission.value[channel];
    const Rational loss = 1 - material.reflectivity.value[channel];
    if (emission == 0) continue;
    if (loss == 0) return std::nullopt;
    most = std::max<Rational>(most, emission / loss);
  }
  return most;
}

// Bounds that hold for any factors.
struct CrudeBounds {
  Enclosure radiosity, net;
};

CrudeBounds crude_bounds(const Rational& emission, const Rational& reflectivity, const std::optional<Rational>& most) {
  const double least = rounded_down(emission);
  return {{least, reflectivity == 0 ? rounded_up(emission)
                  : most            ? rounded_up(emission + reflectivity * *most)
                                    : kInfinity},
          {reflectivity == 1 ? least
           : most            ? rounded_down(emission - (1 - reflectivity) * *most)
                             : -kInfinity,
           rounded_up(emission)}};
}

Enclosure both(const Enclosure& a, const Enclosure& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace

void set_a_priori_bounds(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                         const Spectrum& sky_emission, RadiositySolution& solution) {
  HOTTEL_REQUIRE(solution.guarantee != Guarantee::kEstimated);
  solution.max_relative_width = 0;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    ChannelSolution& channel = solution.channels[c];
    channel.max_relative_width = 0;
    const std::optional<Rational> most = most_sent(matrix, materials, sky_emission, c);
    bool is_any_moved = false;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const Material& material = materials[*matrix.elements()[i].material];
      const Rational &emission = material.emission.value[c], &reflectivity = material.reflectivity.value[c];
      ElementRadiosity& element = channel.elements[i];
      CrudeBounds bounds = crude_bounds(emission, reflectivity, most);
      bounds.radiosity = both(bounds.radiosity, {element.lower, element.upper});
      bounds.net = both(bounds.net, {element.net_lower, element.net_upper});
      const double moved = std::clamp(element.radiosity, bounds.radiosity.lower, bounds.radiosity.upper);
      is_any_moved |= moved != element.radiosity;
      element.radiosity = moved;
      element.net_value = std::clamp(element.net_value, bounds.net.lower, bounds.net.upper);
      element.lower = bounds.radiosity.lower;
      element.upper = bounds.radiosity.upper;
      element.net_lower = bounds.net.lower;
      element.net_upper = bounds.net.upper;
      if (element.radiosity > 0)
        channel.max_relative_width =
            std::max(channel.max_relative_width, (element.upper - element.lower) / element.radiosity);
    }
    if (is_any_moved) set_irradiances(matrix, sky_emission.value[c], channel);
    solution.max_relative_width = std::max(solution.max_relative_width, channel.max_relative_width);
  }
}

}  // namespace hottel

#include "solver/radiosity/a_priori_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "kernel/doubles.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/irradiance.h"
#include "solver/radiosity/printed_number.h"
#include "solver/radiosity/unbounded_rows.h"

namespace hottel {
namespace {

const RationalEnclosure kNothing{};

const RationalEnclosure& direct_of(const RadiositySources& sources, std::uint32_t element, int channel) {
  return sources.direct_irradiance.empty() ? kNothing : sources.direct_irradiance[element][channel];
}

// The most that anything in the scene sends out; nothing when there is no bound.
std::optional<Rational> most_sent(const ExchangeMatrix& matrix, const std::vector<Rational>& reflectivity,
                                  const RadiositySources& sources, int channel) {
  Rational most = sources.sky[channel].upper;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Rational& rho = reflectivity[*matrix.elements()[i].material];
    const Rational loss = 1 - rho;
    const Rational sent = sources.emission[i][channel].upper + rho * direct_of(sources, i, channel).upper;
    if (sent == 0) continue;
    if (loss == 0) return std::nullopt;
    most = std::max<Rational>(most, sent / loss);
  }
  return most;
}

// Bounds that hold for any factors.
struct CrudeBounds {
  Enclosure radiosity, net;
};

CrudeBounds crude_bounds(const RationalEnclosure& emission, const RationalEnclosure& direct,
                         const Rational& reflectivity, const std::optional<Rational>& most) {
  const Rational loss = 1 - reflectivity;
  return {{rounded_down(emission.lower), reflectivity == 0 ? rounded_up(emission.upper)
                                         : most ? rounded_up(emission.upper + reflectivity * (*most + direct.upper))
                                                : kInfinity},
          {loss == 0 ? rounded_down(emission.lower)
           : most    ? rounded_down(emission.lower - loss * (*most + direct.upper))
                     : -kInfinity,
           rounded_up(emission.upper - loss * direct.lower)}};
}

Enclosure both(const Enclosure& a, const Enclosure& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace

void set_a_priori_bounds(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                         const Spectrum& sky_emission, RadiositySolution& solution) {
  set_a_priori_bounds(matrix, reflectivities_of(materials), sources_of(matrix, materials, sky_emission), solution);
}

void set_a_priori_bounds(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity,
                         const RadiositySources& sources, RadiositySolution& solution) {
  HOTTEL_REQUIRE(solution.guarantee != Guarantee::kEstimated);
  if (!sources.withdrawn.empty()) return;
  const std::vector<std::string> before = notes_of_unbounded_rows(matrix, solution);
  std::erase_if(solution.notes,
                [&](const std::string& note) { return std::find(before.begin(), before.end(), note) != before.end(); });
  solution.max_relative_width = 0;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    ChannelSolution& channel = solution.channels[c];
    if (sources.has_bands && c == kThermalBand) {  // its sources are more than these
      solution.max_relative_width = std::max(solution.max_relative_width, channel.max_relative_width);
      continue;
    }
    channel.max_relative_width = 0;
    const int of = static_cast<int>(c);
    const std::vector<Rational> rho = in_channel(reflectivity, of);
    const std::optional<Rational> most = most_sent(matrix, rho, sources, of);
    bool is_any_moved = false;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      ElementRadiosity& element = channel.elements[i];
      CrudeBounds bounds =
          crude_bounds(sources.emission[i][of], direct_of(sources, i, of), rho[*matrix.elements()[i].material], most);
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
    if (is_any_moved) set_irradiances(matrix, sources, of, channel);
    solution.max_relative_width = std::max(solution.max_relative_width, channel.max_relative_width);
  }
  for (std::string& note : notes_of_unbounded_rows(matrix, solution)) solution.notes.push_back(std::move(note));
}

}  // namespace hottel

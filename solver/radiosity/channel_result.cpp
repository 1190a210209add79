#include "solver/radiosity/channel_result.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "solver/radiosity/matrix_checks.h"

namespace hottel {
ChannelResults::ChannelResults(const RadiositySystem& system, const std::vector<Rational>& reflectivity,
                               bool is_refined)
    : system_(system), is_refined_(is_refined) {
  for (const Rational& rho : reflectivity) {
    reflectivity_.push_back(to_double(rho));
    loss_.push_back(ScaledBall::of(Rational(1 - rho)));
  }
}

void ChannelResults::fill(const RadiositySources& given, int channel, const Sources& sources,
                          const CertifiedBounds& bounds, FactorsMeant meant, SharedRows* others,
                          ChannelSolution& solution) const {
  for (std::size_t c = 0; c < sources.is_lit.size(); ++c)
    if (!sources.is_lit[c])
      solution.dark.push_back({system_.components()[c].first_element, system_.components()[c].size});
  const Numbers numbers = numbers_of(given, channel);
  const std::vector<ScaledBall> radiosity = fill_radiosities(numbers, sources, bounds, solution);
  fill_irradiances(numbers, radiosity, system_.irradiance(radiosity, meant, others), solution);
}

ChannelResults::Numbers ChannelResults::numbers_of(const RadiositySources& given, int channel) const {
  const ExchangeMatrix& matrix = system_.matrix();
  Numbers result;
  result.emission.resize(matrix.size());
  result.emitted.resize(matrix.size() + 1);
  result.direct.resize(matrix.size());
  // Elements of one material share their numbers.
  std::unordered_map<const RationalEnclosure*, std::pair<Printed, ScaledBall>> known;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const RationalEnclosure& emission = given.emission[i][channel];
    const auto place = known.try_emplace(&emission);
    if (place.second) place.first->second = {Printed(emission), ScaledBall::around(emission.lower, emission.upper)};
    result.emission[i] = place.first->second.first;
    result.emitted[i] = place.first->second.second;
    if (given.direct_irradiance.empty()) continue;
    const RationalEnclosure& direct = given.direct_irradiance[i][channel];
    result.direct[i] = ScaledBall::around(direct.lower, direct.upper);
  }
  const auto ball = [channel](const SourceSpectrum& source) {
    return ScaledBall::around(source[channel].lower, source[channel].upper);
  };
  result.absorbed_besides = ball(given.besides.absorbed);
  result.to_sky_besides = ball(given.besides.to_sky);
  result.unaccounted = ScaledBall::of(given.besides.unaccounted[static_cast<std::size_t>(channel)]);
  const RationalEnclosure& sky = given.sky[channel];
  result.emitted[matrix.sky()] = ScaledBall::around(sky.lower, sky.upper);
  return result;
}

std::vector<ScaledBall> ChannelResults::fill_radiosities(const Numbers& numbers, const Sources& sources,
                                                         const CertifiedBounds& bounds,
                                                         ChannelSolution& solution) const {
  const ExchangeMatrix& matrix = system_.matrix();
  std::vector<ScaledBall> radiosity = sources.emission;  // right for all that is known
  solution.elements.resize(matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ElementRadiosity& element = solution.elements[i];
    const Printed& e = numbers.emission[i];
    element.emission = e.nearest;
    element.reflectivity = reflectivity_[*matrix.elements()[i].material];
    const std::int32_t u = system_.unknown(i);
    if (u < 0) {
      element.radiosity = e.nearest;
      element.lower = e.lower;
      element.upper = e.upper;
    } else if (sources.is_lit[system_.rows()[static_cast<std::size_t>(u)].component]) {
      const auto place = static_cast<std::size_t>(u);
      radiosity[i] = bounds.enclosed(place);
      element.lower = lower_scaled(bounds.lower[place], bounds.exponent[place]);
      element.upper = upper_scaled(bounds.upper[place], bounds.exponent[place]);
      if (!system_.has_negative_factors()) element.lower = std::max(element.lower, e.lower);  // B >= E
      const double value = std::ldexp(radiosity[i].mantissa.hi, radiosity[i].exponent);
      element.radiosity = std::clamp(value, element.lower, element.upper);
      if (value < e.lower)
        radiosity[i] = ScaledBall::of(DoubleDoubleBall::around({element.radiosity, 0}, {element.lower, element.upper}));
      if (element.radiosity > 0)
        solution.max_relative_width =
            std::max(solution.max_relative_width, (element.upper - element.lower) / element.radiosity);
    }
  }
  return radiosity;
}

void ChannelResults::fill_irradiances(const Numbers& numbers, const std::vector<ScaledBall>& radiosity,
                                      const std::vector<ScaledBall>& exchange, ChannelSolution& solution) const {
  const ExchangeMatrix& matrix = system_.matrix();
  EnergySum energy(matrix);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const ScaledBall irradiance = sum(exchange[i], numbers.direct[i]);
    const ScaledBall absorbed = product(loss_[*matrix.elements()[i].material], irradiance);
    // Two forms of one number. Where the equations are not solved, the second is what the radiosities exchange.
    const ScaledBall net = difference(numbers.emitted[i], absorbed);
    const ScaledBall exchanged = is_refined_ ? net : difference(radiosity[i], irradiance);
    ElementRadiosity& element = solution.elements[i];
    element.irradiance = std::max(0.0, irradiance.nearest());
    element.net_value = exchanged.nearest();
    element.net_lower = std::min(net.lower(), element.net_value);
    element.net_upper = net.upper();
    if (!system_.has_negative_factors())  // H >= 0
      element.net_upper = std::min(element.net_upper, numbers.emission[i].upper);
    element.net_upper = std::max(element.net_upper, element.net_value);
    energy.add(i, sum(numbers.emitted[i], numbers.direct[i]), absorbed, radiosity[i], numbers.emitted[matrix.sky()]);
  }
  energy.add_besides(numbers.absorbed_besides, numbers.to_sky_besides, numbers.unaccounted);
  solution.energy = energy.balance();
}

}  // namespace hottel

#include "solver/radiosity/net_flux.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {
namespace {

ScaledBall within(double value, double lower, double upper) {
  return ScaledBall::of(DoubleDoubleBall::around({value, 0}, {lower, upper}));
}

NetFlux::Power power_of(const ScaledBall& flux) { return {flux.nearest(), flux.lower(), flux.upper()}; }

// Of every element, the sky last.
std::vector<ScaledBall> flux_by_element(const ExchangeMatrix& matrix, const ChannelSolution& solution,
                                        const ScaledBall& sky_emission) {
  std::vector<ScaledBall> result(matrix.size() + 1);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const ElementRadiosity& element = solution.elements[i];
    const ScaledBall area = ScaledBall::of(DoubleDoubleBall::of(matrix.elements()[i].area));
    const ScaledBall radiosity = within(element.radiosity, element.lower, element.upper);
    result[i] = product(area, within(element.net_value, element.net_lower, element.net_upper));
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      const bool is_sky = entry.to == matrix.sky();
      if (!is_sky && matrix.has_row(entry.to)) continue;
      const bool is_any_within =
          matrix.guarantee() == Guarantee::kEnclosed && matrix.guarantee(i, k) == Guarantee::kEnclosed;
      const DoubleDoubleBall factor = is_any_within
                                          ? DoubleDoubleBall::around({entry.factor.value, 0}, matrix.bounds(i, k))
                                          : DoubleDoubleBall::of(entry.factor);
      const ScaledBall sent = is_sky ? difference(sky_emission, radiosity) : negated(radiosity);
      result[entry.to] = sum(result[entry.to], product(product(area, ScaledBall::of(factor)), sent));
    }
  }
  return result;
}

}  // namespace

NetFlux::Power sum(const NetFlux::Power& a, const NetFlux::Power& b) {
  return power_of(sum(within(a.value, a.lower, a.upper), within(b.value, b.lower, b.upper)));
}

std::vector<NetFlux> net_flux(const ExchangeMatrix& matrix, const RadiositySolution& solution,
                              const SourceSpectrum& sky_emission,
                              const std::function<std::string(const Element&)>& name_of, const ShiningLights& shining) {
  const auto lost = power_without_rows(matrix, shining.lights, shining.shares);
  for (const ChannelSolution& channel : solution.channels) HOTTEL_REQUIRE(channel.elements.size() == matrix.size());
  std::vector<char> is_listed(matrix.size() + 1, 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    is_listed[i] = 1;
    for (const FactorEntry& entry : matrix.row(i)) is_listed[entry.to] = 1;
  }
  for (const auto& [element, power] : lost) is_listed[element] = 1;
  std::vector<NetFlux> result;
  std::vector<std::size_t> place(matrix.size() + 1);  // of an element, in the result
  std::vector<ScaledBall> area;
  std::unordered_map<std::string, std::size_t> place_of;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) {
    if (!is_listed[i]) continue;
    const std::string name = i == matrix.sky() ? matrix.name(i) : name_of(matrix.elements()[i]);
    const auto [known, is_new] = place_of.emplace(name, result.size());
    if (is_new) {
      result.push_back({name, {}, std::vector<NetFlux::Power>(solution.channels.size())});
      area.emplace_back();
    }
    place[i] = known->second;
    if (i == matrix.sky()) continue;
    area[place[i]] = sum(area[place[i]], ScaledBall::of(DoubleDoubleBall::of(matrix.elements()[i].area)));
    result[place[i]].area = area[place[i]].nearest();
  }
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const RationalEnclosure& sky = sky_emission[static_cast<int>(c)];
    std::vector<ScaledBall> flux =
        flux_by_element(matrix, solution.channels[c], ScaledBall::around(sky.lower, sky.upper));
    for (const auto& [element, power] : lost)
      flux[element] = difference(flux[element], ScaledBall::around(power[c].lower, power[c].upper));
    std::vector<ScaledBall> total(result.size());
    for (std::uint32_t i = 0; i <= matrix.size(); ++i)
      if (is_listed[i]) total[place[i]] = sum(total[place[i]], flux[i]);
    for (std::size_t k = 0; k < result.size(); ++k) result[k].by_channel[c] = power_of(total[k]);
  }
  return result;
}

std::vector<NetFlux> light_flux(const ShiningLights& shining, std::size_t channels) {
  std::vector<NetFlux> result;
  for (std::size_t k = 0; k < shining.lights.size(); ++k) {
    NetFlux& flux = result.emplace_back(NetFlux{shining.lights[k].name, {}, {}});
    for (std::size_t c = 0; c < channels; ++c) {
      const Rational& power = shining.lights[k].power.value[c];
      const Enclosure& whole = shining.shares[k].whole;
      flux.by_channel.push_back(
          shining.shares[k].solid.empty()
              ? power_of(ScaledBall::around(power * exact_value(whole.lower), power * exact_value(whole.upper)))
              : NetFlux::Power{});
    }
  }
  return result;
}

}  // namespace hottel

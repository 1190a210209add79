#include "solver/system/net_flux.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "solver/system/enclosed.h"
#include "solver/system/matrix_checks.h"

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Powers of two by which areas and light are divided, so that products stay in the range of Enclosed.
struct Scale {
  int area = 0, light = 0;
};

Scale scale_of(const ExchangeMatrix& matrix, const ChannelSolution& solution, const Enclosed& sky_emission) {
  double brightest = sky_emission.value();
  for (const ElementRadiosity& element : solution.elements)
    brightest = std::max({brightest, element.radiosity, element.irradiance});
  return {hottel::scale_of(largest_area(matrix)), hottel::scale_of(brightest)};
}

NetFlux::Power power_of(const Enclosed& flux, int exponent) {
  const double lower = lower_scaled(flux.lower(), exponent), upper = upper_scaled(flux.upper(), exponent);
  return {std::ldexp(flux.value(), exponent), std::isnan(lower) ? -kInfinity : lower,
          std::isnan(upper) ? kInfinity : upper};
}

// What is exactly 0 leaves a sum as it is.
void add(Enclosed& total, const Enclosed& term) {
  if (term.size() == 0) return;
  total = total.size() == 0 ? term : sum(total, term);
}

// Of every element, the sky last; scaled.
std::vector<Enclosed> flux_by_element(const ExchangeMatrix& matrix, const ChannelSolution& solution,
                                      const Enclosed& sky_emission, const Scale& scale) {
  std::vector<Enclosed> result(matrix.size() + 1);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const ElementRadiosity& element = solution.elements[i];
    const Enclosed area = scaled(Enclosed::of(matrix.elements()[i].area), -scale.area);
    const Enclosed radiosity =
        scaled(Enclosed::around({element.radiosity, 0}, {element.lower, element.upper}), -scale.light);
    const Enclosed net =
        scaled(Enclosed::around({element.net, 0}, {element.net_lower, element.net_upper}), -scale.light);
    if (net.size() != 0) result[i] = product(area, net);
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      const bool is_sky = entry.to == matrix.sky();
      if (!is_sky && matrix.has_row(entry.to)) continue;
      const Enclosed factor = matrix.guarantee() == Guarantee::kEnclosed
                                  ? Enclosed::around({entry.factor.value, 0}, matrix.bounds(i, k))
                                  : Enclosed::of(entry.factor);
      const Enclosed sent = is_sky ? difference(scaled(sky_emission, -scale.light), radiosity) : negated(radiosity);
      if (sent.size() != 0) add(result[entry.to], product(product(area, factor), sent));
    }
  }
  return result;
}

}  // namespace

std::vector<NetFlux> net_flux(const ExchangeMatrix& matrix, const RadiositySolution& solution,
                              const Spectrum& sky_emission, const std::function<std::string(const Element&)>& name_of) {
  std::vector<char> is_listed(matrix.size() + 1, 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    is_listed[i] = 1;
    for (const FactorEntry& entry : matrix.row(i)) is_listed[entry.to] = 1;
  }
  std::vector<NetFlux> result;
  std::vector<std::size_t> place(matrix.size() + 1);  // of an element, in the result
  std::vector<Enclosed> area;
  std::unordered_map<std::string, std::size_t> place_of;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) {
    if (!is_listed[i]) continue;
    const std::string name = i == matrix.sky() ? "sky" : name_of(matrix.elements()[i]);
    const auto [known, is_new] = place_of.emplace(name, result.size());
    if (is_new) {
      result.push_back({name, {}, std::vector<NetFlux::Power>(solution.channels.size())});
      area.emplace_back();
    }
    place[i] = known->second;
    if (i == matrix.sky()) continue;
    add(area[place[i]], Enclosed::of(matrix.elements()[i].area));
    result[place[i]].area = area[place[i]].value();
  }
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const Enclosed sky = Enclosed::of(sky_emission.value[c]);
    const Scale scale = scale_of(matrix, solution.channels[c], sky);
    const std::vector<Enclosed> flux = flux_by_element(matrix, solution.channels[c], sky, scale);
    std::vector<Enclosed> total(result.size());
    for (std::uint32_t i = 0; i <= matrix.size(); ++i)
      if (is_listed[i]) add(total[place[i]], flux[i]);
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k].by_channel[c] = power_of(total[k], scale.area + scale.light);
    // What arrives at a black back or goes to the sky is known by factors alone, and those are estimates.
    if (matrix.guarantee() == Guarantee::kEstimated)
      for (std::uint32_t i = 0; i <= matrix.size(); ++i)
        if (is_listed[i] && (i == matrix.sky() || !matrix.has_row(i))) {
          NetFlux::Power& power = result[place[i]].by_channel[c];
          power = {power.value, -kInfinity, kInfinity};
        }
  }
  return result;
}

}  // namespace hottel

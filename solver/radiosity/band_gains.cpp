#include "solver/radiosity/band_gains.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/material.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

SourceSpectrum with_thermal(const SourceSpectrum& spectrum, const RationalEnclosure& thermal) {
  return SourceSpectrum::of(std::array{spectrum[kSolarBand], thermal, thermal});
}

Rational not_below_zero(const Rational& value) { return value > 0 ? value : Rational(0); }

}  // namespace

RadiositySources with_gains(const ExchangeMatrix& matrix, RadiositySources sources, const ChannelSolution& solar) {
  HOTTEL_REQUIRE(sources.has_bands && sources.keeps_gains.size() == matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!sources.keeps_gains[i]) continue;
    const ElementRadiosity& element = solar.elements[i];
    if (element.net_lower == 0 && element.net_upper == 0) continue;
    if (!std::isfinite(element.net_lower) || !std::isfinite(element.net_upper))
      throw RequestError("what '" + matrix.elements()[i].name +
                         "' gains in the solar band has no proven bounds, so there are none of its temperature");
    RationalEnclosure flux = sources.emission[i][kThermalBand];
    if (!sources.withdrawn.empty()) {
      const RationalEnclosure& taken = sources.withdrawn[i][kThermalBand];
      flux = {flux.lower - taken.upper, flux.upper - taken.lower};
    }
    const Rational lower = flux.lower - exact_value(element.net_upper);
    const Rational upper = flux.upper - exact_value(element.net_lower);
    sources.emission[i] = with_thermal(sources.emission[i], {not_below_zero(lower), not_below_zero(upper)});
    if (lower < 0) sources.withdrawn.resize(matrix.size());
    if (!sources.withdrawn.empty())
      sources.withdrawn[i] = with_thermal({}, {not_below_zero(-upper), not_below_zero(-lower)});
  }
  return sources;
}

RadiositySolution in_one(RadiositySolution solar, RadiositySolution thermal) {
  HOTTEL_REQUIRE(solar.channels.size() == 2 && thermal.channels.size() == 2);
  solar.channels[kThermalBand] = std::move(thermal.channels[kThermalBand]);
  sum_up_channels(solar);
  if (solar.factorizations == 0 || thermal.factorizations > 0) solar.used = thermal.used;
  solar.factorizations += thermal.factorizations;
  solar.unknowns = std::max(solar.unknowns, thermal.unknowns);
  solar.components = std::max(solar.components, thermal.components);
  for (const auto& [stage, seconds] : thermal.seconds) solar.seconds[stage] += seconds;
  for (std::string& note : thermal.notes)
    if (std::find(solar.notes.begin(), solar.notes.end(), note) == solar.notes.end())
      solar.notes.push_back(std::move(note));
  return solar;
}

}  // namespace hottel

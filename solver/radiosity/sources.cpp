// What shines on the components of a radiosity system, each in a unit of its own.
#include <algorithm>
#include <climits>
#include <limits>
#include <map>
#include <optional>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

constexpr int kMostAbove = 500;  // 2^kMostAbove: how far radiosities may be above emissions

// Of what a component emits and sees, as far as it decides on its radiosities.
struct Extremes {
  bool are_known = true, is_any = false;
  Rational least, most;

  void meet(const Rational& radiosity) {
    if (!is_any || radiosity < least) least = radiosity;
    if (!is_any || radiosity > most) most = radiosity;
    is_any = true;
  }
};

// By component. At the brightest unknown nothing that it sees is brighter, so (1 - rho) B <= E there; unless it absorbs
// and emits nothing, and then all that it sees is as bright. So for the darkest.
std::vector<Extremes> extremes_of(const RadiositySystem& system, const std::vector<const Rational*>& emission) {
  const Rational zero = 0;
  const auto emitted = [&](std::uint32_t element) -> const Rational& {
    return emission[element] ? *emission[element] : zero;
  };
  std::vector<Extremes> result(system.components().size());
  for (const SystemRow& row : system.rows()) {
    Extremes& extremes = result[row.component];
    const Rational &own = emitted(row.element), &taken = system.absorptivity(row);
    if (taken > 0)
      extremes.meet(own == 0 ? zero : Rational(own / taken));
    else if (own > 0)
      extremes.are_known = false;
    for (const FactorEntry& entry : system.matrix().row(row.element))
      if (system.unknown(entry.to) < 0) extremes.meet(emitted(entry.to));
  }
  for (Extremes& extremes : result) extremes.are_known &= extremes.is_any && system.rows_are_closed();
  return result;
}

}  // namespace

Sources RadiositySystem::sources(const std::vector<Material>& materials, const Spectrum& sky_emission,
                                 int channel) const {
  std::vector<const Rational*> emission(matrix_->size() + 1, nullptr);
  for (std::uint32_t i = 0; i < matrix_->size(); ++i)
    if (matrix_->has_row(i)) emission[i] = &materials[*matrix_->elements()[i].material].emission.value[channel];
  emission[matrix_->sky()] = &sky_emission.value[channel];
  return sources_of(emission);
}

Sources RadiositySystem::unit_source(std::uint32_t element) const {
  const Rational one = 1;
  std::vector<const Rational*> emission(matrix_->size() + 1, nullptr);
  emission[element] = &one;
  return sources_of(emission);
}

Sources RadiositySystem::sources_of(const std::vector<const Rational*>& emission) const {
  Sources result;
  std::map<const Rational*, ScaledBall> scaled;  // materials are few
  for (const Rational* e : emission) {
    if (e && !scaled.contains(e)) scaled[e] = ScaledBall::of(*e);
    result.emission.push_back(e ? scaled[e] : ScaledBall());
  }
  result.is_lit.assign(components_.size(), 0);
  std::vector<std::optional<int>> largest(components_.size());
  for (const SystemRow& row : rows_) {
    const auto meet = [&](std::uint32_t element, bool arrives = true) {
      if (result.emission[element].is_zero()) return;
      if (arrives) result.is_lit[row.component] = 1;
      std::optional<int>& exponent = largest[row.component];
      exponent = std::max(exponent.value_or(INT_MIN), result.emission[element].exponent);
    };
    meet(row.element);
    for (const FactorEntry& entry : matrix_->row(row.element))
      if (unknown_[entry.to] < 0) meet(entry.to, is_positive(entry.factor));
  }

  const std::vector<Extremes> extremes = extremes_of(*this, emission);
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const Extremes& e = extremes[c];
    int unit = largest[c].value_or(0);
    if (e.are_known && e.most > 0) unit += std::clamp(exponent_of(e.most) - unit - kMostAbove, 0, kMostAbove);
    result.exponent.push_back(unit);
    const auto in_unit = [&](const Rational& value) {
      return DoubleDoubleBall::of(scaled_by_power_of_two(value, -unit));
    };
    result.range.push_back(e.are_known ? Enclosure{in_unit(e.least).lower(), in_unit(e.most).upper()}
                                       : Enclosure{0, std::numeric_limits<double>::infinity()});
  }

  result.largest.assign(components_.size(), 0);
  for (const SystemRow& row : rows_) {
    double& most = result.largest[row.component];
    most = std::max(most, result.emission_in(row.component, row.element).hi);
    for (const FactorEntry& entry : matrix_->row(row.element))
      if (unknown_[entry.to] < 0) most = std::max(most, result.emission_in(row.component, entry.to).hi);
  }
  return result;
}

}  // namespace hottel

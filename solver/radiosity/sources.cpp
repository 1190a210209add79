// What shines on the components of a radiosity system, each in a unit of its own.
#include <algorithm>
#include <climits>
#include <limits>
#include <map>
#include <optional>

#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

constexpr int kMostAbove = 500;  // 2^kMostAbove: how far radiosities may be above emissions

// Of what a component emits and sees, as far as it decides on its radiosities.
struct Extremes {
  bool are_known = true, is_any = false;
  Rational least, most;

  void meet(const Rational& lower, const Rational& upper) {
    if (!is_any || lower < least) least = lower;
    if (!is_any || upper > most) most = upper;
    is_any = true;
  }
  void meet(const RationalEnclosure& radiosity) { meet(radiosity.lower, radiosity.upper); }
};

// By component. At the brightest unknown nothing that it sees is brighter, so (1 - rho) B <= E there; unless it absorbs
// and emits nothing, and then all that it sees is as bright. So for the darkest.
std::vector<Extremes> extremes_of(const RadiositySystem& system,
                                  const std::vector<const RationalEnclosure*>& emission) {
  const RationalEnclosure zero;
  const auto emitted = [&](std::uint32_t element) -> const RationalEnclosure& {
    return emission[element] ? *emission[element] : zero;
  };
  std::vector<Extremes> result(system.components().size());
  for (const SystemRow& row : system.rows()) {
    Extremes& extremes = result[row.component];
    const RationalEnclosure& own = emitted(row.element);
    const Rational& taken = system.absorptivity(row);
    if (own.upper == 0) {
      if (taken > 0) extremes.meet(zero);
    } else if (taken > 0) {
      const Rational most = own.upper / taken;
      extremes.meet(own.is_exact() ? most : Rational(own.lower / taken), most);
    } else {
      extremes.are_known = false;
    }
    for (const FactorEntry& entry : system.matrix().row(row.element))
      if (system.unknown(entry.to) < 0) extremes.meet(emitted(entry.to));
  }
  for (Extremes& extremes : result) extremes.are_known &= extremes.is_any && system.rows_are_closed();
  return result;
}

}  // namespace

Sources RadiositySystem::sources(const RadiositySources& sources, int channel) const {
  HOTTEL_REQUIRE(sources.emission.size() == matrix_->size());
  HOTTEL_REQUIRE(sources.direct_irradiance.empty() || sources.direct_irradiance.size() == matrix_->size());
  std::vector<const RationalEnclosure*> emission(matrix_->size() + 1, nullptr);
  for (std::uint32_t i = 0; i < matrix_->size(); ++i)
    if (matrix_->has_row(i)) emission[i] = &sources.emission[i][channel];
  emission[matrix_->sky()] = &sources.sky[channel];
  std::vector<RationalEnclosure> raised;  // by what is reflected of the light that arrives directly
  raised.reserve(rows_.size());
  if (!sources.direct_irradiance.empty())
    for (const SystemRow& row : rows_) {
      const RationalEnclosure& direct = sources.direct_irradiance[row.element][channel];
      if (direct.upper == 0) continue;
      const RationalEnclosure& own = *emission[row.element];
      const Rational rho = 1 - absorptivity(row);
      RationalEnclosure sum{own.lower + rho * direct.lower, own.upper};
      sum.upper = own.is_exact() && direct.is_exact() ? sum.lower : Rational(own.upper + rho * direct.upper);
      emission[row.element] = &raised.emplace_back(std::move(sum));
    }
  return in_units(emission);
}

Sources RadiositySystem::unit_source(std::uint32_t element) const {
  const RationalEnclosure one{1, 1};
  std::vector<const RationalEnclosure*> emission(matrix_->size() + 1, nullptr);
  emission[element] = &one;
  return in_units(emission);
}

Sources RadiositySystem::in_units(const std::vector<const RationalEnclosure*>& emission) const {
  Sources result;
  std::map<const RationalEnclosure*, ScaledBall> scaled;  // materials are few
  for (const RationalEnclosure* e : emission) {
    if (e && !scaled.contains(e)) scaled[e] = ScaledBall::around(e->lower, e->upper);
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

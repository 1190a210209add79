#include "solver/radiosity/matrix_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string_view>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

// The largest of a number a row. A maximum is the same in any order.
template <class OfRow>
double largest_of_rows(const ExchangeMatrix& matrix, const OfRow& of_row) {
  double largest = 0;
  std::mutex mutex;
  parallel_ranges(matrix.size(), 16, [&](std::size_t begin, std::size_t end) {
    double here = 0;
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
      if (matrix.has_row(i)) here = std::max(here, of_row(i));
    const std::lock_guard lock(mutex);
    largest = std::max(largest, here);
  });
  return largest;
}

}  // namespace

double closure_defect(const ExchangeMatrix& matrix) {
  return largest_of_rows(matrix, [&](std::uint32_t i) {
    DoubleDoubleBall defect{-1, 0, 0};
    for (const FactorEntry& entry : matrix.row(i)) defect = sum(defect, {entry.factor.value, 0, 0});
    return std::abs(defect.value());
  });
}

double reciprocity_defect(const ExchangeMatrix& matrix) {
  return largest_of_rows(matrix, [&](std::uint32_t i) {
    double largest = 0;
    const double area = matrix.elements()[i].area.value;
    for (const FactorEntry& entry : matrix.row(i)) {
      if (entry.to == matrix.sky() || !matrix.has_row(entry.to)) continue;
      const double other = matrix.elements()[entry.to].area.value;
      const double there = matrix.factor(entry.to, i).value;
      // A pair with entries both ways is looked at once.
      if (entry.to < i && there != 0) continue;
      largest = std::max(largest, std::abs(area * entry.factor.value - other * there) / std::min(area, other));
    }
    return largest;
  });
}

std::optional<BeyondDoubles> beyond_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission,
                                            const RadiositySolution& solution) {
  const auto told = [](std::string_view what, std::optional<std::uint32_t> element = {}) {
    return BeyondDoubles{fmt::format("{} is beyond the range of doubles", what), element};
  };
  for (const Rational& emission : sky_emission.value)
    if (!std::isfinite(to_double(emission))) return told("the emission of the sky");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    if (!(element.area.value > 0 && std::isfinite(element.area.value)))
      return BeyondDoubles{
          "the area of '" + element.name + "' " + written_problem(written_double(Rounded{element.area.value, 1})), i};
    for (const ChannelSolution& channel : solution.channels)
      if (!std::isfinite(channel.elements[i].radiosity) || !std::isfinite(channel.elements[i].irradiance))
        return told("the light of '" + element.name + "'", i);
  }
  const EnergyBalance& energy = solution.energy;
  if (!std::isfinite(energy.emitted) || !std::isfinite(energy.absorbed) || !std::isfinite(energy.to_sky))
    return told("the power of the light in all");
  return std::nullopt;
}

std::optional<BeyondDoubles> below_doubles(const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  const auto is_lost = [](const Spectrum& spectrum) {
    return std::ranges::any_of(spectrum.value, [](const Rational& value) { return std::isnan(written_double(value)); });
  };
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Material& material = materials[*matrix.elements()[i].material];
    for (const auto& [what, spectrum] : {std::pair(material.has_given_flux() ? "flux" : "emission", &material.emission),
                                         std::pair("reflectivity", &material.reflectivity)})
      if (is_lost(*spectrum))
        return BeyondDoubles{fmt::format("the {} of '{}' {}", what, matrix.elements()[i].name,
                                         written_problem(written_double(Rounded{0, 1}))),
                             i};
  }
  return std::nullopt;
}

void require_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission, const RadiositySolution& solution) {
  if (const auto beyond = beyond_doubles(matrix, sky_emission, solution)) throw RequestError(beyond->text);
}

namespace {

ScaledBall middle(const ScaledBall& value) {
  return ScaledBall::of(DoubleDoubleBall{value.mantissa.hi, 0, 0}, value.exponent);
}

}  // namespace

void EnergySum::add(std::uint32_t row, const ScaledBall& emission, const ScaledBall& absorbed,
                    const ScaledBall& radiosity, const ScaledBall& sky_emission) {
  const ScaledBall area = ScaledBall::of(DoubleDoubleBall{matrix_.elements()[row].area.value, 0, 0});
  const ScaledBall sent = middle(radiosity);
  emitted_ = sum(emitted_, product(area, middle(emission)));
  absorbed_ = sum(absorbed_, product(area, middle(absorbed)));
  for (const FactorEntry& entry : matrix_.row(row)) {
    const bool is_sky = entry.to == matrix_.sky();
    if (!is_sky && matrix_.has_row(entry.to)) continue;
    const ScaledBall exchange = product(area, ScaledBall::of(DoubleDoubleBall{entry.factor.value, 0, 0}));
    ScaledBall& taken = is_sky ? to_sky_ : absorbed_;
    taken = sum(taken, product(exchange, sent));
    if (is_sky) emitted_ = sum(emitted_, product(exchange, middle(sky_emission)));
  }
}

void EnergySum::add_besides(const ScaledBall& absorbed, const ScaledBall& to_sky, const ScaledBall& unaccounted) {
  emitted_ = sum(emitted_, sum(sum(middle(absorbed), middle(to_sky)), middle(unaccounted)));
  absorbed_ = sum(absorbed_, middle(absorbed));
  to_sky_ = sum(to_sky_, middle(to_sky));
}

EnergyBalance EnergySum::balance() const {
  const ScaledBall defect = difference(difference(emitted_, absorbed_), to_sky_);
  return {emitted_.nearest(), absorbed_.nearest(), to_sky_.nearest(), defect.nearest()};
}

}  // namespace hottel

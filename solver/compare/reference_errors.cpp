#include "solver/compare/reference_errors.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

double error_of(const ExchangeMatrix& exact, std::uint32_t i, std::size_t k, double tolerance) {
  const FactorEntry& entry = exact.row(i)[k];
  if (exact.guarantee(i, k) == Guarantee::kEnclosed) {
    const Enclosure bounds = exact.bounds(i, k);
    return std::max(bounds.upper - entry.factor.value, entry.factor.value - bounds.lower);
  }
  if (entry.to == exact.sky()) return tolerance;
  return tolerance * std::min(1.0, exact.elements()[entry.to].area.value / exact.elements()[i].area.value);
}

}  // namespace

ReferenceErrors reference_errors(const ExchangeMatrix& exact, double tolerance,
                                 const std::optional<RadiositySolution>& solution) {
  ReferenceErrors errors;
  if (exact.guarantee() == Guarantee::kExact || exact.entry_count() == 0) return errors;
  long double squares = 0;
  for (std::uint32_t i = 0; i < exact.size(); ++i)
    for (std::size_t k = 0; k < exact.row(i).size(); ++k) {
      const double error = error_of(exact, i, k, tolerance);
      errors.max = std::max(errors.max, error);
      squares += static_cast<long double>(error) * error;
    }
  errors.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(exact.entry_count())));
  if (!solution) return errors;
  double widest = 0, largest = 0;
  for (const ChannelSolution& channel : solution->channels)
    for (const ElementRadiosity& element : channel.elements) {
      widest = std::max(widest, element.upper - element.lower);
      largest = std::max(largest, element.radiosity);
    }
  if (largest > 0) errors.radiosity = widest / 2 / largest;
  return errors;
}

}  // namespace hottel

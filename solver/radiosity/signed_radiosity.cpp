#include "solver/radiosity/signed_radiosity.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kernel/doubles.h"
#include "kernel/int128.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Doubles not above and not below a - b; a - b itself where it is one.
double difference_below(double a, double b) {
  double difference = 0, rest = 0;
  two_sum(a, -b, difference, rest);
  if (std::isnan(difference)) return -kInfinity;
  return rest == 0 ? difference : std::nextafter(difference, -kInfinity);
}
double difference_above(double a, double b) { return -difference_below(b, a); }

ElementRadiosity difference_of(const ElementRadiosity& a, const ElementRadiosity& b) {
  ElementRadiosity result;
  result.emission = a.emission - b.emission;
  result.reflectivity = a.reflectivity;
  result.lower = difference_below(a.lower, b.upper);
  result.upper = difference_above(a.upper, b.lower);
  result.radiosity = std::clamp(a.radiosity - b.radiosity, result.lower, result.upper);
  result.irradiance = a.irradiance - b.irradiance;
  result.net_lower = difference_below(a.net_lower, b.net_upper);
  result.net_upper = difference_above(a.net_upper, b.net_lower);
  result.net_value = std::clamp(a.net_value - b.net_value, result.net_lower, result.net_upper);
  return result;
}

EnergyBalance difference_of(const EnergyBalance& a, const EnergyBalance& b) {
  return {a.emitted, a.absorbed - b.absorbed + b.emitted, a.to_sky - b.to_sky, a.defect - b.defect};
}

void subtract(const ExchangeMatrix& matrix, const ChannelSolution& withdrawn, ChannelSolution& supplied) {
  supplied.max_relative_width = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ElementRadiosity& element = supplied.elements[i];
    element = difference_of(element, withdrawn.elements[i]);
    if (element.radiosity != 0)
      supplied.max_relative_width =
          std::max(supplied.max_relative_width, (element.upper - element.lower) / std::abs(element.radiosity));
  }
  std::erase_if(supplied.dark, [&](const DarkComponent& dark) {
    return std::none_of(withdrawn.dark.begin(), withdrawn.dark.end(),
                        [&](const DarkComponent& other) { return other.first_element == dark.first_element; });
  });
  if (supplied.residual_history.empty()) supplied.residual_history = withdrawn.residual_history;
  supplied.energy = difference_of(supplied.energy, withdrawn.energy);
}

}  // namespace

RadiositySolution difference_of(const ExchangeMatrix& matrix, RadiositySolution supplied,
                                const RadiositySolution& withdrawn) {
  HOTTEL_REQUIRE(supplied.channels.size() == withdrawn.channels.size());
  supplied.max_relative_width = 0;
  for (std::size_t c = 0; c < supplied.channels.size(); ++c) {
    subtract(matrix, withdrawn.channels[c], supplied.channels[c]);
    supplied.max_relative_width = std::max(supplied.max_relative_width, supplied.channels[c].max_relative_width);
  }
  supplied.energy = difference_of(supplied.energy, withdrawn.energy);
  if (supplied.factorizations == 0) supplied.used = withdrawn.used;
  supplied.factorizations = std::max(supplied.factorizations, withdrawn.factorizations);
  supplied.unknowns = std::max(supplied.unknowns, withdrawn.unknowns);
  supplied.components = std::max(supplied.components, withdrawn.components);
  for (const auto& [stage, seconds] : withdrawn.seconds) supplied.seconds[stage] += seconds;
  for (const std::string& note : withdrawn.notes)
    if (std::find(supplied.notes.begin(), supplied.notes.end(), note) == supplied.notes.end())
      supplied.notes.push_back(note);
  return supplied;
}

}  // namespace hottel

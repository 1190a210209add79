#include "solver/radiosity/oriented_light.h"

#include "geometry/material.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel {

double mean_radiant_temperature(const std::vector<double>& mean_irradiance) {
  HOTTEL_REQUIRE(!mean_irradiance.empty());
  if (mean_irradiance.size() == 2) return black_temperature(mean_irradiance[kThermalBand]);
  double sum = 0;
  for (const double value : mean_irradiance) sum += value;
  return black_temperature(sum / static_cast<double>(mean_irradiance.size()));
}

}  // namespace hottel

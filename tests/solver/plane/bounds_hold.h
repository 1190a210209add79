// Whether the bounds of radiosities hold numbers that are known to a hundred digits.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity_solver.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::testing_radiosity {

inline double rounded_down(const mpf_class& value) {
  const double near = value.get_d();  // truncated
  return mpf_class(near, kBits) > value ? std::nextafter(near, -std::numeric_limits<double>::infinity()) : near;
}
inline double rounded_up(const mpf_class& value) { return -rounded_down(-value); }

// Counts the bounds that were asked, and those that do not hold.
struct BoundsHold {
  std::size_t checked = 0, misses = 0, open = 0;  // open: without an end on some side
  std::string first_miss;

  void require(std::uint32_t i, const mpf_class& real, const Enclosure& bounds, double value, const char* what) {
    ++checked;
    open += std::isinf(bounds.upper) || std::isinf(bounds.lower);
    const mpf_class slack = (abs(real) + 1) * 1e-75;  // what the reference itself may be off by
    const bool holds = (std::isinf(bounds.lower) || mpf_class(bounds.lower, kBits) <= real + slack) &&
                       (std::isinf(bounds.upper) || mpf_class(bounds.upper, kBits) >= real - slack) &&
                       bounds.contains(value);
    if (!holds && ++misses == 1)
      first_miss =
          fmt::format("{} of {}: {} in [{}, {}], real {}", what, i, value, bounds.lower, bounds.upper, real.get_d());
  }

  // The radiosities and nets of a solution against those of one set of factors within their bounds.
  void add(const ExchangeMatrix& matrix, const WideFactors& factors, const RadiositySolution& solution,
           const std::vector<Material>& materials, const Spectrum& sky) {
    const auto radiosity = radiosity_of(matrix, factors, materials, sky, 0);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const ElementRadiosity& e = solution.channels[0].elements[i];
      mpf_class irradiance = factors[i][matrix.sky()] * number(sky.value[0]);
      for (std::uint32_t j = 0; j < matrix.size(); ++j) irradiance += factors[i][j] * radiosity[j];
      const Material& material = materials[*matrix.elements()[i].material];
      const mpf_class net =
          number(material.emission.value[0]) - (1 - number(material.reflectivity.value[0])) * irradiance;
      require(i, radiosity[i], {e.lower, e.upper}, e.radiosity, "radiosity");
      require(i, net, {e.net_lower, e.net_upper}, e.net_value, "net");
    }
  }
};

// Nothing where light does not die out for the doubles themselves.
inline std::optional<RadiositySolution> solution_of(const ExchangeMatrix& matrix, const Scene2& scene) {
  try {
    return solve_radiosity(matrix, scene.materials, scene.sky_emission);
  } catch (const RequestError&) {
    return std::nullopt;
  }
}

}  // namespace hottel::testing_radiosity

// The temperatures of elements: what their material says, or what they come to by themselves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/material.h"
#include "kernel/enclosure.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Returns the temperature [K] of a black body that sends out this much [W/m²]: (power / sigma) to the 1/4.
double black_temperature(double power);

// A temperature [K] with proven bounds.
struct BoundedTemperature {
  double value = 0, lower = 0, upper = 0;
};

// Returns the temperature of a black body that sends out some power [W/m²] between two doubles, neither below 0.
//
//   (1) sigma lower⁴ <= the least power, and sigma upper⁴ >= the most, as rationals; no double nearer to them does
//   (2) value is that of `power`, and lies between the bounds
// COST: microseconds.
BoundedTemperature black_temperature(double power, const Enclosure& bounds);

// Temperatures of elements: what their material says (grey_temperature), or, where it neither absorbs nor emits
// (Material::is_adiabatic), what they come to by themselves: that of a black body with their radiosity.
class ElementTemperatures {
 public:
  explicit ElementTemperatures(const std::vector<Material>& materials);

  // Whether there is something to tell of it: it is warm, or insulated.
  bool is_known(std::uint32_t material) const { return is_known_[material] != 0; }
  // Of an element of this material in one channel; nothing where it has none, as where a foreign matrix makes a
  // radiosity negative. Bounds hold where those of the radiosity do.
  std::optional<BoundedTemperature> of(std::uint32_t material, const ElementRadiosity& element) const;

 private:
  std::vector<std::optional<BoundedTemperature>> typed_;  // by material
  std::vector<char> is_adiabatic_, is_known_;             // by material
};

}  // namespace hottel

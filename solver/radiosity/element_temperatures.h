// The temperatures of elements: what their material says, or what they come to by themselves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "kernel/enclosure.h"
#include "solver/radiosity/matrix_checks.h"
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

// Temperatures of elements: what their material says (gray_temperature), or, where it neither absorbs nor emits
// (Material::is_adiabatic), what they come to by themselves: that of a black body with their radiosity B; where their
// net flux q is given, that for which sigma T⁴ = B + (1 - e) q / e.
//
//   (1) where the bounds of sigma T⁴ hold 0 the lower bound of T is 0
//   (2) in two bands q is what is given and what the element gains in the solar band
class ElementTemperatures {
 public:
  explicit ElementTemperatures(const std::vector<Material>& materials);

  // Whether there is something to tell of it: it is warm, or insulated, or its net flux is given.
  bool is_known(std::uint32_t material) const { return is_known_[material] != 0; }
  // Of an element of this material in one channel, of two bands the thermal one, to which `solar` belongs; nothing
  // where it has none, as where an external matrix makes a radiosity negative; nor where sigma T⁴ is below 0
  // (coldest_below_zero). Bounds hold where those of the radiosity do.
  std::optional<BoundedTemperature> of(std::uint32_t material, const ElementRadiosity& element,
                                       const ElementRadiosity* solar = nullptr) const;
  // Of element i of a solution in one of its channels; nothing in the solar band.
  std::optional<BoundedTemperature> of(std::uint32_t material, const RadiositySolution& solution, std::size_t channel,
                                       std::uint32_t i) const;

 private:
  std::vector<std::optional<BoundedTemperature>> typed_;  // by material
  std::vector<char> comes_out_, is_known_;                // by material
  std::vector<Rational> above_radiosity_, resistance_;    // by material: sigma T⁴ less B, by what is given; per gain
};

// A double near sigma T⁴ of an element whose temperature comes out, and doubles around it.
struct BlackPower {
  double value = 0;
  Enclosure bounds;
};
// resistance: (1 - e) / e, with which what is gained in the solar band counts, where there is one.
BlackPower black_power(const Rational& above_radiosity, const ElementRadiosity& element, const Rational& resistance = 0,
                       const ElementRadiosity* solar = nullptr);
// The solar band of element i of a solution in two bands; null where there are none.
inline const ElementRadiosity* solar_of(const RadiositySolution& solution, std::uint32_t i) {
  return solution.channels.size() == 2 ? &solution.channels[kSolarBand].elements[i] : nullptr;
}

// An insulated element without an emissivity that gains something in the solar band: its temperature does not follow.
// The first there is.
std::optional<std::uint32_t> first_without_emissivity(const ExchangeMatrix& matrix,
                                                      const std::vector<Material>& materials,
                                                      const RadiositySolution& solution);
std::string text_without_emissivity(const Element& element, const std::vector<Material>& materials);

// An element that nothing could make as cold as it would have to be: sigma T⁴ is below 0, proven.
struct ElementBelowZero {
  std::uint32_t element = 0;
  double power = 0;  // the upper bound of sigma T⁴
};

// Returns the coldest of the elements of given net flux, and those that are insulated, whose sigma T⁴ has an upper
// bound below 0 in some channel; nothing where there is none.
std::optional<ElementBelowZero> coldest_below_zero(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                                   const RadiositySolution& solution);
// Returns the first of the elements of given net flux, and those that are insulated, whose sigma T⁴ is too large for a
// double in some channel; nothing where there is none.
std::optional<BeyondDoubles> temperature_beyond_doubles(const ExchangeMatrix& matrix,
                                                        const std::vector<Material>& materials,
                                                        const RadiositySolution& solution);
// What is to be said of it, without the place in the file.
std::string text_of(const ElementBelowZero& cold, const ExchangeMatrix& matrix, const std::vector<Material>& materials);

}  // namespace hottel

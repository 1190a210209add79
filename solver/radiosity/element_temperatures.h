// The temperatures of elements: what their material says, or what they come to by themselves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
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
// (Material::is_adiabatic), what they come to by themselves: that of a black body with their radiosity B; where their
// net flux q is given, that for which sigma T⁴ = B + (1 - e) q / e.
//
//   (1) where the bounds of sigma T⁴ hold 0 the lower bound of T is 0
class ElementTemperatures {
 public:
  explicit ElementTemperatures(const std::vector<Material>& materials);

  // Whether there is something to tell of it: it is warm, or insulated, or its net flux is given.
  bool is_known(std::uint32_t material) const { return is_known_[material] != 0; }
  // Of an element of this material in one channel; nothing where it has none, as where a foreign matrix makes a
  // radiosity negative; nor where sigma T⁴ is below 0 (coldest_below_zero). Bounds hold where those of the radiosity
  // do.
  std::optional<BoundedTemperature> of(std::uint32_t material, const ElementRadiosity& element) const;

 private:
  std::vector<std::optional<BoundedTemperature>> typed_;  // by material
  std::vector<char> comes_out_, is_known_;                // by material
  std::vector<Rational> above_radiosity_;                 // by material: sigma T⁴ less B, where it comes out
};

// A double near sigma T⁴ of an element whose temperature comes out, and doubles around it.
struct BlackPower {
  double value = 0;
  Enclosure bounds;
};
BlackPower black_power(const Rational& above_radiosity, const ElementRadiosity& element);

// An element that nothing could make as cold as it would have to be: sigma T⁴ is below 0, proven.
struct ElementBelowZero {
  std::uint32_t element = 0;
  double power = 0;  // the upper bound of sigma T⁴
};

// Returns the coldest of the elements of given net flux, and those that are insulated, whose sigma T⁴ has an upper
// bound below 0 in some channel; nothing where there is none.
std::optional<ElementBelowZero> coldest_below_zero(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                                   const RadiositySolution& solution);
// What is to be said of it, without the place in the file.
std::string text_of(const ElementBelowZero& cold, const ExchangeMatrix& matrix, const std::vector<Material>& materials);

}  // namespace hottel

// The temperature of a gray body, read off what it emits.
#pragma once

#include <optional>

#include "geometry/material.h"

namespace hottel {

// Returns the temperature [K] of a gray body of this material: the rational T for which emission = (1 - reflectivity)
// sigma T⁴ exactly, in every channel that is not white; of two bands in the thermal one.
//
//   (1) a material given by emissivity and temperature, or equal to such a one, has the temperature that was typed;
//       0 where it emits nothing
//   (2) nothing for a material whose emission is no such number, as of a lamp that is given in W/m²; for channels of
//       different temperatures; and for one that is white in all channels: what it emits says nothing of how warm it is
// COST: microseconds.
std::optional<Rational> gray_temperature(const Material& material);

}  // namespace hottel

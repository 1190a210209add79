// Temperatures that may have been meant in degrees Celsius.
#pragma once

#include <optional>
#include <string>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns a sentence about temperatures between 0 and 100 K of materials that surfaces have, where no sky is colder: it
// sends as much as a black body of that temperature, or nothing that has a row in the matrix sees it. Nothing where
// there are none. Without a matrix the sky may be seen by any.
std::optional<std::string> kelvin_hint(const SceneTable& scene, const ExchangeMatrix* matrix);
inline constexpr const char* kKelvinSuggestion = "temperatures are in kelvin: 20 degrees Celsius are 293.15";

}  // namespace hottel

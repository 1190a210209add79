// What `solve` would refuse in a scene, found before light is solved for.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/check/light_fates.h"

namespace hottel {

// Returns the surfaces of these elements, each once. REQUIRES elements that ascend.
std::vector<std::uint32_t> surfaces_of_elements(const ExchangeMatrix& matrix, std::span<const std::uint32_t> elements);

// An error that a check tells; where it is, is a matter of the dimension.
struct LightError {
  std::string kind;                     // no-solution, beyond-doubles or unknown-unit
  std::vector<std::uint32_t> surfaces;  // ascending; none for the whole scene
  std::string message, suggestion;
};

// Returns what is told of lights that sources_of() refuses with a message: unknown-unit where lamps cannot be told in
// W/m² (untold_lamp), else beyond-doubles.
LightError refused_light(const SceneTable& scene, std::string message);

// Returns beyond-doubles for areas and emissions of rows that doubles do not hold, and for the emission of the sky.
// `size` is what messages call an area: "length" in the plane. Entries of the matrix do not matter.
std::vector<LightError> size_errors(const SceneTable& scene, const ExchangeMatrix& matrix, const char* size);

// Returns no-solution for each component that reflects all light and emits; without one, beyond-doubles.
//
//   (1) no-solution is told iff solve_radiosity refuses the scene for a component that reflects all light and emits,
//       or, where rows are not closed, because it cannot tell that light dies out
//   (2) else beyond-doubles is told iff solve_radiosity refuses the scene, or require_doubles its solution
// REQUIRES the matrix of the scene, by faces or by elements, its sources and its fates.
// COST: a few passes over the matrix; that of solve_radiosity (which reports to `progress`) where numbers are not
// between 1e-60 and 1e60, or rows not closed.
std::vector<LightError> light_errors(const SceneTable& scene, const ExchangeMatrix& matrix,
                                     const RadiositySources& sources, const LightFates& fates, const char* size,
                                     const std::function<void(double)>& progress = {});

}  // namespace hottel

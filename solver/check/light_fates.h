// What becomes of light in a scene before it is solved for.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// What becomes of light in one component, over all channels.
struct LightFate {
  bool is_lit = false, has_no_solution = false, reflects_all = false;
  double loss = std::numeric_limits<double>::infinity();  // the part that is lost at a reflection, of equal irradiances
};

// The components of the system of radiosity, by their elements in the matrix, ascending.
//
//   (1) a component is there once for all channels; channels in which other faces reflect have components of their own
//   (2) has_no_solution: in some channel all is reflected, nothing gets out, and some is emitted
//   (3) rows_are_closed: as RadiositySystem has it
//   (4) are_real_rows_closed: they are, or the matrix promises that rows of the real factors sum to 1; else (2) says
//       nothing of what solve_radiosity does
struct LightFates {
  std::map<std::vector<std::uint32_t>, LightFate> of;
  bool rows_are_closed = true, are_real_rows_closed = true;
};

// REQUIRES the matrix of the scene, by faces or by elements, and its sources. COST: a few passes over it.
LightFates light_fates(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySources& sources);

}  // namespace hottel

// A scene in space looked over: everything that is worth telling before light is computed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/check/finding.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

struct PreparedScene3;

// In scenes of more faces with a material view factors would take long: it is looked from the middle of at most
// kMostLooks3 of them (middle_views.h).
inline constexpr std::size_t kMostFacesChecked3 = 200, kMostLooks3 = 300;

// What was found, and the view factors that it took.
//
//   (1) findings are sorted (sort_findings); docs/check.md has their kinds
//   (2) an error is told where the scene cannot be prepared (conflicting-claims), its promise "closed" is broken, or
//       solve_radiosity, or require_doubles of its solution, refuses the factors (light_errors); where there are more
//       faces than kMostFacesChecked3, of the last only where sizes or emissions are beyond doubles
//   (3) factors: by faces; nothing where claims conflict, memory does not suffice, or there are more faces than
//       kMostFacesChecked3 (light-not-checked says so, and what was looked at instead)
struct SceneCheck3 {
  Findings3 findings;
  std::shared_ptr<const ExchangeMatrix> factors;
  std::size_t unmeasured = 0;  // pairs for which there are no factors
};

// Where a check takes what it needs of a scene (Simulation3 has it). `prepared` may throw InputError where claims
// conflict; `factors`, which are asked for after it, if at all, RequestError where they cannot be computed. Then what
// needs them is not checked.
struct CheckSources3 {
  std::function<std::shared_ptr<const PreparedScene3>()> prepared;
  std::function<std::shared_ptr<const ExchangeMatrix>()> factors;  // by faces
  std::function<std::vector<LightShares>()> lights = {};           // by faces; none: there are no lights
};

// Throws InputError for a "behind" that cannot be obeyed (geometry/space/arrangement/solids.h).
// REQUIRES a valid scene. COST: O(n log n) for contacts and meshes, 10^4 polygons take a few seconds; and view factors.
SceneCheck3 check_scene(const Scene3& scene, const CheckSources3& sources);

}  // namespace hottel

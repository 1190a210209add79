// A scene in the plane looked over: everything that is worth telling before light is computed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/check/finding.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

struct PreparedScene2;

// What was found, and the view factors that it took.
//
//   (1) findings are sorted (sort_findings); docs/check.md has their kinds
//   (2) an error is told iff prepare would fail, solve_radiosity (or that its light is in doubles),
//       or the promise "closed"
//   (3) factors: by elements where some surface is divided, as solve has them; nothing when claims conflict or memory
//       does not suffice (light-not-checked says so)
//   (4) black_backs: the surfaces that black-back is told of, in the order of the scene
struct SceneCheck2 {
  Findings2 findings;
  std::shared_ptr<const ExchangeMatrix> factors;
  std::vector<std::uint32_t> black_backs{};
};

// Where a check takes what it needs of a scene (Simulation2 has it), once each, if at all: after it was found that
// claims do not conflict.
struct CheckSources2 {
  std::function<std::shared_ptr<const PreparedScene2>()> prepared;  // undivided
  // As solve has them: exact, by elements where some surface is divided. May throw RequestError: light is not checked.
  std::function<std::shared_ptr<const ExchangeMatrix>()> factors;
  std::function<std::vector<LightShares>()> lights = {};  // of the elements of the factors; none: there are no lights
  std::function<void(double)> progress = {};              // fraction of the rest done; may throw to stop
};

// Throws InputError for a "behind" that cannot be obeyed (geometry/plane/arrangement/solids.h).
// COST: an overlay, exact view factors, and once more those where something is nearly touched; the rest O(n log n).
SceneCheck2 check_scene(const Scene2& scene, const CheckSources2& sources);

// Those warnings that tell of light which is lost in solids and on black backs, sorted: what a solution goes with.
//
//   (1) they are those of check_scene where the matrix is the exact one: filled-room, covered (of what emits),
//       inside-out, black-back
// REQUIRES a matrix of the scene, by faces or elements. COST: a pass over the matrix; where there is a solid or a black
// back is seen, linear in the sides of pieces.
Findings2 lost_light_warnings(const PreparedScene2& prepared, const ExchangeMatrix& matrix);

}  // namespace hottel

// A scene in the plane looked over: everything that is worth telling before light is computed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "geometry/check/finding.h"
#include "geometry/exchange/exchange_2.h"

namespace hottel {

struct CheckOptions {
  std::uint64_t memory = 0;                   // bytes that view factors may take; 0: no limit
  std::function<void(double)> progress = {};  // fraction done; may throw to stop
};

// What was found, and the view factors that it took.
//
//   (1) findings are sorted (sort_findings); docs/check.md has their kinds
//   (2) an error is told iff prepare, solve_radiosity (or that its light is in doubles) or the promise "closed" would
//       fail
//   (3) factors: by elements where some surface is divided, as solve has them; nothing when claims conflict or memory
//   does not suffice (light-not-checked says so)
struct SceneCheck2 {
  Findings findings;
  std::optional<ExchangeMatrix> factors;
};

// COST: an overlay, exact view factors, and once more those where something is nearly touched; the rest O(n log n).
SceneCheck2 check_scene(const Scene2& scene, const CheckOptions& options = {});

}  // namespace hottel

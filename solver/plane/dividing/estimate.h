// What dividing every edge once more would change, estimated: exact means over halves of elements.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

// How many elements are looked at, at the most.
inline constexpr std::uint32_t kMostDivided2 = 64;

// What is to be estimated for.
struct DividingRequest2 {
  const PreparedScene2& whole;  // the scene, its surfaces undivided
  SolvedElements solved;
  bool has_exact_factors = true;  // those of the matrix; else there is no pointwise estimate
  LightTest lights = LightTest::kExact;
  std::uint64_t memory = 0;  // bytes, as ExchangeRequest takes it
  std::uint32_t most = kMostDivided2;
  std::function<void(double)> progress = {};
};

// Returns the estimates. Of elements looked at each is cut in two halves, of which the exact factors to all elements
// and the exact direct light are taken.
//
//   (1) the halves of an element gather in the mean what it has, but for rounding
//   (2) the same bits for any number of threads
// COST: a triangulation and a sweep about each vertex, as for the factors, and what two pairs of each element with each
// of those looked at cost; then those of face means.
DividingEstimate estimate_dividing(const DividingRequest2& request);

// Which elements of edges that are divided evenly are merged in pairs.
ElementMerging merging_in_pairs(const Scene2& scene, std::span<const Element> elements);

}  // namespace hottel

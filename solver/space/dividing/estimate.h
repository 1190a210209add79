// What dividing every polygon once more would change, estimated: what points of elements see.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

// How many elements are looked at, at the most.
inline constexpr std::uint32_t kMostDivided3 = 64;

// What is to be estimated for.
struct DividingRequest3 {
  const PreparedScene3& prepared;
  SolvedElements solved;
  Granularity granularity = Granularity::kFace;  // of the matrix
  bool has_exact_factors = true;                 // those of the matrix; else there is no pointwise estimate
  LightTest lights = LightTest::kExact;
  std::uint32_t most = kMostDivided3;
  std::function<void(double)> progress = {};
};

// Returns the estimates. Each element looked at is divided as `--elements` would do it the next time: in four, where it
// is a quad or a triangle. Of each part the middle of its largest patch gathers what it sees, exactly; the direct light
// is that of the whole part.
//
//   (1) what elements gather on masks that lie on them, and these on their bases, is as they are
//   (2) the same bits for any number of threads
// COST: a map from each part of those looked at, and for each face that is seen and divided the product of fragments
// and elements; the shares of lights in the parts; then those of face means.
DividingEstimate estimate_dividing(const DividingRequest3& request);

// Which elements of polygons that are divided evenly are merged, four to one.
ElementMerging merging_in_fours(const Scene3& scene, std::span<const Element> elements);

}  // namespace hottel

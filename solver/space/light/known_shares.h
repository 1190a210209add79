// Shares of lights, as far as they are not known from another scene.
#pragma once

#include <memory>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/light_test.h"

namespace hottel {

// The lights of a scene, and their shares. Null: none are known.
struct KnownShares3 {
  std::vector<Light> lights;
  std::vector<LightPlace3> places;
  std::shared_ptr<const std::vector<LightShares>> shares = nullptr;
};

// Whether two lights shine on the same: they stand at one place, and their beams are the same. Neither power nor motion
// matters.
bool is_lit_alike_3(const Light& a, const LightPlace3& at, const Light& b, const LightPlace3& there);

// Returns light_shares(prepared, granularity, test) of tested_shares.h. Lights that shine as one that is known have its
// shares.
//
// REQUIRES that those are of the same elements, by the same test.
std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity, LightTest test,
                                      const KnownShares3& known);

}  // namespace hottel

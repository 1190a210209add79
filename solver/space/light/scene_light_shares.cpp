#include "solver/space/light/scene_light_shares.h"

#include "kernel/support/failure.h"

namespace hottel {

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity) {
  HOTTEL_REQUIRE(prepared.scene.lights.empty());
  return {};
}

}  // namespace hottel

// What gathered light of a solution is made of.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/radiosity/direct_light.h"
#include "solver/space/light/gathered_light.h"
#include "solver/space/light/scene_lights.h"
#include "viewer/picture/space/gathered_view.h"

namespace hottel {

// The light of a solution, ready to be gathered: radiosity runs over the elements that send (smooth_runs_3), so that
// nothing jumps at their borders. At the corners of elements it is what is gathered there, but for direct light, of
// which corners have the mean of what elements around them have.
//
// responses: what is told of points. shares: of the lights of the scene. REQUIRES that scene and solution outlive it.
// COST: that of a SmoothMesh3, and of GatheredLight3 for each corner.
class GatheredSource3 {
 public:
  GatheredSource3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                  Responses3 responses, std::span<const LightShares> shares);

  const GatheredLight3& light() const { return light_; }
  const Responses3& responses() const { return responses_; }
  const ElementTable3& table() const { return *table_; }
  // To be looked at: lights as GatheredScene3 has them.
  GatheredScene3 scene(const ElementPaint3& paint, const SceneLights3* lights = nullptr) const {
    return {prepared_, *table_, paint, responses_, light_, lights};
  }

 private:
  const PreparedScene3& prepared_;
  std::shared_ptr<const ElementTable3> table_;
  Responses3 responses_;
  std::vector<PartRun3> runs_;
  GatheredLight3 light_;
};

}  // namespace hottel

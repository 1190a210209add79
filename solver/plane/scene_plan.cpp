#include "solver/plane/scene_plan.h"

namespace hottel {

Plan plan_scene(const Scene2& scene, const PlanRequest& request) {
  return {scene, {.is_convex_room = is_convex_room(scene), .noun = "edge"}, request};
}

}  // namespace hottel

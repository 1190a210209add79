#include "solver/plane/scene_plan.h"

#include <algorithm>

#include "kernel/support/counted.h"
#include "solver/plan_draft.h"

namespace hottel {
namespace {

// What the showcase and generated scenes take, on one core of the machine of benchmarks/results.
constexpr double kSecondsPerPair = 1.0e-6;
constexpr double kSecondsPerCellAndEdge = 2.0e-8;
constexpr double kSecondsPerShare = 1.0e-5;
constexpr double kTypicalVisible = 60;  // faces that one face sees in a furnished or cluttered scene

}  // namespace

Plan plan_scene(const Scene2& scene, const PlanRequest& request) {
  const auto n = static_cast<double>(scene.surfaces.size());
  const bool is_convex = is_convex_room(scene);
  PlanDraft draft(scene, request, {.one = "edge", .across = "along edges"});
  draft.add(Plan::kOcclusion, !is_convex, draft.count_text(scene.surfaces.size()) + " that may hide each other",
            "one convex room: nothing can hide anything", n * std::min(n, kTypicalVisible) * kSecondsPerPair);
  draft.add_back_faces();
  draft.add_sky(is_convex, 0);
  draft.add_subdivision();
  draft.add_channels();
  draft.add_interreflection(n);
  draft.add_unreachable(is_convex);
  draft.add(Plan::kIllumination, request.grid_cells > 0, counted(request.grid_cells, "cell"), "no grid is asked for",
            static_cast<double>(request.grid_cells) * std::min(n, 400.0) * kSecondsPerCellAndEdge);
  draft.add_lights(n * kSecondsPerShare);
  return draft.take();
}

}  // namespace hottel

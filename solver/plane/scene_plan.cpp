#include "solver/plane/scene_plan.h"

#include <algorithm>

#include "geometry/plane/scene/moving_lights.h"
#include "kernel/support/counted.h"
#include "solver/plan_draft.h"

namespace hottel {
namespace {

// What the showcase and generated scenes take, on one core of the machine of benchmarks/results. What is seen in a
// scene with something between hardly depends on how large it is.
constexpr double kSecondsPerRow = 2.5e-5;  // of factors, where something may hide others
constexpr double kSecondsPerCell = 1.0e-7;
constexpr double kSecondsPerCellAndSeen = 2.0e-8;
constexpr double kSecondsPerShare = 1.0e-5;
constexpr double kSecondsPerPicture = 0.18;  // of the usual size
constexpr double kSeenFromAPlace = 50, kSeenFromAFace = 32;

// Elements that have a row.
double rows_of(const Scene2& scene) {
  double rows = 0;
  for (const Surface& surface : scene.surfaces)
    for (const bool is_back : {false, true})
      if (surface.material_of(is_back)) rows += surface.elements;
  return rows;
}

}  // namespace

Plan plan_scene(const Scene2& scene, const PlanRequest& request) {
  const double n = rows_of(scene);
  const bool is_convex = is_convex_room(scene);
  const double seen_from_a_face = is_convex ? n : std::min(n, kSeenFromAFace);
  const double seen_from_a_place = is_convex ? n : std::min(n, kSeenFromAPlace);
  const auto cells = static_cast<double>(request.grid_cells);
  PlanDraft draft(scene, request, {.one = "edge", .across = "along edges"});
  draft.add(Plan::kOcclusion, !is_convex, draft.count_text(scene.surfaces.size()) + " that may hide each other",
            "one convex room: nothing can hide anything", n * kSecondsPerRow);
  draft.add_back_faces();
  draft.add_sky(is_convex, 0);
  draft.add_subdivision();
  draft.add_channels();
  draft.add_interreflection(n, n * seen_from_a_face);
  draft.add_unreachable(is_convex);
  draft.add(Plan::kIllumination, request.grid_cells > 0, counted(request.grid_cells, "cell"), "no grid is asked for",
            cells * (kSecondsPerCell + seen_from_a_place * kSecondsPerCellAndSeen));
  draft.add_as_asked(Plan::kPicture, request.grid_cells > 0, "the light in the rooms", "no grid is asked for",
                     kSecondsPerPicture);
  draft.add_lights(n * kSecondsPerShare);
  draft.add_movement(has_moving_lights(scene));
  return draft.take();
}

}  // namespace hottel

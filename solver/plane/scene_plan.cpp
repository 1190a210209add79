#include "solver/plane/scene_plan.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/moving_lights.h"
#include "kernel/plain_functions.h"
#include "kernel/support/counted.h"
#include "solver/plan_draft.h"
#include "solver/plane/dividing/estimate.h"

namespace hottel {
namespace {

// What the showcase and generated scenes take, on one core of the machine of benchmarks/results.
constexpr double kSecondsPerVertex = 5.0e-6;      // of the arrangement
constexpr double kSecondsPerPair = 1.2e-6;        // of factors, where something may hide others
constexpr double kSecondsPerSight = 5.0e-8;       // of a vertex, from another
constexpr double kSecondsPerPlainPair = 5.0e-7;   // that is not rounded correctly
constexpr double kSecondsPerPairOnDisk = 2.5e-7;  // to be written, read again, and rounded once more
constexpr double kSecondsPerCell = 2.0e-7;
constexpr double kSecondsPerCellAndSeen = 1.2e-8;
constexpr double kTimesOfAnAverage = 16;  // what an average over a cell costs over the light at its centre
constexpr double kSeenTogether = 220;     // cells near each other share less of what they see where more of it hides
constexpr double kSecondsPerShare = 1.0e-5;
constexpr double kSecondsPerPixel = 8.0e-8;
constexpr double kUsualSide = 1400;  // pixels along the longer side of a picture, at least
constexpr std::uint64_t kSample = 64;

// Pixels of a picture of the light: whole ones a cell.
double pixels_of(double cells, double longer_side) {
  const double along = std::ceil(kUsualSide / longer_side);
  return cells * along * along;
}

double pixels_of(const PlanRequest& request) {
  if (request.grid_pixels > 0) return static_cast<double>(request.grid_pixels);
  const auto cells = static_cast<double>(request.grid_cells);
  return pixels_of(cells, std::sqrt(cells));
}

}  // namespace

std::uint64_t picture_pixels_2(const Grid2& grid) {
  return static_cast<std::uint64_t>(pixels_of(static_cast<double>(grid.cells()), std::max(grid.nx, grid.ny)));
}

double seconds_of_factors_2(double vertices, double pairs) {
  return vertices * kSecondsPerVertex + pairs * kSecondsPerPair;
}

double seconds_on_disk_2(double pairs) { return pairs * kSecondsPerPairOnDisk; }

Plan plan_scene(const PreparedScene2& prepared, const PlanRequest& request) {
  const Scene2& scene = prepared.scene;
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  double n = 0;
  for (std::uint32_t label = 0; label < table.count(); ++label) n += table.has_row(label);
  const auto vertices = static_cast<double>(prepared.arrangement.vertices().size());
  const bool is_convex = is_convex_room(scene);
  const SightEstimate2 sight = is_convex ? SightEstimate2() : estimated_sight(prepared.arrangement, table, kSample);
  const double pairs = is_convex ? n * n / 2 : static_cast<double>(sight.pairs);
  const double seen = is_convex ? n : sight.seen * (1 + same_bits::pow(sight.seen_typed / kSeenTogether, 2));
  const auto cells = static_cast<double>(request.grid_cells);
  PlanDraft draft(scene, request, {.one = "edge", .across = "along edges"});
  draft.add(Plan::kOcclusion, !is_convex, draft.count_text(scene.surfaces.size()) + " that may hide each other",
            "one convex room: nothing can hide anything", seconds_of_factors_2(vertices, pairs));
  draft.add_back_faces();
  draft.add_sky(is_convex, 0);
  draft.add_subdivision();
  draft.add_channels();
  draft.add_interreflection(n, 2 * pairs);
  draft.add_unreachable(is_convex);
  const double halves = 2 * std::min<double>(n, kMostDivided2);
  draft.add_dividing(vertices * (kSecondsPerVertex + seen * kSecondsPerSight) +
                     (n > 0 ? 2 * pairs / n * halves : 0) * kSecondsPerPlainPair);
  draft.add(Plan::kIllumination, request.grid_cells > 0, counted(request.grid_cells, "cell"), "no grid is asked for",
            cells * (kSecondsPerCell + seen * kSecondsPerCellAndSeen) * (request.is_average ? kTimesOfAnAverage : 1));
  draft.add_as_asked(Plan::kPicture, request.has_picture,
                     request.grid_cells > 0 ? "the light in the rooms" : "values of faces", "no picture is asked for",
                     request.has_picture && request.grid_cells > 0 ? pixels_of(request) * kSecondsPerPixel : 0);
  draft.add_lights(n * kSecondsPerShare);
  draft.add_movement(has_moving_lights(scene));
  return draft.take();
}

}  // namespace hottel

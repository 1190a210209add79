#include "solver/space/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "geometry/exchange_report.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/nothing_between.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "geometry/space/scene/moving_lights.h"
#include "kernel/plain_functions.h"
#include "kernel/support/counted.h"
#include "solver/plan_draft.h"
#include "solver/space/dividing/estimate.h"
#include "solver/space/sampled_cost.h"

namespace hottel {
namespace {

// What the scenes of benchmarks/plan_estimates.py take, on one core: to arrange a polygon; a pair that face each other
// with nothing there.
constexpr double kSecondsPerPolygon = 3.0e-4;
constexpr double kSecondsPerPair = 1.8e-5;
constexpr double kSecondsPerMap = 3.0e-6;    // of a cell, by polygon
constexpr double kSecondsPerPart = 1.0e-6;   // of a cell, by element
constexpr double kSecondsPerShare = 1.0e-4;  // of a light, by polygon
constexpr double kSecondsPerPixel = 1.5e-7;
constexpr double kSecondsPerGathered = 1.5e-6;  // of a point where light is gathered, by polygon
constexpr double kSecondsPerRun = 2.1e-5;       // of the same, where radiosity runs over elements; by their number
constexpr double kPowerOfRuns = 0.3;            // to this power: most are seen whole, and far away
constexpr double kGatheredPoints = 1100;        // of a picture, by its pixels
constexpr double kPowerOfPixels = 0.28;         // to this power: points stand close where light changes, along lines
constexpr double kMostGathered = 2;             // and at most so many for each pixel
constexpr double kPairsOfACell = 2;  // what averages over a cell cost over pairs of a row: less of it is clear
// Pairs of faces that are looked at to tell how many face each other.
constexpr std::size_t kMostLookedAt = 2000;

// The faces of a scene, and how many elements each is divided into.
class Faces {
 public:
  explicit Faces(const PreparedScene3& prepared)
      : occluders_(prepared.occluders()), table_(*prepared.elements(Granularity::kFace)) {
    const Scene3& scene = prepared.scene;
    for (const Element& face : table_.elements()) {
      const Surface& surface = scene.surfaces[face.surface];
      const std::uint64_t leaves = surface.trees.of(face.is_back).size();
      const std::uint64_t parts = !face.material ? 1
                                  : leaves > 0   ? leaves
                                                 : element_count(scene.polygons[face.surface], surface.elements);
      parts_.push_back(static_cast<double>(parts));
      if (face.material && face.area.value > 0) rows_ += parts;
    }
  }

  std::uint64_t rows() const { return rows_; }

  // About how many pairs of elements, of which one has a row, face each other.
  double facing_pairs() const {
    const std::size_t n = table_.count();
    if (n < 2) return 0;
    double sum = 0;
    if (n * (n - 1) / 2 <= kMostLookedAt) {
      for (std::uint32_t j = 1; j < n; ++j)
        for (std::uint32_t i = 0; i < j; ++i) sum += pairs_of(i, j);
      return sum;
    }
    std::mt19937_64 random(1);
    for (std::size_t k = 0; k < kMostLookedAt; ++k) {
      const auto i = static_cast<std::uint32_t>(random() % n), j = static_cast<std::uint32_t>(random() % (n - 1));
      sum += pairs_of(i, j < i ? j : j + 1);
    }
    return sum / kMostLookedAt * static_cast<double>(n) * static_cast<double>(n - 1) / 2;
  }

 private:
  double pairs_of(std::uint32_t i, std::uint32_t j) const {
    if (!table_.has_row(i) && !table_.has_row(j)) return 0;
    if (table_.parts(i).empty() || table_.parts(j).empty()) return 0;
    if (!surfaces_face_each_other(occluders_, table_.parts(i).front(), table_.parts(j).front())) return 0;
    return parts_[i] * parts_[j];
  }

  const Occluders3& occluders_;
  const ElementTable3& table_;
  std::vector<double> parts_;  // elements by face
  std::uint64_t rows_ = 0;
};

std::string short_count(double count) {
  return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
}

void add_groups(const Scene3& scene, PlanDraft& draft) {
  const std::vector<std::size_t> sizes = group_sizes(scene);
  const auto count = static_cast<std::size_t>(std::ranges::count_if(sizes, [](std::size_t size) { return size > 1; }));
  draft.add(Plan::kGroups, count > 0, counted(count, "group") + " of several polygons: a row each with --per group",
            "every polygon is a group of its own");
}

// Of a point, by what it sees.
double seconds_per_map(const Scene3& scene, std::uint64_t rows) {
  return static_cast<double>(scene.polygons.size()) * kSecondsPerMap +
         (is_divided(scene) ? static_cast<double>(rows) * kSecondsPerPart : 0);
}

// Of a point of a face, where light is gathered.
double seconds_per_gathered(const Scene3& scene, std::uint64_t rows) {
  return static_cast<double>(scene.polygons.size()) * kSecondsPerGathered +
         (is_divided(scene) ? same_bits::pow(static_cast<double>(rows), kPowerOfRuns) * kSecondsPerRun : 0);
}

void add_picture(const Scene3& scene, const PlanRequest& request, std::uint64_t rows, PlanDraft& draft) {
  const Camera3 usual, &camera = scene.camera ? *scene.camera : usual;
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const double points = std::min(kGatheredPoints * same_bits::pow(pixels, kPowerOfPixels), kMostGathered * pixels);
  const double gathered = request.is_gathered ? points * seconds_per_gathered(scene, rows) : 0;
  const std::string who = scene.camera ? "what the camera sees" : "what a camera chosen for the scene sees";
  const bool has_any = request.has_picture && !scene.surfaces.empty();
  draft.add_as_asked(Plan::kPicture, has_any, who + (request.is_gathered ? ", its light gathered" : ""),
                     request.has_picture ? "the scene is empty" : "no picture is asked for",
                     has_any ? pixels * kSecondsPerPixel + gathered : 0);
}

// Light between the faces, and on them. seconds_per_row: what the factors of a row take.
void add_light(const Scene3& scene, const PlanRequest& request, std::uint64_t rows, double seconds_per_row,
               PlanDraft& draft) {
  const double seconds_per_cell =
      request.is_average ? kPairsOfACell * seconds_per_row + kSecondsPerPolygon : seconds_per_map(scene, rows);
  draft.add_as_asked(
      Plan::kIllumination, request.grid_cells > 0,
      (request.is_average ? "the irradiance of " : "light between the faces, ") + counted(request.grid_cells, "cell"),
      "no grid is asked for", static_cast<double>(request.grid_cells) * seconds_per_cell);
  add_picture(scene, request, rows, draft);
  if (request.texels > 0)
    draft.add_as_asked(Plan::kTexels, true, "light gathered at " + counted(request.texels, "point") + " of a face", "",
                       static_cast<double>(request.texels) * seconds_per_gathered(scene, rows));
  draft.add_lights(static_cast<double>(scene.surfaces.size()) * kSecondsPerShare);
  draft.add_movement(has_moving_lights(scene));
}

}  // namespace

Plan plan_scene(const PreparedScene3& prepared, const PlanRequest& request, SkyBy sky) {
  const Scene3& scene = prepared.scene;
  const Arrangement3& arrangement = prepared.arrangement();
  const Occluders3& occluders = prepared.occluders();
  const Faces faces(prepared);
  const bool is_plain = arrangement.is_plain(), is_empty = scene.surfaces.empty();
  const bool is_room = is_plain && is_convex_room(scene, occluders);
  const bool hides = !is_room && !(is_plain && faces_nothing(scene, occluders));
  const double pairs = faces.facing_pairs();
  const bool sees_sky = !is_room && (!scene.closed || request.everything);
  const SampledCost3 cost = hides || sees_sky ? sampled_cost(prepared, sees_sky) : SampledCost3();
  const double plain = hides || sees_sky ? cost.plain : pairs * kSecondsPerPair;
  PlanDraft draft(scene, request, {.one = "polygon", .across = "across polygons"});
  draft.add(Plan::kExchange, !is_empty,
            fmt::format("{}, about {} pairs that face each other", counted(faces.rows(), "row"), short_count(pairs)),
            "the scene is empty",
            static_cast<double>(scene.polygons.size()) * kSecondsPerPolygon + plain + cost.sampling);
  draft.add(Plan::kOcclusion, hides, draft.count_text(scene.surfaces.size()) + " that may hide each other, or the sky",
            is_empty  ? "the scene is empty"
            : is_room ? "one convex room: nothing can hide anything"
                      : "no face has anything before it",
            cost.pairs - cost.plain);
  draft.add_back_faces();
  const bool is_by_closure = sky == SkyBy::kClosure;
  draft.add_sky(is_room, is_by_closure ? cost.sky / kRowsOfASkyCheck : cost.sky, is_by_closure);
  draft.add_subdivision();
  add_groups(scene, draft);
  draft.add_channels();
  draft.add_interreflection(static_cast<double>(faces.rows()), 2 * pairs);
  draft.add_unreachable(is_room);
  draft.add_dividing(4 * std::min<double>(static_cast<double>(faces.rows()), kMostDivided3) *
                     seconds_per_map(scene, faces.rows()));
  const double of_all = plain + std::max(0.0, cost.pairs - cost.plain) + (is_by_closure ? 0 : cost.sky);
  const double rows = std::max<double>(1, static_cast<double>(faces.rows()));
  add_light(scene, request, faces.rows(), 2 * of_all / rows, draft);
  return draft.take();
}

}  // namespace hottel

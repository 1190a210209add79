// rays:N, rays:N:stratified, rays:N:sobol, each with :uniform and :seed=S.
// GUARANTEE: estimated.
// REFERENCE: J. R. Howell, The Monte Carlo method in radiative heat transfer, 1998; A. B. Owen, Monte Carlo variance of
// scrambled net quadrature, 1997; I. Wald et al., Embree: a kernel framework for efficient CPU ray tracing, 2014.
#include "solver/space/methods/rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "solver/methods/factor_rows.h"
#include "solver/methods/ray_names.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/space/methods/contact_rows.h"
#include "solver/space/methods/embree_scene.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/side_elements.h"

namespace hottel {
namespace {

constexpr const char* kRaysReference = "Howell 1998; Owen 1997; Wald 2014";
constexpr double kChance = 5.7e-7;                           // beyond five standard deviations
constexpr double kSinglePrecision = 1e-4;                    // allowed for what Embree's numbers shift; an estimate
constexpr std::uint64_t kOtherSeed = 0x6a09e667f3bcc909ull;  // of places, beside that of directions

// Where a ray may start: a triangle of a patch.
struct Start {
  const ElementPatch3* patch;
  Vector3d corner, along, across;
  double end;  // of the area, from the first triangle on: in (0, 1]
};

std::vector<Start> starts_on(std::span<const ElementPatch3> patches) {
  std::vector<Start> starts;
  double area = 0;
  for (const ElementPatch3& patch : patches)
    for (std::size_t k = 1; k + 1 < patch.corners.size(); ++k) {
      const Vector3d &first = patch.corners[0], along = patch.corners[k] - first, across = patch.corners[k + 1] - first;
      area += dot(cross(along, across), patch.normal);
      starts.push_back({&patch, first, along, across, area});
    }
  for (Start& start : starts) start.end /= area;
  starts.back().end = 1;
  return starts;
}

// The element at a place of a side, or that nearest to it; `nothing` where the side has none: a place within a solid.
std::uint32_t element_at(std::span<const SidePart3> side, const Vector3d& place, const Vector3d& outward,
                         std::uint32_t nothing) {
  if (side.size() == 1) return side.front().label;
  std::uint32_t best = nothing;
  double least_outside = std::numeric_limits<double>::infinity();
  for (const SidePart3& part : side) {
    double outside = 0;  // how far the place is beyond a border of the part
    for (std::size_t k = 0; k < part.corners.size(); ++k) {
      const Vector3d& a = part.corners[k];
      const Vector3d edge = part.corners[k + 1 == part.corners.size() ? 0 : k + 1] - a;
      outside = std::max(outside, dot(cross(place - a, edge), outward) / length(edge));
    }
    if (outside == 0) return part.label;
    if (outside < least_outside) {
      least_outside = outside;
      best = part.label;
    }
  }
  return best;
}

class Rays3 final : public ElementMethod3 {
 public:
  explicit Rays3(const RayOptions& options) : options_(options), info_(ray_method_info(options, kRaysReference)) {}
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene3& prepared) const override;

 protected:
  ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override {
    const ElementGeometry3 geometry(prepared);
    const EmbreeScene3 scene(prepared.occluders());
    const SideElements3 sides(prepared, geometry.table());
    const RaySamples directions(options_.sampling, options_.rays, options_.seed);
    const RaySamples places(options_.sampling, options_.rays, options_.seed ^ kOtherSeed, 2);
    const FillRow shoot = [&](std::uint32_t from, RowSums& by) {
      const double share = geometry.share_of_patches(from);
      if (geometry.patches(from).empty() || share == 0) return add_contacts(geometry, from, by);
      const std::vector<Start> starts = starts_on(geometry.patches(from));
      const std::vector<RaySamples::Point> at = paired_places(places, from);
      std::size_t k = 0;
      directions.for_each(from, [&](const RaySamples::Point& direction) {
        by.add(label_met(prepared.occluders(), scene, sides, starts, at[k++], direction, geometry.table().sky()), 1);
      });
      by.divide_by(static_cast<double>(options_.rays) / share);
      add_contacts(geometry, from, by);
    };
    ExchangeMatrix matrix =
        matrix_by_rows(geometry.table().elements(), has_patches(geometry), progress, [&] { return shoot; });
    report.standard_error = largest_standard_error(matrix, options_.rays);
    report.row_defect = closure_defect(matrix);
    report.notes.push_back(fmt::format("seed {}", options_.seed));
    return matrix;
  }

 private:
  // Strata of places are paired with those of directions at random; the points of a sequence in four dimensions are
  // pairs already.
  std::vector<RaySamples::Point> paired_places(const RaySamples& places, std::uint32_t from) const {
    std::vector<RaySamples::Point> points;
    points.reserve(options_.rays);
    places.for_each(from, [&](const RaySamples::Point& point) { points.push_back(point); });
    if (options_.sampling == Sampling::kStratified) {
      const RandomStream random(options_.seed + kOtherSeed, from);
      for (std::size_t k = points.size(); k > 1; --k)
        std::swap(points[k - 1], points[static_cast<std::size_t>(random.uniform(k) * static_cast<double>(k))]);
    }
    return points;
  }

  std::uint32_t label_met(const Occluders3& occluders, const EmbreeScene3& scene, const SideElements3& sides,
                          const std::vector<Start>& starts, const RaySamples::Point& place,
                          const RaySamples::Point& direction, std::uint32_t sky) const {
    const auto start =
        std::find_if(starts.begin(), starts.end() - 1, [&place](const Start& s) { return place.position < s.end; });
    const double begin = start == starts.begin() ? 0 : (start - 1)->end;
    const double within = std::clamp((place.position - begin) / (start->end - begin), 0.0, 1.0);
    // Uniform over a triangle.
    const double root = std::sqrt(within), s = root * (1 - place.turn), t = root * place.turn;
    const Vector3d from = start->corner + s * start->along + t * start->across;

    const Vector3d u = 1 / length(start->along) * start->along, v = cross(start->patch->normal, u);
    const bool is_by_cosine = options_.law == EmissionLaw::kCosine;
    const double cosine = is_by_cosine ? std::sqrt(1 - direction.position) : 1 - direction.position;
    const double sine = is_by_cosine ? std::sqrt(direction.position) : std::sqrt(1 - cosine * cosine);
    const double turn = 2 * std::numbers::pi * direction.turn;
    const Vector3d way =
        cosine * start->patch->normal + sine * same_bits::cos(turn) * u + sine * same_bits::sin(turn) * v;
    const auto hit = scene.first_hit(from, way, start->patch->piece);
    if (!hit) return sky;
    const BoundedVector& rounded_front = occluders.normal(hit->piece);
    const Vector3d front{rounded_front.x, rounded_front.y, rounded_front.z};
    const bool is_back = dot(front, way) > 0;
    const Vector3d outward = (is_back ? -1 : 1) / length(front) * front;
    return element_at(sides.on({hit->piece, is_back}), from + hit->distance * way, outward, sky);
  }

  RayOptions options_;
  MethodInfo info_;
};

// With strata, the count of rays that go from i to j is the sum over the places p of h(p, d) for the directions d that
// they are paired with: given these, off from its mean over all pairings by t but for 2 exp(-t^2 / (4 n + 2 t))
// (Chatterjee 2007, proposition 1.1); and that mean, which no place and no direction changes by more than 1, by t but
// for 2 exp(-t^2 / n) (McDiarmid 1989).
std::optional<double> Rays3::declared_error(const PreparedScene3& prepared) const {
  if (options_.law != EmissionLaw::kCosine) return std::nullopt;
  const ElementGeometry3 geometry(prepared);
  const auto n = static_cast<double>(options_.rays);
  const double columns = geometry.count() + 1.0, pairs = columns * columns;
  double error = 1;
  if (options_.sampling == Sampling::kIndependent) {
    error = std::sqrt(same_bits::log(2 * pairs / kChance) / (2 * n));
  } else if (options_.sampling == Sampling::kStratified) {
    const double odds = same_bits::log(4 * pairs / kChance);
    error = (odds + std::sqrt(odds * odds + 4 * n * odds) + std::sqrt(n * odds)) / n;
  }
  error += kSinglePrecision;
  return error < 1 ? std::optional(error) : std::nullopt;
}

}  // namespace

std::unique_ptr<ExchangeMethod3> rays_method_3(const RayOptions& options) {
  HOTTEL_REQUIRE(options.rays >= 1 && options.rays <= kMostRays);
  return std::make_unique<Rays3>(options);
}

MethodFamily3 rays_family_3() {
  return {.name = "rays",
          .pattern = kRaysPattern,
          .what = "N random rays from each element, first hit, by Embree",
          .reference = kRaysReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = rays_sweep(),
          .make = [](std::string_view variant) { return rays_method_3(ray_options(variant)); }};
}

}  // namespace hottel

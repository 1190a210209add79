// rays:N, rays:N:stratified, rays:N:sobol, each with :uniform and :seed=S.
// GUARANTEE: estimated.
// REFERENCE: J. R. Howell, The Monte Carlo method in radiative heat transfer, 1998; A. B. Owen, Monte Carlo variance of
// scrambled net quadrature, 1997.
#include "solver/plane/methods/rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/plane/visibility/first_hit.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "solver/methods/factor_rows.h"
#include "solver/methods/ray_names.h"
#include "solver/plane/methods/element_geometry.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

constexpr const char* kRaysReference = "Howell 1998; Owen 1997";
constexpr double kChance = 5.7e-7;  // beyond five standard deviations

// The pieces of an element from its first to its second end: from where rays may start.
class RayStarts {
 public:
  RayStarts(const Arrangement2& arrangement, const ElementGeometry2& geometry) : parts_(geometry.count()) {
    for (const PieceSideId side : arrangement.sides()) {
      const std::uint32_t element = geometry.table().of(side);
      if (!geometry.has_row(element) || geometry.runs(element).empty()) continue;
      const Segment2& piece = arrangement.piece(side);
      const LocalPoint2 &a = geometry.place(piece.a), &b = geometry.place(piece.b);
      // The front is on the right of a run, so a run goes along a -> b where its side is the right one.
      parts_[element].push_back({side, !is_right(side), length(b - a), 0, 0});
      const ElementRun2& run = geometry.runs(element).front();
      parts_[element].back().order = dot(a - run.from, run.direction) + dot(b - run.from, run.direction);
    }
    for (auto& parts : parts_) {
      std::sort(parts.begin(), parts.end(), [](const Part& p, const Part& q) { return p.order < q.order; });
      for (std::size_t k = 1; k < parts.size(); ++k) parts[k].begin = parts[k - 1].begin + parts[k - 1].length;
    }
  }

  // REQUIRES a row for the element, and a position in (0, 1).
  PieceRay2 at(std::uint32_t element, double position) const {
    const std::vector<Part>& parts = parts_[element];
    if (parts.size() == 1) return start(parts.front(), position);
    const double distance = position * (parts.back().begin + parts.back().length);
    // The first part begins at 0, and the distance is not below.
    const auto part = std::upper_bound(parts.begin() + 1, parts.end(), distance,
                                       [](double d, const Part& p) { return d < p.begin; }) -
                      1;
    // Pieces that are shorter than the frame can tell are points: any place on them is the same.
    return start(*part, part->length > 0 ? (distance - part->begin) / part->length : 0.5);
  }

 private:
  struct Part {
    PieceSideId side;
    bool is_reversed;  // the piece runs against the element
    double length, begin, order;
  };
  static PieceRay2 start(const Part& part, double position) {
    const double s = std::clamp(position, 0x1p-53, 1 - 0x1p-53);
    return {part.side, part.is_reversed ? 1 - s : s, 0, 0};
  }

  std::vector<std::vector<Part>> parts_;  // by element
};

class Rays2 final : public ElementMethod2 {
 public:
  explicit Rays2(const RayOptions& options) : options_(options), info_(ray_method_info(options, kRaysReference)) {}
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene2& prepared) const override;
  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override;

 private:
  // The sine and the cosine of the angle to the normal.
  LocalVector2 direction(double turn) const {
    if (options_.law == EmissionLaw::kCosine) return {2 * turn - 1, 2 * std::sqrt(turn * (1 - turn))};
    const double angle = std::numbers::pi * (turn - 0.5);
    return {same_bits::sin(angle), same_bits::cos(angle)};
  }

  RayOptions options_;
  MethodInfo info_;
};

ExchangeMatrix Rays2::compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                       MethodReport& report) const {
  const ElementGeometry2 geometry(prepared);
  const RayStarts starts(prepared.arrangement, geometry);
  const FirstHit2 first_hit(prepared.arrangement);
  const RaySamples samples(options_.sampling, options_.rays, options_.seed);
  const auto n = static_cast<double>(options_.rays);
  const FillRow shoot = [&](std::uint32_t from, RowSums& by) {
    const LocalVector2 along = geometry.runs(from).front().direction, up = geometry.runs(from).front().normal();
    samples.for_each(from, [&](const RaySamples::Point& point) {
      const LocalVector2 way = direction(point.turn);
      PieceRay2 ray = starts.at(from, point.position);
      ray.dx = way.x * along.x + way.y * up.x;
      ray.dy = way.x * along.y + way.y * up.y;
      by.add(geometry.table().of(first_hit(ray)), 1);
    });
    by.divide_by(n);
  };
  ExchangeMatrix matrix =
      matrix_by_rows(geometry.table().elements(), has_runs(geometry), progress, [&] { return shoot; });

  report.standard_error = largest_standard_error(matrix, options_.rays);
  report.row_defect = closure_defect(matrix);
  report.notes.push_back(fmt::format("seed {}", options_.seed));
  return matrix;
}

std::optional<double> Rays2::declared_error(const PreparedScene2& prepared) const {
  if (options_.law != EmissionLaw::kCosine) return std::nullopt;
  const ElementGeometry2 geometry(prepared);
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    if (geometry.has_row(i) && !geometry.is_whole(i)) return std::nullopt;
  const auto n = static_cast<double>(options_.rays);
  const double columns = geometry.count() + 1.0, pairs = columns * columns;
  double error = 1;
  if (options_.sampling != Sampling::kSobol) error = std::sqrt(same_bits::log(2 * pairs / kChance) / (2 * n));
  // What is seen changes across the curves on which a vertex is seen: angles that fall from one end to the other.
  const auto curves = static_cast<double>(prepared.arrangement.vertices().size());
  error = std::min(error, curves * parts_met_by_a_curve(options_.sampling, options_.rays) / n);
  return error < 1 ? std::optional(error) : std::nullopt;
}

}  // namespace

std::unique_ptr<ExchangeMethod2> rays_method_2(const RayOptions& options) {
  HOTTEL_REQUIRE(options.rays >= 1 && options.rays <= kMostRays);
  return std::make_unique<Rays2>(options);
}

MethodFamily2 rays_family_2() {
  return {.name = "rays",
          .pattern = kRaysPattern,
          .what = "N random rays from each element, first hit",
          .reference = kRaysReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = rays_sweep(),
          .make = [](std::string_view variant) { return rays_method_2(ray_options(variant)); }};
}

}  // namespace hottel

// points:n, exact factors from n x n Gauss-Legendre points of each patch: what is left is the quadrature over one area.
// F_ij = sum_k w_k F(x_k, j), F(x, j) from the exact map of the point (geometry/space/visibility/visibility_map.h).
// GUARANTEE: estimated. The error is that of the quadrature of x -> F(x, j): smooth where nothing hides a part of j,
// with kinks where something does, singular where elements touch. REFERENCE: Gauss-Legendre quadrature (Trefethen,
// Approximation Theory and Approximation Practice, 2013, chapter 19).
#include <memory>
#include <vector>

#include "geometry/space/prepared/face_patches.h"
#include "geometry/space/visibility/convex_cut.h"
#include "geometry/space/visibility/visibility_map.h"
#include "solver/methods/factor_rows.h"
#include "solver/methods/gauss_rule.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/space/methods/contact_rows.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/patch_rule.h"
#include "solver/space/methods/quadrature_claims.h"
#include "solver/space/methods/side_elements.h"

namespace hottel {
namespace {

constexpr int kMostPoints = 64;
constexpr double kClosed = 5e-15;  // of the sky, by roundings, where none is seen (visibility_map.h)
constexpr const char* kPointsReference = "Gauss-Legendre quadrature; Trefethen 2013, chapter 19";

Direction3 direction_of(const Vector3d& way) { return unit({way.x, way.y, way.z}); }

// Of the part of a fragment that a part of its side fills.
double factor_of(const Vector3d& eye, const Direction3& normal, const VisibilityMap3& map,
                 const VisibilityMap3::Fragment& fragment, const std::vector<Vector3d>& part) {
  std::vector<Direction3> cone;
  for (std::uint32_t k = fragment.begin; k < fragment.end; ++k) cone.push_back(map.corners[k].direction);
  std::vector<Direction3> ways;
  for (const Vector3d& corner : part) {
    const Vector3d way = corner - eye;
    ways.push_back({way.x, way.y, way.z});
  }
  cone = common_cone_3(std::move(cone), ways);
  return cone.size() >= 3 ? std::fabs(view_factor_3(cone, normal)) : 0;
}

// Adds what a point with a normal sees of a side of a piece, by element; `fragments` are those of one share.
void add_share(const Vector3d& eye, const Direction3& normal, const VisibilityMap3& map,
               const VisibilityMap3::Share& share, std::span<const VisibilityMap3::Fragment> fragments,
               std::span<const SidePart3> side, double weight, RowSums& by) {
  if (!(share.factor > 0)) return;
  if (side.size() == 1) return by.add(side.front().label, weight * share.factor);
  // What roundings leave goes to all in proportion: rows sum to 1.
  std::vector<double> seen(side.size(), 0);
  double all = 0;
  for (std::size_t k = 0; k < side.size(); ++k) {
    for (const VisibilityMap3::Fragment& fragment : fragments)
      seen[k] += factor_of(eye, normal, map, fragment, side[k].corners);
    all += seen[k];
  }
  if (!(all > 0)) return;
  for (std::size_t k = 0; k < side.size(); ++k) by.add(side[k].label, weight * share.factor * seen[k] / all);
}

class Points3 final : public ElementMethod3 {
 public:
  explicit Points3(int n)
      : info_{"points:" + std::to_string(n), "points", static_cast<double>(n), Guarantee::kEstimated, kPointsReference},
        rule_(gauss_rule(n)) {}
  const MethodInfo& info() const override { return info_; }
  // Proven of elements that see each other wholly (quadrature_claims.h).
  std::optional<double> declared_error(const PreparedScene3& prepared) const override {
    return quadrature_claim_3(prepared, claimed_rule());
  }
  ClaimedErrors claimed_errors(const PreparedScene3& prepared) const override {
    return quadrature_claims_3(prepared, claimed_rule());
  }

 protected:
  ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override {
    const ElementGeometry3 geometry(prepared);
    const SideElements3 elements(prepared, geometry.table());
    const FillRow fill = [&](std::uint32_t from, RowSums& by) {
      for (const ElementPatch3& patch : geometry.patches(from)) {
        const std::vector<Point3> corners = corners_of(prepared.occluders().vertices(), *patch.exact);
        Look3 look;
        look.normal = exact_normal(prepared.occluders(), patch);
        for (const RulePoint3& point : rule_points(patch, rule_)) {
          look.eye = exact_point(corners, point);
          add_point(map_from(prepared.occluders(), look), elements, patch, point, geometry.table().sky(), by);
        }
      }
      add_contacts(geometry, from, by);
    };
    ExchangeMatrix matrix =
        matrix_by_rows(geometry.table().elements(), has_patches(geometry), progress, [&] { return fill; });
    report.row_defect = closure_defect(matrix);
    return matrix;
  }

 private:
  static Point3 exact_normal(const Occluders3& occluders, const ElementPatch3& patch) {
    const IntegerVector& front = occluders.exact_normal(patch.piece);
    const BoundedVector& rounded = occluders.normal(patch.piece);
    const int side = dot(Vector3d{rounded.x, rounded.y, rounded.z}, patch.normal) > 0 ? 1 : -1;
    return {Rational(side * front.x), Rational(side * front.y), Rational(side * front.z)};
  }

  // Adds what a point of a patch sees, by its map.
  static void add_point(const VisibilityMap3& map, const SideElements3& elements, const ElementPatch3& patch,
                        const RulePoint3& point, std::uint32_t sky, RowSums& by) {
    const double weight = patch.share * point.weight;
    std::size_t fragment = 0;
    for (const VisibilityMap3::Share& share : map.shares) {  // fragments are by face, as the shares are
      const std::size_t first = fragment;
      while (fragment < map.fragments.size() && map.fragments[fragment].face == share.face) ++fragment;
      add_share(point.at, direction_of(patch.normal), map, share,
                std::span(map.fragments).subspan(first, fragment - first), elements.on(share.face), weight, by);
    }
    if (map.sky_factor > kClosed) by.add(sky, weight * map.sky_factor);
  }

  PatchRule3 claimed_rule() const {
    return {.degree = 2 * static_cast<int>(rule_.place.size()) - 2, .over = RuleOver3::kFirst};
  }

  MethodInfo info_;
  GaussRule rule_;
};

}  // namespace

MethodFamily3 points_family_3() {
  return {.name = "points",
          .pattern = "points:n",
          .what = "exact factors from n x n Gauss points of each element",
          .reference = kPointsReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"points:1", "points:2", "points:3", "points:4", "points:6", "points:8"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            return std::make_unique<Points3>(count_of_variant("points", variant, kMostPoints));
          }};
}

}  // namespace hottel

// Vertex to vertex: the mean of the kernel over all pairs of an end of one element and an end of the other, times a
// visibility of 0 or 1. Pairs nearer than 0.005 R are dropped, R half the diagonal of the bounding box.
//   vertices            F_ij = A_j / (4 * 2) sum cos cos' / r V, where V = 1 iff S(i, j) > 0 exactly
//   vertices:centroid   the same, V = 1 iff the centres see each other
//   vertices:literal    F_ij = A_j / 4 sum cos cos' / r V. The source has A_j / 9 for the 3 x 3 pairs of triangles,
//                       where the mean of cos cos' / (pi r^2) is A_j / (9 pi) sum: the constant of the kernel is lost,
//                       pi in space, 2 in the plane.
//   vertices:literal:centroid   both
// GUARANTEE: estimated. Elements that see each other wholly: an error of A_j (A_i^2 + A_j^2) 0.3 / distance^3; the
// literal variant claims nothing.
// REFERENCE: the trapezoid rule on both elements (Davis and Rabinowitz, Methods of Numerical Integration, 1984, 2.1).
#include <limits>
#include <memory>
#include <optional>

#include "solver/methods/vertex_variant.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/exact_visibility.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/pair_method.h"
#include "solver/plane/methods/quadrature_bounds.h"
#include "solver/plane/methods/run_points.h"

namespace hottel {
namespace {

constexpr const char* kVertexQuadratureReference = "trapezoid rule on both elements, visibility 0 or 1";

class VertexQuadrature2 final : public PairMethod2 {
 public:
  explicit VertexQuadrature2(const VertexVariant& variant)
      : PairMethod2({"vertices" + variant.suffix(), "vertices" + variant.suffix(), 0, Guarantee::kEstimated,
                     kVertexQuadratureReference}),
        variant_(variant) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    const double weight = variant_.is_literal ? 2 : 1, nearest = nearest_of(geometry);
    if (variant_.tests_centres) {
      const auto centres = std::make_shared<const RunPoints2>(prepared, geometry, std::vector{Rational(1, 2)});
      const auto factors = [&geometry, weight, nearest, centres](std::uint32_t i, std::uint32_t j) {
        return sum_over_runs(geometry, i, j, [&](const ElementRun2& a, const ElementRun2& b) {
          const double mean = mean_over_ends(a, b, nearest);
          return mean > 0 && centres->see_each_other(a, 0, b, 0) ? weight * a.length * b.length * mean : 0;
        });
      };
      return {partners_of(centres), factors};
    }
    const auto visibility = exact_visibility_2(prepared);
    const auto factors = [&geometry, weight, nearest, visibility](std::uint32_t i, std::uint32_t j) {
      if (!(visibility->of(i, j) > 0)) return PairFactors{};
      return sum_over_runs(geometry, i, j, [&](const ElementRun2& a, const ElementRun2& b) {
        return weight * a.length * b.length * mean_over_ends(a, b, nearest);
      });
    };
    return {partners_of(visibility), factors};
  }
  double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2& geometry, const ElementRun2& a,
                            const ElementRun2& b) const override {
    const auto runs = facing_runs(vertices, a, b);
    if (variant_.is_literal || !runs || runs->distance <= nearest_of(geometry))
      return std::numeric_limits<double>::infinity();
    return trapezoid_error(*runs);
  }

 private:
  static double nearest_of(const ElementGeometry2& geometry) { return kNearestVertices * geometry.diagonal() / 2; }
  VertexVariant variant_;
};

}  // namespace

MethodFamily2 vertex_quadrature_family_2() {
  return {.name = "vertices",
          .pattern = "vertices[:literal][:centroid]",
          .what = "ends to ends, times a visibility of 0 or 1",
          .reference = kVertexQuadratureReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"vertices:centroid", "vertices", "vertices:literal:centroid", "vertices:literal"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            return std::make_unique<VertexQuadrature2>(vertex_variant(variant));
          }};
}

}  // namespace hottel

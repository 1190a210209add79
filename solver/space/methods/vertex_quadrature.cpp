// Vertex to vertex: the mean of the kernel over all pairs of a corner of one patch and a corner of the other (3 x 3 on
// triangles), times a visibility of 0 or 1. Pairs nearer than 0.005 R are dropped, R half the diagonal of the bounding
// box.
//   vertices            F_ij = A_j / (9 pi) sum cos cos' / r^2 V, where V = 1 iff S(i, j) > 0 exactly
//   vertices:centroid   the same, V = 1 iff the centres see each other
//   vertices:literal    F_ij = A_j / 9 sum cos cos' / r^2 V, as the source writes it: pi is lost
//   vertices:literal:centroid   both
// GUARANTEE: estimated.
// REFERENCE: the trapezoid rule on both elements (Davis and Rabinowitz, Methods of Numerical Integration, 1984, 2.1).
#include <memory>
#include <numbers>

#include "solver/methods/vertex_variant.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/exact_visibility.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/pair_method.h"

namespace hottel {
namespace {

constexpr const char* kVertexQuadratureReference = "trapezoid rule on both elements, visibility 0 or 1";

class VertexQuadrature3 final : public PairMethod3 {
 public:
  explicit VertexQuadrature3(const VertexVariant& variant)
      : PairMethod3({"vertices" + variant.suffix(), "vertices" + variant.suffix(), 0, Guarantee::kEstimated,
                     kVertexQuadratureReference}),
        variant_(variant) {}

 protected:
  PairsOfElements pairs(const Setting& setting) const override {
    const double weight = variant_.is_literal ? std::numbers::pi : 1;
    const double nearest = kNearestVertices * setting.visibility.diagonal() / 2;
    const auto measure = [weight, nearest](const ElementPatch3& a, const ElementPatch3& b) {
      return weight * a.area * b.area * mean_over_corners(a, b, nearest);
    };
    if (variant_.tests_centres) {
      const auto factors = [setting, measure](std::uint32_t i, std::uint32_t j) {
        return sum_over_patches(setting.geometry, i, j, [&](const ElementPatch3& a, const ElementPatch3& b) {
          const double all = measure(a, b);
          return all > 0 && setting.visibility.see_each_other(centre_point(a), centre_point(b)) ? all : 0;
        });
      };
      return {all_later_elements(setting.geometry), factors};
    }
    const auto visibility = exact_visibility_3(setting.prepared);
    const auto factors = [&geometry = setting.geometry, visibility, measure](std::uint32_t i, std::uint32_t j) {
      return visibility->of(i, j) > 0 ? sum_over_patches(geometry, i, j, measure) : PairFactors{};
    };
    return {partners_of(visibility), factors};
  }

 private:
  VertexVariant variant_;
};

}  // namespace

MethodFamily3 vertex_quadrature_family_3() {
  return {.name = "vertices",
          .pattern = "vertices[:literal][:centroid]",
          .what = "mean over pairs of corners, visibility 0 or 1, near pairs dropped",
          .reference = kVertexQuadratureReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"vertices:centroid", "vertices:literal:centroid", "vertices", "vertices:literal"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            return std::make_unique<VertexQuadrature3>(vertex_variant(variant));
          }};
}

}  // namespace hottel

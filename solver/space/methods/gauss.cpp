// gauss:n, n x n Gauss-Legendre points on each patch, and one segment for the visibility of each pair of points.
// F_ij = A_j sum_k sum_l w_k w_l cos cos' / (pi r^2) V_kl.
// GUARANTEE: estimated. Elements that see each other wholly: the error falls geometrically with n, the faster the
// farther they are; where elements touch, like a power of n.
// REFERENCE: Gauss-Legendre quadrature (Trefethen, Approximation Theory and Approximation Practice, 2013, chapter 19).
#include <memory>
#include <vector>

#include "solver/methods/gauss_rule.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/pair_method.h"
#include "solver/space/methods/patch_rule.h"

namespace hottel {
namespace {

constexpr int kMostGaussPoints = 64;
constexpr const char* kGaussReference = "Gauss-Legendre quadrature; Trefethen 2013, chapter 19";

class Gauss3 final : public PairMethod3 {
 public:
  explicit Gauss3(int n)
      : PairMethod3(
            {"gauss:" + std::to_string(n), "gauss", static_cast<double>(n), Guarantee::kEstimated, kGaussReference},
            PatchRule3{.degree = 2 * n - 2}),
        rule_(gauss_rule(n)) {}

 protected:
  PairsOfElements pairs(const Setting& setting) const override {
    const auto points = std::make_shared<std::vector<std::vector<RulePoint3>>>();  // by patch
    for (const ElementPatch3& patch : setting.geometry.all_patches()) points->push_back(rule_points(patch, rule_));
    const auto factors = [setting, points](std::uint32_t i, std::uint32_t j) {
      return sum_over_patches(setting.geometry, i, j, [&](const ElementPatch3& a, const ElementPatch3& b) {
        double sum = 0;
        for (const RulePoint3& x : (*points)[setting.geometry.number_of(a)]) {
          double from_point = 0;
          for (const RulePoint3& y : (*points)[setting.geometry.number_of(b)]) {
            const double kernel = cosine_kernel(x.at, a.normal, y.at, b.normal);
            if (kernel > 0 && setting.visibility.see_each_other({x.at, a.piece}, {y.at, b.piece}))
              from_point += y.weight * kernel;
          }
          sum += x.weight * from_point;
        }
        return a.area * b.area * sum;
      });
    };
    return {all_later_elements(setting.geometry), factors};
  }

 private:
  GaussRule rule_;
};

}  // namespace

MethodFamily3 gauss_family_3() {
  return {.name = "gauss",
          .pattern = "gauss:n",
          .what = "n x n Gauss points on each element, visibility of each pair of points",
          .reference = kGaussReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"gauss:1", "gauss:2", "gauss:3", "gauss:4", "gauss:6"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            return std::make_unique<Gauss3>(count_of_variant("gauss", variant, kMostGaussPoints));
          }};
}

}  // namespace hottel

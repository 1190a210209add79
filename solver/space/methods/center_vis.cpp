// Centre to centre, times the exact partial visibility: F_ij = A_j cos cos' / (pi r^2) Vis(i, j).
// GUARANTEE: estimated.
// REFERENCE: as center; the exact visibility is that of docs/design/space/pair_integrator.md.
#include <memory>

#include "kernel/support/failure.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/exact_visibility.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/pair_method.h"

namespace hottel {
namespace {

constexpr const char* kCenterVisReference =
    "midpoint rule on both elements, exact visibility; Davis and Rabinowitz 1984";

class CenterVis3 final : public PairMethod3 {
 public:
  CenterVis3()
      : PairMethod3({"center-vis", "center-vis", 0, Guarantee::kEstimated, kCenterVisReference},
                    PatchRule3{.degree = 1}) {}

 protected:
  PairsOfElements pairs(const Setting& setting) const override {
    const auto visibility = exact_visibility_3(setting.prepared);
    const auto factors = [&geometry = setting.geometry, visibility](std::uint32_t i, std::uint32_t j) {
      const double visible = visibility->of(i, j);
      return sum_over_patches(geometry, i, j, [visible](const ElementPatch3& a, const ElementPatch3& b) {
        return a.area * b.area * between_centres(a, b) * visible;
      });
    };
    return {partners_of(visibility), factors};
  }
};

}  // namespace

MethodFamily3 center_vis_family_3() {
  return {.name = "center-vis",
          .pattern = "center-vis",
          .what = "centre to centre, times the exact partial visibility",
          .reference = kCenterVisReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"center-vis"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            if (!variant.empty()) throw UsageError("center-vis has no variants in space");
            return std::make_unique<CenterVis3>();
          }};
}

}  // namespace hottel

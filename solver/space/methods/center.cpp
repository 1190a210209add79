// Centre to centre: the midpoint rule on both elements, and one segment for visibility.
// F_ij = A_j cos cos' / (pi r^2), each cosine clamped at 0, if the centres see each other.
// GUARANTEE: estimated.
// REFERENCE: the midpoint rule (Davis and Rabinowitz, Methods of Numerical Integration, 1984, 2.1).
#include <memory>

#include "kernel/support/failure.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/pair_method.h"

namespace hottel {
namespace {

constexpr const char* kCenterReference = "midpoint rule on both elements; Davis and Rabinowitz 1984";

class Center3 final : public PairMethod3 {
 public:
  Center3() : PairMethod3({"center", "center", 0, Guarantee::kEstimated, kCenterReference}, PatchRule3{.degree = 1}) {}

 protected:
  PairsOfElements pairs(const Setting& setting) const override {
    const auto factors = [setting](std::uint32_t i, std::uint32_t j) {
      return sum_over_patches(setting.geometry, i, j, [&](const ElementPatch3& a, const ElementPatch3& b) {
        const double kernel = between_centres(a, b);
        return kernel > 0 && setting.visibility.see_each_other(centre_point(a), centre_point(b))
                   ? a.area * b.area * kernel
                   : 0;
      });
    };
    return {all_later_elements(setting.geometry), factors};
  }
};

}  // namespace

MethodFamily3 center_family_3() {
  return {.name = "center",
          .pattern = "center",
          .what = "centre to centre, times the visibility of that one segment",
          .reference = kCenterReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"center"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            if (!variant.empty()) throw UsageError("the method center has no variants");
            return std::make_unique<Center3>();
          }};
}

}  // namespace hottel

// disk, from the centre of one patch to a disk that stands for the other, times the visibility of the segment between
// their centres. F_ij = A_j cos cos' / (pi r^2 + A_j).
// GUARANTEE: estimated. Not reciprocal: A_i F_ij is not A_j F_ji unless the areas are equal.
// REFERENCE: J. Wallace, K. Elmquist, E. Haines, A ray tracing algorithm for progressive radiosity, 1989.
#include <memory>

#include "kernel/support/failure.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/pair_method.h"

namespace hottel {
namespace {

constexpr const char* kDiskReference = "a disk for each receiver; Wallace, Elmquist and Haines 1989";

class Disk3 final : public PairMethod3 {
 public:
  Disk3() : PairMethod3({"disk", "disk", 0, Guarantee::kEstimated, kDiskReference}) {}

 protected:
  PairsOfElements pairs(const Setting& setting) const override {
    const auto factors = [setting](std::uint32_t i, std::uint32_t j) {
      PairFactors both;
      for (const ElementPatch3& a : setting.geometry.patches(i))
        for (const ElementPatch3& b : setting.geometry.patches(j)) {
          const double forth = a.piece == b.piece ? 0 : factor_of_disk(a, b);
          if (!(forth > 0) || !setting.visibility.see_each_other(centre_point(a), centre_point(b))) continue;
          both.forth += a.share * forth;
          both.back += b.share * factor_of_disk(b, a);
        }
      return both;
    };
    return {all_later_elements(setting.geometry), factors};
  }
};

}  // namespace

MethodFamily3 disk_family_3() {
  return {.name = "disk",
          .pattern = "disk",
          .what = "centre to a disk of the same area, times the visibility of that one segment",
          .reference = kDiskReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"disk"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            if (!variant.empty()) throw UsageError("the method disk has no variants");
            return std::make_unique<Disk3>();
          }};
}

}  // namespace hottel

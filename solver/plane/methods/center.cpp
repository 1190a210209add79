// Centre to centre: the midpoint rule on both elements, and one segment for visibility.
// F_ij = A_j cos cos' / (2 r), each cosine clamped at 0, if the centres see each other.
// GUARANTEE: estimated. Elements that see each other wholly: an error of A_j (A_i^2 + A_j^2) 0.15 / distance^3.
// REFERENCE: the midpoint rule (Davis and Rabinowitz, Methods of Numerical Integration, 1984, 2.1) for the integral of
// the cosine kernel (Heckbert, Radiosity in Flatland, 1992).
#include <limits>
#include <memory>

#include "kernel/support/failure.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/pair_method.h"
#include "solver/plane/methods/quadrature_bounds.h"
#include "solver/plane/methods/run_points.h"

namespace hottel {
namespace {

constexpr const char* kCenterReference = "midpoint rule on both elements; Heckbert 1992";

class Center2 final : public PairMethod2 {
 public:
  Center2() : PairMethod2({"center", "center", 0, Guarantee::kEstimated, kCenterReference}) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    const auto centres = std::make_shared<const RunPoints2>(prepared, geometry, std::vector{Rational(1, 2)});
    const auto factors = [&geometry, centres](std::uint32_t i, std::uint32_t j) {
      return sum_over_runs(geometry, i, j, [&](const ElementRun2& a, const ElementRun2& b) {
        const double kernel = between_centres(a, b);
        return kernel > 0 && centres->see_each_other(a, 0, b, 0) ? a.length * b.length * kernel : 0;
      });
    };
    return {partners_of(centres), factors};
  }
  double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2&, const ElementRun2& a,
                            const ElementRun2& b) const override {
    const auto runs = facing_runs(vertices, a, b);
    return runs ? midpoint_error(*runs) : std::numeric_limits<double>::infinity();
  }
};

}  // namespace

MethodFamily2 center_family_2() {
  return {.name = "center",
          .pattern = "center",
          .what = "centre to centre, times the visibility of that one segment",
          .reference = kCenterReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"center"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            if (!variant.empty()) throw UsageError("the method center has no variants");
            return std::make_unique<Center2>();
          }};
}

}  // namespace hottel

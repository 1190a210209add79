// Centre to centre, times the exact partial visibility.
//   center-vis                    F_ij = A_j cos cos' / (2 r) Vis(i, j)
//   center-vis:inverse-square=K   F_ij = K / r^2 cos cos' Vis(i, j), lengths in units of the scene: the system of the
//                                 first source of this project, literally. It knows no areas: the more elements, the
//                                 larger the sum of a row (K = 1, unit square, 1, 4, 16, 64 elements a side: 3, 23,
//                                 316, 4.9e3), so that nothing bounds it by 1.
// GUARANTEE: estimated. center-vis: an error of A_j (A_i^2 + A_j^2) 0.15 / distance^3, hidden in part or not, between
// elements that lie before each other.
// REFERENCE: as center; the exact visibility is that of docs/design/plane/exchange.md.
#include <cmath>
#include <limits>
#include <memory>

#include "kernel/support/failure.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/exact_visibility.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/pair_method.h"
#include "solver/plane/methods/quadrature_bounds.h"

namespace hottel {
namespace {

constexpr std::string_view kInverseSquare = ":inverse-square=";
constexpr const char* kCenterVisReference = "midpoint rule on both elements, exact visibility; Heckbert 1992";

class CenterVis2 final : public PairMethod2 {
 public:
  CenterVis2() : PairMethod2({"center-vis", "center-vis", 0, Guarantee::kEstimated, kCenterVisReference}) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    const auto visibility = exact_visibility_2(prepared);
    const auto factors = [&geometry, visibility](std::uint32_t i, std::uint32_t j) {
      const double visible = visibility->of(i, j);
      return sum_over_runs(geometry, i, j, [visible](const ElementRun2& a, const ElementRun2& b) {
        return a.length * b.length * between_centres(a, b) * visible;
      });
    };
    return {partners_of(visibility), factors};
  }
  double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2&, const ElementRun2& a,
                            const ElementRun2& b) const override {
    const auto runs = facing_runs(vertices, a, b);
    return runs ? midpoint_error(*runs) : std::numeric_limits<double>::infinity();
  }
  bool claims_hidden_pairs() const override { return true; }
};

class InverseSquare2 final : public PairMethod2 {
 public:
  explicit InverseSquare2(const Rational& constant)
      : PairMethod2({"center-vis" + std::string(kInverseSquare) + to_string(constant), "center-vis:inverse-square",
                     to_double(constant), Guarantee::kEstimated,
                     "F = K/r^2 cos cos Vis as a planar radiosity program used it; see docs/accuracy.md"}),
        constant_(constant) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    const Rational local = constant_ / (geometry.unit() * geometry.unit());
    const double constant = to_double(local);
    if (!std::isnormal(constant) && constant_ != 0)
      throw RequestError("the inverse square of lengths in this scene is beyond the range of double");
    const auto visibility = exact_visibility_2(prepared);
    const auto factors = [&geometry, constant, visibility](std::uint32_t i, std::uint32_t j) {
      const double visible = visibility->of(i, j);
      PairFactors both;
      for (const ElementRun2& a : geometry.runs(i))
        for (const ElementRun2& b : geometry.runs(j)) {
          const double factor = constant * inverse_square(a, b) * visible;
          both.forth += a.share * factor;
          both.back += b.share * factor;
        }
      return both;
    };
    return {partners_of(visibility), factors};
  }

 private:
  Rational constant_;
};

std::unique_ptr<ExchangeMethod2> make_center_vis(std::string_view variant) {
  if (variant.empty()) return std::make_unique<CenterVis2>();
  if (variant.starts_with(kInverseSquare))
    if (const auto constant = parse_rational(variant.substr(kInverseSquare.size())); constant && *constant >= 0)
      return std::make_unique<InverseSquare2>(*constant);
  throw UsageError("the variant of center-vis is inverse-square=K with a number K >= 0, not '" +
                   std::string(variant.substr(1)) + "'");
}

}  // namespace

MethodFamily2 center_vis_family_2() {
  return {.name = "center-vis",
          .pattern = "center-vis[:inverse-square=K]",
          .what = "centre to centre, times the exact partial visibility",
          .reference = kCenterVisReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"center-vis", "center-vis:inverse-square=1"},
          .make = make_center_vis};
}

}  // namespace hottel

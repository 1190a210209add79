// gauss:n, n Gauss-Legendre points on each element, and one segment for the visibility of each pair of points.
// F_ij = A_j sum_k sum_l w_k w_l cos cos' / (2 r) V_kl.
// GUARANTEE: estimated. Elements that see each other wholly: the error falls like rho^(-2 n), where rho > 1 depends on
// distance over length alone (quadrature_bounds.h); where elements touch, like a power of n.
// REFERENCE: Gauss-Legendre quadrature (Trefethen, Approximation Theory and Approximation Practice, 2013, chapter 19).
#include <limits>
#include <memory>

#include "kernel/exact_double.h"
#include "solver/methods/gauss_rule.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/pair_method.h"
#include "solver/plane/methods/quadrature_bounds.h"
#include "solver/plane/methods/run_points.h"

namespace hottel {
namespace {

constexpr int kMostPoints = 1024;
constexpr const char* kGaussReference = "Gauss-Legendre quadrature; Trefethen 2013, chapter 19";

class Gauss2 final : public PairMethod2 {
 public:
  explicit Gauss2(int n)
      : PairMethod2(
            {"gauss:" + std::to_string(n), "gauss", static_cast<double>(n), Guarantee::kEstimated, kGaussReference}),
        n_(n),
        rule_(gauss_rule(n)) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    struct Points {
      RunPoints2 exact;
      std::vector<std::vector<LocalPoint2>> local;  // by run
    };
    std::vector<Rational> places;
    for (const double place : rule_.place) places.push_back(exact_value(place));
    const auto points = std::make_shared<Points>(Points{RunPoints2(prepared, geometry, places), {}});
    for (const ElementRun2& run : geometry.all_runs()) {
      points->local.emplace_back();
      for (const double t : rule_.place) points->local.back().push_back(run.at(t));
    }
    const auto factors = [this, &geometry, points](std::uint32_t i, std::uint32_t j) {
      return sum_over_runs(geometry, i, j, [&](const ElementRun2& a, const ElementRun2& b) {
        const auto &x = points->local[geometry.number_of(a)], &y = points->local[geometry.number_of(b)];
        const LocalVector2 a_normal = a.normal(), b_normal = b.normal();
        double sum = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
          double from_point = 0;
          for (std::size_t l = 0; l < y.size(); ++l) {
            const double kernel = cosine_kernel(x[k], a_normal, y[l], b_normal);
            if (kernel > 0 && points->exact.see_each_other(a, k, b, l)) from_point += rule_.weight[l] * kernel;
          }
          sum += rule_.weight[k] * from_point;
        }
        return a.length * b.length * sum;
      });
    };
    return {partners_of(std::shared_ptr<const RunPoints2>(points, &points->exact)), factors};
  }
  double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2&, const ElementRun2& a,
                            const ElementRun2& b) const override {
    const auto runs = facing_runs(vertices, a, b);
    return runs ? gauss_error(*runs, n_) : std::numeric_limits<double>::infinity();
  }

 private:
  int n_;
  GaussRule rule_;
};

std::unique_ptr<ExchangeMethod2> make_gauss(std::string_view variant) {
  return std::make_unique<Gauss2>(count_of_variant("gauss", variant, kMostPoints));
}

}  // namespace

MethodFamily2 gauss_family_2() {
  return {.name = "gauss",
          .pattern = "gauss:n",
          .what = "n Gauss points on each element, visibility of each pair of points",
          .reference = kGaussReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"gauss:1", "gauss:2", "gauss:4", "gauss:8", "gauss:16"},
          .make = make_gauss};
}

}  // namespace hottel

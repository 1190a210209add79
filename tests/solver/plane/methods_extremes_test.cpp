// Every method on scenes whose sizes differ by sixty orders of magnitude: numbers come out, and they are factors, but
// for those that naive arithmetic makes of them.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel::methods_extremes_test {
namespace {

PreparedScene2 scene_of(const std::string& edges) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [)" + edges + "]}", "extreme"));
}

class MethodsOnExtremes : public testing::TestWithParam<std::string> {};

// Calls visit(family, method, its matrix) for all points of all sweeps. An inverse square may be beyond doubles.
template <class Visit>
void for_each_method(const PreparedScene2& prepared, const Visit& visit) {
  const MethodCatalogue2 methods = methods_2();
  for (const MethodFamily2& family : methods.families())
    for (const std::string& name : family.sweep) {
      const auto method = methods.make(name);
      MethodReport report;
      ExchangeMatrix matrix;
      try {
        matrix = method->compute(prepared, {.granularity = Granularity::kElement}, report);
      } catch (const RequestError&) {
        EXPECT_EQ(name, "center-vis:inverse-square=1");
        continue;
      }
      visit(family, *method, matrix);
    }
}

TEST_P(MethodsOnExtremes, GiveFiniteFactorsThatAreNotNegative) {
  for_each_method(scene_of(GetParam()),
                  [](const MethodFamily2& family, const ExchangeMethod2& method, const ExchangeMatrix& matrix) {
                    for (std::uint32_t i = 0; i < matrix.size(); ++i)
                      for (const FactorEntry& entry : matrix.row(i)) {
                        EXPECT_TRUE(std::isfinite(entry.factor.value)) << method.info().name;
                        if (family.name != "arithmetic" || matrix.guarantee() != Guarantee::kEstimated) {
                          EXPECT_GE(entry.factor.value, 0) << method.info().name;
                        }
                      }
                  });
}

TEST_P(MethodsOnExtremes, KeepWhatTheyClaim) {
  const PreparedScene2 prepared = scene_of(GetParam());
  const ExchangeMatrix exact = exact_exchange(prepared, {.granularity = Granularity::kElement});
  for_each_method(prepared, [&](const MethodFamily2&, const ExchangeMethod2& method, const ExchangeMatrix& matrix) {
    const auto claimed = method.declared_error(prepared);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      for (std::uint32_t j = 0; claimed && j <= matrix.sky(); ++j)
        EXPECT_LE(std::fabs(matrix.factor(i, j).value - exact.factor(i, j).value), *claimed) << method.info().name;
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
        const double right = exact.factor(i, matrix.row(i)[k].to).value;
        EXPECT_LE(matrix.bounds(i, k).lower, right) << method.info().name;
        EXPECT_GE(matrix.bounds(i, k).upper, right) << method.info().name;
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Scenes, MethodsOnExtremes,
                         testing::Values("", R"({"name": "floor", "points": [[1, 0], [-1, 0]], "material": "m"},
                       {"name": "speck", "points": [["-1e-200", 1], ["1e-200", 1]], "material": "m"})",
                                         R"({"name": "floor", "points": [[1, 0], [-1, 0]], "material": "m"},
                       {"name": "outside", "points": [[5, "100.0000000000000000001"], ["-5", "100.0000000000000000001"]],
                        "material": "m"},
                       {"name": "ceiling", "points": [["-5", 100], [5, 100]], "material": "m"})",
                                         R"({"name": "large", "points": [[1, 0], [-1, 0]], "material": "m"},
                       {"name": "small", "points": [["-1e-60", 1], ["1e-60", 1]], "material": "m"})",
                                         R"({"name": "lower", "points": [[1, 0], [0, 0]], "material": "m"},
                       {"name": "upper", "points": [[0, "1e60"], [1, "1e60"]], "material": "m"})",
                                         R"({"name": "lower", "points": [[1, 0], [0, 0]], "material": "m"},
                       {"name": "upper", "points": [[0, 0], [1, "1e-300"]], "material": "m"})",
                                         R"({"name": "a", "points": [["1e300", 0], [0, 0]], "material": "m"},
                       {"name": "b", "points": [[0, 0], ["1e-300", "1e-300"]], "material": "m"},
                       {"name": "c", "points": [["-1e-320", "1e-320"], ["1e300", "1e300"]], "material": "m"})"));

}  // namespace
}  // namespace hottel::methods_extremes_test

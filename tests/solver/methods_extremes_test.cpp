// Every method on scenes whose sizes differ by sixty orders of magnitude: numbers come out, and they are factors, but
// for those that naive arithmetic makes of them.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/scene_json.h"
#include "solver/methods/method_catalogue_2.h"

namespace hottel {
namespace {

PreparedScene2 scene_of(const std::string& edges) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [)" + edges + "]}", "extreme"));
}

class MethodsOnExtremes : public testing::TestWithParam<std::string> {};

TEST_P(MethodsOnExtremes, GiveFiniteFactorsThatAreNotNegative) {
  const PreparedScene2 prepared = scene_of(GetParam());
  const MethodCatalogue2 methods = planar_methods();
  for (const MethodFamily& family : methods.families()) {
    const auto method = methods.make(family.sweep.front());
    MethodReport report;
    const ExchangeMatrix matrix = method->compute(prepared, report);
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i)) {
        EXPECT_TRUE(std::isfinite(entry.factor.value)) << method->info().name;
        if (family.name != "arithmetic") {
          EXPECT_GE(entry.factor.value, 0) << method->info().name;
        }
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MethodsOnExtremes,
                         testing::Values(R"({"name": "large", "points": [[1, 0], [-1, 0]], "material": "m"},
                       {"name": "small", "points": [["-1e-60", 1], ["1e-60", 1]], "material": "m"})",
                                         R"({"name": "lower", "points": [[1, 0], [0, 0]], "material": "m"},
                       {"name": "upper", "points": [[0, "1e60"], [1, "1e60"]], "material": "m"})",
                                         R"({"name": "lower", "points": [[1, 0], [0, 0]], "material": "m"},
                       {"name": "upper", "points": [[0, 0], [1, "1e-300"]], "material": "m"})",
                                         R"({"name": "a", "points": [["1e300", 0], [0, 0]], "material": "m"},
                       {"name": "b", "points": [[0, 0], ["1e-300", "1e-300"]], "material": "m"},
                       {"name": "c", "points": [["-1e-320", "1e-320"], ["1e300", "1e300"]], "material": "m"})"));

}  // namespace
}  // namespace hottel

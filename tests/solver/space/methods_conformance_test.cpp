// Every family of methods on every scene of scenes/analytic/space: its largest error of a factor, against the bound
// that is stated here for it, which is no idle one; rays against their standard error; sums of rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel::methods_conformance_test {
namespace {

namespace fs = std::filesystem;

// What these come to, to two digits: none draws lots, so that they do so anywhere.
const std::vector<std::string> kMethods{"center",  "center-vis", "vertices",    "vertices:literal",
                                        "gauss:3", "points:3",   "hemicube:64", "hemicube:64:uniform",
                                        "disk"};
const std::map<std::string, std::vector<double>> kLargestErrors{
    {"cube", {0.12, 0.12, 0.19, 0.2, 0.092, 1.9e-05, 0.04, 0.12, 0.042}},
    {"furnace", {1.7, 1.7, 0.74, 0.49, 0.2, 0.022, 0.23, 0.18, 0.7}},
    {"nested_cubes", {4.3, 4.3, 0.63, 0.33, 0.097, 0.0049, 0.36, 0.13, 0.36}},
    {"nested_cubes_near", {1, 1, 1.2, 5.5, 1, 0.22, 0.6, 0.5, 1}},
    {"obstructed_squares_corner", {0.21, 0.15, 0.2, 0.31, 0.027, 0.00029, 0.064, 0.15, 0.11}},
    {"patch_on_floor", {0.12, 0.12, 0.28, 0.24, 0.092, 0.00044, 0.04, 0.12, 0.14}},
    {"rect_parallel_1_1.5_0.5", {1.4, 1.4, 0.028, 1.1, 0.026, 0.0021, 0.16, 0.047, 0.18}},
    {"rect_parallel_1_1_0.1", {31, 31, 7.1, 24, 3.2, 0.028, 0.15, 0.048, 0.14}},
    {"rect_parallel_1_1_1", {0.12, 0.12, 0.072, 0.2, 6.5e-05, 1.9e-05, 0.04, 0.12, 0.042}},
    {"rect_parallel_1_1_10", {2.1e-05, 2.1e-05, 4.1e-05, 0.0066, 1e-09, 1e-09, 0.0018, 0.0019, 1.1e-05}},
    {"rect_parallel_2_3_1", {1.4, 1.4, 0.028, 1.1, 0.026, 0.0021, 0.16, 0.047, 0.18}},
    {"rect_parallel_general", {0.0049, 0.0049, 0.011, 0.081, 3.2e-06, 1.4e-06, 0.0029, 0.002, 0.0065}},
    {"rect_perp_1_0.1_1", {0.31, 0.31, 0.43, 0.42, 0.22, 0.0071, 0.036, 0.04, 0.38}},
    {"rect_perp_1_1_1", {0.12, 0.12, 0.19, 0.15, 0.092, 4.9e-06, 0.011, 0.029, 0.0056}},
    {"rect_perp_2_3_1", {0.026, 0.026, 0.15, 0.14, 0.02, 0.002, 0.042, 0.042, 0.057}},
    {"tetrahedron", {0.49, 0.49, 0.32, 0.3, 0.7, 0.00063, 0.0019, 0.025, 0.036}},
};
constexpr double kSlack = 1.1;         // of what is stated
constexpr double kReference = 1.1e-9;  // what exact factors may be off
constexpr double kExact = 1.1e-12;     // and those that errors are taken from

// N rays a row: the error of a factor F is five standard errors at most, and what single precision shifts.
const std::vector<std::pair<std::string, int>> kRays{
    {"rays:4096", 4096}, {"rays:4096:stratified", 4096}, {"rays:4096:sobol", 4096}, {"rays:512:seed=3", 512}};
constexpr double kSinglePrecision = 1e-4;

fs::path folder() { return fs::path(HOTTEL_SOURCE_DIR) / "scenes" / "analytic" / "space"; }

struct Known {
  PreparedScene3 prepared;
  ExchangeMatrix exact;
};

const Known& known(const std::string& stem) {
  static std::map<std::string, std::unique_ptr<Known>> scenes;
  auto& one = scenes[stem];
  if (!one) {
    PreparedScene3 prepared = prepare(read_scene_3(folder() / (stem + ".json")));
    ExchangeMatrix exact =
        exact_exchange(prepared, {.granularity = Granularity::kElement, .wants_visibility = false, .tolerance = 1e-12});
    one = std::make_unique<Known>(Known{std::move(prepared), std::move(exact)});
  }
  return *one;
}

ExchangeMatrix by(const std::string& method, const Known& scene) {
  MethodReport report;
  return methods_3().make(method)->compute(scene.prepared, {.granularity = Granularity::kElement}, report);
}

double largest_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  double largest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j)
      largest = std::max(largest, std::fabs(matrix.factor(i, j).value - exact.factor(i, j).value));
  }
  return largest;
}

class AnalyticMethods3 : public testing::TestWithParam<std::string> {};

TEST_P(AnalyticMethods3, AreAsWrongAsIsStated) {
  const Known& scene = known(GetParam());
  const std::vector<double>& stated = kLargestErrors.at(GetParam());
  ASSERT_EQ(stated.size(), kMethods.size());
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    const double error = largest_error(by(kMethods[m], scene), scene.exact);
    EXPECT_LE(error, kSlack * stated[m]) << kMethods[m];
    EXPECT_TRUE(error >= stated[m] / kSlack || stated[m] < kReference) << kMethods[m] << " " << error;
  }
  EXPECT_LE(largest_error(by("exact", scene), scene.exact), kReference);
}

TEST_P(AnalyticMethods3, RaysAreWithinFiveStandardErrors) {
  const Known& scene = known(GetParam());
  for (const auto& one : kRays) {
    const ExchangeMatrix matrix = by(one.first, scene);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
        const double f = scene.exact.factor(i, j).value;
        EXPECT_NEAR(matrix.factor(i, j).value, f, 5 * std::sqrt(f * (1 - f) / one.second) + kSinglePrecision)
            << one.first << " " << matrix.name(i) << " " << matrix.name(j);
      }
    }
  }
}

TEST_P(AnalyticMethods3, ThoseThatLookEverywhereCloseTheirRows) {
  const Known& scene = known(GetParam());
  for (const char* method : {"points:3", "hemicube:64", "hemicube:64:uniform", "rays:4096:sobol"}) {
    const ExchangeMatrix matrix = by(method, scene);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      double sum = 0;
      for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
      EXPECT_NEAR(sum, 1, 1e-12) << method << " " << matrix.name(i);
    }
  }
}

std::vector<std::string> stems() {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(folder()))
    if (entry.path().extension() == ".json") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

INSTANTIATE_TEST_SUITE_P(, AnalyticMethods3, testing::ValuesIn(stems()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

// Claims are no idle ones: where plates are farther from each other than they are large, they fall with every point.
TEST(ClaimsOfMethods3, FallGeometricallyWhereElementsAreApart) {
  const Known& scene = known("rect_parallel_1_1_10");
  const auto claim = [&](const std::string& method) {
    return methods_3().make(method)->declared_error(scene.prepared);
  };
  for (const std::string family : {"gauss", "points"}) {
    double before = 1;
    for (int n = 1; n <= 5; ++n) {
      const auto now = claim(family + ":" + std::to_string(n));
      ASSERT_TRUE(now) << family << n;
      EXPECT_LT(*now, before / 20) << family << n;
      before = *now;
    }
    EXPECT_LT(before, 1e-8) << family;
  }
  ASSERT_TRUE(claim("center"));
  EXPECT_LT(*claim("center"), 300 * largest_error(by("center", scene), scene.exact));
  EXPECT_EQ(claim("center"), claim("center-vis"));
}

TEST(ClaimsOfMethods3, AreMadeOfWhatCanBeProvenOnly) {
  for (const std::string method : {"center", "gauss:3", "points:3"})
    for (const std::string stem : {"cube", "rect_parallel_1_1_0.1", "rect_perp_1_1_1"})
      EXPECT_FALSE(methods_3().make(method)->declared_error(known(stem).prepared)) << method << " " << stem;
  for (const std::string method : {"vertices", "hemicube:64", "rays:4096:sobol"})
    EXPECT_FALSE(methods_3().make(method)->declared_error(known("rect_parallel_1_1_10").prepared)) << method;
  const auto of_rays = [](const std::string& method) {
    return methods_3().make(method)->declared_error(known("cube").prepared);
  };
  ASSERT_TRUE(of_rays("rays:100000"));
  EXPECT_LT(*of_rays("rays:100000"), 0.012);
  ASSERT_TRUE(of_rays("rays:100000:stratified"));
  EXPECT_GT(*of_rays("rays:100000:stratified"), *of_rays("rays:100000"));
  EXPECT_FALSE(of_rays("rays:4")) << "no better than nothing";
}

TEST(MethodsOfTheCatalogue3, AreAllAmongThem) {
  std::set<std::string> tried{"exact"};
  for (const std::string& name : kMethods) tried.insert(family_of_method(name));
  for (const auto& one : kRays) tried.insert(family_of_method(one.first));
  const MethodCatalogue3 catalogue = methods_3();
  for (const MethodFamily3& family : catalogue.families()) EXPECT_TRUE(tried.contains(family.name)) << family.name;
}

}  // namespace
}  // namespace hottel::methods_conformance_test

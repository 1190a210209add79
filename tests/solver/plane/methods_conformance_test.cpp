// What every method promises (solver/plane/methods/exchange_method.h), on every scene of scenes/analytic; the tolerance
// is the method's own claim. A method that is in the catalogue is in this test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel::methods_conformance_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kFewElements = 60;

const MethodCatalogue2& catalogue() {
  static const MethodCatalogue2 methods = methods_2();
  return methods;
}

std::vector<std::string> stems_in(const std::string& folder) {
  std::vector<std::string> stems;
  const fs::path path = fs::path(HOTTEL_SOURCE_DIR) / "scenes" / folder;
  if (!fs::exists(path)) return stems;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".json") stems.push_back(entry.path().stem().string());
  std::sort(stems.begin(), stems.end());
  return stems;
}

struct SceneCase {
  PreparedScene2 prepared;
  ExchangeMatrix exact;
};

const SceneCase& scene_case(const std::string& folder, const std::string& stem) {
  static std::map<std::string, std::unique_ptr<SceneCase>> cases;
  auto& one = cases[folder + "/" + stem];
  if (!one) {
    PreparedScene2 prepared =
        prepare(read_scene_2(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / folder / (stem + ".json")), Divided2::kYes);
    ExchangeMatrix exact = exact_exchange(prepared, {.granularity = Granularity::kElement});
    one = std::make_unique<SceneCase>(SceneCase{std::move(prepared), std::move(exact)});
  }
  return *one;
}

bool same_bits(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  if (a.size() != b.size() || a.entry_count() != b.entry_count()) return false;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    const auto row = a.row(i), other = b.row(i);
    if (!std::equal(row.begin(), row.end(), other.begin(), other.end(),
                    [](const auto& x, const auto& y) { return x.to == y.to && x.factor.value == y.factor.value; }))
      return false;
  }
  return true;
}

void expect_layout_of(const ExchangeMatrix& exact, const ExchangeMatrix& matrix) {
  ASSERT_EQ(matrix.size(), exact.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    EXPECT_EQ(matrix.elements()[i].name, exact.elements()[i].name);
    EXPECT_EQ(matrix.elements()[i].area, exact.elements()[i].area);
    EXPECT_EQ(matrix.has_row(i), exact.has_row(i));
    EXPECT_TRUE(exact.has_row(i) || matrix.row(i).empty());
    std::int64_t previous = -1;
    for (const FactorEntry& entry : matrix.row(i)) {
      EXPECT_GT(std::int64_t{entry.to}, previous);
      EXPECT_LE(entry.to, matrix.sky());
      EXPECT_TRUE(std::isfinite(entry.factor.value)) << matrix.elements()[i].name << " " << entry.to;
      EXPECT_NE(entry.factor.value, 0);
      EXPECT_TRUE(matrix.guarantee() != Guarantee::kEstimated || entry.factor.side == 0);
      previous = entry.to;
    }
  }
}

void expect_claims_to_hold(const ExchangeMethod2& method, const SceneCase& scene, const ExchangeMatrix& matrix) {
  const ExchangeMethod2::ClaimedErrors claimed = method.claimed_errors(scene.prepared);
  const double of_all = method.declared_error(scene.prepared).value_or(std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
      const double error = std::fabs(matrix.factor(i, j).value - scene.exact.factor(i, j).value);
      const double claim = std::min(claimed(i, j), of_all);
      if (!(error <= claim))
        ADD_FAILURE() << matrix.elements()[i].name << " to " << j << " is off by " << error << ", claimed " << claim;
    }
  }
}

// ExchangeMethod (7).
void expect_pairs_to_be_entries(const ExchangeMethod2& method, const SceneCase& scene, const ExchangeMatrix& matrix) {
  const ExchangeMethod2::FactorsOfPairs factor = method.factors_of_pairs(scene.prepared);
  for (std::uint32_t i = 0; i < matrix.size() && factor; ++i)
    for (std::uint32_t j = 0; j < matrix.size() && matrix.has_row(i); ++j)
      if (i != j) {
        EXPECT_EQ(std::max(factor(i, j), 0.0), matrix.factor(i, j).value) << i << " " << j;
      }
}

void expect_conformance(const std::string& name, const SceneCase& scene) {
  const auto method = catalogue().make(name);
  EXPECT_EQ(method->info().name, name);
  EXPECT_FALSE(method->info().reference.empty());
  const auto computed_by = [&](int threads, MethodReport& report) {
    const ThreadLimit limit(threads);
    return method->compute(scene.prepared, {.granularity = Granularity::kElement}, report);
  };
  MethodReport report;
  const ExchangeMatrix matrix = computed_by(1, report);
  expect_layout_of(scene.exact, matrix);
  EXPECT_EQ(matrix.guarantee() == Guarantee::kExact, method->info().guarantee == Guarantee::kExact);
  EXPECT_TRUE(std::isfinite(report.row_defect));
  for (const int threads : {2, 3}) {
    MethodReport again;
    EXPECT_TRUE(same_bits(computed_by(threads, again), matrix)) << threads << " threads";
    EXPECT_EQ(again.row_defect, report.row_defect);
  }
  expect_claims_to_hold(*method, scene, matrix);
  expect_pairs_to_be_entries(*method, scene, matrix);
}

struct NamedMethod {
  std::string name;
  bool is_first_of_its_curve = true;  // of accuracy against time: the cheapest
};

void PrintTo(const NamedMethod& method, std::ostream* out) { *out << method.name; }

// Every method of every sweep, and of each family the first one normalised.
const std::vector<NamedMethod>& all_methods() {
  static const std::vector<NamedMethod> methods = [] {
    std::vector<NamedMethod> result;
    for (const MethodFamily2& family : catalogue().families()) {
      std::set<std::string> curves;
      for (const std::string& name : family.sweep)
        result.push_back({name, curves.insert(catalogue().make(name)->info().family).second});
      result.push_back({family.sweep.front() + ":normalised", false});
    }
    return result;
  }();
  return methods;
}

class EveryMethod : public testing::TestWithParam<NamedMethod> {
 protected:
  // Of scenes with many elements only the first method of each curve is tried.
  static void try_all_scenes_in(const std::string& folder) {
    for (const std::string& stem : stems_in(folder)) {
      SCOPED_TRACE(stem);
      const SceneCase& scene = scene_case(folder, stem);
      if (scene.exact.size() <= kFewElements || GetParam().is_first_of_its_curve)
        expect_conformance(GetParam().name, scene);
    }
  }
};

TEST_P(EveryMethod, KeepsItsPromisesOnAnalyticScenes) { try_all_scenes_in("analytic"); }

class FirstOfEveryCurve : public EveryMethod {};

TEST_P(FirstOfEveryCurve, KeepsItsPromisesOnShowcaseScenes) { try_all_scenes_in("showcase"); }

TEST_P(FirstOfEveryCurve, KeepsItsPromisesOnDegenerateScenes) { try_all_scenes_in("degenerate"); }

std::vector<NamedMethod> first_methods() {
  std::vector<NamedMethod> firsts;
  for (const NamedMethod& method : all_methods())
    if (method.is_first_of_its_curve) firsts.push_back(method);
  return firsts;
}

std::string identifier(const testing::TestParamInfo<NamedMethod>& test) {
  std::string name = test.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(all_methods()), identifier);
INSTANTIATE_TEST_SUITE_P(, FirstOfEveryCurve, testing::ValuesIn(first_methods()), identifier);

}  // namespace
}  // namespace hottel::methods_conformance_test

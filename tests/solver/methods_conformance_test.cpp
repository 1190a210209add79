// What every method promises (solver/methods/exchange_method_2.h), on every scene of scenes/analytic; the tolerance is
// the method's own claim. A method that is in the catalogue is in this test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>

#include "io/scene_json.h"
#include "kernel/parallel.h"
#include "solver/methods/method_catalogue_2.h"

namespace hottel {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kFewElements = 150;

const MethodCatalogue2& catalogue() {
  static const MethodCatalogue2 methods = planar_methods();
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
        prepare(read_scene_2(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / folder / (stem + ".json")), Divided::kYes);
    ExchangeMatrix exact = exact_exchange(prepared, {.per = Per::kElement});
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
      EXPECT_LE(error, claimed(i, j)) << matrix.elements()[i].name << " to " << j;
      EXPECT_LE(error, of_all) << matrix.elements()[i].name << " to " << j;
    }
  }
}

void expect_conformance(const std::string& name, const SceneCase& scene) {
  const auto method = catalogue().make(name);
  EXPECT_EQ(method->info().name, name);
  EXPECT_FALSE(method->info().reference.empty());
  const auto computed_by = [&](int threads, MethodReport& report) {
    const ThreadLimit limit(threads);
    return method->compute(scene.prepared, report);
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
}

std::vector<std::string> all_methods() {
  std::vector<std::string> names;
  for (const MethodFamily& family : catalogue().families()) {
    names.insert(names.end(), family.sweep.begin(), family.sweep.end());
    names.push_back(family.sweep.front() + ":normalised");
  }
  return names;
}

bool is_cheapest(const std::string& name) {
  for (const MethodFamily& family : catalogue().families())
    if (name == family.sweep.front()) return true;
  return false;
}

// Of scenes with many elements only the cheapest method of a sweep is tried.
bool is_to_be_tried(const std::string& method, const SceneCase& scene) {
  return scene.exact.size() <= kFewElements || is_cheapest(method);
}

std::string identifier(const std::string& text) {
  std::string result;
  for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result;
}

struct MethodOnScene {
  std::string method, stem;
};

void PrintTo(const MethodOnScene& both, std::ostream* out) { *out << both.method << " on " << both.stem; }

std::vector<MethodOnScene> methods_on_analytic_scenes() {
  std::vector<MethodOnScene> result;
  for (const std::string& method : all_methods())
    for (const std::string& stem : stems_in("analytic"))
      if (is_to_be_tried(method, scene_case("analytic", stem))) result.push_back({method, stem});
  return result;
}

class EveryMethod : public testing::TestWithParam<MethodOnScene> {};

TEST_P(EveryMethod, KeepsItsPromisesOnAnalyticScenes) {
  expect_conformance(GetParam().method, scene_case("analytic", GetParam().stem));
}

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(methods_on_analytic_scenes()),
                         [](const auto& test) { return identifier(test.param.method + "_on_" + test.param.stem); });

class EveryMethodAlone : public testing::TestWithParam<std::string> {};

TEST_P(EveryMethodAlone, KeepsItsPromisesOnDegenerateAndShowcaseScenes) {
  for (const char* folder : {"degenerate", "showcase"})
    for (const std::string& stem : stems_in(folder)) {
      SCOPED_TRACE(stem);
      const SceneCase& scene = scene_case(folder, stem);
      if (is_to_be_tried(GetParam(), scene)) expect_conformance(GetParam(), scene);
    }
}

INSTANTIATE_TEST_SUITE_P(, EveryMethodAlone, testing::ValuesIn(all_methods()),
                         [](const auto& test) { return identifier(test.param); });

}  // namespace
}  // namespace hottel

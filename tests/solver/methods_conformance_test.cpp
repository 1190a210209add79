// What every method promises (solver/exchange_method.h), in the plane and in space, on every scene of scenes/analytic
// and more; the tolerance is the method's own claim. A method that is in a catalogue is in this test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/element_table.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "tests/solver/dimensions.h"

namespace hottel::methods_conformance_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kFewElements = 60;

struct Plane : PlaneTests {
  static constexpr const char* kName = "plane";
  static constexpr double kExact = 0;  // what exact factors may be off, beside their rounding
  static constexpr std::uint32_t kMostElements = 0xFFFFFFFFu;
  static fs::path folder(const std::string& name) { return name; }
  static Scene read(const fs::path& file) { return read_scene_2(file); }
  static ExchangeMatrix exact(const Prepared& prepared) {
    return exact_exchange(prepared, {.granularity = Granularity::kElement});
  }
};

struct Space : SpaceTests {
  static constexpr const char* kName = "space";
  static constexpr double kExact = 1.1e-12;
  static constexpr std::uint32_t kMostElements = kFewElements;  // those of the showcase are many
  static fs::path folder(const std::string& name) {
    return name == "showcase" ? fs::path("space") : fs::path(name) / "space";
  }
  static Scene read(const fs::path& file) { return read_scene_3(file); }
  static ExchangeMatrix exact(const Prepared& prepared) {
    return exact_exchange(prepared,
                          {.granularity = Granularity::kElement, .wants_visibility = false, .tolerance = 1e-12});
  }
};

template <class D>
const typename D::Catalogue& catalogue() {
  static const typename D::Catalogue methods = D::methods();
  return methods;
}

template <class D>
std::vector<std::string> stems_in(const std::string& folder) {
  std::vector<std::string> stems;
  const fs::path path = fs::path(HOTTEL_SOURCE_DIR) / "scenes" / D::folder(folder);
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".json") stems.push_back(entry.path().stem().string());
  std::sort(stems.begin(), stems.end());
  return stems;
}

template <class D>
struct SceneCase {
  typename D::Prepared prepared;
  ExchangeMatrix exact;  // without entries where there are too many elements
};

template <class D>
const SceneCase<D>& scene_case(const std::string& folder, const std::string& stem) {
  static std::map<std::string, std::unique_ptr<SceneCase<D>>> cases;
  auto& one = cases[folder + "/" + stem];
  if (!one) {
    auto prepared = D::prepared(D::read(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / D::folder(folder) / (stem + ".json")));
    ExchangeMatrix exact(prepared.elements(Granularity::kElement)->elements(), Guarantee::kEstimated);
    if (exact.size() <= D::kMostElements) exact = D::exact(prepared);
    one = std::make_unique<SceneCase<D>>(SceneCase<D>{std::move(prepared), std::move(exact)});
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

template <class D>
void expect_claims_to_hold(const typename D::Method& method, const SceneCase<D>& scene, const ExchangeMatrix& matrix) {
  const auto claimed = method.claimed_errors(scene.prepared);
  const double of_all = method.declared_error(scene.prepared).value_or(std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
      const double error = std::fabs(matrix.factor(i, j).value - scene.exact.factor(i, j).value);
      const double claim = std::min(claimed(i, j), of_all) + D::kExact;
      if (!(error <= claim))
        ADD_FAILURE() << matrix.elements()[i].name << " to " << j << " is off by " << error << ", claimed " << claim;
    }
  }
}

// ExchangeMethod (7).
template <class D>
void expect_pairs_to_be_entries(const typename D::Method& method, const SceneCase<D>& scene,
                                const ExchangeMatrix& matrix) {
  const auto factor = method.factors_of_pairs(scene.prepared);
  for (std::uint32_t i = 0; i < matrix.size() && factor; ++i)
    for (std::uint32_t j = 0; j < matrix.size() && matrix.has_row(i); ++j)
      if (i != j) {
        EXPECT_EQ(std::max(factor(i, j), 0.0), matrix.factor(i, j).value) << i << " " << j;
      }
}

template <class D>
void expect_conformance(const std::string& name, const SceneCase<D>& scene) {
  const auto method = catalogue<D>().make(name);
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
  expect_claims_to_hold<D>(*method, scene, matrix);
  expect_pairs_to_be_entries<D>(*method, scene, matrix);
}

// A method of one dimension, and what tries it on the scenes of a folder.
struct NamedMethod {
  std::string dimension, name;
  bool is_first_of_its_curve = true;  // of accuracy against time: the cheapest
  void (*try_all_scenes_in)(const std::string& folder, const NamedMethod& method) = nullptr;
};

void PrintTo(const NamedMethod& method, std::ostream* out) { *out << method.dimension << " " << method.name; }

// Of scenes with many elements only the first method of each curve is tried.
template <class D>
void try_all_scenes_in(const std::string& folder, const NamedMethod& method) {
  for (const std::string& stem : stems_in<D>(folder)) {
    SCOPED_TRACE(stem);
    const SceneCase<D>& scene = scene_case<D>(folder, stem);
    if (scene.exact.size() > D::kMostElements) continue;
    if (scene.exact.size() <= kFewElements || method.is_first_of_its_curve) expect_conformance<D>(method.name, scene);
  }
}

// Every method of every sweep, and of each family the first one normalised.
template <class D>
void add_methods(std::vector<NamedMethod>& result) {
  for (const auto& family : catalogue<D>().families()) {
    std::set<std::string> curves;
    for (const std::string& name : family.sweep)
      result.push_back(
          {D::kName, name, curves.insert(catalogue<D>().make(name)->info().family).second, &try_all_scenes_in<D>});
    result.push_back({D::kName, family.sweep.front() + ":normalised", false, &try_all_scenes_in<D>});
  }
}

const std::vector<NamedMethod>& all_methods() {
  static const std::vector<NamedMethod> methods = [] {
    std::vector<NamedMethod> result;
    add_methods<Plane>(result);
    add_methods<Space>(result);
    return result;
  }();
  return methods;
}

class EveryMethod : public testing::TestWithParam<NamedMethod> {
 protected:
  static void try_all_scenes_in(const std::string& folder) { GetParam().try_all_scenes_in(folder, GetParam()); }
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
  std::string name = test.param.dimension + "_" + test.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, EveryMethod, testing::ValuesIn(all_methods()), identifier);
INSTANTIATE_TEST_SUITE_P(, FirstOfEveryCurve, testing::ValuesIn(first_methods()), identifier);

}  // namespace
}  // namespace hottel::methods_conformance_test

// Gray-body exchange factors: the numbered properties of gray_exchange, and Gebhart's equation to a hundred digits.
#include "solver/radiosity/gray_exchange.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "geometry/plane/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::gray_exchange_test {
namespace {

using namespace testing_radiosity;

// A_i script-F_ij and the like, as sums of bounds.
struct Interval {
  mpf_class lower{0, kBits}, upper{0, kBits};

  void add(const Enclosure& bounds, const mpf_class& times = 1) {
    lower += times * bounds.lower;
    upper += times * bounds.upper;
  }
};

Enclosure bounds_of(const ExchangeMatrix& matrix, std::uint32_t from, std::uint32_t to) {
  const auto row = matrix.row(from);
  for (std::size_t k = 0; k < row.size(); ++k)
    if (row[k].to == to) return matrix.bounds(from, k);
  return {0, 0};
}

mpf_class emissivity(const ExactScene& scene, const std::vector<Material>& materials, std::uint32_t element) {
  if (element == scene.matrix().sky() || !scene.matrix().elements()[element].material) return mpf_class(1, kBits);
  return 1 - number(materials[*scene.matrix().elements()[element].material].reflectivity.value[0]);
}

// script-F from the fractions G_ij of what i sends out that j absorbs: G_ij = F_ij e_j + sum_k F_ik rho_k G_kj
// (Gebhart 1961), script-F_ij = e_i G_ij.
std::vector<std::vector<mpf_class>> by_gebhart(const ExactScene& scene, const std::vector<Material>& materials) {
  const std::size_t n = scene.matrix().size();
  std::vector<std::vector<mpf_class>> a(n, std::vector<mpf_class>(2 * n + 1, mpf_class(0, kBits)));
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) a[i][k] = -scene.factors()[i][k] * (1 - emissivity(scene, materials, k));
    for (std::uint32_t j = 0; j <= n; ++j) a[i][n + j] = scene.factors()[i][j] * emissivity(scene, materials, j);
    a[i][i] += 1;
  }
  std::vector<std::vector<mpf_class>> result = solve_dense(std::move(a));
  for (std::uint32_t i = 0; i < n; ++i)
    for (mpf_class& factor : result[i]) factor *= emissivity(scene, materials, i);
  return result;
}

struct GrayCheck {
  std::size_t checked = 0, misses = 0;
  double widest = 0;  // relative
  std::string first_miss;

  void add(const ExactScene& scene, const std::vector<Material>& materials) {
    const ExchangeMatrix gray = gray_exchange(scene.matrix(), materials);
    const auto exact = by_gebhart(scene, materials);
    for (std::uint32_t i = 0; i < gray.size(); ++i)
      for (std::uint32_t j = 0; gray.has_row(i) && j <= gray.sky(); ++j) {
        ++checked;
        const double value = gray.factor(i, j).value;
        const Enclosure bounds = bounds_of(gray, i, j);
        const mpf_class slack = exact[i][j] * 1e-75;  // what the reference itself may be off by
        const bool holds = mpf_class(bounds.lower, kBits) <= exact[i][j] + slack &&
                           mpf_class(bounds.upper, kBits) >= exact[i][j] - slack && bounds.contains(value);
        if (!holds && ++misses == 1)
          first_miss = fmt::format("{}, {} to {}: {} in [{}, {}], exact {}", scene.scene().about, i, j, value,
                                   bounds.lower, bounds.upper, exact[i][j].get_d());
        if (value > 0) widest = std::max(widest, bounds.width() / value);
      }
  }
};

ExactScene random_exact_scene(std::uint64_t seed) {
  return ExactScene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
}

TEST(GrayExchange, LiesWithinItsBoundsOnRandomScenes) {
  GrayCheck check;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    check.add(scene, scene.scene().materials);
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(check.checked, 10'000u);
  EXPECT_LT(check.widest, 1e-13);
  fmt::print("{} factors, {} misses; widest {:.2g}, relative\n", check.checked, check.misses, check.widest);
}

TEST(GrayExchange, IsReciprocal) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix gray = gray_exchange(scene.matrix(), scene.scene().materials);
    for (std::uint32_t i = 0; i < gray.size(); ++i)
      for (std::uint32_t j = 0; j < gray.size(); ++j) {
        if (!gray.has_row(i) || !gray.has_row(j)) continue;
        Interval forth, back;
        forth.add(bounds_of(gray, i, j), scene.areas()[i]);
        back.add(bounds_of(gray, j, i), scene.areas()[j]);
        EXPECT_LE(forth.lower, back.upper) << seed;
        EXPECT_LE(back.lower, forth.upper) << seed;
        EXPECT_EQ(gray.factor(i, j).value > 0, gray.factor(j, i).value > 0);
      }
  }
}

TEST(GrayExchange, HasRowsThatSumToTheEmissivity) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix gray = gray_exchange(scene.matrix(), scene.scene().materials);
    for (std::uint32_t i = 0; i < gray.size(); ++i) {
      if (!gray.has_row(i)) continue;
      Interval row;
      double sum = 0;
      for (std::size_t k = 0; k < gray.row(i).size(); ++k) {
        row.add(gray.bounds(i, k));
        sum += gray.row(i)[k].factor.value;
      }
      const mpf_class e = emissivity(scene, scene.scene().materials, i);
      EXPECT_LE(row.lower, e) << seed;
      EXPECT_GE(row.upper, e) << seed;
      EXPECT_NEAR(sum, e.get_d(), 1e-14 * e.get_d()) << seed;
    }
  }
}

TEST(GrayExchange, WithoutReflectionIsTheViewFactors) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Scene2 black = random_scene(seed);
    for (Material& material : black.materials) material.reflectivity = {};
    const PreparedScene2 prepared = prepare(black);
    const ExchangeMatrix factors = exact_exchange(prepared);
    const ExchangeMatrix gray = gray_exchange(factors, black.materials);
    ASSERT_EQ(gray.entry_count(), factors.entry_count());
    for (std::uint32_t i = 0; i < factors.size(); ++i)
      for (std::size_t k = 0; k < factors.row(i).size(); ++k) {
        EXPECT_EQ(gray.row(i)[k].to, factors.row(i)[k].to);
        EXPECT_EQ(gray.row(i)[k].factor.value, factors.row(i)[k].factor.value);
        EXPECT_LE(gray.bounds(i, k).lower, factors.bounds(i, k).lower);
        EXPECT_GE(gray.bounds(i, k).upper, factors.bounds(i, k).upper);
      }
  }
}

// Two faces that see nothing but each other and themselves: 1/script-F_12 = 1/e_1 + A_1/A_2 (1/e_2 - 1) for a flat or
// convex face 1. Here the base of a triangle, and its two legs as one group.
TEST(GrayExchange, OfTwoFacesIsTheClosedForm) {
  const Scene2 scene = scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"one": {"reflectivity": "1/3"}, "two": {"reflectivity": "3/4"}},
    "edges": [{"name": "base", "points": [[6,0],[0,0]], "material": "one"}],
    "polylines": [{"name": "legs", "points": [[0,0],[3,4],[6,0]], "material": "two"}]})");
  const PreparedScene2 prepared = prepare(scene);
  const ExchangeMatrix gray = gray_exchange(exact_exchange(prepared, {Granularity::kGroup}), scene.materials);
  const std::uint32_t one = gray.find("base").value(), two = gray.find("legs").value();
  const Rational e1(2, 3), e2(1, 4), ratio(6, 10);
  const Rational exact = 1 / (1 / e1 + ratio * (1 / e2 - 1));
  const struct {
    std::uint32_t from, to;
    Rational exact;
  } cases[] = {{one, two, exact}, {two, one, exact * ratio}, {one, one, e1 - exact}, {two, two, e2 - exact * ratio}};
  for (const auto& c : cases) {
    EXPECT_NEAR(gray.factor(c.from, c.to).value, to_double(c.exact), 1e-15 * to_double(c.exact));
    EXPECT_LE(Rational(bounds_of(gray, c.from, c.to).lower), c.exact);
    EXPECT_GE(Rational(bounds_of(gray, c.from, c.to).upper), c.exact);
  }
}

// Plates so wide that they hardly see the sky come near the infinite ones: 1/(1/e1 + 1/e2 - 1).
TEST(GrayExchange, OfParallelPlatesTendsToTheClosedForm) {
  const double limit = 1 / (1 / 0.5 + 1 / 0.2 - 1);
  double previous = 1;
  for (const char* width : {"10", "100", "1000"}) {
    const std::string w = width;
    const Scene2 scene = scene_of(R"({"hottel": 1, "dimension": 2,
      "materials": {"a": {"reflectivity": 0.5}, "b": {"reflectivity": 0.8}},
      "edges": [{"name": "low", "points": [[)" +
                                  w + R"(,0],[0,0]], "material": "a"},
                {"name": "high", "points": [[0,1],[)" +
                                  w + R"(,1]], "material": "b"}]})");
    const PreparedScene2 prepared = prepare(scene);
    const ExchangeMatrix gray = gray_exchange(exact_exchange(prepared), scene.materials);
    const double error = std::abs(gray.factor(0, gray.find("high").value()).value - limit);
    EXPECT_LT(error, previous / 5);
    EXPECT_GT(gray.factor(0, gray.sky()).value, 0);
    previous = error;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST(GrayExchange, TellsHowFarItIsInOrderAndFromOneThread) {
  const ExactScene scene(convex_polygon(70));
  const auto caller = std::this_thread::get_id();
  std::vector<double> told;
  GrayExchangeOptions options;
  options.progress = [&](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    told.push_back(fraction);
  };
  gray_exchange(scene.matrix(), scene.scene().materials, options);
  EXPECT_GE(told.size(), 3u);  // 70 fronts, 70 backs and the sky
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
  options.progress = [](double) { throw RequestError("enough"); };
  EXPECT_THROW(gray_exchange(scene.matrix(), scene.scene().materials, options), RequestError);
}

TEST(GrayExchange, StaysNarrowAsReflectivityNearsOne) {
  const ExactScene scene(convex_polygon(15));
  for (int k = 10; k <= 50; k += 20) {
    std::vector<Material> materials = scene.scene().materials;
    for (Material& m : materials) m.reflectivity = Spectrum::scalar(1 - Rational(1, Integer(1) << k));
    GrayCheck check;
    check.add(scene, materials);
    EXPECT_EQ(check.misses, 0u) << check.first_miss;
    EXPECT_LE(check.widest, 1e-13) << k;
  }
}

// A box that reflects all inside it, in a room where one wall does.
TEST(GrayExchange, OfFacesWithoutEmissivityIsZero) {
  const Scene2 scene = scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"gray": {"reflectivity": 0.5}, "mirror": {"reflectivity": 1}},
    "polylines": [{"name": "box", "points": [[1,1],[1,2],[2,2],[2,1]], "closed": true, "material": "mirror",
                   "back": "gray"}],
    "edges": [{"name": "s", "points": [[4,0],[0,0]], "material": "mirror"},
              {"name": "w", "points": [[0,0],[0,4]], "material": "gray"},
              {"name": "n", "points": [[0,4],[4,4]], "material": "gray"},
              {"name": "e", "points": [[4,4],[4,0]], "material": "gray"}]})");
  const PreparedScene2 prepared = prepare(scene);
  const ExchangeMatrix gray = gray_exchange(exact_exchange(prepared), scene.materials);
  for (const char* name : {"box[0]", "box[3]", "s"}) {
    const std::uint32_t i = gray.find(name).value();
    EXPECT_TRUE(gray.row(i).empty()) << name;
    for (std::uint32_t j = 0; j < gray.size(); ++j) EXPECT_EQ(gray.factor(j, i).value, 0);
  }
  EXPECT_GT(gray.factor(gray.find("w").value(), gray.find("box[0]:back").value()).value, 0);
  EXPECT_GT(gray.factor(gray.find("w").value(), gray.find("w").value()).value, 0);
}

TEST(GrayExchange, IsTheSameForAnyNumberOfThreads) {
  const ExactScene scene = random_exact_scene(7);
  std::vector<ExchangeMatrix> matrices;
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    matrices.push_back(gray_exchange(scene.matrix(), scene.scene().materials));
  }
  for (const ExchangeMatrix& other : matrices)
    for (std::uint32_t i = 0; i < other.size(); ++i)
      for (std::size_t k = 0; k < other.row(i).size(); ++k) {
        EXPECT_EQ(other.row(i)[k].factor.value, matrices[0].row(i)[k].factor.value);
        EXPECT_EQ(other.bounds(i, k), matrices[0].bounds(i, k));
      }
}

TEST(GrayExchange, TakesNoMoreMemoryThanIsAllowed) {
  const ExactScene scene(convex_polygon(12));
  std::vector<Material> materials = scene.scene().materials;
  for (Material& m : materials) m.reflectivity = Spectrum::scalar(Rational(1, 2));
  const std::uint64_t bytes = 12 * 12 * kBytesPerGrayPair;
  EXPECT_EQ(gray_exchange(scene.matrix(), materials, {.memory = bytes}).entry_count(), 144u);
  EXPECT_THROW(gray_exchange(scene.matrix(), materials, {.memory = bytes - 1}), RequestError);
}

}  // namespace
}  // namespace hottel::gray_exchange_test

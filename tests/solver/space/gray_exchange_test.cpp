// Gray-body exchange factors of view factors that are not exact: the numbered properties of gray_exchange.
#include "solver/radiosity/gray_exchange.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::gray_exchange_test {
namespace {

using Dense = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Scene3 scene_of(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
}

// The unit cube: floor and ceiling, front and rear, left and right, no two of which reflect alike.
Scene3 cube() {
  Scene3 scene = scene_of("cube.json");
  scene.materials.clear();
  for (std::uint32_t k = 0; k < 6; ++k) {
    scene.materials.push_back({"material " + std::to_string(k), Spectrum::scalar(Rational(k, 6)), {}});
    scene.surfaces[k].material = k;
  }
  return scene;
}

struct Exchanged {
  Scene3 scene;
  ExchangeMatrix matrix;

  explicit Exchanged(Scene3 of, std::uint32_t elements = 1) : scene(std::move(of)) {
    divide_into(scene, elements);
    matrix = exact_exchange(prepare(scene), {.granularity = Granularity::kElement});
  }
  long double emissivity(std::uint32_t i) const {
    if (i == matrix.sky() || !matrix.elements()[i].material) return 1;
    const Rational e = 1 - scene.materials[*matrix.elements()[i].material].reflectivity.value[0];
    return static_cast<long double>(e.get_num().get_d()) / static_cast<long double>(e.get_den().get_d());
  }
  Dense dense(const ExchangeMatrix& factors) const {
    Dense result = Dense::Zero(factors.size(), factors.size() + 1);
    for (std::uint32_t i = 0; i < factors.size(); ++i)
      for (const FactorEntry& entry : factors.row(i)) result(i, entry.to) = entry.factor.value;
    return result;
  }
  // From the fractions G_ij of what i sends out that j absorbs: G_ij = F_ij e_j + sum_k F_ik rho_k G_kj (Gebhart 1961),
  // script-F_ij = e_i G_ij.
  Dense by_gebhart(const Dense& factors) const {
    const Eigen::Index n = factors.rows();
    Dense system = Dense::Identity(n, n), sources = factors;
    for (std::uint32_t k = 0; k <= n; ++k) {
      if (k < n) system.col(k) -= factors.col(k) * (1 - emissivity(k));
      sources.col(k) *= emissivity(k);
    }
    Dense result = system.partialPivLu().solve(sources);
    for (std::uint32_t i = 0; i < n; ++i) result.row(i) *= matrix.has_row(i) ? emissivity(i) : 0;
    return result;
  }
  // The largest difference of script-F to that of the doubles of the factors.
  double off_gebhart(const ExchangeMatrix& gray) const {
    return static_cast<double>((dense(gray) - by_gebhart(dense(matrix))).cwiseAbs().maxCoeff());
  }
};

// The same factors within bounds that are this much wider, relatively.
ExchangeMatrix with_bounds(const ExchangeMatrix& matrix, double width) {
  ExchangeMatrix result(matrix.elements(), Guarantee::kEnclosed);
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    for (const FactorEntry& entry : matrix.row(i)) {
      entries.push_back(entry);
      bounds.push_back({entry.factor.value * (1 - width), entry.factor.value * (1 + width)});
    }
    begin.push_back(entries.size());
  }
  result.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return result;
}

TEST(GrayExchangeInSpace, OfEstimatesIsThatOfTheDoubles) {
  for (const char* name : {"two_boxes.json", "room_turned.json"}) {
    const Exchanged scene(scene_of(name));
    ASSERT_EQ(scene.matrix.guarantee(), Guarantee::kEstimated);
    const ExchangeMatrix gray = gray_exchange(scene.matrix, scene.scene.materials);
    EXPECT_EQ(gray.guarantee(), Guarantee::kEstimated);
    EXPECT_LT(scene.off_gebhart(gray), 1e-14) << name;
  }
}

// As well as the factors close, which is asked for: 1e-9 of the smaller area.
TEST(GrayExchangeInSpace, OfEstimatesIsReciprocalAndSumsToTheEmissivity) {
  const Exchanged scene(scene_of("room_turned.json"));
  const ExchangeMatrix gray = gray_exchange(scene.matrix, scene.scene.materials);
  for (std::uint32_t i = 0; i < gray.size(); ++i) {
    if (!gray.has_row(i)) continue;
    double sum = 0;
    for (const FactorEntry& entry : gray.row(i)) {
      sum += entry.factor.value;
      if (entry.to != gray.sky() && gray.has_row(entry.to)) {
        EXPECT_NEAR(gray.elements()[i].area.value * entry.factor.value,
                    gray.elements()[entry.to].area.value * gray.factor(entry.to, i).value, 1e-8);
      }
    }
    EXPECT_NEAR(sum, static_cast<double>(scene.emissivity(i)), 1e-8);
  }
}

TEST(GrayExchangeInSpace, OfEnclosedFactorsIsEnclosed) {
  const Exchanged scene(cube(), 2);
  ASSERT_EQ(scene.matrix.guarantee(), Guarantee::kEnclosed);
  const ExchangeMatrix gray = gray_exchange(scene.matrix, scene.scene.materials);
  EXPECT_EQ(gray.guarantee(), Guarantee::kEnclosed);
  EXPECT_LT(max_relative_width(gray), 1e-8);
  EXPECT_LT(scene.off_gebhart(gray), 1e-12);
}

// Whatever the factors are within their bounds, also where their sums are above 1.
TEST(GrayExchangeInSpace, HoldsForAllFactorsWithinTheirBounds) {
  const Exchanged scene(cube());
  std::vector<std::uint32_t> sides;
  for (const char* name : {"floor", "ceiling", "front", "rear", "left", "right"})
    sides.push_back(*scene.matrix.find(name));
  std::mt19937_64 random(1);
  for (const double width : {1e-6, 1e-2, 0.2}) {
    const ExchangeMatrix enclosed = with_bounds(scene.matrix, width);
    const ExchangeMatrix gray = gray_exchange(enclosed, scene.scene.materials);
    EXPECT_EQ(gray.guarantee(), Guarantee::kEnclosed);
    std::size_t checked = 0;
    for (int times = 0; times < 20; ++times) {
      Dense factors = scene.dense(scene.matrix);
      const double share = std::uniform_real_distribution<double>(-width / 4, width / 4)(random);
      for (std::size_t i = 0; i < 6; ++i) {  // opposite sides exchange more, or less, with each other
        const std::uint32_t from = sides[i], opposite = sides[i ^ 1U];
        const long double more = factors(from, opposite) * share;
        for (const std::uint32_t to : sides)
          if (to != from) factors(from, to) += to == opposite ? more : -more / 4;
      }
      const Dense exact = scene.by_gebhart(factors);
      for (std::uint32_t i = 0; i < gray.size(); ++i)
        for (std::size_t k = 0; k < gray.row(i).size(); ++k, ++checked) {
          const auto value = static_cast<double>(exact(i, gray.row(i)[k].to));
          EXPECT_LE(gray.bounds(i, k).lower, value * (1 + 1e-14)) << width;
          EXPECT_GE(gray.bounds(i, k).upper, value * (1 - 1e-14)) << width;
          EXPECT_TRUE(gray.bounds(i, k).contains(gray.row(i)[k].factor.value));
          EXPECT_LE(gray.bounds(i, k).upper, static_cast<double>(scene.emissivity(i)) * (1 + 1e-15));
        }
    }
    EXPECT_EQ(checked, 20u * 36u);
  }
}

TEST(GrayExchangeInSpace, WithoutReflectionIsTheViewFactors) {
  Scene3 black = scene_of("two_boxes.json");
  for (Material& material : black.materials) material.reflectivity = Spectrum::scalar(Rational(0));
  const Exchanged scene(std::move(black));
  const ExchangeMatrix gray = gray_exchange(scene.matrix, scene.scene.materials);
  ASSERT_EQ(gray.entry_count(), scene.matrix.entry_count());
  for (std::uint32_t i = 0; i < gray.size(); ++i)
    for (std::size_t k = 0; k < gray.row(i).size(); ++k)
      EXPECT_EQ(gray.row(i)[k].factor.value, scene.matrix.row(i)[k].factor.value);
}

// The factors times a number, of which nothing is known.
ExchangeMatrix times(const ExchangeMatrix& matrix, double number) {
  ExchangeMatrix result(matrix.elements(), Guarantee::kEstimated);
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    for (FactorEntry entry : matrix.row(i)) {
      entry.factor = {entry.factor.value * number, 0};
      entries.push_back(entry);
    }
    begin.push_back(entries.size());
  }
  result.assign(std::move(begin), std::move(entries));
  return result;
}

TEST(GrayExchangeInSpace, RefusesEstimatesOfWhichLightMayNotDieOutAndNegativeOnes) {
  const Exchanged scene(cube());
  EXPECT_THROW(gray_exchange(times(scene.matrix, 20), scene.scene.materials), RequestError);
  EXPECT_THROW(gray_exchange(times(scene.matrix, -1), scene.scene.materials), ContractViolation);
}

}  // namespace
}  // namespace hottel::gray_exchange_test

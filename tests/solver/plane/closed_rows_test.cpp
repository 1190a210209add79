// Radiosities of enclosed factors whose rows sum to 1: bounds against solutions to a hundred digits for many such
// factors within the enclosures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "solver/radiosity/gray_exchange.h"
#include "solver/radiosity/radiosity_solver.h"
#include "tests/solver/plane/bounds_hold.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::closed_rows_test {
namespace {

using namespace testing_radiosity;

// The same factors, each known to lie within `width` of the smaller area of the pair, or within that share of itself.
ExchangeMatrix widened(const ExactScene& scene, double width, bool is_relative, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const ExchangeMatrix& exact = scene.matrix();
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (FactorEntry entry : exact.row(i)) {
      const mpf_class& factor = scene.factors()[i][entry.to];
      const mpf_class reach = is_relative ? mpf_class(factor * width) : mpf_class(width, kBits);
      const mpf_class below = factor - reach * share(random), above = factor + reach * share(random);
      const Enclosure within{std::max(0.0, rounded_down(below)), rounded_up(above)};
      entry.factor = {std::clamp(within.lower + share(random) * within.width(), within.lower, within.upper), 0};
      if (entry.factor.value == 0) entry.factor.value = within.upper / 2;
      entries.push_back(entry);
      bounds.push_back(within);
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(exact.elements(), Guarantee::kEnclosed);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  matrix.promise_closed_rows();
  return matrix;
}

// Factors within their bounds whose rows sum to 1: the true ones, with shares moved from one entry of a row to another,
// as far as bounds allow or less.
WideFactors moved(const ExchangeMatrix& matrix, WideFactors factors, std::mt19937_64& random) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const std::size_t count = matrix.row(i).size();
    if (count < 2) continue;
    for (std::size_t times = 0; times < 3 * count; ++times) {
      const std::size_t a = random() % count, b = random() % count;
      if (a == b) continue;
      mpf_class &from = factors[i][matrix.row(i)[a].to], &to = factors[i][matrix.row(i)[b].to];
      mpf_class most = from - mpf_class(matrix.bounds(i, a).lower, kBits);
      const mpf_class room = mpf_class(matrix.bounds(i, b).upper, kBits) - to;
      if (room < most) most = room;
      if (most <= 0) continue;
      most *= random() % 2 == 0 ? 1.0 : std::uniform_real_distribution<double>(0, 1)(random);
      from -= most;
      to += most;
    }
  }
  return factors;
}

TEST(ClosedRows, BoundRadiositiesOfAllSuchFactorsWithin) {
  BoundsHold check;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
    const Scene2& plan = scene.scene();
    for (const double width : {1e-14, 1e-6, 0.02, 0.5})
      for (const bool is_relative : {false, true}) {
        const ExchangeMatrix matrix = widened(scene, width, is_relative, random);
        const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
        if (!solved) continue;  // a room of mirrors in which something shines
        const RadiositySolution& solution = *solved;
        check.add(matrix, scene.factors(), solution, plan.materials, plan.sky_emission);
        for (int k = 0; k < 3; ++k)
          check.add(matrix, moved(matrix, scene.factors(), random), solution, plan.materials, plan.sky_emission);
      }
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(check.checked, 10'000u);
}

// A polygon of mirrors, almost, with one lamp.
std::vector<Material> lamp_among(const Rational& reflectivity) {
  std::vector<Material> materials(2);
  materials[0] = {"lamp", Spectrum::scalar(reflectivity), Spectrum::scalar(1)};
  materials[1] = {"wall", Spectrum::scalar(reflectivity), Spectrum::scalar(0)};
  return materials;
}

// Factors known within `half` of their doubles, either way.
ExchangeMatrix known_within(const ExchangeMatrix& exact, double half) {
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < exact.size(); ++i)
    for (FactorEntry entry : exact.row(i)) {
      entry.factor.side = 0;
      entries.push_back(entry);
      bounds.push_back({std::max(0.0, entry.factor.value - half), entry.factor.value + half});
    }
  ExchangeMatrix matrix(exact.elements(), Guarantee::kEnclosed);
  matrix.assign({exact.begins().begin(), exact.begins().end()}, std::move(entries), {}, std::move(bounds));
  matrix.promise_closed_rows();
  return matrix;
}

double width_of(const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  return solve_radiosity(matrix, materials, {}).max_relative_width;
}

ExchangeMatrix without_promise(const ExchangeMatrix& matrix) {
  std::vector<std::size_t> begin(matrix.begins().begin(), matrix.begins().end());
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      entries.push_back(matrix.row(i)[k]);
      bounds.push_back(matrix.bounds(i, k));
    }
  ExchangeMatrix result(matrix.elements(), Guarantee::kEnclosed);
  result.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return result;
}

TEST(ClosedRows, NarrowBoundsByMoreThanTheReflectionsThereAre) {
  const ExactScene scene(convex_polygon(64));
  const ExchangeMatrix closed = known_within(scene.matrix(), 1e-12);
  const auto lamp = lamp_among(Rational(99, 100));
  const double narrow = width_of(closed, lamp), wide = width_of(without_promise(closed), lamp);
  EXPECT_LT(narrow, 4e-10);
  EXPECT_GT(wide, 30 * narrow);
}

TEST(ClosedRows, WidenNothing) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene(random_scene(seed));
    for (const double width : {1e-9, 0.05, 0.5}) {
      const ExchangeMatrix closed = widened(scene, width, true, random);
      const auto by_rows = solution_of(closed, scene.scene()),
                 by_ends = solution_of(without_promise(closed), scene.scene());
      if (!by_rows || !by_ends) continue;
      for (std::uint32_t i = 0; i < closed.size(); ++i) {
        const ElementRadiosity &a = by_rows->channels[0].elements[i], &b = by_ends->channels[0].elements[i];
        EXPECT_GE(a.lower, b.lower) << seed;
        EXPECT_LE(a.upper, b.upper) << seed;
        EXPECT_GE(a.net_lower, b.net_lower) << seed;
        EXPECT_LE(a.net_upper, b.net_upper) << seed;
      }
    }
  }
}

TEST(ClosedRows, LeaveNothingUnknownInAFurnace) {
  const ExactScene scene(convex_polygon(20));
  std::mt19937_64 random(1);
  for (const double width : {1e-12, 1e-3, 0.2}) {
    const ExchangeMatrix closed = widened(scene, width, false, random);
    auto furnace = lamp_among(Rational(99, 100));
    furnace[1].emission = furnace[0].emission;
    const RadiositySolution solution = solve_radiosity(closed, furnace, {});
    for (std::uint32_t i = 0; i < closed.size(); ++i) {
      if (!closed.has_row(i)) continue;
      const ElementRadiosity& e = solution.channels[0].elements[i];
      EXPECT_LE(e.lower, 100);
      EXPECT_GE(e.upper, 100);
      EXPECT_LT(e.upper - e.lower, 1e-12) << width;
      EXPECT_LE(e.net_lower, 0);
      EXPECT_GE(e.net_upper, 0);
      EXPECT_LT(e.net_upper - e.net_lower, 1e-12) << width;
    }
  }
}

// With light from the sky, too: the sky is one more column of rows that sum to 1.
TEST(ClosedRows, CountTheSky) {
  const ExactScene scene(scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"white": {"reflectivity": 0.99, "emission": 0.05}}, "sky": {"emission": 5},
    "polylines": [{"name": "u", "points": [[0, 0], [0, 1]], "material": "white"}],
    "edges": [{"name": "floor", "points": [[3, 0], [0, 0]], "material": "white"}]})"));
  std::mt19937_64 random(1);
  const ExchangeMatrix closed = widened(scene, 1e-3, false, random);
  const RadiositySolution solution = solve_radiosity(closed, scene.scene().materials, scene.scene().sky_emission);
  for (std::uint32_t i = 0; i < closed.size(); ++i) {
    if (!closed.has_row(i)) continue;
    EXPECT_NEAR(solution.channels[0].elements[i].lower, 5, 1e-12);
    EXPECT_NEAR(solution.channels[0].elements[i].upper, 5, 1e-12);
  }
}

TEST(ClosedRows, ThatCannotBeAreRefused) {
  const ExactScene scene(convex_polygon(5));
  std::mt19937_64 random(1);
  const ExchangeMatrix closed = widened(scene, 1e-6, true, random);
  std::vector<std::size_t> begin(closed.begins().begin(), closed.begins().end());
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < closed.size(); ++i)
    for (std::size_t k = 0; k < closed.row(i).size(); ++k) {
      entries.push_back(closed.row(i)[k]);
      bounds.push_back(closed.bounds(i, k));
      if (i > 0) continue;  // a row of halves
      entries.back().factor.value /= 2;
      bounds.back() = {bounds.back().lower / 2, bounds.back().upper / 2};
    }
  ExchangeMatrix broken(closed.elements(), Guarantee::kEnclosed);
  broken.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  const auto lamp = lamp_among(Rational(1, 2));
  EXPECT_NO_THROW(solve_radiosity(broken, lamp, {}));
  broken.promise_closed_rows();
  EXPECT_THROW(solve_radiosity(broken, lamp, {}), ContractViolation);
}

// Sources that are known within bounds of their own, each end of which is solved for.
TEST(ClosedRows, BoundRadiositiesOfSourcesThatAreOnlyEnclosed) {
  BoundsHold check;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene(random_scene(seed));
    const Scene2& plan = scene.scene();
    const ExchangeMatrix matrix = widened(scene, 1e-3, false, random);
    RadiositySources sources = sources_of(matrix, plan.materials, plan.sky_emission);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const RationalEnclosure& own = sources.emission[i][0];
      const RationalEnclosure wide{own.lower * Rational(9, 10), own.upper * Rational(11, 10)};
      sources.emission[i] = SourceSpectrum::of(std::array<RationalEnclosure, 3>{wide, wide, wide});
    }
    const RadiositySolution solution =
        RadiositySolver(std::make_shared<const ExchangeMatrix>(matrix), reflectivities_of(plan.materials))
            .solve(sources);
    for (const Rational& share : {Rational(9, 10), Rational(1), Rational(11, 10)}) {
      std::vector<Material> materials = plan.materials;
      for (Material& material : materials)
        for (Rational& value : material.emission.value) value *= share;
      check.add(matrix, moved(matrix, scene.factors(), random), solution, materials, plan.sky_emission);
    }
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(check.checked, 500u);
}

// Script-F: e_i times the net of i, less what it emits, when j alone emits e_j.
TEST(ClosedRows, BoundExchangeOfGrayFacesWithSuchFactors) {
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene(random_scene(seed));
    const ExchangeMatrix matrix = widened(scene, seed % 2 == 0 ? 1e-3 : 1e-9, false, random);
    std::vector<Material> materials = scene.scene().materials;
    const ExchangeMatrix gray = gray_exchange(matrix, materials);
    const double narrower = max_relative_width(gray);
    EXPECT_LE(narrower, max_relative_width(gray_exchange(without_promise(matrix), materials)) * (1 + 1e-9));
    const WideFactors factors = moved(matrix, scene.factors(), random);
    for (std::uint32_t j = 0; j < matrix.size(); ++j) {
      if (!matrix.has_row(j)) continue;
      // One element alone emits: it gets a material of its own.
      std::vector<Element> elements = matrix.elements();
      std::vector<Material> lit = materials;
      for (Material& material : lit) material.emission = Spectrum::scalar(0);
      lit.push_back(materials[*elements[j].material]);
      const Rational e_j = 1 - lit.back().reflectivity.value[0];
      if (e_j == 0) continue;
      lit.back().emission = Spectrum::scalar(e_j);
      elements[j].material = static_cast<std::uint32_t>(lit.size() - 1);
      ExchangeMatrix own(elements, Guarantee::kEstimated);
      std::vector<FactorEntry> entries;
      for (std::uint32_t i = 0; i < matrix.size(); ++i)
        for (const FactorEntry& entry : matrix.row(i)) entries.push_back({entry.to, {entry.factor.value, 0}, 1});
      own.assign({matrix.begins().begin(), matrix.begins().end()}, std::move(entries));
      const auto radiosity = radiosity_of(own, factors, lit, {}, 0);
      for (std::uint32_t i = 0; i < matrix.size(); ++i)
        for (std::size_t k = 0; k < gray.row(i).size(); ++k) {
          if (gray.row(i)[k].to != j) continue;
          mpf_class irradiance(0, kBits);
          for (std::uint32_t l = 0; l < matrix.size(); ++l) irradiance += factors[i][l] * radiosity[l];
          const mpf_class real =
              irradiance * number(Rational(1 - materials[*matrix.elements()[i].material].reflectivity.value[0]));
          const mpf_class slack = (abs(real) + 1) * 1e-75;
          EXPECT_LE(mpf_class(gray.bounds(i, k).lower, kBits), real + slack) << seed << " " << i << " " << j;
          EXPECT_GE(mpf_class(gray.bounds(i, k).upper, kBits), real - slack) << seed << " " << i << " " << j;
          ++checked;
        }
    }
  }
  EXPECT_GT(checked, 300u);
}

}  // namespace
}  // namespace hottel::closed_rows_test

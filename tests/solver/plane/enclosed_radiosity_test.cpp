// Radiosities of enclosed factors: bounds against solutions to a hundred digits for many factors within the enclosures.
#include "solver/radiosity/enclosed_radiosity.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <string>

#include "kernel/support/failure.h"
#include "solver/radiosity/a_priori_bounds.h"
#include "solver/radiosity/net_flux.h"
#include "tests/solver/plane/bounds_hold.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::enclosed_radiosity_test {
namespace {

using namespace testing_radiosity;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ExactScene random_exact_scene(std::uint64_t seed) {
  return ExactScene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
}

// The same factors, each known to lie in an interval of up to the given relative width about the true one.
ExchangeMatrix widened(const ExactScene& scene, double width, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const ExchangeMatrix& exact = scene.matrix();
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (FactorEntry entry : exact.row(i)) {
      const mpf_class& factor = scene.factors()[i][entry.to];
      const Enclosure within{rounded_down(factor * (1 - std::min(1.0, width * share(random)))),
                             rounded_up(factor * (1 + width * share(random)))};
      entry.factor = {std::clamp(within.lower + share(random) * within.width(), within.lower, within.upper), 0};
      entries.push_back(entry);
      bounds.push_back(within);
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(exact.elements(), Guarantee::kEnclosed);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return matrix;
}

// Factors within the enclosures: at(bounds) of each.
template <class At>
WideFactors factors_within(const ExchangeMatrix& matrix, const At& at) {
  WideFactors factors(matrix.size(), std::vector<mpf_class>(matrix.size() + 1, mpf_class(0, kBits)));
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) factors[i][matrix.row(i)[k].to] = at(matrix.bounds(i, k));
  return factors;
}

WideFactors random_factors(const ExchangeMatrix& matrix, std::mt19937_64& random) {
  return factors_within(matrix, [&](const Enclosure& bounds) {
    const int kind = static_cast<int>(random() % 4);
    const double share = kind == 0 ? 0 : kind == 1 ? 1 : std::uniform_real_distribution<double>(0, 1)(random);
    const mpf_class lower(bounds.lower, kBits), upper(bounds.upper, kBits);
    return mpf_class(lower + share * (upper - lower));
  });
}

bool is_bounded(const RadiositySolution& solution) { return std::isfinite(solution.max_relative_width); }

TEST(EnclosedFactors, BoundRadiositiesOfAllFactorsWithin) {
  BoundsHold check;
  std::size_t bounded = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    for (const double width : {0.0, 1e-14, 1e-6, 0.02, 0.5}) {
      const ExchangeMatrix matrix = widened(scene, width, random);
      const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
      if (width == 0) {
        EXPECT_TRUE(solved);
      }
      if (!solved) continue;
      const RadiositySolution& solution = *solved;
      check.add(matrix, scene.factors(), solution, plan.materials, plan.sky_emission);
      if (!is_bounded(solution)) continue;  // for some of these factors there may be no radiosity
      ++bounded;
      for (int k = 0; k < 3; ++k)
        check.add(matrix, random_factors(matrix, random), solution, plan.materials, plan.sky_emission);
    }
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(bounded, 500u);
  fmt::print("{} numbers, {} misses, {} with open bounds; {} solutions with finite bounds\n", check.checked,
             check.misses, check.open, bounded);
}

TEST(EnclosedFactors, BoundRadiositiesAsNarrowlyAsTheirEndsAllow) {
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    for (const double width : {1e-9, 0.05}) {
      const ExchangeMatrix matrix = widened(scene, width, random);
      const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
      if (!solved) continue;
      const RadiositySolution& solution = *solved;
      if (!is_bounded(solution)) continue;
      const auto radiosity = [&](double Enclosure::*end) {
        const auto at = [end](const Enclosure& bounds) { return mpf_class(bounds.*end, kBits); };
        return radiosity_of(matrix, factors_within(matrix, at), plan.materials, plan.sky_emission, 0);
      };
      const auto least = radiosity(&Enclosure::lower), most = radiosity(&Enclosure::upper);
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        if (!matrix.has_row(i)) continue;
        const ElementRadiosity& e = solution.channels[0].elements[i];
        ++checked;
        // Each is a solution of its own, near a singular one where reflectivities are near 1.
        EXPECT_GE(e.lower, least[i].get_d() * (1 - 1e-9)) << seed << " " << i;
        EXPECT_LE(e.upper, most[i].get_d() * (1 + 1e-9)) << seed << " " << i;
      }
    }
  }
  EXPECT_GT(checked, 1000u);
}

// Two rooms that do not see each other: in each, two faces that see each other and nothing else.
ExchangeMatrix two_rooms(const Enclosure& first, const Enclosure& second) {
  std::vector<Element> elements(4);
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < 4; ++i) {
    elements[i].name = fmt::format("f{}", i);
    elements[i].material = i / 2;
    elements[i].area = {1, 0};
    bounds.push_back(i < 2 ? first : second);
    entries.push_back({i ^ 1, {(bounds.back().lower + bounds.back().upper) / 2, 0}, 1});
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(elements, Guarantee::kEnclosed);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return matrix;
}

std::vector<Material> lamps(const Rational& first, const Rational& second) {
  return {{"a", Spectrum::scalar(first), Spectrum::scalar(1)}, {"b", Spectrum::scalar(second), Spectrum::scalar(1)}};
}

TEST(EnclosedFactors, LeaveBoundsOpenWhereLightNeedNotDieOut) {
  // B = 1 / (1 - rho F) in each room.
  const RadiositySolution solution =
      solve_radiosity(two_rooms({0.5, 0.75}, {0.5, 1.125}), lamps(Rational(1, 2), Rational(9, 10)), {});
  const std::vector<ElementRadiosity>& elements = solution.channels[0].elements;
  EXPECT_LE(elements[0].lower, 4.0 / 3);
  EXPECT_NEAR(elements[0].lower, 4.0 / 3, 1e-14);
  EXPECT_GE(elements[1].upper, 1.6);
  EXPECT_NEAR(elements[1].upper, 1.6, 1e-14);
  EXPECT_NEAR(elements[2].lower, 1 / 0.55, 1e-14);
  EXPECT_EQ(elements[2].upper, kInfinity);  // 0.9 * 1.125 > 1
  EXPECT_EQ(elements[3].net_lower, -kInfinity);
  EXPECT_EQ(solution.max_relative_width, kInfinity);
  ASSERT_EQ(solution.notes.size(), 1u);
  EXPECT_EQ(solution.notes[0], "no upper bound could be proven for 2 of 4 radiosities");
}

TEST(CrudeBounds, TakeBackThatAnUpperBoundIsMissing) {
  const ExchangeMatrix matrix = two_rooms({0.5, 0.75}, {0.5, 1.125});
  const std::vector<Material> materials = lamps(Rational(1, 2), Rational(9, 10));
  RadiositySolution solution = solve_radiosity(matrix, materials, {});
  ASSERT_EQ(solution.notes.size(), 1u);
  set_a_priori_bounds(matrix, materials, {}, solution);
  EXPECT_EQ(solution.channels[0].elements[2].upper, 10);  // 1 / (1 - 9/10)
  EXPECT_TRUE(solution.notes.empty()) << solution.notes[0];
}

TEST(EnclosedFactors, BoundRadiositiesOfEverySolver) {
  const ExchangeMatrix matrix = two_rooms({0.5, 0.75}, {0.25, 0.5});
  const std::vector<Material> materials = lamps(Rational(1, 2), Rational(9, 10));
  for (const Solver solver :
       {Solver::kAuto, Solver::kLu, Solver::kBicgstab, Solver::kJacobi, Solver::kGaussSeidel, Solver::kShooting}) {
    for (const std::optional<int> iterations : {std::optional<int>(), std::optional<int>(1)}) {
      RadiosityOptions options;
      options.solver = solver;
      options.iterations = iterations;
      const RadiositySolution solution = solve_radiosity(matrix, materials, {}, options);
      BoundsHold check;
      std::mt19937_64 random(1);
      for (int k = 0; k < 8; ++k) check.add(matrix, random_factors(matrix, random), solution, materials, {});
      EXPECT_EQ(check.misses, 0u) << to_string(solver) << " " << check.first_miss;
      EXPECT_NEAR(solution.channels[0].elements[3].upper, 1 / (1 - 0.45), 1e-14) << to_string(solver);
    }
  }
  EXPECT_THROW(solve_radiosity(matrix, materials, {}, {Solver::kCholesky, {}, {}, {}}), RequestError);
}

TEST(EnclosedFactors, LeaveDarkWhatNoFactorsWithinLight) {
  std::vector<Material> materials = lamps(Rational(1, 2), Rational(9, 10));
  materials[1].emission = {};
  const RadiositySolution solution = solve_radiosity(two_rooms({0.5, 0.75}, {0.25, 0.5}), materials, {});
  ASSERT_EQ(solution.channels[0].dark.size(), 1u);
  EXPECT_EQ(solution.channels[0].dark[0].first_element, 2u);
  EXPECT_EQ(solution.channels[0].elements[3].upper, 0);
  // Light that may arrive, but does not for the doubles.
  std::vector<Element> elements = two_rooms({0.5, 0.75}, {0.25, 0.5}).elements();
  ExchangeMatrix perhaps(elements, Guarantee::kEnclosed);
  perhaps.assign({0, 1, 1, 2, 2}, {{1, {0.5, 0}, 1}, {0, {0, 0}, 1}}, {}, {{0.5, 0.5}, {0, 0.25}});
  const RadiositySolution lit = solve_radiosity(perhaps, materials, {});
  EXPECT_EQ(lit.channels[0].elements[2].lower, 0);
  EXPECT_NEAR(lit.channels[0].elements[2].upper, 0.9 * 0.25 * 1.25, 1e-14);
}

TEST(EnclosedFactors, TellHowFarTheyAreThreeTimesOver) {
  std::vector<double> told;
  RadiosityOptions options;
  options.progress = [&](double fraction) { told.push_back(fraction); };
  solve_radiosity(two_rooms({0.5, 0.75}, {0.25, 0.5}), lamps(Rational(1, 2), Rational(9, 10)), {}, options);
  ASSERT_EQ(told.size(), 3u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
}

// Net fluxes of a solution hold for these factors.
std::size_t expect_within(const ExactScene& scene, const WideFactors& factors, const ExchangeMatrix& matrix,
                          const RadiositySolution& solution, const std::string& what) {
  const Scene2& plan = scene.scene();
  const mpf_class sky = number(plan.sky_emission.value[0]);
  const auto radiosity = radiosity_of(matrix, factors, plan.materials, plan.sky_emission, 0);
  std::map<std::string, mpf_class> flux;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::uint32_t j = 0; j <= matrix.sky() && matrix.has_row(i); ++j) {
      const bool is_sky = j == matrix.sky();
      const std::string from = matrix.elements()[i].name, to = is_sky ? "sky" : matrix.elements()[j].name;
      for (const std::string& name : {from, to}) flux.try_emplace(name, 0, kBits);
      const mpf_class share = scene.areas()[i] * factors[i][j];
      const mpf_class arrives = is_sky ? sky : radiosity[j];
      flux[from] -= share * arrives;
      if (j == 0) flux[from] += scene.areas()[i] * radiosity[i];
      if (is_sky || !matrix.has_row(j)) flux[to] += share * ((is_sky ? sky : mpf_class(0, kBits)) - radiosity[i]);
    }
  std::size_t checked = 0;
  for (const NetFlux& each : net_flux(matrix, solution, plan.sky_emission, [](const Element& e) { return e.name; })) {
    const NetFlux::Power& power = each.by_channel[0];
    const mpf_class real = flux.at(each.name), slack = (abs(real) + 1) * 1e-60;
    ++checked;
    EXPECT_LE(mpf_class(power.lower, kBits), real + slack) << what << " " << each.name;
    EXPECT_GE(mpf_class(power.upper, kBits), real - slack) << what << " " << each.name;
    EXPECT_LT(power.upper - power.lower, kInfinity);
  }
  return checked;
}

TEST(EnclosedFactors, BoundNetFluxesOfAllFactorsWithin) {
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix matrix = widened(scene, seed % 2 == 0 ? 0.01 : 1e-10, random);
    const std::optional<RadiositySolution> solved = solution_of(matrix, scene.scene());
    if (!solved || !is_bounded(*solved)) continue;
    for (const WideFactors& factors : {scene.factors(), random_factors(matrix, random)})
      checked += expect_within(scene, factors, matrix, *solved, fmt::format("{}", seed));
  }
  EXPECT_GT(checked, 500u);
}

// The same factors, of which each is known exactly, within an interval, or only guessed where `has_estimates`.
ExchangeMatrix mixed(const ExactScene& scene, double width, bool has_estimates, std::mt19937_64& random) {
  const ExchangeMatrix& exact = scene.matrix();
  const ExchangeMatrix wide = widened(scene, width, random);
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  std::vector<Guarantee> guarantees;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < exact.row(i).size(); ++k) {
      guarantees.push_back(static_cast<Guarantee>(random() % (has_estimates ? 3 : 2)));
      entries.push_back(guarantees.back() == Guarantee::kExact ? exact.row(i)[k] : wide.row(i)[k]);
      if (guarantees.back() == Guarantee::kEstimated) entries.back().factor.value *= 1 - width;  // perhaps outside
      bounds.push_back(wide.bounds(i, k));
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(exact.elements(), Guarantee::kExact);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds), std::move(guarantees));
  return matrix;
}

TEST(MixedFactors, BoundRadiositiesOfAllFactorsWithinWhereNoneIsEstimated) {
  BoundsHold check;
  std::size_t bounded = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    for (const double width : {1e-12, 0.05}) {
      const ExchangeMatrix matrix = mixed(scene, width, false, random);
      const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
      if (!solved) continue;
      EXPECT_EQ(solved->guarantee, Guarantee::kEnclosed);
      check.add(matrix, scene.factors(), *solved, plan.materials, plan.sky_emission);
      if (!is_bounded(*solved)) continue;
      ++bounded;
      for (int k = 0; k < 3; ++k)
        check.add(matrix, random_factors(matrix, random), *solved, plan.materials, plan.sky_emission);
    }
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(bounded, 120u);
}

TEST(MixedFactors, BoundRadiositiesOfThePrintedFactorsWhereSomeAreEstimated) {
  BoundsHold check;
  std::size_t solutions = 0, missed_by_the_scene = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    const ExchangeMatrix matrix = mixed(scene, 0.05, true, random);
    const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
    if (!solved || matrix.guarantee() != Guarantee::kEstimated) continue;
    ++solutions;
    EXPECT_EQ(solved->guarantee, Guarantee::kEstimated);
    EXPECT_LT(solved->max_relative_width, 1e-9) << seed;
    // The doubles, and the real numbers behind those that are exact.
    for (const bool has_real : {false, true}) {
      WideFactors printed(matrix.size(), std::vector<mpf_class>(matrix.size() + 1, mpf_class(0, kBits)));
      for (std::uint32_t i = 0; i < matrix.size(); ++i)
        for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
          const FactorEntry& entry = matrix.row(i)[k];
          printed[i][entry.to] = has_real && matrix.guarantee(i, k) == Guarantee::kExact
                                     ? scene.factors()[i][entry.to]
                                     : mpf_class(entry.factor.value, kBits);
        }
      check.add(matrix, printed, *solved, plan.materials, plan.sky_emission);
    }
    BoundsHold of_scene;
    of_scene.add(matrix, scene.factors(), *solved, plan.materials, plan.sky_emission);
    missed_by_the_scene += of_scene.misses > 0;
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(solutions, 60u);
  EXPECT_GT(missed_by_the_scene, solutions / 2) << "the guarantee would be needless";
}

TEST(MixedFactors, BoundNetFluxesOfThePrintedFactorsWhereSomeAreEstimated) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    const ExchangeMatrix matrix = mixed(scene, 0.05, true, random);
    const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
    if (!solved || matrix.guarantee() != Guarantee::kEstimated) continue;
    WideFactors printed(matrix.size(), std::vector<mpf_class>(matrix.size() + 1, mpf_class(0, kBits)));
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i)) printed[i][entry.to] = mpf_class(entry.factor.value, kBits);
    expect_within(scene, printed, matrix, *solved, fmt::format("{}", seed));
  }
}

TEST(CrudeBounds, AreNotForEstimates) {
  const ExactScene scene = random_exact_scene(1);
  std::mt19937_64 random(1);
  const ExchangeMatrix matrix = mixed(scene, 1e-6, true, random);
  std::optional<RadiositySolution> solved = solution_of(matrix, scene.scene());
  ASSERT_TRUE(solved);
  EXPECT_THROW(set_a_priori_bounds(matrix, scene.scene().materials, {}, *solved), ContractViolation);
}

TEST(CrudeBounds, NarrowThoseOfEnclosedFactorsAndHold) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    const ExactScene scene = random_exact_scene(seed);
    const Scene2& plan = scene.scene();
    const ExchangeMatrix matrix = widened(scene, seed % 2 == 0 ? 0.3 : 1e-12, random);
    const std::optional<RadiositySolution> solved = solution_of(matrix, plan);
    if (!solved) continue;
    const RadiositySolution& solution = *solved;
    RadiositySolution narrowed = solution;
    set_a_priori_bounds(matrix, plan.materials, plan.sky_emission, narrowed);
    BoundsHold check;
    check.add(matrix, scene.factors(), narrowed, plan.materials, plan.sky_emission);
    EXPECT_EQ(check.misses, 0u) << check.first_miss;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      EXPECT_GE(narrowed.channels[0].elements[i].lower, solution.channels[0].elements[i].lower);
      EXPECT_LE(narrowed.channels[0].elements[i].upper, solution.channels[0].elements[i].upper);
    }
  }
}

}  // namespace
}  // namespace hottel::enclosed_radiosity_test

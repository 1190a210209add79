// Proven bounds against solutions to a hundred digits.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/factors_as_given.h"
#include "solver/radiosity/net_flux.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::radiosity_bounds_test {
namespace {

using namespace testing_radiosity;

constexpr std::uint64_t kScenes = 1000;

ExactScene random_exact_scene(std::uint64_t seed) {
  return ExactScene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
}

TEST(RadiosityBounds, HoldOnRandomScenesAndNeedTheirErrorTerms) {
  BoundsCheck check, without_factors, without_any;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const auto& materials = scene.scene().materials;
    check.add(scene, scene.solve(), materials);
    if (seed % 4 != 1) continue;
    const auto solve_without = [&](const ErrorTerms& terms) {
      return FactorsAsGiven(scene.matrix(), reflectivities_of(materials))
          .solve(sources_of(scene.matrix(), materials, scene.scene().sky_emission), {}, false, terms);
    };
    without_factors.add(scene, solve_without({false, true}), materials);
    without_any.add(scene, solve_without({false, false}), materials);
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(check.checked, 10 * kScenes);
  EXPECT_LT(check.widest, 1e-14);
  EXPECT_GT(without_factors.misses, 0u);
  EXPECT_GT(without_any.misses, 0u);
  fmt::print(
      "{} radiosities, {} misses; relative widths {:.2g} to {:.2g}, ratio {:.2g}; without error terms {} of {} "
      "missed, without those of the factors {}\n",
      check.checked, check.misses, check.narrowest, check.widest, check.widest / check.narrowest, without_any.misses,
      without_any.checked, without_factors.misses);
}

TEST(RadiosityBounds, StayNarrowAsReflectivityNearsOne) {
  for (const bool is_furnace : {false, true}) {
    const ExactScene scene(is_furnace ? analytic_scene("furnace") : convex_polygon(40));
    for (const Solver solver : {Solver::kCholesky, Solver::kCg})
      for (int k = 10; k <= 50; k += solver == Solver::kCg ? 8 : 4) {
        std::vector<Material> materials = scene.scene().materials;
        const Rational loss(1, Integer(1) << k);
        for (Material& m : materials) {
          m.reflectivity = Spectrum::scalar(1 - loss);
          if (is_furnace) m.emission = Spectrum::scalar(loss);
        }
        const RadiositySolution solution = scene.solve(materials, {solver, {}, {}, {}});
        BoundsCheck check;
        check.add(scene, solution, materials);
        EXPECT_EQ(check.misses, 0u) << check.first_miss;
        EXPECT_LE(check.widest, 1e-14) << to_string(solver) << " k = " << k;
      }
  }
}

TEST(RadiosityBounds, StayNarrowFarBeyondTheReachOfDoubles) {
  const ExactScene scene(convex_polygon(9));
  for (const int k : {60, 90, 200, 400}) {
    std::vector<Material> materials = scene.scene().materials;
    for (Material& m : materials) m.reflectivity = Spectrum::scalar(1 - Rational(1, Integer(1) << k));
    const RadiositySolution solution = scene.solve(materials);
    EXPECT_LE(solution.max_relative_width, 1e-14) << k;
    // All sides are nearly as bright: emitted = absorbed.
    EXPECT_NEAR(std::ldexp(solution.channels[0].elements[0].radiosity, -k) * 9, 1, 0.1);
  }
}

TEST(RadiosityBounds, StayNarrowUpToTheEndOfTheRangeOfDoubles) {
  const ExactScene scene(convex_polygon(5));
  for (const int k : {900, 1000, 1060, 1100}) {
    std::vector<Material> materials = scene.scene().materials;
    for (Material& m : materials) m.reflectivity = Spectrum::scalar(1 - Rational(1, Integer(1) << k));
    const RadiositySolution solution = scene.solve(materials);
    for (const ElementRadiosity& e : solution.channels[0].elements) {
      if (e.reflectivity == 0) continue;  // the backs
      if (k <= 1000) {
        EXPECT_NEAR(std::ldexp(e.radiosity, -k) * 5, 1, 0.5) << k;  // five sides, about 1/5 each
        EXPECT_LE(e.upper - e.lower, 1e-14 * e.radiosity) << k;
      } else {
        EXPECT_EQ(e.lower, std::numeric_limits<double>::max()) << k;
        EXPECT_TRUE(std::isinf(e.radiosity) && std::isinf(e.upper)) << k;
      }
    }
  }
}

TEST(RadiosityBounds, OfLargeScenesByGradientsAgreeWithElimination) {
  Scene2 scene = generate_2({"clutter", 900, 5});
  const PreparedScene2 prepared = prepare(scene);
  const ExchangeMatrix matrix = exact_exchange(prepared, {Granularity::kFace, false});
  const auto solve = [&](Solver solver) {
    return solve_radiosity(matrix, scene.materials, scene.sky_emission, {solver, {}, {}, {}});
  };
  const RadiositySolution gradients = solve(Solver::kAuto), elimination = solve(Solver::kCholesky);
  EXPECT_EQ(gradients.used, Solver::kCg);
  EXPECT_GT(gradients.unknowns, kMostDenseUnknowns);
  EXPECT_LE(gradients.max_relative_width, 1e-14);
  EXPECT_LE(elimination.max_relative_width, 1e-14);
  for (std::size_t c = 0; c < gradients.channels.size(); ++c)
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      const ElementRadiosity &a = gradients.channels[c].elements[i], &b = elimination.channels[c].elements[i];
      EXPECT_LE(std::max(a.lower, b.lower), std::min(a.upper, b.upper));
    }
}

TEST(RadiosityBounds, HoldForEverySolverAsItIs) {
  const Solver solvers[] = {Solver::kAuto,     Solver::kCholesky, Solver::kCg,          Solver::kLu,
                            Solver::kBicgstab, Solver::kJacobi,   Solver::kGaussSeidel, Solver::kShooting};
  for (std::uint64_t seed = 0; seed < 14; ++seed) {
    Scene2 plain = random_scene(seed);
    for (Material& m : plain.materials)  // so that plain iterations get somewhere
      if (m.reflectivity.value[0] > Rational(9, 10)) m.reflectivity = Spectrum::scalar(Rational(9, 10));
    const ExactScene scene(plain);
    for (const Solver solver : solvers) {
      const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
      BoundsCheck check;
      check.add(scene, solution, scene.scene().materials);
      EXPECT_EQ(check.misses, 0u) << to_string(solver) << " " << check.first_miss;
      double widest = 0, brightest = 0;
      for (const ElementRadiosity& e : solution.channels[0].elements) {
        widest = std::max(widest, e.upper - e.lower);
        brightest = std::max(brightest, e.radiosity);
      }
      EXPECT_LE(widest, 1e-10 * brightest) << to_string(solver) << " " << plain.about;
      if (solver != Solver::kAuto) {
        EXPECT_EQ(solution.used, solver);
      }
      ASSERT_FALSE(solution.channels[0].residual_history.empty());
      EXPECT_LE(solution.channels[0].residual_history.back(), 1e-12) << to_string(solver) << " " << plain.about;
    }
  }
}

TEST(RadiosityBounds, AreWideButTrueAfterFewIterations) {
  const ExactScene scene(analytic_scene("square_radiosity_bright"));
  for (const Solver solver :
       {Solver::kCg, Solver::kBicgstab, Solver::kJacobi, Solver::kGaussSeidel, Solver::kShooting}) {
    RadiosityOptions options;
    options.solver = solver;
    options.iterations = 1;
    const RadiositySolution solution = scene.solve(options);
    BoundsCheck check;
    check.add(scene, solution, scene.scene().materials);
    EXPECT_EQ(check.misses, 0u) << to_string(solver) << " " << check.first_miss;
    EXPECT_EQ(solution.channels[0].residual_history.size(), 2u) << to_string(solver);
    options.iterations.reset();
    options.until = 1e-3;
    const auto history = scene.solve(options).channels[0].residual_history;
    EXPECT_LE(history.back(), 1e-3) << to_string(solver);
    EXPECT_GT(history[history.size() - 2], 1e-3) << to_string(solver);
  }
}

TEST(RadiosityBounds, AreTheSameForAnyNumberOfThreads) {
  const ExactScene scene(convex_polygon(60));
  for (const Solver solver : {Solver::kCholesky, Solver::kCg, Solver::kBicgstab, Solver::kJacobi}) {
    std::vector<Material> materials = scene.scene().materials;
    for (Material& m : materials) m.reflectivity = Spectrum::scalar(Rational(19, 20));
    std::vector<RadiositySolution> solutions;
    for (const int threads : {1, 2, 3, 7}) {
      const ThreadLimit limit(threads);
      solutions.push_back(scene.solve(materials, {solver, {}, {}, {}}));
    }
    for (const RadiositySolution& other : solutions)
      for (std::size_t i = 0; i < scene.matrix().size(); ++i) {
        const ElementRadiosity &a = solutions[0].channels[0].elements[i], &b = other.channels[0].elements[i];
        EXPECT_EQ(a.radiosity, b.radiosity);
        EXPECT_EQ(a.lower, b.lower);
        EXPECT_EQ(a.upper, b.upper);
        EXPECT_EQ(a.irradiance, b.irradiance);
      }
  }
}

// A matrix as somebody else might hand it over: three faces, rows that sum to what they like.
ExchangeMatrix foreign(double scale) {
  std::vector<Element> elements(3);
  for (int i = 0; i < 3; ++i) {
    elements[i].name = fmt::format("f{}", i);
    elements[i].material = 0;
    elements[i].area = {1 + i * 0.5, 0};
  }
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  std::vector<FactorEntry> entries;
  const double factors[3][3] = {{0, 0.5, 0.25}, {0.375, 0, 0.5}, {0.25, 0.75, 0}};
  std::vector<std::size_t> begin{0};
  for (int i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j)
      if (factors[i][j] > 0) entries.push_back({j, {factors[i][j] * scale, 0}, 1});
    begin.push_back(entries.size());
  }
  matrix.assign(begin, entries);
  return matrix;
}

TEST(EstimatedMatrices, AreSolvedAsTheyAre) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  // (I - F/2) B = 1 by hand, over the rationals.
  const Rational a(1, 4), b(1, 8), c(3, 16), d(1, 4), e(1, 8), f(3, 8);
  const Rational determinant = 1 - d * f - a * (c + d * e) - b * (c * f + e);
  const Rational exact = ((1 - d * f) + a * (1 + d) + b * (f + 1)) / determinant;
  for (const Solver solver : {Solver::kAuto, Solver::kLu, Solver::kBicgstab, Solver::kJacobi, Solver::kGaussSeidel}) {
    const RadiositySolution solution = solve_radiosity(foreign(1), materials, {}, {solver, {}, {}, {}});
    const ElementRadiosity& first = solution.channels[0].elements[0];
    EXPECT_LE(Rational(first.lower), exact) << to_string(solver);
    EXPECT_GE(Rational(first.upper), exact) << to_string(solver);
    EXPECT_NEAR(first.radiosity, to_double(exact), 1e-11);
    EXPECT_GT(solution.reciprocity_defect, 0.01);
    EXPECT_EQ(solution.closure_defect, 0.25);
    EXPECT_EQ(solution.guarantee, Guarantee::kEstimated);
  }
}

TEST(EstimatedMatrices, WithASpectralRadiusOfOneOrMoreAreRefused) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  EXPECT_NO_THROW(solve_radiosity(foreign(2), materials, {}));  // rows sum to more than 1, rho F does not
  EXPECT_THROW(solve_radiosity(foreign(2.5), materials, {}), RequestError);
  EXPECT_THROW(solve_radiosity(foreign(2.5), materials, {}, {Solver::kJacobi, {}, {}, {}}), RequestError);
}

TEST(EstimatedMatrices, AreNotSymmetrisedInSilence) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  EXPECT_THROW(solve_radiosity(foreign(1), materials, {}, {Solver::kCholesky, {}, {}, {}}), RequestError);
  EXPECT_THROW(solve_radiosity(foreign(1), materials, {}, {Solver::kCg, {}, {}, {}}), RequestError);
}

TEST(EstimatedMatrices, WithFactorsThatAreNoneAreRefused) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  EXPECT_THROW(solve_radiosity(foreign(NAN), materials, {}), RequestError);
  EXPECT_THROW(solve_radiosity(foreign(INFINITY), materials, {}), RequestError);
}

TEST(EstimatedMatrices, WithNegativeFactorsAreSolvedAndNothingIsProven) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  for (const Solver solver : {Solver::kLu, Solver::kBicgstab, Solver::kJacobi}) {
    const RadiositySolution solution = solve_radiosity(foreign(-1), materials, {}, {solver, {}, {}, {}});
    const auto& elements = solution.channels[0].elements;
    const double factors[3][3] = {{0, 0.5, 0.25}, {0.375, 0, 0.5}, {0.25, 0.75, 0}};
    for (int i = 0; i < 3; ++i) {
      double irradiance = 0;
      for (int j = 0; j < 3; ++j) irradiance -= factors[i][j] * elements[j].radiosity;
      EXPECT_NEAR(elements[i].radiosity, 1 + irradiance / 2, 1e-11) << to_string(solver);
      EXPECT_EQ(elements[i].lower, -INFINITY);
      EXPECT_EQ(elements[i].upper, INFINITY);
    }
    for (const NetFlux& flux : net_flux(foreign(-1), solution, {}, [](const Element& e) { return e.name; })) {
      EXPECT_EQ(flux.by_channel[0].lower, -INFINITY);
      EXPECT_EQ(flux.by_channel[0].upper, INFINITY);
      EXPECT_TRUE(std::isfinite(flux.by_channel[0].value));
    }
  }
}

TEST(EstimatedMatrices, MayHoldZeros) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  for (const Solver solver : {Solver::kLu, Solver::kBicgstab, Solver::kJacobi, Solver::kShooting}) {
    const RadiositySolution solution = solve_radiosity(foreign(0), materials, {}, {solver, {}, {}, {}});
    EXPECT_EQ(solution.components, 3u);
    for (const ElementRadiosity& e : solution.channels[0].elements) EXPECT_NEAR(e.radiosity, 1, 1e-15);
  }
}

TEST(ExactMatrices, WithRowsThatDoNotSumToOneAreRefusedByName) {
  const std::vector<Material> materials{{"m", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)}};
  for (const double gap : {0.0, 1e-12, -1e-12, 0.25}) {
    ExchangeMatrix matrix(foreign(1).elements(), Guarantee::kExact);
    matrix.assign({0, 2, 3, 4}, {{1, {0.5, 0}, 1}, {2, {0.5, 0}, 1}, {0, {1, 0}, 1}, {0, {1 - gap, 0}, 1}});
    if (gap == 0)
      EXPECT_NO_THROW(solve_radiosity(matrix, materials, {}));
    else
      EXPECT_THAT([&] { solve_radiosity(matrix, materials, {}); },
                  ::testing::ThrowsMessage<ContractViolation>(::testing::HasSubstr("exact factors of 'f2'")));
  }
}

TEST(Solvers, HaveNamesThatReadBack) {
  for (const char* name : {"auto", "cholesky", "cg", "lu", "bicgstab", "jacobi", "gauss-seidel", "shooting"})
    EXPECT_STREQ(to_string(solver_named(name).value()), name);
  EXPECT_FALSE(solver_named("gauss"));
}

}  // namespace
}  // namespace hottel::radiosity_bounds_test

// Faces of given net flux, of both signs, against solutions to a hundred digits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"
#include "solver/radiosity/signed_radiosity.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::given_flux_test {
namespace {

using namespace testing_radiosity;

constexpr std::uint64_t kScenes = 300;

// A random scene in which every other material but the taker has a given net flux, from -8 to 8.
Scene2 scene_with_fluxes(std::uint64_t seed) {
  Scene2 scene = random_scene(seed);
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    if (scene.materials[m].name != "taker" && (m + seed) % 2 == 0)
      set_given_flux(Rational(1 + m % 4, 4), Rational(static_cast<long>((5 * seed + 7 * m) % 17) - 8),
                     scene.materials[m]);
  return scene;
}

bool has_flux_below_zero(const Scene2& scene) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                     [&](const Surface& surface) { return scene.materials[surface.material].emission.value[0] < 0; });
}

TEST(GivenFlux, BoundsOfSourcesOfBothSignsHoldOnRandomScenes) {
  BoundsCheck check;
  std::size_t signed_scenes = 0, without_solution = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const ExactScene scene(scene_with_fluxes(seed));
    try {
      check.add(scene, scene.solve(), scene.scene().materials);
      signed_scenes += has_flux_below_zero(scene.scene());
    } catch (const RequestError&) {
      ++without_solution;  // a room that loses nothing
    }
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_GT(signed_scenes, kScenes / 4);
  EXPECT_LT(without_solution, kScenes / 4);
  fmt::print("{} radiosities, {} misses, {} scenes in which heat is taken, {} without a solution\n", check.checked,
             check.misses, signed_scenes, without_solution);
}

TEST(GivenFlux, NetFluxIsTheOneThatIsGivenAndHoldsForEverySolver) {
  for (const Solver solver : {Solver::kCholesky, Solver::kCg, Solver::kLu, Solver::kBicgstab, Solver::kJacobi,
                              Solver::kGaussSeidel, Solver::kShooting})
    for (const long flux : {-3, 0, 5}) {
      Scene2 polygon = convex_polygon(7);
      polygon.materials[1].reflectivity = Spectrum::scalar(Rational(1, 2));
      polygon.materials.push_back({"given", {}, {}});
      set_given_flux(Rational(1, 3), Rational(flux), polygon.materials.back());
      polygon.surfaces[3].material = 2;
      const ExactScene scene(std::move(polygon));
      const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
      BoundsCheck check;
      check.add(scene, solution, scene.scene().materials);
      EXPECT_EQ(check.misses, 0u) << to_string(solver) << " " << check.first_miss;
      for (std::uint32_t i = 0; i < scene.matrix().size(); ++i)
        if (const Element& element = scene.matrix().elements()[i]; element.material == 2u) {
          const ElementRadiosity& e = solution.channels[0].elements[i];
          EXPECT_LE(e.net_lower, static_cast<double>(flux)) << to_string(solver);
          EXPECT_GE(e.net_upper, static_cast<double>(flux)) << to_string(solver);
          EXPECT_NEAR(e.net(), static_cast<double>(flux), 1e-9) << to_string(solver);
        }
      const EnergyBalance& energy = solution.energy;
      EXPECT_NEAR(energy.emitted - energy.absorbed - energy.to_sky, energy.defect, 1e-6 * energy.emitted);
    }
}

// Properties (1) and (2) of difference_of: what is subtracted is doubles, so the bounds are of their difference.
TEST(SignedRadiosity, BoundsAreOutsideTheDifferencesOfBounds) {
  const ExactScene scene(convex_polygon(5));
  RadiositySolution all = scene.solve();
  for (ElementRadiosity& e : all.channels[0].elements) e.lower = 0.1, e.radiosity = 0.2, e.upper = 0.3;
  RadiositySolution part = all;
  for (ElementRadiosity& e : part.channels[0].elements) e.lower = 1e-20, e.radiosity = 0.05, e.upper = 0.25;
  const RadiositySolution left = difference_of(scene.matrix(), all, part);
  for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
    if (!scene.matrix().has_row(i)) continue;
    const ElementRadiosity& e = left.channels[0].elements[i];
    EXPECT_LE(Rational(e.lower), Rational(0.1) - Rational(0.25));
    EXPECT_GE(Rational(e.upper), Rational(0.3) - Rational(1e-20));
    EXPECT_TRUE(e.lower <= e.radiosity && e.radiosity <= e.upper);
    EXPECT_LE(e.upper - e.lower, 0.451);
  }
}

// sigma T⁴ = B + (1 - e) q / e, and the bound 0 of T where those of sigma T⁴ hold 0.
TEST(GivenFlux, TemperatureIsOfTheRadiosityAndWhatTheSurfaceResists) {
  Material given;
  set_given_flux(Rational(1, 4), 100, given);
  EXPECT_EQ(given.power_above_radiosity(), 300);
  EXPECT_EQ(given.surface_reflectivity(), Spectrum::scalar(Rational(3, 4)));
  const ElementTemperatures temperatures({given});
  const auto at = temperatures.of(0, {.radiosity = 159, .lower = 158, .upper = 160});
  const auto power_of = [](double t) { return black_emission(Spectrum::scalar(Rational(t))).value[0]; };
  EXPECT_LE(power_of(at->lower), 458);
  EXPECT_GE(power_of(at->upper), 460);
  EXPECT_GT(power_of(std::nextafter(at->lower, HUGE_VAL)), 458);
  set_given_flux(Rational(1, 4), -100, given);
  const ElementTemperatures cold({given});
  EXPECT_EQ(cold.of(0, {.radiosity = 300, .lower = 299, .upper = 301})->lower, 0);
  EXPECT_EQ(cold.of(0, {.radiosity = 299.5, .lower = 299, .upper = 301})->value, 0);
  EXPECT_FALSE(cold.of(0, {.radiosity = 200, .lower = 199, .upper = 201}));
}

}  // namespace
}  // namespace hottel::given_flux_test

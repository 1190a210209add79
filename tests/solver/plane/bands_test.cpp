// Two bands against solutions to a hundred digits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::bands_solver_test {
namespace {

using namespace testing_radiosity;

constexpr std::uint64_t kScenes = 200;

// A random scene in two bands: some materials keep what they gain, with fluxes from -3 to 3 or none.
Scene2 scene_in_bands(std::uint64_t seed) {
  Scene2 scene = random_scene(seed);
  scene.has_bands = true;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    Material& material = scene.materials[m];
    if (material.name != "taker" && (m + seed) % 2 == 0)
      set_given_flux(Rational(1 + m % 4, 4), Rational(static_cast<long>((5 * seed + 7 * m) % 7) - 3), material);
    set_bands(Rational((seed + 2 * m) % 5, 5), Rational((3 * seed + m) % 4, 3), material);
  }
  scene.sky_emission = in_bands(Rational(seed % 3), scene.sky_emission.value[0]);
  return scene;
}

struct Number {
  mpf_class radiosity, net;
};

// By element: B = E + rho F B, and B - H, with emissions by element.
std::vector<Number> solved(const ExactScene& scene, const std::vector<mpf_class>& emission, std::size_t band) {
  const std::size_t n = scene.matrix().size();
  std::vector<std::vector<mpf_class>> a(n, std::vector<mpf_class>(n + 1, mpf_class(0, kBits)));
  const mpf_class sky = number(scene.scene().sky_emission.value[band]);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (scene.matrix().has_row(i)) {
      const Material& material = scene.scene().materials[*scene.matrix().elements()[i].material];
      const mpf_class rho = number(material.reflectivity.value[band]);
      for (std::size_t j = 0; j < n; ++j) a[i][j] = -rho * scene.factors()[i][j];
      a[i][n] = emission[i] + rho * scene.factors()[i][n] * sky;
    }
    a[i][i] += 1;
  }
  std::vector<Number> result;
  for (const auto& row : solve_dense(std::move(a))) result.push_back({row.front(), mpf_class(0, kBits)});
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!scene.matrix().has_row(i)) continue;
    mpf_class irradiance = scene.factors()[i][n] * sky;
    for (std::size_t j = 0; j < n; ++j) irradiance += scene.factors()[i][j] * result[j].radiosity;
    result[i].net = result[i].radiosity - irradiance;
  }
  return result;
}

TEST(TwoBands, BoundsHoldOnRandomScenesOfBothBandsTogether) {
  std::size_t checked = 0, misses = 0, gains = 0, without_solution = 0;
  double widest = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const ExactScene scene(scene_in_bands(seed));
    const std::vector<Material>& materials = scene.scene().materials;
    RadiositySolution solution;
    try {
      solution = scene.solve();
    } catch (const RequestError&) {
      ++without_solution;
      continue;
    }
    ASSERT_EQ(solution.channel_names, (std::vector<std::string>{"solar", "thermal"}));
    const std::size_t n = scene.matrix().size();
    std::vector<mpf_class> emission(n, mpf_class(0, kBits));
    const auto material_of = [&](std::uint32_t i) { return materials[*scene.matrix().elements()[i].material]; };
    for (std::uint32_t i = 0; i < n; ++i)
      if (scene.matrix().has_row(i)) emission[i] = number(material_of(i).emission.value[kSolarBand]);
    const std::vector<Number> solar = solved(scene, emission, kSolarBand);
    for (std::uint32_t i = 0; i < n; ++i)
      if (scene.matrix().has_row(i)) {
        emission[i] = number(material_of(i).emission.value[kThermalBand]);
        if (!material_of(i).keeps_gains()) continue;
        emission[i] -= solar[i].net;
        gains += abs(solar[i].net) > 1e-60;
      }
    const std::vector<Number> thermal = solved(scene, emission, kThermalBand);
    for (std::uint32_t i = 0; i < n; ++i) {
      if (!scene.matrix().has_row(i)) continue;
      for (const auto& [exact, band] : {std::pair(&solar[i], kSolarBand), {&thermal[i], kThermalBand}}) {
        const ElementRadiosity& e = solution.channels[band].elements[i];
        const mpf_class slack = (abs(exact->radiosity) + 1) * 1e-75;
        const bool holds = e.lower <= exact->radiosity + slack && e.upper >= exact->radiosity - slack &&
                           e.net_lower <= exact->net + slack && e.net_upper >= exact->net - slack &&
                           e.lower <= e.radiosity && e.radiosity <= e.upper;
        ++checked;
        misses += !holds;
        if (e.radiosity > 1e-3) widest = std::max(widest, (e.upper - e.lower) / e.radiosity);
      }
      const Material& material = material_of(i);
      if (!material.keeps_gains()) continue;
      const mpf_class e = number(*material.emissivity);
      const mpf_class power =
          thermal[i].radiosity + (1 - e) / e * (number(material.thermal(material.emission)) - solar[i].net);
      const BlackPower found =
          black_power(material.power_above_radiosity(), solution.channels[kThermalBand].elements[i],
                      material.resistance(), solar_of(solution, i));
      const mpf_class slack = (abs(power) + 1) * 1e-75;
      misses += !(found.bounds.lower <= power + slack && found.bounds.upper >= power - slack);
    }
  }
  EXPECT_EQ(misses, 0u);
  EXPECT_GT(gains, kScenes);
  EXPECT_LT(without_solution, kScenes / 2);
  fmt::print("{} radiosities, {} misses, {} gains, {} scenes without a solution, widest {:.2g}\n", checked, misses,
             gains, without_solution, widest);
}

}  // namespace
}  // namespace hottel::bands_solver_test

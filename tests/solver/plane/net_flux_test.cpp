// Net fluxes: the numbered properties of net_flux, against radiosities to a hundred digits.
#include "solver/radiosity/net_flux.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::net_flux_test {
namespace {

using namespace testing_radiosity;

std::string element_name(const Element& element) { return element.name; }
std::string surface_name(const Element& element) {
  return std::to_string(element.surface) + (element.is_back ? ":back" : "");
}

std::vector<NetFlux> flux_of(const ExactScene& scene,
                             const std::function<std::string(const Element&)>& name_of = element_name) {
  return net_flux(scene.matrix(), scene.solve(), scene.scene().sky_emission, name_of);
}

// By name; a row loses A_i (B_i - H_i), what it sends to the sky and to black backs arrives there.
std::map<std::string, mpf_class> exact_flux(const ExactScene& scene,
                                            const std::function<std::string(const Element&)>& name_of) {
  const ExchangeMatrix& matrix = scene.matrix();
  std::vector<mpf_class> radiosity = scene.radiosity(scene.scene().materials, scene.scene().sky_emission, 0);
  radiosity.push_back(number(scene.scene().sky_emission.value[0]));
  std::map<std::string, mpf_class> flux;
  const auto add = [&](const std::string& name, const mpf_class& power) {
    flux.try_emplace(name, mpf_class(0, kBits)).first->second += power;
  };
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
      const mpf_class power = scene.areas()[i] * scene.factors()[i][j] * (radiosity[i] - radiosity[j]);
      add(name_of(matrix.elements()[i]), power);
      if (j == matrix.sky())
        add("sky", -power);
      else if (!matrix.has_row(j))
        add(name_of(matrix.elements()[j]), -power);
    }
  }
  return flux;
}

ExactScene random_exact_scene(std::uint64_t seed) {
  return ExactScene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
}

TEST(NetFlux, LiesWithinItsBoundsByElementAndByFace) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    for (const auto& name_of : {element_name, surface_name}) {
      const auto exact = exact_flux(scene, name_of);
      mpf_class largest(0, kBits);
      for (const auto& [name, flux] : exact) largest = std::max<mpf_class>(largest, abs(flux));
      for (const NetFlux& flux : flux_of(scene, name_of)) {
        const NetFlux::Power& power = flux.by_channel.at(0);
        const mpf_class& expected = exact.at(flux.name);
        const mpf_class slack = largest * 1e-75;  // what the reference itself may be off by
        EXPECT_LE(mpf_class(power.lower, kBits), expected + slack) << seed << " " << flux.name;
        EXPECT_GE(mpf_class(power.upper, kBits), expected - slack) << seed << " " << flux.name;
        EXPECT_LE(power.lower, power.value);
        EXPECT_GE(power.upper, power.value);
      }
    }
  }
}

TEST(NetFlux, OfAllSumsToZero) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    double lower = 0, upper = 0, sum = 0, size = 0;
    for (const NetFlux& flux : flux_of(scene)) {
      lower += flux.by_channel.at(0).lower;
      upper += flux.by_channel.at(0).upper;
      sum += flux.by_channel.at(0).value;
      size += std::abs(flux.by_channel.at(0).value);
    }
    const double rounding = 1e-16 * size;  // of these sums
    EXPECT_LE(lower, rounding) << seed;
    EXPECT_GE(upper, -rounding) << seed;
    EXPECT_LE(std::abs(sum), 1e-14 * size) << seed;
  }
}

// A lamp that stands over a floor, its black back to the east, under an open sky that shines too.
constexpr const char* kOpen = R"({"hottel": 1, "dimension": 2,
  "materials": {"lamp": {"emission": 9, "reflectivity": 0.1}, "floor": {"reflectivity": [0.5, 0.25, 0.5]}},
  "sky": {"emission": 1},
  "edges": [{"name": "lamp", "points": [[1,2],[1,1]], "material": "lamp"},
            {"name": "floor", "points": [[4,0],[0,0]], "material": "floor", "elements": 4}]})";

TEST(NetFlux, IsPositiveWhereMoreLeavesThanArrives) {
  const ExactScene scene(scene_of(kOpen), Divided2::kYes);
  const RadiositySolution solution = scene.solve();
  const std::vector<NetFlux> flux =
      net_flux(scene.matrix(), solution, scene.scene().sky_emission,
               [&](const Element& e) { return scene.scene().surfaces[e.surface].name + (e.is_back ? ":back" : ""); });
  ASSERT_EQ(flux.size(), 4u);
  EXPECT_EQ(flux[0].name, "lamp");
  EXPECT_EQ(flux[1].name, "lamp:back");
  EXPECT_EQ(flux[2].name, "floor");
  EXPECT_EQ(flux[3].name, "sky");
  EXPECT_EQ(flux[2].area, 4);
  EXPECT_FALSE(flux[3].area.has_value());
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(flux[0].by_channel[c].lower, 0);
    EXPECT_LT(flux[1].by_channel[c].upper, 0);  // black: it takes what the floor sends there
    EXPECT_LT(flux[2].by_channel[c].upper, 0);
    // The energy balance says the same: what the sky sends in less what it takes.
    const ChannelSolution& channel = solution.channels[c];
    double emitted = 0;
    for (std::uint32_t i = 0; i < scene.matrix().size(); ++i)
      emitted += scene.matrix().elements()[i].area.value * channel.elements[i].emission;
    EXPECT_NEAR(flux[3].by_channel[c].value, channel.energy.emitted - emitted - channel.energy.to_sky, 1e-14);
    EXPECT_NEAR(flux[0].by_channel[c].value, solution.channels[c].elements[0].net(), 1e-14);
  }
}

TEST(NetFlux, OfAFurnaceIsZeroAndOfTheDarkExactlySo) {
  for (const NetFlux& flux : flux_of(ExactScene(analytic_scene("furnace")))) {
    EXPECT_NEAR(flux.by_channel[0].value, 0, 1e-16 * *flux.area);
    EXPECT_LE(flux.by_channel[0].lower, 0);
    EXPECT_GE(flux.by_channel[0].upper, 0);
  }
  Scene2 dark = analytic_scene("furnace");
  for (Material& material : dark.materials) material.emission = {};
  for (const NetFlux& flux : flux_of(ExactScene(dark))) {
    EXPECT_EQ(flux.by_channel[0].lower, 0);
    EXPECT_EQ(flux.by_channel[0].upper, 0);
  }
}

TEST(NetFlux, BeyondTheRangeOfDoublesHasOpenBounds) {
  Scene2 scene = analytic_scene("square_radiosity");
  for (Material& m : scene.materials)
    if (!m.emission.is_zero()) m.emission = Spectrum::scalar(parse_rational("1e400").value());
  for (const NetFlux& flux : flux_of(ExactScene(scene))) {
    EXPECT_FALSE(std::isnan(flux.by_channel[0].lower));
    EXPECT_FALSE(std::isnan(flux.by_channel[0].upper));
    EXPECT_TRUE(flux.by_channel[0].lower == -HUGE_VAL || flux.by_channel[0].upper == HUGE_VAL) << flux.name;
  }
}

}  // namespace
}  // namespace hottel::net_flux_test

// Temperatures with proven bounds, and scenes of heat made in code.
#include "io/results/temperature_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "geometry/plane/scene/scene_builder.h"
#include "io/scene/scene_json.h"
#include "kernel/doubles.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel::temperature_files_test {
namespace {

Rational power_of(double temperature) {
  const Rational t(temperature);
  return black_emission(Spectrum::scalar(1)).value[0] * t * t * t * t;
}

// Properties (1) and (2) of black_temperature.
TEST(BlackTemperature, BoundsAreTheNearestDoublesThatHold) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> decades(-300, 300);
  for (int k = 0; k < 300; ++k) {
    const double power = std::pow(10, decades(random)), above = std::nextafter(power * (1 + 1e-14), kInfinity);
    const BoundedTemperature t = black_temperature(power, {power, above});
    EXPECT_LE(power_of(t.lower), Rational(power));
    EXPECT_GT(power_of(std::nextafter(t.lower, kInfinity)), Rational(power));
    EXPECT_GE(power_of(t.upper), Rational(above));
    EXPECT_LT(power_of(std::nextafter(t.upper, 0)), Rational(above));
    EXPECT_TRUE(t.lower <= t.value && t.value <= t.upper);
  }
  for (const double least : {5e-324, 1e-320, 1e-316, 1e-308}) {
    const BoundedTemperature t = black_temperature(least, {least, least});
    EXPECT_LE(power_of(t.lower), Rational(least));
    EXPECT_GE(power_of(t.upper), Rational(least));
    EXPECT_LE(t.upper, std::nextafter(t.lower, kInfinity));
  }
  const BoundedTemperature none = black_temperature(0, {0, 0});
  EXPECT_TRUE(none.lower == 0 && none.value == 0 && none.upper == 0);
  EXPECT_EQ(black_temperature(1, {0, kInfinity}).upper, kInfinity);
}

TEST(ElementTemperatures, AreTypedOrThoseOfWhatIsSentBack) {
  Material hot, third, wool, lamp;
  set_gray_body(Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(400), hot);
  set_gray_body(Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(Rational(1000, 3)), third);
  set_insulated(wool);
  lamp.emission = Spectrum::scalar(10);
  const ElementTemperatures temperatures({hot, third, wool, lamp, Material()});
  const ElementRadiosity sent{.radiosity = 459, .lower = 458, .upper = 460};
  const auto at = [&](std::uint32_t m) { return temperatures.of(m, sent); };
  EXPECT_TRUE(at(0)->lower == 400 && at(0)->value == 400 && at(0)->upper == 400);
  EXPECT_LT(at(1)->lower, at(1)->upper);
  EXPECT_LE(Rational(at(1)->lower), Rational(1000, 3));
  EXPECT_GE(Rational(at(1)->upper), Rational(1000, 3));
  EXPECT_LE(power_of(at(2)->lower), 458);
  EXPECT_GE(power_of(at(2)->upper), 460);
  EXPECT_FALSE(at(3));
  EXPECT_EQ(at(4)->value, 0);
  EXPECT_TRUE(temperatures.is_known(0) && temperatures.is_known(2));
  EXPECT_FALSE(temperatures.is_known(3) || temperatures.is_known(4));
}

TEST(SceneBuilder, MakesScenesOfHeatAsFilesDo) {
  SceneBuilder2 builder;
  builder.add_material("wool", {.insulated = true})
      .add_edge("floor", {0, 0}, {1, 0}, "wool")
      .set_sky_temperature(270.5)
      .set_unit("mm");
  const Scene2 made = builder.build();
  const Scene2 read = parse_scene_2(R"({"hottel": 1, "dimension": 2, "unit": "mm", "sky": {"temperature": 270.5},
    "materials": {"wool": {"insulated": true}},
    "edges": [{"name": "floor", "points": [[0, 0], [1, 0]], "material": "wool"}]})",
                                    "read");
  EXPECT_EQ(write_scene_2(made), write_scene_2(read));
  EXPECT_TRUE(has_temperatures(made));
  EXPECT_THROW(builder.add_material("both", {.emission = 1, .insulated = true}), InputError);
  EXPECT_THROW(builder.set_unit(""), InputError);
}

TEST(SceneBuilder, GivesFacesNetFluxesAsFilesDo) {
  SceneBuilder2 builder;
  builder.add_material("panel", {.emissivity = "3/4", .flux = -2.5}).add_edge("floor", {0, 0}, {1, 0}, "panel");
  const Scene2 made = builder.build();
  const Scene2 read = parse_scene_2(R"({"hottel": 1, "dimension": 2,
    "materials": {"panel": {"emissivity": "3/4", "flux": -2.5}},
    "edges": [{"name": "floor", "points": [[0, 0], [1, 0]], "material": "panel"}]})",
                                    "read");
  EXPECT_EQ(write_scene_2(made), write_scene_2(read));
  EXPECT_TRUE(has_temperatures(made));
  EXPECT_THROW(builder.add_material("cold", {.flux = 1}), InputError);
  EXPECT_THROW(builder.add_material("none", {.emissivity = 0, .flux = 1}), InputError);
  EXPECT_THROW(builder.add_material("both", {.emissivity = 1, .temperature = 3, .flux = 1}), InputError);
}

}  // namespace
}  // namespace hottel::temperature_files_test

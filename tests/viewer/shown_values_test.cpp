// What pictures show of a solution: radiosities, temperatures, view factors, and what is refused.
#include "viewer/picture/shown_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geometry/near_names.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/colour_map.h"

namespace hottel::shown_values_test {
namespace {

using testing::HasSubstr;

TEST(BlackTemperature, IsTheFourthRoot) {
  EXPECT_NEAR(black_temperature(5.670374419e-8 * 81 * 1e8), 300, 1e-12);
  EXPECT_EQ(black_temperature(0), 0);
}

TEST(Shown, IsNamedByItsWord) {
  EXPECT_TRUE(shown_by("light").is_light());
  EXPECT_EQ(shown_by("net").quantity, Quantity::kNet);
  EXPECT_EQ(shown_by("sky"), (Shown{Quantity::kFactor, "sky", std::nullopt}));
  EXPECT_EQ(shown_by("factor:wall:back"), (Shown{Quantity::kFactor, "wall:back", std::nullopt}));
  for (const char* word : {"heat", "factor", "factor:", "Net", ""}) {
    try {
      shown_by(word);
      ADD_FAILURE() << word;
    } catch (const UnknownName& error) {
      EXPECT_THAT(error.what(), HasSubstr("light, radiosity, irradiance, net, temperature, sky, or factor:NAME"));
    }
  }
}

// Two plates of side 1 at distance 1 before a sky, one of them hot; the other reradiates.
constexpr const char* kPlates = R"({"hottel": 1, "dimension": 3, "sky": {"emission": 3}, "materials": {
  "hot": {"emissivity": 0.5, "temperature": 400}, "adiabatic": {"reflectivity": 1}}, "polygons": [
  {"name": "low", "group": "plates", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "hot", "back": "hot"},
  {"name": "high", "group": "plates", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "adiabatic"}]})";

struct Solved {
  Simulation3 simulation;
  explicit Solved(const std::string& text) : simulation(parse_scene_3(text, "plates.json")) {}

  ShownValues shown(const Shown& what) const {
    require_shown(what, simulation.scene());
    return shown_values(what, simulation.scene(), simulation.factors()->matrix, *simulation.radiosities());
  }
  const ElementRadiosity& element(std::uint32_t i, std::size_t channel = 0) const {
    return simulation.radiosities()->channels[channel].elements[i];
  }
};

// Elements: low, low:back, high, high:back; the last one is black.
TEST(ShownValues, AreTheDoublesOfTheTables) {
  const Solved solved(kPlates);
  const ShownValues radiosity = solved.shown({Quantity::kRadiosity});
  const ShownValues irradiance = solved.shown({Quantity::kIrradiance}), net = solved.shown({Quantity::kNet});
  ASSERT_EQ(radiosity.elements.size(), 4u);
  for (const std::uint32_t i : {0u, 1u, 2u}) {
    EXPECT_EQ(radiosity.elements[i], solved.element(i).radiosity);
    EXPECT_EQ(irradiance.elements[i], solved.element(i).irradiance);
    EXPECT_EQ(net.elements[i], solved.element(i).radiosity - solved.element(i).irradiance);
  }
  EXPECT_EQ(radiosity.elements[3], std::nullopt);
  EXPECT_EQ(net.least, std::min({*net.elements[0], *net.elements[1], *net.elements[2]}));
  EXPECT_EQ(net.greatest, std::max({*net.elements[0], *net.elements[1], *net.elements[2]}));
  EXPECT_EQ(net.areas, (std::vector<double>{1, 1, 1, 0}));
  EXPECT_EQ(net.unit, "W/m²");
  EXPECT_THAT(net.title, HasSubstr("net flux [W/m²]: "));
}

TEST(ShownValues, FactorsGoToTheSkyAFaceOrAGroup) {
  const Solved solved(kPlates);
  // Opposite squares at the distance of their side.
  const double opposite =
      (std::log(4.0 / 3) + 4 * std::numbers::sqrt2 * std::atan(1 / std::numbers::sqrt2) - std::numbers::pi) /
      std::numbers::pi;
  const ShownValues sky = solved.shown(shown_by("sky"));
  EXPECT_NEAR(*sky.elements[0], 1 - opposite, 1e-12);
  EXPECT_EQ(sky.elements[1], 1);
  EXPECT_EQ(sky.unit, "1");
  EXPECT_EQ(sky.scale.upper, 1);
  EXPECT_EQ(*sky.elements[0], solved.simulation.factors()->matrix.factor("low", "sky").value);
  const ShownValues high = solved.shown(shown_by("factor:high"));
  EXPECT_NEAR(*high.elements[0], opposite, 1e-12);
  EXPECT_EQ(high.elements[2], 0);
  EXPECT_EQ(solved.shown(shown_by("factor:plates")).elements[0], high.elements[0]);
  EXPECT_EQ(solved.shown(shown_by("factor:hi*")).elements[0], high.elements[0]);
  EXPECT_EQ(solved.shown(shown_by("factor:?ig[h]")).elements[0], high.elements[0]);
  EXPECT_EQ(solved.shown(shown_by("factor:*ig*:back")).elements[0], 0);
  EXPECT_THROW(solved.shown(shown_by("factor:?gih")), UnknownName);
  EXPECT_EQ(solved.shown(shown_by("factor:high:back")).elements[0], 0);
  EXPECT_THROW(solved.shown(shown_by("factor:hihg")), UnknownName);
  EXPECT_THROW(solved.shown(shown_by("factor:hihg:back")), UnknownName);
}

TEST(ShownValues, ATemperatureIsThatOfTheMaterialOrOfWhatIsSentBack) {
  const Solved solved(kPlates);
  const ShownValues shown = solved.shown({Quantity::kTemperature});
  EXPECT_EQ(shown.elements[0], 400);
  EXPECT_EQ(shown.elements[1], 400);
  const double radiosity = solved.element(2).radiosity;
  EXPECT_NEAR(5.670374419e-8 * std::pow(*shown.elements[2], 4), radiosity, 1e-12 * radiosity);
  EXPECT_EQ(shown.unit, "K");
  EXPECT_EQ(shown.scale.upper, 400);
}

TEST(ShownValues, FacesWithoutATemperatureHaveNoValue) {
  std::string text = kPlates;
  text.replace(text.find(R"({"reflectivity": 1})"), 19, R"({"reflectivity": 0.5, "emission": 1})");
  EXPECT_EQ(Solved(text).shown({Quantity::kTemperature}).elements[2], std::nullopt);
  // Nothing in the scene has one, but 0 K.
  text.replace(text.find("400"), 3, "0");
  try {
    Solved(text).shown({Quantity::kTemperature});
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no face of plates.json has one"));
  }
}

TEST(ShownValues, OfThreeChannelsAreTheirMeanOrOne) {
  std::string text = kPlates;
  text.replace(text.find(R"({"reflectivity": 1})"), 19, R"({"reflectivity": [1, 0.5, 0]})");
  const Solved solved(text);
  const ShownValues mean = solved.shown({Quantity::kIrradiance});
  EXPECT_DOUBLE_EQ(
      *mean.elements[0],
      (solved.element(0, 0).irradiance + solved.element(0, 1).irradiance + solved.element(0, 2).irradiance) / 3);
  EXPECT_THAT(mean.title, HasSubstr("irradiance, mean of r, g, b [W/m²]"));
  const ShownValues green = solved.shown({Quantity::kIrradiance, "", 1});
  EXPECT_EQ(green.elements[0], solved.element(0, 1).irradiance);
  EXPECT_THAT(green.title, HasSubstr("irradiance, g [W/m²]"));
  EXPECT_THROW(Solved(kPlates).shown({Quantity::kIrradiance, "", 1}), UsageError);
  EXPECT_THROW(solved.shown({Quantity::kTemperature, "", 1}), UsageError);
  EXPECT_THROW(solved.shown({Quantity::kLight, "", 1}), UsageError);
}

// A closed cube in which every face sends out 1 and half of what it receives: all radiosities are 2, but for roundings.
std::string closed_cube() {
  return R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5, "emission": 1}}, "polygons": [
    {"name": "b", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m", "elements": 3},
    {"name": "t", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "m", "elements": 3},
    {"name": "s", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "m", "elements": 3},
    {"name": "n", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "m", "elements": 3},
    {"name": "w", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "m", "elements": 3},
    {"name": "e", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "m", "elements": 3}]})";
}

TEST(ShownValues, RoundingsHaveOneColour) {
  const Simulation3 simulation(parse_scene_3(closed_cube(), "cube.json"),
                               {.factors = {.granularity = Granularity::kElement}});
  for (const Quantity quantity : {Quantity::kRadiosity, Quantity::kIrradiance, Quantity::kNet}) {
    const ShownValues shown =
        shown_values({quantity}, simulation.scene(), simulation.factors()->matrix, *simulation.radiosities());
    EXPECT_EQ(shown.scale.lower, shown.scale.upper);
    EXPECT_NEAR(shown.scale.lower, quantity == Quantity::kNet ? 0 : 2, 1e-10);
    EXPECT_THAT(shown.title, testing::EndsWith(quantity == Quantity::kNet ? "]: 0" : "]: 2"));
    const Colour one = scale_colour(shown.scale, *shown.elements[0]);
    for (const auto& value : shown.elements)
      if (value) {
        EXPECT_EQ(pixel_of(scale_colour(shown.scale, *value)), pixel_of(one));
      }
  }
}

TEST(ShownValues, TakeTheScaleAskedFor) {
  const Solved solved(kPlates);
  const ShownValues own = solved.shown({Quantity::kRadiosity});
  const auto asked = [&](const AskedScale& scale, Quantity quantity = Quantity::kRadiosity) {
    return solved.shown({.quantity = quantity, .scale = scale});
  };
  EXPECT_EQ(asked({10, 20}).scale.lower, 10);
  EXPECT_EQ(asked({10, 20}).scale.upper, 20);
  EXPECT_THAT(asked({10, 1e6}).title, testing::EndsWith("radiosity [W/m²]: 10 to 1e+06"));
  EXPECT_THAT(asked({10, 20}).title, HasSubstr("radiosity [W/m²]: 10 to 20, values to "));
  EXPECT_TRUE(asked({10, 20}).scale.cuts_upper);
  EXPECT_EQ(asked({10, 20}).least, own.least);
  EXPECT_EQ(asked({10, 20}).greatest, own.greatest);
  EXPECT_EQ(asked({10, {}}).scale.upper, own.scale.upper);
  EXPECT_EQ(asked({{}, 1e6}).scale.lower, own.scale.lower);
  EXPECT_EQ(asked({1e9, {}}).scale.lower, 1e9) << "above all values";
  EXPECT_EQ(asked({{}, 1e-9}).scale.upper, 1e-9) << "below all values";
  EXPECT_EQ(asked({10, 20}).elements, own.elements);
  const ShownValues logarithmic = asked({{}, {}, true});
  EXPECT_TRUE(logarithmic.scale.logarithmic);
  EXPECT_FALSE(logarithmic.scale.has_zero);
  EXPECT_EQ(logarithmic.scale.lower, own.scale.lower);
  const ShownValues toward = solved.shown({.quantity = Quantity::kFactor, .toward = "high", .scale = {{}, {}, true}});
  EXPECT_TRUE(toward.scale.has_zero);
  EXPECT_EQ(toward.scale.lower, *toward.elements[0]) << "the least above 0";
  const ShownValues nothing =
      solved.shown({.quantity = Quantity::kFactor, .toward = "high:back", .scale = {{}, {}, true}});
  EXPECT_EQ(nothing.scale.position(1), 0);
  EXPECT_THROW(asked({20, 10}), UsageError);
  EXPECT_THROW(asked({10, 10}), UsageError);
  EXPECT_THROW(asked({0, 10, true}), UsageError);
  EXPECT_THROW(asked({{}, -1, true}), UsageError);
  EXPECT_THROW(asked({{}, {}, true}, Quantity::kNet), UsageError);
  EXPECT_THROW(asked({10, 20}, Quantity::kLight), UsageError);
}

}  // namespace
}  // namespace hottel::shown_values_test

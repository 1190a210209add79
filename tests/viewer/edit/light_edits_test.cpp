// Lights changed by a key, or as they are typed.
#include "viewer/edit/light_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hottel::light_edits_test {
namespace {

Light spot() {
  Light light{.name = "torch", .type = LightType::kSpot, .focus = 25, .falloff = 2, .power = {}};
  light.power = Spectrum{{6, 5, 3}, false};
  return light;
}

Light bulb() {
  Light light{.name = "bulb", .power = {}};
  light.power = Spectrum::scalar(2);
  return light;
}

Light sun() {
  Light light{.name = "sun", .type = LightType::kSun, .power = {}};
  light.power = Spectrum::scalar(800);
  return light;
}

TEST(LightEdits, LeaveASunASun) {
  Light light = sun();
  for (const char* name : {"less reflectivity", "more reflectivity", "colour", "less emission", "more emission"}) {
    edit_light(light, name);
    EXPECT_TRUE(light.is_sun()) << name;
    EXPECT_EQ(light_problem(light), "") << name;
  }
  light = sun();
  std::vector<Rational> rotation{0, 0, 0};
  edit_light(light, rotation, "spin");
  EXPECT_EQ(rotation, (std::vector<Rational>{0, 0, kSpin}));
  EXPECT_EQ(light_text(light, rotation), "irradiance 800; rotation 0 0 30");
  EXPECT_EQ(read_light("irradiance 900; rotation 0 15 0", light, rotation), "");
  EXPECT_TRUE(light.is_sun());
  EXPECT_EQ(light.power.value[0], 900);
  EXPECT_EQ(rotation[1], 15);
  EXPECT_EQ(read_light("focus 20", light, rotation), "a sun: say 'irradiance' or 'rotation', not 'focus'");
  EXPECT_EQ(read_light("power 20", light, rotation), "a sun: say 'irradiance' or 'rotation', not 'power'");
  Light lamp = bulb();
  EXPECT_NE(read_light("irradiance 20", lamp, rotation), "");
}

// (1)
TEST(LightEdits, StayWithinWhatALightMayBe) {
  for (const char* name : {"less reflectivity", "more reflectivity", "less emission", "more emission", "colour"}) {
    Light light = spot();
    for (int k = 0; k < 60; ++k) {
      edit_light(light, name);
      ASSERT_EQ(light_problem(light), "") << name;
    }
  }
  Light wide = spot();
  for (int k = 0; k < 60; ++k) edit_light(wide, "more reflectivity");
  EXPECT_EQ(wide.focus, 90);
  wide.falloff = 0;
  for (int k = 0; k < 60; ++k) edit_light(wide, "more reflectivity");
  EXPECT_EQ(wide.focus, 180);
  for (int k = 0; k < 60; ++k) edit_light(wide, "less reflectivity");
  EXPECT_EQ(wide.focus, Rational(1, 10));
}

TEST(LightEdits, ChangePowerByAQuarterAndKeepItsColour) {
  Light light = bulb();
  edit_light(light, "more emission");
  EXPECT_EQ(light.power, Spectrum::scalar(Rational(5, 2)));
  for (int k = 0; k < 6; ++k) {
    edit_light(light, "colour");
    EXPECT_EQ(*std::max_element(light.power.value.begin(), light.power.value.end()), Rational(5, 2)) << k;
  }
  EXPECT_EQ(light.power, Spectrum::scalar(Rational(5, 2)));  // six paints later
}

// (2)
TEST(LightEdits, MakeASpotOfAPointLightThatIsFocused) {
  Light light = bulb();
  edit_light(light, "less reflectivity");
  EXPECT_EQ(light.type, LightType::kSpot);
  EXPECT_EQ(light.focus, 140);
}

TEST(LightEdits, SetSpotsSpinningAndStopThem) {
  for (const std::size_t axes : {1u, 3u}) {
    Light light = spot();
    std::vector<Rational> rotation(axes);
    edit_light(light, rotation, "spin");
    EXPECT_EQ(rotation.back(), kSpin);
    EXPECT_EQ(std::count(rotation.begin(), rotation.end(), Rational(0)), static_cast<std::ptrdiff_t>(axes - 1));
    rotation.front() = 7;
    edit_light(light, rotation, "spin");
    EXPECT_EQ(rotation, std::vector<Rational>(axes));
    EXPECT_EQ(light, spot());
    Light round = bulb();
    edit_light(round, rotation, "spin");
    EXPECT_EQ(rotation, std::vector<Rational>(axes));
    edit_light(light, rotation, "less reflectivity");
    EXPECT_EQ(light.focus, 20);
  }
  EXPECT_TRUE(is_light_edit("spin"));
  EXPECT_TRUE(is_light_edit("colour"));
  EXPECT_FALSE(is_light_edit("material"));
}

// (3)
TEST(LightEdits, KeepAllDigitsOfWhatIsTypedAsItIsShown) {
  Light light = spot();
  light.focus = Rational(1000000007, 33333333);
  std::vector<Rational> rotation{Rational(1, 700000001)};
  const Light before = light;
  const auto turning = rotation;
  EXPECT_EQ(read_light(light_text(light, rotation), light, rotation), "");
  EXPECT_EQ(light, before);
  EXPECT_EQ(rotation, turning);
}

// (4)
TEST(LightEdits, ReadWhatIsTyped) {
  Light light = bulb();
  std::vector<Rational> rotation(3);
  EXPECT_EQ(light_text(light, rotation), "power 2");
  EXPECT_EQ(read_light("power 1 0.5 1/4; focus 30 ; rotation 0 0 90", light, rotation), "");
  EXPECT_EQ(light.type, LightType::kSpot);
  EXPECT_EQ(light_text(light, rotation), "power 1 0.5 0.25; focus 30; falloff 0; rotation 0 0 90");
}

TEST(LightEdits, RefuseWhatCannotBeAndChangeNothing) {
  for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
           {"brightness 3", "say 'power', 'focus', 'falloff' or 'rotation', not 'brightness'"},
           {"power 2; focus 0", "focus must be greater than 0 and at most 180 degrees"},
           {"power -1", "power: it must not be negative"},
           {"focus 10 20", "focus: takes 1 number, not 2"},
           {"rotation 1 2", "rotation: takes 1 number, not 2"},
           {"falloff 2000000", "falloff must not be above 1000000"}}) {
    Light light = spot();
    std::vector<Rational> rotation{5};
    EXPECT_EQ(read_light(text, light, rotation), problem) << text;
    EXPECT_EQ(light, spot());
    EXPECT_EQ(rotation.front(), 5);
  }
}

}  // namespace
}  // namespace hottel::light_edits_test

// Elements that are asked for the shares of lights again and again.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/space/light/scene_light_shares.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::lit_elements_test {
namespace {

Scene3 stage() { return read_scene_3(HOTTEL_SOURCE_DIR "/scenes/lights/stage.json"); }

void expect_same(const std::vector<LightShares>& a, const std::vector<LightShares>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].of_element, b[k].of_element) << k;
    EXPECT_EQ(a[k].sky, b[k].sky) << k;
    EXPECT_EQ(a[k].solid, b[k].solid) << k;
  }
}

// (1), (3)
TEST(LitElements3, SharesAreThoseOfASceneWithItsLightsThere) {
  const Scene3 before = stage();
  const LitElements3 lit(std::make_shared<const PreparedScene3>(prepare(before)), Granularity::kElement);
  Scene3 moved = before;
  moved.light_places[1].position.x += Rational(1, 10);
  Scene3 added = before;
  added.add_light(moved.lights[1], moved.light_places[1]);
  Scene3 turned = before;
  turned.light_places[0].direction.x += 1;
  Scene3 focused = before;
  focused.lights[0].focus += 1;
  Scene3 erased = before;
  erased.lights.erase(erased.lights.begin());
  erased.light_places.erase(erased.light_places.begin());
  Scene3 other = before;
  std::swap(other.lights[0], other.lights[1]);
  std::swap(other.light_places[0], other.light_places[1]);
  other.lights[0].power = Spectrum::scalar(1);
  other.light_places[1].rotation = {1, 2, 3};
  for (int round = 0; round < 2; ++round)
    for (const Scene3& scene : {before, moved, added, turned, focused, erased, other})
      expect_same(lit.shares(scene), light_shares(prepare(scene), Granularity::kElement));
}

// (2), (3): more places than are known, asked for again and again, in another order.
TEST(LitElements3, ForgetsWhatItWasNotAskedForLong) {
  Scene3 scene = stage();
  const LitElements3 lit(std::make_shared<const PreparedScene3>(prepare(scene)), Granularity::kFace);
  for (const int step : {1, 7, 1}) {
    for (int k = 0; k < 90; ++k) {
      const int place = k * step % 90;
      scene.light_places[0].direction = {place - 45, 5, 30};
      scene.light_places[1].position.x = Rational(place % 20, 24);
      const auto all = lit.shares(scene);
      if (k % 10 == 0) expect_same(all, light_shares(prepare(scene), Granularity::kFace));
    }
  }
}

TEST(LitElements3, LightsShineAlikeWhateverTheirPowerAndMotion) {
  Light light;
  LightPlace3 place{{1, 2, 3}, {0, 0, 1}, {}, {}}, other = place;
  light.type = LightType::kSpot;
  light.focus = 20;
  Light strong = light;
  strong.power = Spectrum::scalar(7);
  strong.name = "strong";
  other.rotation = {1, 2, 3};
  EXPECT_TRUE(is_lit_alike_3(light, place, strong, other));
  other.direction.x = 1;
  EXPECT_FALSE(is_lit_alike_3(light, place, strong, other));
  strong.type = light.type = LightType::kPoint;
  EXPECT_TRUE(is_lit_alike_3(light, place, strong, other)) << "it shines all around";
  other.position.x += 1;
  EXPECT_FALSE(is_lit_alike_3(light, place, strong, other));
}

// Simulation3 (1) and (5): one light is moved after the other, with and without the shares of versions before.
TEST(LitElements3, LeaveASimulationAsItWouldBeAnew) {
  Scene3 scene = stage();
  const SimulationRequest3 request{.factors = {.granularity = Granularity::kElement}};
  Simulation3 simulation(scene, request);
  for (int k = 0; k < 4; ++k) {
    if (k != 2) simulation.radiosities();
    scene.light_places[k % 2].position.y += Rational(1, 8);
    simulation = simulation.with_scene(scene);
  }
  const auto elements = simulation.radiosities()->channels[0].elements;
  const auto anew = Simulation3(scene, request).radiosities()->channels[0].elements;
  ASSERT_EQ(elements.size(), anew.size());
  for (std::size_t i = 0; i < anew.size(); ++i) EXPECT_EQ(elements[i].radiosity, anew[i].radiosity) << i;
}

}  // namespace
}  // namespace hottel::lit_elements_test

// Shares of lights that are known from another scene.
#include "solver/space/light/known_shares.h"

#include <gtest/gtest.h>

#include "io/scene/scene_json.h"
#include "solver/space/light/tested_shares.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
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

TEST(KnownShares3, AreThoseOfNoneThatAreKnown) {
  const Scene3 before = stage();
  const auto of = [](const Scene3& scene) {
    return light_shares(prepare(scene), Granularity::kElement, LightTest::kExact);
  };
  const KnownShares3 known{before.lights, before.light_places,
                           std::make_shared<const std::vector<LightShares>>(of(before))};
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
  for (const Scene3& scene : {before, moved, added, turned, focused, erased})
    expect_same(light_shares(prepare(scene), Granularity::kElement, LightTest::kExact, known), of(scene));
}

TEST(KnownShares3, AreTakenWhereALightStandsAndShinesAlike) {
  const Scene3 scene = stage();
  std::vector<LightShares> marked(2);
  marked[0].solid = "first";
  marked[1].solid = "second";
  const KnownShares3 known{scene.lights, scene.light_places, std::make_shared<const std::vector<LightShares>>(marked)};
  Scene3 other = scene;
  std::swap(other.lights[0], other.lights[1]);
  std::swap(other.light_places[0], other.light_places[1]);
  other.lights[0].power = Spectrum::scalar(1);
  other.lights[1].name = "another";
  other.light_places[1].rotation = {1, 2, 3};
  const auto shares = light_shares(prepare(other), Granularity::kElement, LightTest::kExact, known);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].solid, "second");
  EXPECT_EQ(shares[1].solid, "first");
}

// Simulation3 (1) and (5): one light is moved after the other, with and without the shares of the version before.
TEST(KnownShares3, LeaveASimulationAsItWouldBeAnew) {
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
}  // namespace hottel

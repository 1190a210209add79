// Frames of lights that move in space, with a store: it has what a run forgets.
#include "solver/animation.h"

#include <gtest/gtest.h>

#include "geometry/space/scene/moving_lights.h"
#include "io/scene/scene_json.h"
#include "solver/memory_store.h"
#include "solver/space/light/refinement.h"
#include "solver/space/simulation/refined.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::stored_animation_test {
namespace {

struct Nothing {
  static std::uint64_t bytes() { return 0; }
};
using Animation3 = Animation<Simulation3, Nothing>;

constexpr RefinementLevels kLevels{.everywhere = 0, .at_borders = 1};

Scene3 stage() {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/stage.json");
  for (Surface& surface : scene.surfaces) surface.elements = 1;
  return scene;
}

SimulationRequest3 by_element(std::shared_ptr<FactorStore> store = nullptr) {
  SimulationRequest3 request;
  request.factors.granularity = Granularity::kElement;
  request.factors.tolerance = 1e-6;
  request.factors.store = std::move(store);
  return request;
}

void expect_same_frame(const Simulation3& a, const Simulation3& b) {
  EXPECT_EQ(a.scene().surfaces, b.scene().surfaces);
  const auto of_a = a.radiosities(), of_b = b.radiosities();
  ASSERT_EQ(of_a->channels.size(), of_b->channels.size());
  for (std::size_t c = 0; c < of_a->channels.size(); ++c) {
    ASSERT_EQ(of_a->channels[c].elements.size(), of_b->channels[c].elements.size());
    for (std::size_t i = 0; i < of_a->channels[c].elements.size(); ++i) {
      const ElementRadiosity &x = of_a->channels[c].elements[i], &y = of_b->channels[c].elements[i];
      EXPECT_EQ(x.radiosity, y.radiosity);
      EXPECT_EQ(x.lower, y.lower);
      EXPECT_EQ(x.upper, y.upper);
    }
  }
}

// (1), with a store in memory.
TEST(Animation3, AFrameWithAStoreIsThatOfANewSimulation) {
  const auto store = make_memory_store();
  Animation3 kept(Simulation3(stage(), by_element(store)), kLevels, 1 << 30, store);
  for (const Rational& time : {Rational(0), Rational(1, 2), Rational(0)})
    expect_same_frame(kept.at(time).simulation,
                      refined(Simulation3(scene_after(stage(), time), by_element()), kLevels));
}

// (2)
TEST(Animation3, ComputesPairsOfNewElementsOnlyAndNothingThatComesBack) {
  const auto store = make_memory_store();
  Animation3 animation(Simulation3(stage(), by_element(store)), kLevels, 1 << 30, store);
  const FrameCounts first = animation.at(0).counts, second = animation.at(Rational(1, 2)).counts;
  EXPECT_EQ(first.read, 0u);
  EXPECT_GT(first.computed, 0u);
  EXPECT_GT(second.activated, 0u) << "the beams have moved";
  EXPECT_LT(second.activated, second.elements);
  EXPECT_GT(second.read, 0u) << "pairs of elements that were there before";
  EXPECT_GT(second.computed, 0u);
  const FrameCounts back = animation.at(4).counts;
  EXPECT_EQ(back.computed, 0u);
  EXPECT_EQ(back.elements, first.elements);
}

// A store without room keeps nothing, and changes nothing.
TEST(Animation3, AStoreInMemoryGivesUpWhatItHasNoRoomFor) {
  const auto store = make_memory_store(1000);
  Animation3 animation(Simulation3(stage(), by_element(store)), kLevels, 0, store);
  const auto first = animation.at(0);
  animation.at(Rational(1, 2));
  const auto back = animation.at(4);
  EXPECT_EQ(back.counts.computed, first.counts.computed);
  EXPECT_EQ(back.counts.read, 0u);
  expect_same_frame(first.simulation, back.simulation);
}

// (2): what a run forgets, its store has.
TEST(Animation3, TakesFromTheStoreWhatTheMemoryDoesNotHold) {
  const auto store = make_memory_store();
  Animation3 animation(Simulation3(stage(), by_element(store)), kLevels, 0, store);
  const auto first = animation.at(0);
  animation.at(Rational(1, 2));
  const auto back = animation.at(4);
  EXPECT_EQ(back.counts.computed, 0u);
  EXPECT_EQ(back.counts.read, first.counts.computed);
  expect_same_frame(first.simulation, back.simulation);
}

}  // namespace
}  // namespace hottel::stored_animation_test

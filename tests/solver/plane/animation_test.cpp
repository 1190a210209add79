// Frames of lights that move in the plane: each is the scene at its time, and what comes back is not computed again.
#include "solver/animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "geometry/plane/scene/moving_lights.h"
#include "io/scene/scene_json.h"
#include "solver/plane/light/refinement.h"
#include "solver/plane/simulation/refined.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/radiosity/radiosity_solver.h"

namespace hottel::animation_test {
namespace {

struct Nothing {
  static std::uint64_t bytes() { return 0; }
};
using Animation2 = Animation<Simulation2, Nothing>;

constexpr RefinementLevels kLevels{.everywhere = 0, .at_borders = 4};

Scene2 lighthouse() {
  Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/lighthouse.json");
  scene.grids.front().nx = 12;
  scene.grids.front().ny = 8;
  return scene;
}

void expect_same_frame(const Simulation2& a, const Simulation2& b) {
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
      EXPECT_EQ(x.irradiance, y.irradiance);
    }
  }
  // Bit for bit: cells in solids have no value.
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  EXPECT_TRUE(std::ranges::equal(a.light()->grid.values, b.light()->grid.values, {}, bits, bits));
}

// (1)
TEST(Animation2, AFrameIsANewSimulationOfTheSceneAtItsTimeBitForBit) {
  Animation2 animation(Simulation2(lighthouse()), kLevels, 1 << 30, nullptr);
  for (const Rational& time : {Rational(0), Rational(1, 3), Rational(13, 4), Rational(1, 3), Rational(403, 100)}) {
    const auto frame = animation.at(time);
    expect_same_frame(frame.simulation, refined(Simulation2(scene_after(lighthouse(), time)), kLevels));
  }
}

// (2)
TEST(Animation2, WhatComesBackIsNotComputedAgain) {
  Animation2 animation(Simulation2(lighthouse()), kLevels, 1 << 30, nullptr);
  std::vector<FrameCounts> first;
  for (int k = 0; k < 8; ++k) first.push_back(animation.at(Rational(k) / 2).counts);  // once around in 4 s
  EXPECT_EQ(first[0].activated, first[0].elements);
  EXPECT_GT(first[0].computed, 0u);
  for (const FrameCounts& counts : first) EXPECT_EQ(counts.computed == 0, counts.read > 0);
  for (int k = 0; k < 16; ++k) {
    const FrameCounts again = animation.at(4 + Rational(k) / 2).counts;
    EXPECT_EQ(again.computed, 0u);
    EXPECT_EQ(again.elements, first[static_cast<std::size_t>(k % 8)].elements);
    EXPECT_GT(again.read, 0u);
  }
}

TEST(Animation2, WithoutRefinementAllFramesShareOneMatrix) {
  Animation2 animation(Simulation2(lighthouse()), {}, 1 << 30, nullptr);
  const auto first = animation.at(0);
  EXPECT_GT(first.counts.computed, 0u);
  for (int k = 1; k < 5; ++k) {
    const auto frame = animation.at(Rational(k) / 7);
    EXPECT_EQ(frame.counts.computed, 0u);
    EXPECT_EQ(frame.counts.activated, 0u);
    EXPECT_EQ(frame.simulation.factors(), first.simulation.factors());
    EXPECT_EQ(frame.simulation.system(), first.simulation.system());
    EXPECT_NE(frame.simulation.radiosities()->channels[0].elements[0].radiosity,
              first.simulation.radiosities()->channels[0].elements[0].radiosity);
  }
}

// (2): with no memory but for the last frame all is computed again, and is the same.
TEST(Animation2, GivesUpWhatTheMemoryDoesNotHold) {
  Animation2 animation(Simulation2(lighthouse()), kLevels, 0, nullptr);
  const auto first = animation.at(0);
  animation.at(Rational(1, 2));
  const auto again = animation.at(0);
  EXPECT_EQ(again.counts.computed, first.counts.computed);
  expect_same_frame(again.simulation, first.simulation);
  EXPECT_EQ(animation.at(0).counts.computed, 0u) << "the last one stays";
}

// (3)
TEST(Animation2, FramesShareTheOverlay) {
  const Simulation2 still(lighthouse());
  const Simulation2 moved = still.with_scene(scene_after(still.scene(), Rational(1, 2)));
  EXPECT_EQ(moved.prepared()->shared, still.prepared()->shared);
  const Simulation2 divided = refined(moved, kLevels);
  EXPECT_GT(divided.factors()->matrix.size(), moved.factors()->matrix.size());
  EXPECT_EQ(divided.with_scene(still.scene()).prepared()->shared, still.prepared()->shared);
}

}  // namespace
}  // namespace hottel::animation_test

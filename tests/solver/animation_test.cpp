// Frames of lights that move, in both dimensions: each is the scene at its time, and what comes back is not computed
// again.
#include "solver/animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/scene/moving_lights.h"
#include "geometry/space/scene/moving_lights.h"
#include "io/scene/scene_json.h"
#include "solver/plane/light/refinement.h"
#include "solver/plane/simulation/refined.h"
#include "solver/space/light/refinement.h"
#include "solver/space/simulation/refined.h"
#include "tests/solver/dimensions.h"

namespace hottel::animation_test {
namespace {

struct Nothing {
  static std::uint64_t bytes() { return 0; }
};

// Scenes whose lights are back after four seconds.
struct MovingPlane : PlaneTests {
  static constexpr RefinementLevels kLevels{.everywhere = 0, .at_borders = 4};
  static constexpr int kFrames = 8;  // of the four seconds

  static Simulation still() {
    Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/lighthouse.json");
    scene.grids.front().nx = 12;
    scene.grids.front().ny = 8;
    return Simulation(std::move(scene));
  }
};

struct MovingSpace : SpaceTests {
  static constexpr RefinementLevels kLevels{.everywhere = 0, .at_borders = 1};
  static constexpr int kFrames = 2;

  static Simulation still() {
    Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/stage.json");
    for (Surface& surface : scene.surfaces) surface.elements = 1;
    scene.grids = {{{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, 3, 2}};
    return Simulation(std::move(scene), {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-6}});
  }
};

template <class D>
class AnimationTest : public testing::Test {
 protected:
  using Simulation = typename D::Simulation;

  static Animation<Simulation, Nothing> animation(const RefinementLevels& levels, std::uint64_t memory) {
    return {D::still(), levels, memory, nullptr};
  }

  static void expect_same_frame(const Simulation& a, const Simulation& b) {
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
    EXPECT_TRUE(std::ranges::equal(D::values(*a.light()), D::values(*b.light()), {}, bits, bits));
  }
};

using Moving = testing::Types<MovingPlane, MovingSpace>;
struct MovingNames {
  template <class D>
  static std::string GetName(int) {
    return std::is_same_v<D, MovingPlane> ? "plane" : "space";
  }
};
TYPED_TEST_SUITE(AnimationTest, Moving, MovingNames);

// (1)
TYPED_TEST(AnimationTest, AFrameIsANewSimulationOfTheSceneAtItsTimeBitForBit) {
  auto animation = this->animation(TypeParam::kLevels, 1 << 30);
  const auto still = TypeParam::still();
  for (const Rational& time : {Rational(0), Rational(1, 3), Rational(13, 4), Rational(1, 3)}) {
    const auto frame = animation.at(time);
    this->expect_same_frame(
        frame.simulation,
        refined(typename TypeParam::Simulation(scene_after(still.scene(), time), still.request()), TypeParam::kLevels));
  }
}

// (2)
TYPED_TEST(AnimationTest, WhatComesBackIsNotComputedAgain) {
  auto animation = this->animation(TypeParam::kLevels, 1 << 30);
  const auto time = [](int frame) -> Rational { return Rational(4 * frame) / TypeParam::kFrames; };
  std::vector<FrameCounts> first;
  for (int k = 0; k < TypeParam::kFrames; ++k) first.push_back(animation.at(time(k)).counts);
  EXPECT_EQ(first[0].activated, first[0].elements);
  EXPECT_GT(first[0].computed, 0u);
  for (const FrameCounts& counts : first) EXPECT_EQ(counts.computed == 0, counts.read > 0);
  for (int k = 0; k < 2 * TypeParam::kFrames; ++k) {
    const FrameCounts again = animation.at(4 + time(k)).counts;
    EXPECT_EQ(again.computed, 0u);
    EXPECT_EQ(again.elements, first[static_cast<std::size_t>(k % TypeParam::kFrames)].elements);
    EXPECT_GT(again.read, 0u);
  }
}

TYPED_TEST(AnimationTest, WithoutRefinementAllFramesShareOneMatrix) {
  auto animation = this->animation({}, 1 << 30);
  const auto first = animation.at(0);
  EXPECT_GT(first.counts.computed, 0u);
  for (int k = 1; k < 5; ++k) {
    const auto frame = animation.at(Rational(k) / 7);
    EXPECT_EQ(frame.counts.computed, 0u);
    EXPECT_EQ(frame.counts.activated, 0u);
    EXPECT_EQ(frame.simulation.factors(), first.simulation.factors());
    EXPECT_EQ(frame.simulation.system(), first.simulation.system());
    EXPECT_NE(frame.simulation.radiosities(), first.simulation.radiosities());
  }
}

// (2): with no memory but for the last frame all is computed again, and is the same.
TYPED_TEST(AnimationTest, GivesUpWhatTheMemoryDoesNotHold) {
  auto animation = this->animation(TypeParam::kLevels, 0);
  const auto first = animation.at(0);
  animation.at(Rational(1, 2));
  const auto again = animation.at(0);
  EXPECT_EQ(again.counts.computed, first.counts.computed);
  this->expect_same_frame(again.simulation, first.simulation);
  EXPECT_EQ(animation.at(0).counts.computed, 0u) << "the last one stays";
}

// (3)
TYPED_TEST(AnimationTest, FramesShareTheArrangement) {
  const auto still = TypeParam::still();
  const auto moved = still.with_scene(scene_after(still.scene(), Rational(1, 2)));
  EXPECT_EQ(TypeParam::arrangement(*moved.prepared()), TypeParam::arrangement(*still.prepared()));
  const auto divided = refined(moved, TypeParam::kLevels);
  EXPECT_GT(divided.factors()->matrix.size(), moved.factors()->matrix.size());
  EXPECT_EQ(TypeParam::arrangement(*divided.with_scene(still.scene()).prepared()),
            TypeParam::arrangement(*still.prepared()));
}

}  // namespace
}  // namespace hottel::animation_test

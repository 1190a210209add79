// Versions of a scene in space: what is shown together is of one of them.
#include "viewer/window/space/live_version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "tests/viewer/window/space/hand.h"
#include "viewer/window/space/live_scene.h"
#include "viewer/window/space/view_mode.h"

namespace hottel::live_version_test {
namespace {

using testing_viewer::kRoom;

const StageProgress kAnyProgress = [](std::string_view, double) {};
constexpr double kPatience = 300;

// The room, each polygon divided; the material "red" may be made like "white".
std::shared_ptr<const Scene3> divided_room(std::uint32_t n, const char* reflectivity_of_red = nullptr) {
  Scene3 scene = parse_scene_3(kRoom, "room");
  divide_into(scene, n);
  if (reflectivity_of_red != nullptr)
    std::ranges::find(scene.materials, "red", &Material::name)->reflectivity =
        Spectrum::scalar(Rational(reflectivity_of_red));
  return std::make_shared<const Scene3>(std::move(scene));
}

SimulationRequest3 by_elements() { return {.factors = {.granularity = Granularity::kElement}}; }

// Everything of a version belongs together: as many of all, and the light of its scene, bit for bit.
void expect_whole(const LiveVersion3& version) {
  const std::uint32_t count = version.model().table().count();
  EXPECT_EQ(version.light().values.size(), count * version.light().channels);
  if (!version.is_lit()) return;
  ASSERT_EQ(version.factors()->matrix.size(), count);
  const auto fresh = Simulation3(version.scene(), by_elements()).radiosities();
  ASSERT_EQ(version.radiosities()->channels.size(), fresh->channels.size());
  for (std::size_t c = 0; c < fresh->channels.size(); ++c)
    for (std::uint32_t i = 0; i < count; ++i)
      EXPECT_EQ(version.radiosities()->channels[c].elements[i].radiosity, fresh->channels[c].elements[i].radiosity);
}

// Other materials are alike than before, so factors are on their way while the light of the version before is shown:
// each view mode is of that one alone.
TEST(LiveScene3Thread, AVersionStaysWholeUntilTheNextHasItsLight) {
  LiveScene3 live(by_elements(), nullptr);
  const auto before = divided_room(3), after = divided_room(3, "1/2");
  live.set(before);
  ASSERT_TRUE(live.wait(kPatience));
  const LiveVersion3::Ptr lit = live.state().version;
  ASSERT_TRUE(live.state().is_lit());
  live.set(after);
  EXPECT_EQ(live.state().version, lit);
  std::vector<LiveVersion3::Ptr> seen{lit};
  for (bool is_first = true; !live.is_at_rest(); is_first = false) {
    live.collect();
    ASSERT_TRUE(live.state().is_lit());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!is_first && live.state().version == seen.back()) continue;
    for (const ViewMode3 mode : {ViewMode3::kRadiosity, ViewMode3::kIrradiance}) {
      const ViewResult3 result = compute_view_3(live.state().version, {.mode = mode}, kAnyProgress);
      ASSERT_TRUE(result.shown);
      EXPECT_EQ(result.shown->elements.size(), result.version->model().table().count());
    }
    if (live.state().version != seen.back()) seen.push_back(live.state().version);
  }
  live.collect();
  EXPECT_EQ(live.state().version->of().scene(), after);
  EXPECT_EQ(lit->of().scene(), before);
  expect_whole(*lit);
  expect_whole(*live.state().version);
}

// Scenes of other shapes and materials, faster than their light is made.
TEST(LiveScene3Thread, WhatIsShownBelongsTogetherHoweverFastScenesFollow) {
  LiveScene3 live(by_elements(), nullptr);
  std::vector<std::shared_ptr<const Scene3>> scenes;
  for (const std::uint32_t n : {1u, 3u, 2u})
    for (const char* red : {"1/2", "1/3", "3/4"}) scenes.push_back(divided_room(n, red));
  std::vector<LiveVersion3::Ptr> shown;
  for (int k = 0; k < 60; ++k) {
    live.set(scenes[static_cast<std::size_t>(k * 7 + k / 5) % scenes.size()]);
    for (int m = 0; m < k % 8; ++m) {
      live.collect();
      if (const auto& now = live.state().version; now && (shown.empty() || shown.back() != now)) shown.push_back(now);
      std::this_thread::sleep_for(std::chrono::microseconds(1500));
    }
  }
  ASSERT_TRUE(live.wait(kPatience));
  shown.push_back(live.state().version);
  for (const LiveVersion3::Ptr& version : shown) expect_whole(*version);
}

TEST(LiveElement3, IsFoundInModelsThatHaveItsPart) {
  const auto model_of = [](std::uint32_t n) {
    return SceneVersion3(divided_room(n), by_elements(), nullptr).model(kAnyProgress);
  };
  const auto coarse = model_of(1), fine = model_of(3), again = model_of(3);
  for (std::uint32_t k = 0; k < fine->table().count(); ++k) {
    EXPECT_EQ((LiveElement3{fine, k}).number_in(*fine), k);
    EXPECT_EQ((LiveElement3{fine, k}).number_in(*again), k);
    EXPECT_EQ((LiveElement3{fine, k}).number_in(*coarse).has_value(), !fine->table().elements()[k].is_part());
  }
}

}  // namespace
}  // namespace hottel::live_version_test

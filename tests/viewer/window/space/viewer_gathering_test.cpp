// Light of a viewer in space that is gathered while it rests.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/viewer/window/space/hand.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel::viewer_gathering_test {
namespace {

using testing_viewer::Hand;

// The part of the frame that is within two steps of 256 of what `solve --shading gathered` draws.
double part_like_picture_of_solve(const Hand& hand) {
  const LiveVersion3& version = *hand.viewer->state().version;
  const auto simulation = version.of().simulation();
  PreparedScene3 prepared = *simulation.prepared();
  prepared.scene.camera = hand.viewer->camera().camera({400, 300});
  const ElementPaint3& light = version.light();
  const ToneCurve tone(hand.viewer->tone(), hand.viewer->exposure(), light.values, light.channels);
  const RenderedView3 view(prepared, Granularity::kElement, *version.radiosities(),
                           {.shading = Shading::kGathered, .light_shares = simulation.light_shares(), .curve = tone});
  int alike = 0;
  for (std::uint32_t k = 0; k < 400 * 300; ++k) {
    const auto level = tone.levels(view.pixels().at(k % 400, k / 400));
    int most = 0;
    for (unsigned c = 0; c < 3; ++c)
      most =
          std::max(most, std::abs(static_cast<int>(hand.viewer->frame().pixels[k] >> (16 - 8 * c) & 255u) - level[c]));
    alike += most <= 2 ? 1 : 0;
  }
  return alike / (400.0 * 300);
}

TEST(Viewer3Gathering, ShowsWhatSolveDraws) {
  Hand hand;
  hand.play("key f\ndo gather");
  EXPECT_EQ(hand.viewer->gathered(), 1);
  hand.play("leave");
  EXPECT_GT(part_like_picture_of_solve(hand), 0.55) << "the rest lies below texts";
  hand.viewer->save_picture(hand.path("seen.png"));
  EXPECT_TRUE(std::filesystem::exists(hand.path("seen.png")));
}

TEST(Viewer3Gathering, IsThrownAwayByAnyChange) {
  Hand hand;
  hand.play("do gather");
  for (const char* change : {"tone", "look up", "darker"}) {
    hand.viewer->command(change);
    hand.viewer->update();
    EXPECT_EQ(hand.viewer->gathered(), 0) << change;
    hand.viewer->settle(Hand::kPatience);
    EXPECT_EQ(hand.viewer->gathered(), 1) << change;
  }
  hand.play("do gather");
  EXPECT_EQ(hand.viewer->gathered(), 0);
}

TEST(Viewer3Gathering, IsOfLightAlone) {
  Hand hand;
  hand.play("do gather\ndo look irradiance");
  EXPECT_EQ(hand.viewer->gathered(), 0);
  hand.play("do look light");
  EXPECT_EQ(hand.viewer->gathered(), 1);
}

}  // namespace
}  // namespace hottel::viewer_gathering_test

// Light of a desk in space that is gathered while it rests.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/viewer/window/space/hand.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel::desk_gathering_test {
namespace {

using testing_desk::Hand;

// The part of the frame that is within two steps of 256 of what `solve --shading gathered` draws.
double part_like_picture_of_solve(const Hand& hand) {
  const LiveVersion3& version = *hand.desk->state().version;
  const auto simulation = version.of().simulation();
  PreparedScene3 prepared = *simulation.prepared();
  prepared.scene.camera = hand.desk->camera().camera({400, 300});
  const ElementPaint3& light = version.light();
  const ToneCurve tone(hand.desk->tone(), hand.desk->exposure(), light.values, light.channels);
  const RenderedView3 view(prepared, Granularity::kElement, *version.radiosities(),
                           {.shading = Shading::kGathered, .light_shares = simulation.light_shares(), .curve = tone});
  int alike = 0;
  for (std::uint32_t k = 0; k < 400 * 300; ++k) {
    const auto level = tone.levels(view.pixels().at(k % 400, k / 400));
    int most = 0;
    for (unsigned c = 0; c < 3; ++c)
      most = std::max(most, std::abs(static_cast<int>(hand.desk->frame().pixels[k] >> (16 - 8 * c) & 255u) - level[c]));
    alike += most <= 2 ? 1 : 0;
  }
  return alike / (400.0 * 300);
}

TEST(Desk3Gathering, ShowsWhatSolveDraws) {
  Hand hand;
  hand.play("key f\ndo gather");
  EXPECT_EQ(hand.desk->gathered(), 1);
  hand.play("leave");
  EXPECT_GT(part_like_picture_of_solve(hand), 0.55) << "the rest lies below texts";
  hand.desk->save_picture(hand.path("seen.png"));
  EXPECT_TRUE(std::filesystem::exists(hand.path("seen.png")));
}

TEST(Desk3Gathering, IsThrownAwayByAnyChange) {
  Hand hand;
  hand.play("do gather");
  for (const char* change : {"tone", "look up", "darker"}) {
    hand.desk->command(change);
    hand.desk->update();
    EXPECT_EQ(hand.desk->gathered(), 0) << change;
    hand.desk->settle(Hand::kPatience);
    EXPECT_EQ(hand.desk->gathered(), 1) << change;
  }
  hand.play("do gather");
  EXPECT_EQ(hand.desk->gathered(), 0);
}

TEST(Desk3Gathering, IsOfLightAlone) {
  Hand hand;
  hand.play("do gather\ndo look irradiance");
  EXPECT_EQ(hand.desk->gathered(), 0);
  hand.play("do look light");
  EXPECT_EQ(hand.desk->gathered(), 1);
}

}  // namespace
}  // namespace hottel::desk_gathering_test

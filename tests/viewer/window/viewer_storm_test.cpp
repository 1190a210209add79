// A short storm over each viewer; hottel_viewer_storm makes long ones.
#include "tests/viewer/window/viewer_storm.h"

#include <gmock/gmock.h>

namespace hottel::viewer_storm::viewer_storm_test {
namespace {

void expect_to_stand(const StormOptions& options) {
  const StormResult result = run_storm(options);
  EXPECT_THAT(result.failures, testing::IsEmpty());
  EXPECT_GE(result.events, options.events);
  EXPECT_GT(result.frames, options.events / 20);
}

TEST(ViewerStormThread, TheViewerOfThePlaneStands) {
  expect_to_stand({.dimension = 2, .seed = 1, .events = 600, .most_width = 320, .most_height = 200});
}

TEST(ViewerStormThread, TheViewerOfSpaceStands) {
  expect_to_stand({.dimension = 3, .seed = 1, .events = 600, .most_width = 320, .most_height = 200});
}

TEST(ViewerStormThread, TheViewerOfSpaceStandsWhileFactorsAreOnTheirWay) {
  expect_to_stand({.dimension = 3, .seed = 3, .events = 400, .elements = 4, .most_width = 320, .most_height = 200});
}

}  // namespace
}  // namespace hottel::viewer_storm::viewer_storm_test

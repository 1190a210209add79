// A short storm over each desk; hottel_desk_storm makes long ones.
#include "tests/viewer/window/desk_storm.h"

#include <gmock/gmock.h>

namespace hottel::desk_storm::desk_storm_test {
namespace {

void expect_to_stand(const StormOptions& options) {
  const StormResult result = run_storm(options);
  EXPECT_THAT(result.failures, testing::IsEmpty());
  EXPECT_GE(result.events, options.events);
  EXPECT_GT(result.frames, options.events / 20);
}

TEST(DeskStormThread, TheDeskOfThePlaneStands) {
  expect_to_stand({.dimension = 2, .seed = 1, .events = 600, .most_width = 320, .most_height = 200});
}

TEST(DeskStormThread, TheDeskOfSpaceStands) {
  expect_to_stand({.dimension = 3, .seed = 1, .events = 600, .most_width = 320, .most_height = 200});
}

TEST(DeskStormThread, TheDeskOfSpaceStandsWhileFactorsAreOnTheirWay) {
  expect_to_stand({.dimension = 3, .seed = 3, .events = 400, .elements = 4, .most_width = 320, .most_height = 200});
}

}  // namespace
}  // namespace hottel::desk_storm::desk_storm_test

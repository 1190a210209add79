#include "geometry/near_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hottel::near_names_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> near(std::string_view name, const std::vector<std::string>& known) {
  return near_names(name, known);
}

TEST(NearNames, DifferByAThirdOfTheLettersAtMost) {
  EXPECT_THAT(near("wal", {"door", "wall", "ball"}), ElementsAre("wall"));
  EXPECT_THAT(near("wlal", {"wall"}), ElementsAre("wall"));
  EXPECT_THAT(near("window", {"widnow", "winds", "win"}), ElementsAre("widnow", "winds"));
  EXPECT_THAT(near("floor", {"ceiling", "flow", "door"}), IsEmpty());
  EXPECT_THAT(near("x", {"y", "z"}), IsEmpty());
  EXPECT_THAT(near("", {"a"}), IsEmpty());
}

TEST(NearNames, DoNotCountCase) { EXPECT_THAT(near("WALL", {"mall", "wall"}), ElementsAre("wall", "mall")); }

TEST(NearNames, MayGoOnWhereTheNameEnds) {
  EXPECT_THAT(near("wal", {"wall:back", "wall"}), ElementsAre("wall", "wall:back"));
  EXPECT_THAT(near("room", {"room[10]", "room[0]", "bedroom", "room[1]", "room[2]"}),
              ElementsAre("room[0]", "room[1]", "room[2]"));
}

TEST(NearNames, AreAtMostThreeTheNearestFirstAndEachOnce) {
  EXPECT_THAT(near("window", {"windows1", "window1", "window1", "window2", "window3"}),
              ElementsAre("window1", "window2", "window3"));
}

TEST(NearNames, AreOthers) {
  EXPECT_THAT(near("sky", {"sky", "skyline"}), ElementsAre("skyline"));
  EXPECT_THAT(near("sky", {"sky"}), IsEmpty());
}

TEST(NearNames, OfVeryLongNamesThereAreNone) {
  const std::string name(100'000, 'a');
  EXPECT_THAT(near(name, {name + "b"}), IsEmpty());
  EXPECT_THAT(near("aaaaaa", {name}), IsEmpty());
}

TEST(NearNames, AreOneHintOrNone) {
  EXPECT_THAT(near_name_hints("wal", std::vector<std::string>{"wall", "wall:back"}),
              ElementsAre("did you mean 'wall', 'wall:back'?"));
  EXPECT_THAT(near_name_hints("wal", std::vector<std::string>{"door"}), IsEmpty());
}

}  // namespace
}  // namespace hottel::near_names_test

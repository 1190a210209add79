// What a solve makes of a scene, counted: one validation, one arrangement of its surfaces, in space one set of
// occluders, and one table of the elements of each granularity. The counting program is `hottel` with counting
// functions in the place of those that make these.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/cli/program.h"

namespace hottel::testing_cli::once_test {
namespace {

std::string counts_of(const std::string& command, const std::string& scene_and_options) {
  const Workplace place;
  const Outcome outcome = place.run("HOTTEL_COUNTS=counts '" HOTTEL_COUNTING_PROGRAM "' " + command +
                                    " " HOTTEL_SOURCE_DIR "/scenes/" + scene_and_options + " --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return place.read("counts");
}

std::string counts_of_solve(const std::string& arguments) { return counts_of("solve", arguments + " -o out"); }

TEST(Solve, MakesEachOfASceneInThePlaneOnce) {
  const std::string expected = R"(validations 1
arrangements 1
occluders 0
tables of faces 1, of elements 1, of groups 0
)";
  EXPECT_EQ(counts_of_solve("analytic/strip_obstructed.json"), expected);
  EXPECT_EQ(counts_of_solve("analytic/strip_obstructed.json --elements 2"), expected);
}

TEST(Solve, MakesEachOfASceneInSpaceOnce) {
  const std::string expected = R"(validations 1
arrangements 1
occluders 1
tables of faces 1, of elements 1, of groups 0
)";
  EXPECT_EQ(counts_of_solve("space/two_boxes.json --tolerance 1e-4"), expected);
}

TEST(Solve, OfElementsInSpaceMakesTheirTableOnce) {
  EXPECT_EQ(counts_of_solve("space/two_boxes.json --tolerance 1e-4 --elements 2"), R"(validations 1
arrangements 1
occluders 1
tables of faces 1, of elements 2, of groups 0
)");
}

TEST(Commands, ValidateASceneOnce) {
  for (const std::string scene : {"analytic/strip_obstructed.json", "space/two_boxes.json"}) {
    const std::string name = scene.starts_with("space") ? " --from lamp --to floor" : " --from bottom --to top";
    for (const auto& [command, options] : {std::pair<std::string, std::string>("factors", " --elements 2 -o f.csv"),
                                           {"plan", " --elements 2"},
                                           {"visibility", name},
                                           {"visibility", " --graph -o g.csv"},
                                           {"check", ""},
                                           {"compare", " --elements 2 --methods center -o c"},
                                           {"compare", " --methods center --divide 1,2 -o d"},
                                           {"convert", " out.json"}})
      EXPECT_THAT(counts_of(command, scene + options), testing::StartsWith("validations 1\n")) << command << options;
  }
}

}  // namespace
}  // namespace hottel::testing_cli::once_test

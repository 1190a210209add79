// What a solve makes of a scene, counted: one validation, one arrangement of its surfaces, in space one set of
// occluders, and one table of the elements of each granularity. The counting program is `hottel` with counting
// functions in the place of those that make these.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::testing_cli::once_test {
namespace {

std::string counts_of_solve(const std::string& arguments) {
  const Workplace place;
  const Outcome outcome =
      place.run("HOTTEL_COUNTS=counts '" HOTTEL_COUNTING_PROGRAM "' solve " HOTTEL_SOURCE_DIR "/scenes/" + arguments +
                " -o out --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return place.read("counts");
}

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

}  // namespace
}  // namespace hottel::testing_cli::once_test

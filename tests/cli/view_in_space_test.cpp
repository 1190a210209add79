// hottel view of scenes in space, without a screen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::view_in_space_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

class ViewInSpace : public testing::Test {
 protected:
  ViewInSpace() {
    place.write("cube.json", R"({"hottel": 1, "dimension": 3, "closed": true,
      "materials": {"white": {"reflectivity": 0.5}, "lamp": {"emission": 1}}, "polygons": [
      {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "white"},
      {"name": "ceiling", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "lamp"},
      {"name": "front", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "white"},
      {"name": "rear", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "white"},
      {"name": "left", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "white"},
      {"name": "right", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "white"}]})");
  }
  Outcome play(const std::string& script, const std::string& options = "") const {
    place.write("steps.txt", script);
    return place.run("hottel view cube.json --script steps.txt " + options);
  }
  Workplace place;
};

// The bytes of a new process on the saved scene.
TEST_F(ViewInSpace, HashesAreThoseOfAFreshProcess) {
  const Outcome outcome =
      play("orbit 30 10\nmaterial lamp emission 2\npick rear\nkey ]\nhash\nsave moved.json\n", "--elements 2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Outcome fresh = place.run(
      "hottel factors moved.json --quiet > factors.csv; hottel solve moved.json --quiet -o out; "
      "for f in factors.csv out/radiosity.csv; do sha256sum $f | cut -c1-64; done");
  ASSERT_EQ(fresh.code, 0) << fresh.err;
  const auto sums = lines_of(fresh.out);
  ASSERT_EQ(sums.size(), 2u);
  EXPECT_EQ(outcome.out, "factors.csv " + sums[0] + " radiosity.csv " + sums[1] + "\n");
}

TEST_F(ViewInSpace, WritesWhatIsSeen) {
  const Outcome outcome = place.run("hottel view cube.json --screenshot seen.png --size 300x200");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("seen.png"), StartsWith("\x89PNG"));
  const Outcome recorded = play("orbit 5\norbit 5\npause 0.1\n", "--record frames --size 200x150");
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_THAT(recorded.err, HasSubstr("5 frames, 20 a second, in frames"));
  for (const char* look : {"light", "radiosity", "irradiance", "factors", "errors", "plan"})
    EXPECT_EQ(place.run(std::string("hottel view cube.json --look ") + look + " --screenshot seen.png").code, 0);
}

TEST_F(ViewInSpace, RefusesWhatIsOfThePlane) {
  EXPECT_EQ(place.run("hottel view cube.json --look bands --screenshot x.png").code, 2);
  for (const char* step :
       {"move 1,2\n", "orbit\n", "orbit a\n", "do polyline\n", "pick nobody\n", "eye 0,0,0 0,0,0\n"}) {
    const Outcome outcome = play(std::string("#\n") + step);
    EXPECT_EQ(outcome.code, 3) << step;
    EXPECT_THAT(outcome.err, StartsWith("steps.txt:2: ")) << step;
  }
  place.write("flat.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}},
    "edges": [{"name": "a", "points": [[0, 0], [1, 0]], "material": "m"}]})");
  const Outcome outcome = place.run("echo orbit 3 | hottel view flat.json --script -");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("'orbit' is a step for scenes in space"));
}

}  // namespace
}  // namespace hottel::view_in_space_test

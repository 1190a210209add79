// What commands that were refused or ended leave behind: nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::left_behind_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kBox = std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json";

// A room of mirrors with a lamp: nothing can be solved.
const std::string kMirrors = R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1, "reflectivity": 1}},
 "polylines": [{"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "m"}]})";

TEST(LeftBehind, ARefusedCommandLeavesNoFolder) {
  const Workplace place;
  place.write("mirrors.json", kMirrors);
  const std::vector<std::string> refused = {"solve mirrors.json",
                                            "solve mirrors.json -o out",
                                            "solve mirrors.json -o a/b/c/",
                                            "reference out mirrors.json",
                                            "reference a/b mirrors.json " + kBox,
                                            "compare mirrors.json --methods file:missing.csv -o a/out",
                                            "compare mirrors.json --methods 'run:false'",
                                            "compare mirrors.json --methods strings --map strings -o out",
                                            "solve mirrors.json -o out --method 'run:exit 3'"};
  for (const std::string& line : refused) {
    const Outcome outcome = place.run("hottel " + line + " --quiet");
    EXPECT_NE(outcome.code, 0) << line;
    EXPECT_THAT(place.files(), ElementsAre("mirrors.json")) << line;
  }
}

TEST(LeftBehind, AFolderThatWasThereIsLeftAsItWas) {
  const Workplace place;
  place.write("mirrors.json", kMirrors);
  std::filesystem::create_directories(place.path("out/mirrors"));
  place.write("out/radiosity.csv", "earlier");
  EXPECT_EQ(place.run("hottel solve mirrors.json -o out").code, 1);
  EXPECT_EQ(place.run("hottel reference out mirrors.json").code, 1);
  EXPECT_EQ(place.run("ls -R out").out, "out:\nmirrors\nradiosity.csv\n\nout/mirrors:\n");
}

TEST(LeftBehind, ASetThatCannotBeWrittenLeavesNoFolder) {
  const Workplace place;
  place.write("set", "a file");
  EXPECT_EQ(place.run("hottel reference set " + kBox).code, 3);
  EXPECT_EQ(place.read("set"), "a file");
  const Outcome outcome = place.run("ulimit -f 4; hottel reference new " + kBox + " --quiet");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_THAT(place.files(), ElementsAre("set"));
}

TEST(LeftBehind, EarlierOutputsWhereStandardOutputCannotBeWritten) {
  const Workplace place;
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"solve " + kBox + " -o out --json --quiet", "out/radiosity.csv"},
      {"compare " + kBox + " --methods strings -o out --json --quiet", "out/compare.csv"},
      {"check " + kBox + " --fix repaired.json --within 1e-6", "repaired.json"},
      {"visibility " + kBox + " --at 1,1 --json -o seen.png", "seen.png"},
      {"factors " + kBox + " --json -o factors.csv", "factors.csv"}};
  for (const auto& [line, file] : lines) {
    std::filesystem::create_directory(place.path("out"));
    place.write(file, "earlier");
    EXPECT_EQ(place.run("hottel " + line + " > /dev/full").code, 3) << line;
    EXPECT_EQ(place.read(file), "earlier") << line;
    // A reader that has gone is no failure: the file is there.
    EXPECT_EQ(place.run("exec 3> >(true); sleep 0.1; hottel " + line + " >&3").code, 0) << line;
    EXPECT_NE(place.read(file), "earlier") << line;
  }
}

// A command that does not end when it is told to; the run is ended once more, by Ctrl-C or otherwise.
class EndedTwice : public testing::TestWithParam<const char*> {};

TEST_P(EndedTwice, LeavesNoScratchFolderAndNoProcess) {
  const Workplace place;
  const Outcome outcome = place.run(
      "mkdir tmp; export TMPDIR=$PWD/tmp; hottel compare " + kBox +
      " --methods 'run:trap \"\" TERM; echo half > {out}; mkdir $(dirname {out})/sub; echo $$ > pid; sleep 60' -o "
      "new/out & "
      "child=$!; until [ -s pid ]; do sleep 0.02; done; kill -INT $child; sleep 0.1; kill -" +
      std::string(GetParam()) +
      " $child; wait $child; code=$?; sleep 0.1; kill -0 $(cat pid) 2>/dev/null && echo alive; ls tmp; ls; exit $code");
  EXPECT_GE(outcome.code, 128) << outcome.err;
  EXPECT_EQ(outcome.out, "pid\ntmp\n");
}

INSTANTIATE_TEST_SUITE_P(, EndedTwice, testing::Values("INT", "TERM", "HUP"),
                         [](const auto& test) { return std::string(test.param); });

TEST(LeftBehind, WhereThereIsNoPlaceForTemporaryFilesThatIsSaid) {
  const Workplace place;
  const Outcome outcome = place.run("TMPDIR=$PWD/none hottel compare " + kBox + " --methods run:false -o out --quiet");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("TMPDIR: names no folder for temporary files: "));
  EXPECT_THAT(place.files(), testing::IsEmpty());
}

TEST(LeftBehind, ACommandThatIsTerminatedLeavesNoFolder) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel solve " + kBox +
                " --elements 3 --method 'run:echo > started; sleep 60; echo {out}' -o new/out & child=$!; until [ -e "
                "started ]; do sleep 0.02; done; kill -TERM $child; wait $child; code=$?; ls; exit $code");
  EXPECT_EQ(outcome.code, 143) << outcome.err;
  EXPECT_EQ(outcome.out, "started\n");
}

}  // namespace
}  // namespace hottel::left_behind_test

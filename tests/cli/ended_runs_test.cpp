// Runs that are told to end, or refused, leave what they have computed; and those that were killed leave no rubbish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::ended_runs::ended_runs_test {
namespace {

using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

struct Signal {
  const char* name;
  int code;
};

class EndedBy : public testing::TestWithParam<Signal> {};

TEST_P(EndedBy, LeavesItsFactorsToTheNextRun) {
  const Workplace place;
  const std::string line =
      "hottel factors " + kScenes + "space/two_boxes.json --per element --elements 3 --threads 1 --quiet";
  ASSERT_EQ(place.run(line + " -o alone.csv").code, 0);
  // Again where it was done before, or had not begun.
  std::uint64_t read = 0, computed = 0;
  for (const double seconds : {0.3, 0.1, 0.6, 1.2, 2.4, 4.8, 9.6}) {
    if (read > 0) break;
    ASSERT_EQ(place.run("rm -f s s-wal s-shm ended.csv").code, 0);
    const Outcome ended =
        place.run(line + " -o ended.csv --store s & child=$!; until [ -s s ]; do sleep 0.01; done; sleep " +
                  std::to_string(seconds) + "; kill -" + GetParam().name + " $child; wait $child");
    ASSERT_TRUE(ended.code == GetParam().code || ended.code == 0) << ended.code << ended.err;
    if (ended.code == 0) continue;
    EXPECT_EQ(ended.err, "");
    EXPECT_FALSE(testing_cli::fs::exists(place.path("ended.csv")));
    ASSERT_EQ(place.run("hottel store s --check").code, 0);
    const Outcome next = place.run(line + " -o next.csv --store s --json");
    ASSERT_EQ(next.code, 0) << next.err;
    EXPECT_EQ(place.read("next.csv"), place.read("alone.csv"));
    const auto report = nlohmann::json::parse(next.out);
    read = report["store"]["read"];
    computed = report["store"]["computed"];
    EXPECT_EQ(read + computed, report["counts"]["pairs"]);
  }
  EXPECT_GT(read, 0U);
  EXPECT_GT(computed, 0U);
}

INSTANTIATE_TEST_SUITE_P(, EndedBy, testing::Values(Signal{"INT", 130}, Signal{"TERM", 143}, Signal{"HUP", 129}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(EndedRuns, ThatAreRefusedLeaveTheirFactorsToTheNextOne) {
  const std::string plane = R"({"hottel": 1, "dimension": 2, "closed": true, "materials": {"m": {"emission": 1}},
    "polylines": [{"name": "a", "points": [[0,0],[1,0]], "material": "m"},
                  {"name": "b", "points": [[1,1],[0,1]], "material": "m"}]})";
  const std::string space = R"({"hottel": 1, "dimension": 3, "closed": true, "materials": {"m": {"emission": 1}},
    "polygons": [{"name": "a", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
                 {"name": "b", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "m"}]})";
  for (std::string scene : {plane, space}) {
    const Workplace place;
    const std::string line = "hottel solve scene.json --store s --quiet -o out";
    place.write("scene.json", scene);
    EXPECT_EQ(place.run(line).code, 1) << "the promise is broken";
    place.write("scene.json", scene.replace(scene.find("true"), 4, "false"));
    const Outcome next = place.run(line + " --json");
    ASSERT_EQ(next.code, 0) << next.err;
    const auto report = nlohmann::json::parse(next.out);
    EXPECT_EQ(report["store"]["computed"], 0);
    EXPECT_GT(report["store"]["read"], 0);
  }
}

std::string this_kernel() {
  std::string text;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> text;
  return text.substr(0, 8);
}

// By whatever command writes into the folder.
TEST(EndedRuns, ThatWereKilledLeaveNoTemporaryFileAfterALaterOne) {
  const std::string box = std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json";
  const std::string beacon = std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/beacon.json";
  const std::vector<std::string> lines = {
      "solve " + box + " -o out",
      "factors " + box + " -o out/f.csv",
      "factors " + box + " -o out/f.npy",
      "visibility " + box + " --at 1,1 -o out/v.png",
      "check " + box + " --fix out/fixed.json --within 1e-6",
      "compare " + box + " --methods strings --repeat 1 -o out",
      "reference out " + box,
      "generate clutter --n 20 --seed 1 -o out/g.json",
      "convert " + box + " out/c.json",
      "view " + box + " --screenshot out/s.png",
      "animate " + beacon + " --frames 1 -o out",
  };
  for (const std::string& line : lines) {
    const Workplace place;
    const std::string left = "out/.hottel-1-0-" + this_kernel() + ".tmp", other = "out/.hottel-1-0-other.tmp";
    testing_cli::fs::create_directory(place.path("out"));
    place.write(left, "half");
    place.write(other, "half");
    const Outcome outcome = place.run("hottel " + line + " --quiet");
    ASSERT_EQ(outcome.code, 0) << line << outcome.err;
    EXPECT_FALSE(testing_cli::fs::exists(place.path(left))) << line;
    EXPECT_TRUE(testing_cli::fs::exists(place.path(other))) << line << ": perhaps of another machine";
  }
}

}  // namespace
}  // namespace hottel::ended_runs::ended_runs_test

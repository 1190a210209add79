// Runs with their sums on disk that are killed: the next one in the folder removes what they left, and nothing else.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::killed_out_of_core_test {
namespace {

using namespace testing_cli;

class KilledOutOfCore : public testing::Test {
 protected:
  KilledOutOfCore() {
    EXPECT_EQ(place_.run("hottel generate clutter --n 10000 --seed 1 -o scene.json").code, 0);
    EXPECT_EQ(place_.run("hottel factors scene.json -o alone.csv").code, 0);
  }
  // Starts a run whose number is in $run from then on, and waits until it has a folder of sums in d.
  static std::string begun(const std::string& command) {
    return "hottel " + command +
           " --quiet --out-of-core d & run=$!; until ls -d d/hottel-run-$run-* > /dev/null 2>&1; do kill -0 $run || "
           "exit 9; sleep 0.005; done; ";
  }
  std::string folders() const { return place_.run("ls -A d 2>/dev/null | wc -l").out; }

  Workplace place_;
};

TEST_F(KilledOutOfCore, LeavesAFolderThatTheNextRunRemoves) {
  for (const std::string command :
       {"factors scene.json -o kept.csv", "solve scene.json --no-illumination --no-picture -o kept"}) {
    ASSERT_EQ(place_.run(begun(command) + "kill -KILL $run; wait $run; true").code, 0);
    EXPECT_EQ(folders(), "1\n") << "nobody could remove it";
    ASSERT_EQ(place_.run("hottel factors scene.json -o next.csv --out-of-core d").code, 0);
    EXPECT_EQ(place_.run("cmp alone.csv next.csv").code, 0);
    EXPECT_EQ(folders(), "0\n");
  }
}

// One is stopped for as long as another one is killed and a third one does its work.
TEST_F(KilledOutOfCore, IsToldFromARunThatLives) {
  const Outcome outcome = place_.run(
      "set -e; " + begun("factors scene.json -o living.csv") + "kill -STOP $run; living=$run; " +
      begun("factors scene.json -o killed.csv") + "kill -KILL $run; wait $run || true; ls d | wc -l; " +
      "hottel factors scene.json -o next.csv --quiet --out-of-core d; ls -d d/hottel-run-$living-* | wc -l; ls d | wc "
      "-l; kill -CONT $living; wait $living; cmp alone.csv next.csv; cmp alone.csv living.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "2\n1\n1\n");
  EXPECT_EQ(folders(), "0\n");
}

}  // namespace
}  // namespace hottel::killed_out_of_core_test

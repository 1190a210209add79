// Runs that are killed while their sums go to files: what they leave, the next one takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/cli/killed_run.h"
#include "tests/cli/program.h"

namespace hottel::killed_checkpoint_test {
namespace {

using namespace testing_cli;
using testing::HasSubstr;

class KilledCheckpoint : public testing::Test {
 protected:
  KilledCheckpoint() {
    EXPECT_EQ(place_.run("hottel generate clutter --n 10000 --seed 1 -o scene.json").code, 0);
    EXPECT_EQ(place_.run("hottel factors scene.json -o alone.csv").code, 0);
  }
  KilledRun run_for(double seconds) const {
    return run({"hottel", "factors", place_.path("scene.json").string(), "--threads", "2", "--quiet", "-o",
                place_.path("kept.csv").string(), "--checkpoint", place_.path("d").string()},
               seconds);
  }

  Workplace place_;
};

TEST_F(KilledCheckpoint, GoesOnToTheSameBytes) {
  const double alone = run_for(1e9).seconds;
  std::mt19937_64 random(3);
  int killed = 0;
  for (int k = 0; k < 6; ++k) killed += run_for(alone * std::uniform_real_distribution<>(0.2, 0.95)(random)).was_killed;
  EXPECT_GT(killed, 2);
  ASSERT_TRUE(run_for(1e9).succeeded);
  EXPECT_EQ(place_.run("cmp alone.csv kept.csv").code, 0);
  EXPECT_EQ(place_.run("ls -A d 2>/dev/null | wc -l").out, "0\n") << "chunks of a run that is done";
}

// Radiosities from sums of runs that were killed.
TEST_F(KilledCheckpoint, LeadsToTheSameRadiosities) {
  const std::string solve = "hottel solve scene.json --no-illumination --no-picture --quiet -o ";
  ASSERT_EQ(place_.run(solve + "alone").code, 0);
  for (int k = 0; k < 3; ++k)
    run({"hottel", "solve", place_.path("scene.json").string(), "--no-illumination", "--no-picture", "--quiet", "-o",
         place_.path("kept").string(), "--checkpoint", place_.path("d").string()},
        0.2 + 0.3 * k);
  ASSERT_EQ(place_.run(solve + "kept --checkpoint d").code, 0);
  EXPECT_EQ(place_.run("cmp alone/radiosity.csv kept/radiosity.csv && cmp alone/flux.csv kept/flux.csv").code, 0);
  EXPECT_EQ(place_.run("ls -A d 2>/dev/null | wc -l").out, "0\n") << "chunks of a run that is done";
}

TEST_F(KilledCheckpoint, IsOfOneSceneAlone) {
  for (double share = 0.9; share > 0.1 && place_.run("ls d/*.sums").code != 0; share -= 0.1) run_for(share * 0.5);
  if (place_.run("ls d/*.sums").code != 0) GTEST_SKIP() << "no run was killed between its first chunk and its end";
  EXPECT_EQ(place_.run("hottel generate clutter --n 1000 --seed 2 -o other.json").code, 0);
  const Outcome other = place_.run("hottel factors other.json -o other.csv --checkpoint d");
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("scene.json by hottel"));
  EXPECT_NE(place_.run("ls other.csv").code, 0);
}

}  // namespace
}  // namespace hottel::killed_checkpoint_test

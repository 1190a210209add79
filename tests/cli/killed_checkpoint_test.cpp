// Runs that are killed while their sums go to files: what they leave, the next one takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
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
  // A command that keeps its sums in d.
  std::vector<std::string> kept(std::vector<std::string> words, const std::string& out) const {
    words.insert(words.begin(), "hottel");
    words.insert(words.end(), {place_.path("scene.json").string(), "--threads", "2", "--quiet", "-o",
                               place_.path(out).string(), "--checkpoint", place_.path("d").string()});
    return words;
  }
  KilledRun run_for(double seconds) const { return run(kept({"factors"}, "kept.csv"), seconds); }
  std::string chunks() const { return place_.run("ls -A d 2>/dev/null | wc -l").out; }

  // Kills a command again and again, each time somewhere else; each run that comes to its end has the same results. A
  // run after such a one begins anew.
  void kill_at_random(const std::vector<std::string>& words, const std::string& compare) const {
    const int kills = asked("HOTTEL_KILLS", 6);
    const double alone = run(words, 1e9).seconds;
    std::mt19937_64 random(3);
    int killed = 0, succeeded = 0;
    for (int runs = 0; killed < kills && runs < 10 * kills; ++runs) {
      const KilledRun one = run(words, alone * std::uniform_real_distribution<>(0.05, 1.2)(random));
      killed += one.was_killed;
      succeeded += one.succeeded;
      ASSERT_TRUE(one.was_killed || one.succeeded);
      if (one.was_killed) continue;
      ASSERT_EQ(place_.run(compare).code, 0) << "after " << killed << " kills";
    }
    EXPECT_GE(killed, kills);
    ASSERT_TRUE(run(words, 1e9).succeeded);
    EXPECT_EQ(place_.run(compare).code, 0);
    EXPECT_EQ(chunks(), "0\n") << "chunks of a run that is done";
    std::printf("%d runs killed, %d came to their end: the same bytes\n", killed, succeeded + 1);
  }

  Workplace place_;
};

TEST_F(KilledCheckpoint, GoesOnToTheSameBytes) {
  kill_at_random(kept({"factors"}, "kept.csv"), "cmp alone.csv kept.csv");
}

// Radiosities from sums of runs that were killed.
TEST_F(KilledCheckpoint, LeadsToTheSameRadiosities) {
  ASSERT_EQ(place_.run("hottel solve scene.json --no-illumination --no-picture --quiet -o alone").code, 0);
  kill_at_random(kept({"solve", "--no-illumination", "--no-picture"}, "kept"),
                 "cmp alone/radiosity.csv kept/radiosity.csv && cmp alone/flux.csv kept/flux.csv");
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

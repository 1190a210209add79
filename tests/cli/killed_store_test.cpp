// Runs that are killed while they compute factors into a store: how much of their work is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "tests/cli/killed_run.h"
#include "tests/cli/program.h"
#include "tests/sanitizers.h"

namespace hottel::killed_store::killed_store_test {
namespace {

using namespace testing_cli;

struct Case {
  const char *name, *kind;
  int edges;  // to generate
  std::vector<std::string> options;
};

class KilledStore : public testing::TestWithParam<Case> {};

// Whoever computes the same factors goes on where the killed runs were. A chain of runs, each killed but the last,
// loses what they worked together beyond one run that is not killed.
TEST_P(KilledStore, LosesTenSecondsOfWorkAtMost) {
  const Workplace place;
  const int wanted = asked("HOTTEL_KILLS", 2), larger = asked("HOTTEL_KILLED_SCENES_LARGER", 1);
  const std::string edges = std::to_string(GetParam().edges * larger);
  ASSERT_EQ(
      place.run("hottel generate " + std::string(GetParam().kind) + " --n " + edges + " --seed 1 -o scene.json").code,
      0);
  const std::string threads = "2";
  const auto words = [&](const char* out) {
    std::vector<std::string> all = {"hottel",  "factors", place.path("scene.json").string(), "--threads", threads,
                                    "--quiet", "-o",      place.path(out).string()};
    all.insert(all.end(), GetParam().options.begin(), GetParam().options.end());
    if (out != std::string("alone.csv")) all.insert(all.end(), {"--store", place.path("s").string()});
    return all;
  };
  const KilledRun alone = run(words("alone.csv"), 1e9);
  ASSERT_TRUE(alone.succeeded);
  std::mt19937_64 random(static_cast<std::uint64_t>(asked("HOTTEL_KILLED_SEED", 1)));
  int killed = 0, chains = 0;
  double lost = 0, most = 0;
  while (killed < wanted) {
    ASSERT_EQ(place.run("rm -f s s-wal s-shm").code, 0);
    double worked = 0;
    int killed_of_chain = 0;
    for (;;) {
      // In the middle on average, and once in a while while it keeps what it has found.
      const bool kills = killed < wanted;
      const double seconds = alone.seconds * (0.1 + 0.7 * std::uniform_real_distribution<>()(random));
      const KilledRun now = run(words("kept.csv"), kills ? seconds : 1e9);
      worked += now.seconds;
      if (!now.was_killed) {
        ASSERT_TRUE(now.succeeded);
        break;
      }
      ++killed;
      ++killed_of_chain;
      ASSERT_EQ(place.run("[ ! -e s ] || hottel store s --check").code, 0) << "after kill " << killed;
    }
    ASSERT_EQ(place.run("cmp alone.csv kept.csv").code, 0);
    ++chains;
    if (killed_of_chain == 0) continue;
    const double lost_now = (worked - alone.seconds) / 2;  // by two threads
    lost += lost_now;
    most = std::max(most, lost_now / killed_of_chain);
    std::printf("%s: %d killed, %.1f s of %.1f lost\n", GetParam().name, killed_of_chain, lost_now, alone.seconds / 2);
    std::fflush(stdout);
    EXPECT_LT(lost_now, 10.0 * killed_of_chain);
  }
  std::printf("%s: %d runs killed in %d chains; %.2f s lost of each, %.2f s in the worst chain\n", GetParam().name,
              killed, chains, lost / killed, most);
  EXPECT_EQ(place.run("ls -A | grep -c '^[.]hottel-'").out, "0\n") << "temporary files";
}

INSTANTIATE_TEST_SUITE_P(, KilledStore,
                         testing::Values(Case{"space", "room-boxes", 10, {"--per", "element", "--elements", "2"}},
                                         Case{"groups", "room-boxes", 14, {"--per", "group", "--matrix", "visibility"}},
                                         Case{"plane", "clutter", 20'000, {}}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace hottel::killed_store::killed_store_test

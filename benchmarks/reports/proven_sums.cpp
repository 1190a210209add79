// Holds sums over triangles that pierce each other, each with the error that its rules state, against bounds that are
// proven. Writes a line for each tenth of the pairs; exit code 1 where a sum is not where its bounds say.
//
//   report_proven_sums [PAIRS [SEED]]
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <vector>

#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"
#include "tests/comparison/space/pierced_pairs.h"

namespace hottel {
namespace {

constexpr double kAsked = 1e-9;  // of the smaller area

// What became of pairs.
struct Tally {
  std::uint64_t pairs = 0, outside = 0, wide = 0;
  std::vector<double> widths;  // in the smaller area

  void add(std::uint64_t seed, const oracle::PiercedPair3& pair) {
    ++pairs;
    widths.push_back(pair.width());
    if (!pair.is_within_bounds()) {
      ++outside;
      fmt::print("seed {}: {} is outside [{}, {}] {}\n", seed, pair.sum.measure, pair.proven.bounds.lower,
                 pair.proven.bounds.upper, pair.sum.problem);
    }
    if (!(pair.width() <= kAsked)) {
      ++wide;
      fmt::print("seed {}: bounds are {:.1e} of the smaller area apart\n", seed, pair.width());
    }
  }
  void print(double seconds) {
    std::sort(widths.begin(), widths.end());
    fmt::print(
        "{} pairs, {} sums outside their bounds, {} bounds wider than {:.0e} of the smaller area; median {:.1e}, "
        "widest {:.1e}; {:.0f} s\n",
        pairs, outside, wide, kAsked, widths.empty() ? 0 : widths[widths.size() / 2],
        widths.empty() ? 0 : widths.back(), seconds);
    std::fflush(stdout);
  }
};

int run(std::uint64_t most, std::uint64_t first) {
  constexpr std::uint64_t kSeedsAtOnce = 1000;
  Tally tally;
  std::mutex adding;
  Stopwatch watch;
  double seconds = 0;
  for (std::uint64_t told = 0; tally.pairs < most; first += kSeedsAtOnce) {
    parallel_for(kSeedsAtOnce, [&](std::size_t k) {
      const auto pairs = oracle::pierced_pairs_3(first + k);
      const std::lock_guard lock(adding);
      for (const oracle::PiercedPair3& pair : pairs) tally.add(first + k, pair);
    });
    seconds += watch.lap();
    if (tally.pairs < most && 10 * tally.pairs / most == told) continue;
    told = 10 * tally.pairs / most;
    tally.print(seconds);
  }
  return tally.outside == 0 && tally.wide == 0 ? 0 : 1;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  const auto number = [&](int k, std::uint64_t usual) {
    return k < argc ? std::strtoull(argv[k], nullptr, 10) : usual;
  };
  const std::uint64_t pairs = number(1, 1'000'000), seed = number(2, 1);
  if (argc > 3 || pairs == 0) {
    fmt::print(stderr, "report_proven_sums [PAIRS [SEED]]\n");
    return 2;
  }
  return hottel::run(pairs, seed);
}

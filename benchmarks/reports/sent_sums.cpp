// Counts what ranks send to rank 0 of sweeps in the plane: sums by pair, for pairs of scenes of several kinds. Nothing
// is timed, and no messages are sent: vertices are dealt out as to so many ranks of one thread each, and each range is
// swept by itself. Writes a table.
//
//   report_sent_sums [EDGES...]
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "geometry/plane/exchange/sweep_crew.h"
#include "geometry/plane/exchange/swept_vertices.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

struct Kind {
  const char* name;
  const char* kind;
  Rational length;
};

std::vector<WorkRange> dealt(std::size_t vertices, std::size_t ranks) {
  WorkQueue queue(sweep_sizes(vertices), ranks);
  std::vector<WorkRange> ranges;
  for (WorkRange range = queue.take(); !range.is_empty(); range = queue.take()) ranges.push_back(range);
  return ranges;
}

void report(const Kind& kind, std::uint64_t n) {
  const Scene2 scene = generate_2({.kind = kind.kind, .n = n, .seed = 1, .length = kind.length});
  const PreparedScene2 prepared = prepare(scene);
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const std::vector<VertexId> order = swept_vertices(prepared.arrangement, table);
  const auto sums_of = [&](const WorkRange& range) {
    const auto vertices = std::span(order).subspan(range.begin, range.size());
    return swept_part(range, vertices, prepared.arrangement, table);
  };
  const SweptPart2 all = sums_of({0, order.size()});
  const auto pairs = static_cast<double>(all.sums.size());
  fmt::print("| {} | {} | {} | {:.1f} |", kind.name, scene.edges.size(), all.sums.size(),
             static_cast<double>(all.counts.updates) / pairs);
  for (const std::size_t ranks : {2, 8, 64}) {
    const std::vector<WorkRange> ranges = dealt(order.size(), ranks);
    std::vector<std::size_t> sizes(ranges.size());
    parallel_for(ranges.size(), [&](std::size_t k) { sizes[k] = sums_of(ranges[k]).sums.size(); });
    const auto found = static_cast<double>(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}));
    const double sent = found * static_cast<double>(ranks - 1) / static_cast<double>(ranks);  // rank 0 keeps its own
    fmt::print(" {:.2f} | {:.1f} |", sent / pairs,
               static_cast<double>(*std::ranges::max_element(sizes) * sizeof(PairSum2)) / 1e6);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  using namespace hottel;
  std::vector<std::uint64_t> sizes;
  for (int k = 1; k < argc; ++k) sizes.push_back(std::strtoull(argv[k], nullptr, 10));
  if (sizes.empty()) sizes = {1000, 10'000};
  fmt::print(
      "| kind | edges | pairs | terms a pair | sent a pair, 2 ranks | most at once, MB | 8 ranks | MB | 64 ranks | MB "
      "|\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  const std::vector<Kind> kinds{{"clutter, short views", "clutter", kShortView},
                                {"clutter, long views", "clutter", kLongView},
                                {"lattice", "lattice", 1},
                                {"maze", "maze", 1},
                                {"pillars", "pillars", 1},
                                {"comb", "comb", 1}};
  for (const Kind& kind : kinds)
    for (const std::uint64_t n : sizes) report(kind, n);
}

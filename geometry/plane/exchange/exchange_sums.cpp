#include "geometry/plane/exchange/exchange_sums.h"

#include <algorithm>
#include <random>

#include "geometry/plane/exchange/gap_terms.h"
#include "geometry/plane/exchange/swept_vertices.h"

namespace hottel {
namespace {

// Follows the gaps that start at one vertex.
class Sweep {
 public:
  Sweep(const Arrangement2& arrangement, const ElementTable2& table) : arrangement_(arrangement), table_(table) {}

  void operator()(VertexId v, TermBuffer2<PairSum2>& out) const {
    const Vertices2& vertices = arrangement_.vertices();
    thread_local View2 view;
    look_around(vertices, arrangement_.triangulation(), v, view);
    for_each_gap(vertices, v, view, true, [&](const Gap2& gap) {
      ++out.gaps;
      FixedLength2 length{0, false};
      bool is_measured = false;
      for_each_term(gap, table_, [&](std::uint32_t i, std::uint32_t j, int sign) {
        if (!is_measured) {
          length = vertices.distance(gap.v, gap.w);
          is_measured = true;
        }
        ++out.updates;
        const unsigned directions = i == j ? 2 : 1;
        const Int128 value = directions * length.value;
        const bool is_obstructed = (table_.ends_among(i, gap.v, gap.w) | table_.ends_among(j, gap.v, gap.w)) != 3;
        out.add({pair_key(i, j), length.is_exact ? 0 : directions, is_obstructed, sign > 0 ? value : -value});
      });
    });
  }

 private:
  const Arrangement2& arrangement_;
  const ElementTable2& table_;
};

}  // namespace

PairSums2 sum_visible_pairs(const Arrangement2& arrangement, const ElementTable2& table,
                            const std::function<void(double)>& progress, std::uint64_t most_pairs, SumCounts2& counts,
                            SweepParts2* parts) {
  return sum_pairs_about(swept_vertices(arrangement, table), arrangement, table, progress, most_pairs, counts, parts);
}

PairSums2 sum_pairs_about(std::span<const VertexId> order, const Arrangement2& arrangement, const ElementTable2& table,
                          const std::function<void(double)>& progress, std::uint64_t most_pairs, SumCounts2& counts,
                          SweepParts2* parts, SharedWork<SweptPart2>* work) {
  const std::size_t label_count = table.covered() + 1;
  return {sum_terms<PairSum2>(order, label_count, Sweep(arrangement, table), progress, most_pairs, counts, parts, work),
          table.count()};
}

SightEstimate2 estimated_sight(const Arrangement2& arrangement, const ElementTable2& table, std::uint64_t most) {
  // Pairs that see each other through one opening have four terms; there are few with less.
  constexpr std::uint64_t kTermsPerPair = 4;
  const std::uint64_t n = arrangement.vertices().size();
  std::mt19937_64 random(1);
  const std::uint64_t sample = std::min(most, n);
  if (sample == 0) return {};
  std::uint64_t terms = 0, seen = 0, seen_typed = 0;
  View2 view;
  for (std::uint64_t k = 0; k < sample; ++k) {
    const auto v = VertexId(sample == n ? k : random() % n);
    look_around(arrangement.vertices(), arrangement.triangulation(), v, view);
    seen += view.seen.size();
    seen_typed += static_cast<std::uint64_t>(std::ranges::count_if(
        view.seen, [&](const View2::Seen& s) { return s.vertex.index() < arrangement.typed_points(); }));
    // Every gap is met from both its ends: half of it belongs to this one.
    for_each_gap(arrangement.vertices(), v, view, false, [&](const Gap2& gap) {
      for_each_term(gap, table, [&terms](std::uint32_t, std::uint32_t, int) { ++terms; });
    });
  }
  const auto each = [sample](std::uint64_t sum) { return static_cast<double>(sum) / static_cast<double>(sample); };
  return {terms * n / (2 * kTermsPerPair * sample), each(seen), each(seen_typed)};
}

Int128 closure_defect(const PairSums2& sums, const ElementTable2& table) {
  std::vector<Int128> sum(table.covered() + 1, 0);
  sums.for_each([&sum](const PairSum2& pair) {
    sum[pair.i()] += pair.value;
    if (pair.j() != pair.i()) sum[pair.j()] += pair.value;
  });
  Int128 defect = 0;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    if (!table.has_row(label)) continue;
    const Int128 difference = sum[label] - 2 * table.length(label).value;
    defect = std::max(defect, difference < 0 ? -difference : difference);
  }
  return defect;
}

}  // namespace hottel

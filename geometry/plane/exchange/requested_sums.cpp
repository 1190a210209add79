#include "geometry/plane/exchange/requested_sums.h"

#include <limits>
#include <vector>

#include "geometry/memory_text.h"
#include "geometry/plane/exchange/convex_sums.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/sweep_crew.h"
#include "geometry/plane/exchange/swept_vertices.h"
#include "geometry/plane/prepared/element_table.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

std::uint64_t count_all_pairs(const ElementTable2& table) {
  std::uint64_t rows = 0;
  for (std::uint32_t i = 0; i < table.count(); ++i) rows += table.has_row(i);
  return rows * (rows - 1) / 2;
}

// How many pairs the memory holds.
std::uint64_t most_pairs(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
                         std::uint64_t bytes_per_pair) {
  if (request.memory == 0) return std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t most = request.memory / bytes_per_pair;
  const std::uint64_t pairs =
      sweeps(prepared, request) ? estimated_sight(prepared.arrangement, table).pairs : count_all_pairs(table);
  if (pairs > most) refuse_memory(prepared.scene, pairs, "visible pairs", bytes_per_pair, request.memory);
  return most;
}

// Here alone, or with others where there are no parts.
PairSums2 sweep(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
                std::uint64_t most, SumCounts2& counts, SweepParts2* parts) {
  SweepCrew2* const crew = parts == nullptr ? CrewScope<SweepCrew2>::crew() : nullptr;
  if (crew == nullptr) return sum_visible_pairs(prepared.arrangement, table, request.progress, most, counts, parts);
  const std::vector<VertexId> order = swept_vertices(prepared.arrangement, table);
  const auto work = crew->begin({prepared, request.granularity, table, order});
  return sum_pairs_about(order, prepared.arrangement, table, request.progress, most, counts, nullptr, work.get());
}

}  // namespace

bool sweeps(const PreparedScene2& prepared, const ExchangeRequest& request) {
  return request.always_sweeps || !is_convex_room(prepared.scene);
}

PairSums2 requested_sums(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
                         std::uint64_t bytes_per_pair, ExchangeReport& report, SweepParts2* parts) {
  Stopwatch watch;
  const std::uint64_t most = most_pairs(prepared, table, request, bytes_per_pair);
  SumCounts2 counts;
  PairSums2 sums = sweeps(prepared, request) ? sweep(prepared, table, request, most, counts, parts)
                                             : sum_convex_pairs(prepared.arrangement, table);
  report.seconds[sweeps(prepared, request) ? "sweep" : "strings"] = watch.lap();
  report.gaps = counts.gaps;
  report.terms = counts.updates;
  return sums;
}

void report_scene(const PreparedScene2& prepared, const ElementTable2& table, ExchangeReport& report) {
  report.surfaces = prepared.scene.surfaces.size();
  report.vertices = prepared.arrangement.vertices().size();
  report.pieces = prepared.arrangement.pieces().size();
  report.elements = table.count();
}

}  // namespace hottel

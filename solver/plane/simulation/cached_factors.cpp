#include "solver/plane/simulation/cached_factors.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/cached_pairs.h"
#include "solver/cached_report.h"
#include "solver/plane/simulation/cached_sweep.h"
#include "solver/store_key.h"

namespace hottel {
namespace {

// Another one wherever the same scene and request may give other numbers, or they are kept otherwise, than before.
constexpr const char* kKind = "plane 1";

bool is_exact(const ExchangeMethod2& method) { return method.info().guarantee == Guarantee::kExact; }

// As methods that know elements only have them (ElementMethod2).
std::vector<Element> rows_of(const PreparedScene2& prepared, Granularity granularity) {
  const bool is_divided = is_cut(prepared.division);
  return is_divided && granularity != Granularity::kElement
             ? prepare(prepared.scene, Divided2::kNo).elements(granularity)->elements()
             : prepared.elements(granularity)->elements();
}

std::uint32_t what_of(const ExchangeMethod2& method, const ExchangeRequest& request) {
  if (!is_exact(method)) return 0;
  return (request.wants_visibility ? kKeptVisibilities : 0) | (request.wants_measures ? kKeptMeasures : 0);
}

StoreTable table_of(const ExchangeMethod2& method, const PreparedScene2& prepared, const ExchangeRequest& request,
                    const std::vector<Element>& elements) {
  StoreTable table;
  table.elements = element_ids(elements);
  table.about = prepared.scene.file + " by " + method.info().name;
  StoreKey key(kKind);
  key.add(method.info().name);
  key.add_count(request.granularity == Granularity::kGroup ? 1 : 0);
  key.add_table(prepared.scene);
  for (const Edge2& edge : prepared.scene.edges)
    for (const Point2* point : {&edge.from, &edge.to}) {
      key.add_number(point->x);
      key.add_number(point->y);
    }
  if (!is_exact(method)) {
    key.add_division(prepared.scene);
    key.add_elements(table.elements);
  }
  table.key = key.text();
  return table;
}

MethodReport report_of(const ExchangeMatrix& matrix, const PreparedScene2& prepared, MethodReport report,
                       double seconds) {
  report.counts.surfaces = prepared.scene.surfaces.size();
  report.counts.vertices = prepared.arrangement.vertices().size();
  report.counts.pieces = prepared.arrangement.pieces().size();
  report.counts.elements = matrix.size();
  report.counts.seconds["prepare"] = prepared.seconds;
  report.counts.seconds["store"] = seconds;
  return report;
}

// The sweep, where it goes on.
ComputedFactors2 swept_factors(const CachedSweep2& sweep, const PreparedScene2& prepared,
                               const ExchangeRequest& request) {
  ComputedFactors2 result;
  SweepParts2 parts = sweep.parts();
  result.matrix = with_file_context(prepared.scene.file,
                                    [&] { return exact_exchange(prepared, request, &result.report.counts, &parts); });
  return result;
}

}  // namespace

StoreTable store_table_2(const ExchangeMethod2& method, const PreparedScene2& prepared,
                         const ExchangeRequest& request) {
  return table_of(method, prepared, request, rows_of(prepared, request.granularity));
}

ComputedFactors2 cached_factors_2(FactorStore& store, const ExchangeMethod2& method, const PreparedScene2& prepared,
                                  const ExchangeRequest& request) {
  Stopwatch watch;
  const std::vector<Element> elements = rows_of(prepared, request.granularity);
  const StoreTable table = table_of(method, prepared, request, elements);
  const std::uint32_t what = what_of(method, request);
  const std::vector<CachedRows> kept = store.read(table, what);
  PairRanges known(static_cast<std::uint32_t>(elements.size()));
  std::optional<CachedSweep2> sweep;
  if (method.info().name == "exact") sweep.emplace(store, prepared, table);
  const Guarantee guarantee = is_exact(method) ? Guarantee::kExact : Guarantee::kEstimated;
  if (auto matrix = cached_matrix(kept, elements, guarantee, what, known)) {
    std::optional<MethodReport> report;
    if (is_exact(method)) {
      report.emplace();
      report->counts.pairs = pair_count(*matrix);
      report->counts.closure_is_exact = true;  // it was when they were kept
    } else {
      report = cached_report(kept, *matrix);
    }
    if (report) {
      store.add(0, pair_count(*matrix));
      if (sweep) sweep->forget();  // of a run that was killed before it did
      MethodReport of_run = report_of(*matrix, prepared, std::move(*report), watch.lap());
      return {std::move(*matrix), std::move(of_run)};
    }
    known = PairRanges(static_cast<std::uint32_t>(elements.size()));
  }
  const double seconds = watch.lap();
  ComputedFactors2 computed = sweep ? swept_factors(*sweep, prepared, request) : factors_by(method, prepared, request);
  watch.lap();
  const auto keep = [&](std::span<const CachedRow> rows) { store.keep(table, what, rows); };
  if (keep_matrix(computed.matrix, known, keep)) {
    if (!is_exact(method)) {
      const CachedRow report = report_to_keep(computed.matrix, computed.report);
      keep(std::span(&report, 1));
    }
    if (sweep) sweep->forget();
  }
  store.add(pair_count(computed.matrix), 0);
  computed.report.counts.seconds["store"] = seconds + watch.lap();
  return computed;
}

}  // namespace hottel

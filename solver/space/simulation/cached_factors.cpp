#include "solver/space/simulation/cached_factors.h"

#include <algorithm>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/cached_pairs.h"
#include "solver/cached_report.h"
#include "solver/store_key.h"

namespace hottel {
namespace {

// Another one wherever the same scene and request may give other numbers, or they are kept otherwise, than before.
constexpr const char* kKind = "space 2";

void add_points(StoreKey& key, const std::vector<Point3>& points) {
  key.add_count(points.size());
  for (const Point3& point : points) {
    key.add_number(point.x);
    key.add_number(point.y);
    key.add_number(point.z);
  }
}

StoreKey key_of(const std::string& method, const Scene3& scene, const ExchangeRequest& request) {
  StoreKey key(kKind);
  key.add(method);
  key.add_bits(request.tolerance);
  if (request.proves) key.add("proven");
  key.add_count(request.granularity == Granularity::kGroup ? 1 : 0);
  key.add_table(scene);
  for (const Polygon3& polygon : scene.polygons) {
    key.add_count(polygon.is_nearly_plane ? 1 : 0);
    add_points(key, polygon.points);
    key.add_count(polygon.holes.size());
    for (const auto& hole : polygon.holes) add_points(key, hole);
    key.add_count(polygon.facets.size());
    for (const auto& [a, b, c] : polygon.facets) add_points(key, {a, b, c});
  }
  key.add_count(scene.masks.size());
  for (const Mask3& mask : scene.masks) {
    key.add_count(mask.surface);
    key.add_count(mask.base);
  }
  return key;
}

std::uint32_t what_of(const ExchangeRequest& request) { return request.wants_visibility ? kKeptVisibilities : 0; }

// 41 bytes and the column: what is kept of a pair.
constexpr std::uint8_t kIsWhole = 1, kHasAlone = 2;

PairSum3 read_pair(NumberReader& in) {
  PairSum3 pair{.i = 0, .j = 0};
  const std::uint8_t head = in.byte();
  pair.is_whole = (head & kIsWhole) != 0;
  pair.measure = in.number();
  pair.error = in.number();
  pair.bounds.lower = in.number();
  pair.bounds.upper = in.number();
  if ((head & kHasAlone) != 0) pair.alone = in.number();
  return pair;
}

void write_pair(const PairSum3& pair, NumberWriter& out) {
  out.byte(static_cast<std::uint8_t>((pair.is_whole ? kIsWhole : 0) | (pair.alone != 0 ? kHasAlone : 0)));
  out.number(pair.measure);
  out.number(pair.error);
  out.number(pair.bounds.lower);
  out.number(pair.bounds.upper);
  if (pair.alone != 0) out.number(pair.alone);
}

}  // namespace

StoreTable store_table_3(const ExchangeRows3& rows, const PreparedScene3& prepared, const ExchangeRequest& request) {
  return {key_of("exact", prepared.scene, request).text(), prepared.scene.file + " by exact",
          element_ids(rows.table().elements())};
}

StoreTable store_table_3(const ExchangeMethod3& method, const PreparedScene3& prepared,
                         const ExchangeRequest& request) {
  StoreTable table;
  table.elements = element_ids(prepared.elements(request.granularity)->elements());
  table.about = prepared.scene.file + " by " + method.info().name;
  StoreKey key = key_of("by elements: " + method.info().name, prepared.scene, request);
  key.add_division(prepared.scene);
  key.add_elements(table.elements);
  table.key = key.text();
  return table;
}

std::uint64_t take_kept(FactorStore& store, const StoreTable& table, const ExchangeRequest& request,
                        ExchangeRows3& rows) {
  const std::vector<CachedRows> kept = store.read(table, what_of(request));
  std::vector<PairSum3> pairs;
  PairRanges known(rows.table().count());
  take_pairs<PairSum3>(kept, known, pairs, read_pair);
  const std::uint64_t taken = pairs.size();
  rows.take(std::move(pairs), std::move(known));
  return taken;
}

std::uint64_t keep_pairs(FactorStore& store, const StoreTable& table, const ExchangeRequest& request,
                         std::span<const PairSum3> pairs, const PairRanges& known) {
  std::uint64_t kept = 0;
  std::vector<CachedRow> rows;
  auto pair = pairs.begin();
  for (std::uint32_t i = 0; i < known.elements(); ++i) {
    if (known.ranges(i).empty()) continue;
    CachedRow& row = rows.emplace_back();
    row.row = i;
    row.known.assign(known.ranges(i).begin(), known.ranges(i).end());
    NumberWriter out(row.numbers);
    for (; pair != pairs.end() && pair->i == i; ++pair) {
      if (pair->is_zero()) continue;
      row.to.push_back(pair->j);
      write_pair(*pair, out);
      ++kept;
    }
  }
  HOTTEL_REQUIRE(pair == pairs.end());
  if (!rows.empty()) store.keep(table, what_of(request), rows);
  return kept;
}

ComputedFactors3 cached_factors_3(FactorStore& store, const ExchangeMethod3& method, const PreparedScene3& prepared,
                                  const ExchangeRequest& request, const std::function<ComputedFactors3()>& compute) {
  Stopwatch watch;
  const StoreTable table = store_table_3(method, prepared, request);
  const std::vector<Element> elements = prepared.elements(request.granularity)->elements();
  const std::vector<CachedRows> kept = store.read(table, 0);
  PairRanges known(static_cast<std::uint32_t>(elements.size()));
  if (auto matrix = cached_matrix(kept, elements, Guarantee::kEstimated, 0, known)) {
    if (const auto report = cached_report(kept, *matrix)) {
      ComputedFactors3 result;
      result.matrix = std::move(*matrix);
      result.notes = report->notes;
      result.report.surfaces = prepared.scene.surfaces.size();
      result.report.vertices = prepared.occluders().vertices().size();
      result.report.elements = elements.size();
      result.report.pairs = report->counts.pairs;
      result.report.max_defect = report->row_defect;
      result.report.seconds["prepare"] = prepared.seconds;
      result.report.seconds["store"] = watch.lap();
      store.add(0, pair_count(result.matrix));
      return result;
    }
    known = PairRanges(static_cast<std::uint32_t>(elements.size()));
  }
  ComputedFactors3 result = compute();
  const auto keep = [&](std::span<const CachedRow> rows) { store.keep(table, 0, rows); };
  if (keep_matrix(result.matrix, known, keep)) {
    MethodReport report;
    report.row_defect = result.report.max_defect;
    report.counts.pairs = result.report.pairs;
    report.notes = result.notes;
    const CachedRow row = report_to_keep(result.matrix, report);
    keep(std::span(&row, 1));
  }
  store.add(pair_count(result.matrix), 0);
  return result;
}

}  // namespace hottel

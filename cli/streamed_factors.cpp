#include "cli/streamed_factors.h"

#include <fmt/format.h>

#include <memory>

#include "geometry/plane/exchange/exact_rows.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/requested_sums.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/plane/prepared/element_table.h"
#include "io/results/factors_report.h"
#include "io/sums/plane/sum_folder.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/memory_estimate.h"
#include "solver/plane/scene_memory.h"

namespace hottel {
namespace {

// The rows of a run, and what they are made of; each refers to those before it.
struct Streamed {
  std::shared_ptr<const PreparedScene2> prepared;
  ExchangeRequest request;
  std::shared_ptr<const ElementTable2> table;
  std::unique_ptr<SumFolder2> folder;  // where they are on disk
  std::unique_ptr<const SumsInMemory2> in_memory;
  std::unique_ptr<ExactRows2> rows;
  ExchangeReport counts;
};

// Of --out-of-core or --checkpoint; null where neither is given.
std::unique_ptr<SumFolder2> folder_of(const FactorsOptions& options, Streamed& streamed) {
  if (!options.sums.is_given()) return nullptr;
  return std::make_unique<SumFolder2>(options.sums.request(), *streamed.prepared, *streamed.table, streamed.request,
                                      streamed.counts);
}

std::unique_ptr<const SumsInMemory2> in_memory(Streamed& streamed) {
  return std::make_unique<const SumsInMemory2>(
      requested_sums(*streamed.prepared, *streamed.table, streamed.request, kBytesPerSum2, streamed.counts));
}

void add_rows(const FactorsOptions& options, Streamed& streamed) {
  Stopwatch watch;
  streamed.table = table_with_rows(*streamed.prepared, streamed.request);
  streamed.counts.seconds["prepare"] = streamed.prepared->seconds;
  streamed.counts.seconds["label"] = watch.lap();
  streamed.folder = folder_of(options, streamed);
  if (!streamed.folder) streamed.in_memory = in_memory(streamed);
  const SumSource2& sums = streamed.folder ? static_cast<const SumSource2&>(*streamed.folder) : *streamed.in_memory;
  report_scene(*streamed.prepared, *streamed.table, streamed.counts);
  streamed.rows =
      std::make_unique<ExactRows2>(*streamed.prepared, *streamed.table, streamed.request, sums, streamed.counts);
}

std::unique_ptr<Streamed> streamed_rows(const FactorsOptions& options, const Simulation2& simulation,
                                        const Streams& streams) {
  require_memory_of_rows(options, simulation.scene());
  auto result = std::make_unique<Streamed>();
  result->prepared = simulation.prepared(streams.stages());
  result->request = {.granularity = options.per(),
                     .wants_visibility = options.format() == FactorFormat::kCsv,  // others have none
                     .rows = rows_to_compute(options, simulation.scene()),
                     .memory = memory_allowed(options.memory),
                     .progress = streams.progress("view factors")};
  with_file_context(options.scene, [&] { add_rows(options, *result); });
  return result;
}

// The matrix of so many pairs is made: it takes some 200 MB.
constexpr std::uint64_t kMostPairsInMatrix = std::uint64_t{1} << 22;

}  // namespace

void require_memory_of_rows(const FactorsOptions& options, const Scene2& scene) {
  require_memory(scene, {.granularity = options.per(), .pairs_on_disk = options.sums.is_given()}, options.memory);
}

bool needs_rows_alone(const FactorsOptions& options) {
  return options.is_exact() && options.lists_pairs() && options.pairs == "visible" && !options.wants_exact_form &&
         !options.script_f && options.picture.empty() && !options.store.is_given() &&
         !(options.json && options.out.empty());
}

FactorTable table_of_rows(const FactorsOptions& options, const SceneTable& scene, RowRanges& rows,
                          const Streams& streams) {
  FactorTable table{scene, rows.matrix(), options.per()};
  table.has_areas = options.areas;
  table.digits = options.digits;
  table.ranges = &rows;
  take_rows(options, streams, table);
  return table;
}

bool streams_rows(const FactorsOptions& options, const Simulation2& simulation, const Streams& streams) {
  if (options.sums.is_given()) return true;
  if (!needs_rows_alone(options)) return false;
  const auto prepared = simulation.prepared(streams.stages());
  return estimated_sight(prepared->arrangement, *prepared->elements(options.per())).pairs > kMostPairsInMatrix;
}

void write_streamed_factors(FactorsOptions& options, const Simulation2& simulation, const FactorOrigin& origin,
                            FactorsFiles& files, Streams& streams) {
  std::unique_ptr<Streamed> streamed = streamed_rows(options, simulation, streams);
  if (takes_groups_of_many(options, streamed->rows->begins().back(), streams)) {
    streamed.reset();
    streamed = streamed_rows(options, simulation, streams);
  }
  const FactorTable table = table_of_rows(options, streamed->prepared->scene, *streamed->rows, streams);
  with_file_context(options.scene, [&] {
    write_table(options, table, origin, files, [&](const Sink& sink) {
      write_faces_csv(table, element_pieces(*streamed->prepared, table.granularity), sink);
    });
  });
  FactorsReport report{options.scene, options.method, options.per()};
  report.of_method.counts = streamed->counts;
  files.finish();
  if (options.json) streams.write("", factors_json(report));
  files.commit();
  if (streamed->folder) {
    options.sums.tell(streamed->folder->bytes(), streams);
    streamed->folder->forget();
  }
  streams.note(factors_text(report));
}

}  // namespace hottel

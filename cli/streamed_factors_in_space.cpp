#include "cli/streamed_factors_in_space.h"

#include <memory>

#include "cli/deck_requests.h"
#include "cli/streamed_factors.h"
#include "geometry/closed_promise.h"
#include "geometry/space/exchange/closed_promise.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/unmeasured_pairs.h"
#include "io/results/space/element_files.h"
#include "io/results/space/factors_report.h"
#include "io/sums/space/pair_folder.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/scene_memory.h"

namespace hottel {
namespace {

// The rows of a run, and what they are made of; each refers to those before it.
struct RowsInSpace {
  std::shared_ptr<const PreparedScene3> prepared;
  ExchangeRequest request;
  std::shared_ptr<const ElementTable3> table;
  std::unique_ptr<PairFolder3> folder;  // where pairs are on disk
  std::unique_ptr<PairsInMemory3> in_memory;
  std::unique_ptr<ExchangeRows3> measured;
  std::unique_ptr<MeasuredRows3> rows;
  ExchangeReport3 counts;
};

void measure_rows(const FactorsOptions& options, const Streams& streams, RowsInSpace& streamed) {
  streamed.table = streamed.prepared->elements(options.per());
  if (options.sums.is_given())
    streamed.folder =
        std::make_unique<PairFolder3>(options.sums.folder(), *streamed.prepared, *streamed.table, streamed.request);
  else
    streamed.in_memory = std::make_unique<PairsInMemory3>(streamed.table->count());
  PairKeeper3* const keeper =
      streamed.folder ? static_cast<PairKeeper3*>(streamed.folder.get()) : streamed.in_memory.get();
  streamed.measured = std::make_unique<ExchangeRows3>(*streamed.prepared, streamed.request, keeper);
  streamed.measured->add_all(streams.progress("view factors"));
  streamed.rows = streamed.measured->rows(&streamed.counts);
  if (options.guarantee.must_be_enclosed()) require_enclosed_3(*streamed.rows, streamed.request.tolerance);
}

std::unique_ptr<RowsInSpace> rows_in_space(const FactorsOptions& options, const Simulation3& simulation,
                                           const Streams& streams) {
  const FactorsRequest3& asked = simulation.request().factors;
  require_memory(simulation.scene(), {.granularity = options.per(), .pairs_on_disk = options.sums.is_given()},
                 options.memory);
  auto result = std::make_unique<RowsInSpace>();
  result->prepared = simulation.prepared(streams.stages());
  result->request = {.granularity = options.per(),
                     .wants_visibility = options.format() == FactorFormat::kCsv,  // others have none
                     .tolerance = asked.tolerance,
                     .proves = asked.must_be_enclosed,
                     .sky = asked.sky,
                     .rows = rows_to_compute(options, simulation.scene()),
                     .memory = memory_allowed(options.memory)};
  if (!result->request.rows.is_all() && simulation.scene().closed) require_closed(*result->prepared);
  with_file_context_of_pairs(simulation.scene().file, [&] { measure_rows(options, streams, *result); });
  if (result->request.rows.is_all()) require_closed(simulation.scene(), *result->rows);
  return result;
}

}  // namespace

bool streams_rows_in_space(const FactorsOptions& options) {
  if (!options.sums.checkpoint.empty())
    throw UsageError(
        "--checkpoint is for scenes in the plane: in space --store keeps what a run that is ended had done");
  const bool needs_all = options.deck.list > 0;
  if (options.sums.is_given() && needs_all)
    throw UsageError("--out-of-core has no rows in memory for list of the deck to tell");
  return needs_rows_alone(options) && !needs_all;
}

void write_streamed_factors_in_space(FactorsOptions& options, const Simulation3& simulation, const FactorOrigin& origin,
                                     FactorsFiles& files, const Streams& streams) {
  std::unique_ptr<RowsInSpace> streamed = rows_in_space(options, simulation, streams);
  if (takes_groups_of_many(options, streamed->rows->begins().back(), streams)) {
    streamed.reset();
    streamed = rows_in_space(options, simulation, streams);
  }
  const Scene3& scene = streamed->prepared->scene;
  FactorTable table = table_of_rows(options, scene, *streamed->rows, streams);
  obey_deck(options, streams, table, scene.polygons);
  with_file_context(options.scene, [&] {
    write_table(options, table, origin, files, [&](const Sink& sink) {
      write_faces_csv_3(table, written_outlines(*streamed->table, streamed->prepared->occluders().vertices()), sink);
    });
  });
  files.finish();
  const FactorsReport3 report{.scene = options.scene,
                              .method = options.method,
                              .granularity = options.per(),
                              .tolerance = streamed->request.tolerance,
                              .guarantee = streamed->rows->guarantee(),
                              .counts = streamed->counts,
                              .notes = {}};
  if (options.json) streams.write("", factors_json(report));
  files.commit();
  if (streamed->folder) options.sums.tell(streamed->folder->bytes(), streams);
  streams.note(factors_text(report));
}

}  // namespace hottel

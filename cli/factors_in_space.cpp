#include "cli/factors_in_space.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cli/deck_requests.h"
#include "cli/script_f.h"
#include "cli/sights_in_space.h"
#include "cli/streamed_factors.h"
#include "geometry/closed_promise.h"
#include "geometry/space/exchange/closed_promise.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/unmeasured_pairs.h"
#include "io/external/space/external_matrix.h"
#include "io/results/space/element_files.h"
#include "io/results/space/factors_report.h"
#include "io/sums/space/pair_folder.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/scene_memory.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

void require_what_space_has(const FactorsOptions& options) {
  if (options.wants_exact_form && options.granularity != "face")
    throw UsageError("--exact-form in space is for whole faces, --per face, not --per " + options.granularity);
  if (!options.picture.empty())
    throw UsageError(
        "--picture and --toward draw scenes in the plane; in space `hottel solve --show factor:NAME` or "
        "`--show sky` does");
  if (options.is_exact()) return;
  const auto refuse_of = [&options](const std::string& option) {
    throw UsageError(option + " is for the method exact only, not for " + options.method);
  };
  if (options.tolerance) refuse_of("--tolerance");
  options.guarantee.refuse_of_method(options.method);
  if (options.memory > 0) refuse_of("--memory");
}

FactorsRequest3 request_in_space(const FactorsOptions& options, const Scene3& scene) {
  return {.method = options.is_exact() ? nullptr : all_methods_3().make(options.method),
          .granularity = options.per(),
          .wants_visibility = options.is_exact() && (options.matrix.empty() || options.matrix == "visibility"),
          .wants_measures = options.matrix == "exchange",
          .tolerance = tolerance_of(options.tolerance, FactorsRequest3().tolerance),
          .sky = options.sky.in_space(options.method),
          .must_be_enclosed = options.guarantee.must_be_enclosed(),
          .rows = rows_to_compute(options, scene),
          .memory = options.memory,
          .store = options.store.open(options.method)};
}

// Whether no more is asked for than rows of the list: these are written row by row, and no matrix of all of them is
// made. Throws UsageError for --out-of-core where more is, and for --checkpoint.
bool streams_rows_in_space(const FactorsOptions& options) {
  if (!options.sums.checkpoint.empty())
    throw UsageError(
        "--checkpoint is for scenes in the plane: in space --store keeps what a run that is ended had done");
  const bool needs_all = options.deck.list > 0;
  if (options.sums.is_given() && needs_all)
    throw UsageError("--out-of-core has no rows in memory for list of the deck to tell");
  return needs_rows_alone(options) && !needs_all;
}

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

// Computes and writes them. The same bytes as by the matrix. REQUIRES streams_rows_in_space(options).
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

}  // namespace

void factors_in_space(FactorsOptions& options, ValidScene3 scene, const Streams& streams) {
  require_what_space_has(options);
  const bool by_rows = streams_rows_in_space(options);
  FactorsRequest3 request = request_in_space(options, *scene);
  options.elements.apply_to(scene);
  require_room_for(options, [&](FactorFormat format) {
    const ElementCounts3 counts = element_counts(*scene, request.granularity);
    return dense_size(counts.all, counts.with_material, format);
  });
  if (options.elements.is_given() && request.granularity != Granularity::kElement &&
      !(request.method && request.method->works_by_elements()))
    streams.note("the division into elements changes no number here: each row is a whole " + options.granularity +
                 "; --per element writes a row for each element");
  const FactorOrigin origin{3, options.method, options.keeps_scene() ? write_scene_3(*scene) : ""};
  Simulation3 simulation(std::move(scene), {.factors = request});

  FactorsFiles files(options, streams);
  if (options.wants_exact_form) {
    write_exact_forms_3(options.exact_form, simulation, streams, *files.out);
    files.finish();
    return files.commit();
  }
  if (by_rows) return write_streamed_factors_in_space(options, simulation, origin, files, streams);
  simulation.require_closed(streams.stages());
  if (takes_groups_of_many(options, simulation.factors(streams.stages())->matrix.entry_count(), streams)) {
    request.granularity = options.per();
    simulation = simulation.with_request({.factors = request});
  }
  const auto computed = simulation.factors(streams.stages());
  const auto prepared = simulation.prepared();
  std::optional<GrayFactors> gray;
  if (options.script_f) gray = gray_factors(options, computed->matrix, prepared->scene.materials, streams);
  FactorTable table{prepared->scene, gray ? gray->matrix : computed->matrix, request.granularity};
  if (gray) table.gray_channel = gray->channel;
  table.has_areas = options.areas;
  table.digits = options.digits;
  take_rows(options, streams, table);
  obey_deck(options, streams, table, prepared->scene.polygons);
  if (options.pairs == "facing" || options.matrix == "visibility") table.hidden = *simulation.hidden(streams.stages());
  if (files.out)
    with_file_context(options.scene, [&] {
      write_table(options, table, origin, files, [&](const Sink& sink) {
        const ElementTable3& elements = *prepared->elements(request.granularity);
        write_faces_csv_3(table, written_outlines(elements, prepared->occluders().vertices()), sink);
      });
    });
  files.finish();
  const FactorsReport3 report{.scene = options.scene,
                              .method = options.method,
                              .granularity = request.granularity,
                              .tolerance = request.tolerance,
                              .guarantee = computed->matrix.guarantee(),
                              .counts = computed->report,
                              .notes = computed->notes,
                              .gray = gray ? std::optional(gray->report) : std::nullopt,
                              .store = options.store.report(request.store)};
  if (options.json) streams.write("", factors_json(report));
  files.commit();
  note_matrix(options, table, streams);
  streams.note(factors_text(report));
}

}  // namespace hottel

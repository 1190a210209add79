#include "cli/factors_in_space.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cli/deck_requests.h"
#include "cli/script_f.h"
#include "cli/sights_in_space.h"
#include "cli/streamed_factors_in_space.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/external/space/external_matrix.h"
#include "io/results/space/element_files.h"
#include "io/results/space/factors_report.h"
#include "kernel/support/with_file_context.h"
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

#include "cli/sights_in_space.h"

#include <optional>
#include <string_view>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/exchange/event_surfaces.h"
#include "geometry/space/exchange/exact_form.h"
#include "geometry/space/exchange/face_sight.h"
#include "geometry/space/exchange/vertex_graph.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/results/csv_field.h"
#include "io/results/space/event_files.h"
#include "io/results/space/sight_report.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/event_picture.h"

namespace hottel {
namespace {

Face face_with_form(const Scene3& scene, const std::string& name) {
  if (name == "sky")
    throw UsageError("--exact-form in space is for two faces: what is seen of the sky has no closed form");
  return face_of(scene, name);
}

std::string form_line(const PreparedScene3& prepared, const Face& from, const Face& to, const ArcSum3& form) {
  const Scene3& scene = prepared.scene;
  const std::optional<Rational> area = rational_area(prepared, from);
  return csv_field(face_name(scene, from)) + "," + csv_field(face_name(scene, to)) + "," + form.to_string() + "," +
         (area ? to_string(*area) : "") + "\n";
}

// The pairs of faces that see each other, each in both directions where both have materials.
void write_all_forms(const Simulation3& simulation, const Streams& streams, OutputFile& out) {
  const PreparedScene3& prepared = *simulation.prepared(streams.stages());
  const Scene3& scene = prepared.scene;
  std::size_t without = 0;
  for (std::uint32_t f = 0; f < 2 * scene.surfaces.size(); ++f) {
    const Face from = Face::of(f);
    if (!scene.surfaces[from.surface].material_of(from.is_back)) continue;
    for (const SeenFace3& seen : faces_seen_by(prepared, from)) {
      const ExactForm3 form = seen.face && seen.is_whole ? exact_form_3(prepared, from, *seen.face) : ExactForm3();
      if (form.exchange)
        out.write(form_line(prepared, from, *seen.face, *form.exchange));
      else
        ++without;
    }
  }
  if (without > 0) streams.note("no closed form is known of " + counted(without, "pair"));
}

}  // namespace

void write_face_sight(const std::string& name, bool is_json, const Simulation3& simulation, const Streams& streams) {
  if (name == "sky") throw UsageError("--face is a face, which the sky is not");
  const auto prepared = simulation.prepared(streams.stages());
  const Face face = face_of(prepared->scene, name);
  with_file_context(prepared->scene.file, [&] {
    require_free(*prepared, face);
    const VisibilityAnswer answer =
        face_answer(prepared->scene, name, faces_seen_by(*prepared, face, streams.progress("weak visibility")));
    streams.write("", is_json ? answer.json : answer.text);
  });
}

void write_graph_3(const SceneLines& lines, const Simulation3& simulation, const Streams& streams) {
  streams.write_with(lines.out, [&](OutputFile& file) {
    const auto prepared = simulation.prepared(streams.stages());
    with_file_context(lines.scene, [&] {
      const VisibilityGraph3 graph{graph_vertices_3(prepared->scene),
                                   visibility_graph_3(*prepared, streams.progress("visibility graph"))};
      if (lines.json)
        file.write(graph_json_3(prepared->scene, graph));
      else
        write_graph_csv_3(prepared->scene, graph, lines.exact, [&](std::string_view text) { file.write(text); });
      streams.note(graph_summary_3(graph));
    });
  });
}

void require_sense(const EventRequest3& request) {
  if (request.from.empty() || request.to.empty())
    throw UsageError("--events in space are those between two faces: it goes with --from A and --to B");
  if (request.from == "sky" || request.to == "sky")
    throw UsageError("--events in space are between two faces, not of the sky");
  if (request.json || request.exact)
    throw UsageError("--events in space writes a .csv or a .vtp: it has neither --json nor --exact");
  const bool is_file = !request.out.empty() && request.out != "-";
  if (is_file && !request.out.ends_with(".csv") && !request.out.ends_with(".vtp") && !picture_format(request.out))
    throw UsageError("event surfaces are written as .csv or .vtp, drawn as .png, .svg or .pdf, not '" + request.out +
                     "'");
}

void write_events_3(const EventRequest3& request, const Simulation3& simulation, const Streams& streams) {
  const Scene3& scene = simulation.scene();
  const Face from = face_of(scene, request.from), to = face_of(scene, request.to);
  streams.write_with(request.out, [&](OutputFile& file) {
    const auto prepared = simulation.prepared(streams.stages());
    with_file_context(request.scene, [&] {
      for (const Face& face : {from, to}) require_free(*prepared, face);
      const std::vector<EventSurface3> events = event_surfaces(*prepared, from, to);
      const auto sink = [&file](std::string_view text) { file.write(text); };
      if (const auto format = request.out.empty() ? std::nullopt : picture_format(request.out))
        sink(event_picture_3(scene, to, events, *format));
      else
        request.out.ends_with(".vtp") ? write_events_vtp(events, sink) : write_events_csv_3(scene, events, sink);
      streams.note(events_summary_3(events));
    });
  });
}

void write_exact_forms_3(const std::vector<std::string>& names, const Simulation3& simulation, const Streams& streams,
                         OutputFile& out) {
  const Scene3& scene = simulation.scene();
  with_file_context(scene.file, [&] {
    if (names.empty()) {
      out.write("from,to,exchange,area\n");
      return write_all_forms(simulation, streams, out);
    }
    const Face from = face_with_form(scene, names[0]), to = face_with_form(scene, names[1]);
    const auto prepared = simulation.prepared(streams.stages());
    const ExactForm3 form = exact_form_3(*prepared, from, to);
    if (!form.exchange)
      throw RequestError("no closed form is known of " + quoted_name(names[0]) + " and " + quoted_name(names[1]) +
                         ": " + form.why_not);
    out.write("from,to,exchange,area\n" + form_line(*prepared, from, to, *form.exchange));
  });
}

}  // namespace hottel

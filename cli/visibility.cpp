// hottel visibility: what points see, what a point of a face receives, what two faces see of each other, what some
// point of a face sees, the lines along which it changes, and which vertices see each other.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "cli/command.h"
#include "cli/guarantee_option.h"
#include "cli/oriented_points.h"
#include "cli/points_in_plane.h"
#include "cli/points_in_space.h"
#include "cli/scene_input.h"
#include "cli/scene_lines.h"
#include "cli/sights_in_space.h"
#include "cli/unit_notes.h"
#include "cli/visibility_in_plane.h"
#include "cli/visibility_in_space.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/visibility/weak_visibility.h"
#include "geometry/scene_names.h"
#include "io/external/oriented_points.h"
#include "io/external/space/point_list.h"
#include "io/files/text_file.h"
#include "io/results/plane/edge_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

struct VisibilityOptions {
  std::string scene, at, on, from, to, out, points, range, edge, face, side = "both";
  bool json = false, exact = false, irradiance = false, no_irradiance = false, events = false, graph = false,
       pieces = false;
  PolygonOptions polygons;
  GuaranteeOption guarantee;

  bool is_pair() const { return !from.empty() || !to.empty(); }
};

// Whole faces: nothing here is asked of their elements.
Simulation2 simulation_of(ValidScene2 scene) {
  return Simulation2(std::move(scene), {.granularity = Granularity::kFace});
}

// What CLI11 does not see.
void require_sense(const VisibilityOptions& options) {
  if (options.is_pair() && (options.from.empty() || options.to.empty() || !options.at.empty() || !options.on.empty()))
    throw UsageError("--from A and --to B go together, without --at and --on");
  if (!options.is_pair() && options.at.empty())
    throw UsageError(
        "visibility needs --at X,Y or --on NAME --at T or --from A --to B or --points FILE or --edge NAME or --face "
        "NAME or --events or --graph");
  if (options.from == "sky" && options.to == "sky")
    throw UsageError("--from or --to is a face: the sky exchanges nothing with itself");
}

bool is_file(const std::string& out) { return !out.empty() && out != "-"; }

// Points with normals: the light on a small area at each, in place of what it sees.
ExitCode light_at_points(const VisibilityOptions& options, OrientedPointsInput input, Streams& streams) {
  for (const auto& [is_given, option] : {std::pair(!options.range.empty(), "--range"),
                                         {options.exact, "--exact"},
                                         {options.pieces, "--pieces"},
                                         {options.side != VisibilityOptions().side, "--side"}})
    if (is_given) throw UsageError(std::string(option) + " is for polygons; points with normals have none");
  if (options.guarantee.asked)
    throw UsageError("--guarantee is for what points see; the light at points with normals has no proven bounds");
  write_oriented_light(input, read_scene_noting(options.scene, options.polygons, streams), streams);
  return ExitCode::kDone;
}

// Points in space: which faces each sees.
ExitCode faces_at_points(const VisibilityOptions& options, const std::string& text, const std::string& name,
                         Streams& streams) {
  for (const auto& [is_given, option] : {std::pair(!options.range.empty(), "--range"),
                                         {options.exact, "--exact"},
                                         {options.irradiance, "--irradiance"},
                                         {options.side != VisibilityOptions().side, "--side"}})
    if (is_given) throw UsageError(std::string(option) + " is for points in the plane; these have three coordinates");
  const ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  const auto* const space = std::get_if<ValidScene3>(&scene);
  if (space == nullptr)
    throw InputError({name, 0}, "points have three coordinates, and " + options.scene + " is in the plane");
  write_seen_faces({text, name, options.out, options.pieces, options.guarantee.must_be_enclosed()}, **space, streams);
  return ExitCode::kDone;
}

ExitCode from_points(const VisibilityOptions& options, Streams& streams) {
  const bool is_standard_input = options.points == kStandardInput;
  const std::string name = is_standard_input ? kStandardInputName : options.points;
  require_not_read("-o " + options.out, options.out, "--points", options.points);
  const std::string text = is_standard_input ? read_standard_input() : read_text_file(options.points);
  if (names_normals(text)) return light_at_points(options, {text, name, options.scene, options.out}, streams);
  if (are_points_3(text)) return faces_at_points(options, text, name, streams);
  options.guarantee.refuse_in_plane();
  if (options.polygons.triangulates)
    throw UsageError("--triangulate cuts polygons in space; points without normals are for the plane");
  if (options.pieces) throw UsageError("--pieces are for what points in space see; these are in the plane");
  const PolygonRequest2 request = polygon_request({.text = text,
                                                   .name = name,
                                                   .out = options.out,
                                                   .range = options.range,
                                                   .is_exact = options.exact,
                                                   .has_light = options.irradiance,
                                                   .fronts_only = options.side == "front"});
  note_passed_over(request.passed_over, streams);
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (std::holds_alternative<ValidScene3>(scene))
    throw InputError({name, 0}, "points have two coordinates, and " + options.scene + " is in space: give x,y,z");
  write_polygons(request, simulation_of(std::get<ValidScene2>(std::move(scene))), streams);
  return ExitCode::kDone;
}

// ---- what some point of a face sees, and critical lines

ExitCode from_edge(const VisibilityOptions& options, Streams& streams) {
  if (is_file(options.out)) throw UsageError("--edge writes to standard output, not to '" + options.out + "'");
  if (options.edge == "sky") throw UsageError("--edge is a face, which the sky is not");
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (std::holds_alternative<ValidScene3>(scene))
    throw UsageError("--edge is for scenes in the plane; in space --face NAME tells what some point of a face sees");
  const auto prepared = simulation_of(std::get<ValidScene2>(std::move(scene))).prepared(streams.stages());
  const Face face = face_of(prepared->scene, options.edge);
  require_free(*prepared, face);
  const WeakVisibility2 sight = weak_visibility(*prepared, face, streams.progress("weak visibility"));
  const VisibilityAnswer answer = edge_answer(*prepared, options.edge, sight);
  streams.write("", options.json ? answer.json : answer.text);
  return ExitCode::kDone;
}

ExitCode from_face_in_space(const VisibilityOptions& options, Streams& streams) {
  if (is_file(options.out)) throw UsageError("--face writes to standard output, not to '" + options.out + "'");
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (std::holds_alternative<ValidScene2>(scene))
    throw UsageError("--face is for scenes in space; in the plane --edge NAME tells what some point of an edge sees");
  write_face_sight(options.face, options.json, Simulation3(std::get<ValidScene3>(std::move(scene))), streams);
  return ExitCode::kDone;
}

SceneLines scene_lines(const VisibilityOptions& options) {
  return {.scene = options.scene, .out = options.out, .json = options.json, .exact = options.exact};
}

ExitCode events(const VisibilityOptions& options, Streams& streams) {
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (auto* const there = std::get_if<ValidScene3>(&scene)) {
    const EventRequest3 request{options.scene, options.from, options.to, options.out, options.json, options.exact};
    require_sense(request);
    write_events_3(request, Simulation3(std::move(*there)), streams);
    return ExitCode::kDone;
  }
  if (options.is_pair()) throw UsageError("--events with --from A and --to B is for scenes in space");
  const SceneLines lines = scene_lines(options);
  require_sense(lines, "critical lines are");
  write_events(lines, *simulation_of(std::get<ValidScene2>(std::move(scene))).prepared(streams.stages()), streams);
  return ExitCode::kDone;
}

ExitCode graph(const VisibilityOptions& options, Streams& streams) {
  const SceneLines lines = scene_lines(options);
  require_sense(lines, "the visibility graph is");
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (auto* const there = std::get_if<ValidScene3>(&scene))
    write_graph_3(lines, Simulation3(std::move(*there)), streams);
  else
    write_graph(lines, *simulation_of(std::get<ValidScene2>(std::move(scene))).prepared(streams.stages()), streams);
  return ExitCode::kDone;
}

constexpr int kLinesOfAPart = 6;

// A long answer with the beginning of each of its parts, which blank lines divide: who wants all of it leaves out the
// drawing.
std::string shortened(const std::string& text) {
  std::string result;
  std::size_t left_out = 0;
  int in_part = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    in_part = end - begin == 1 ? 0 : in_part + 1;
    if (in_part <= kLinesOfAPart)
      result += text.substr(begin, end - begin);
    else if (++left_out; in_part == kLinesOfAPart + 1)
      result += "  ...\n";
    begin = end;
  }
  if (left_out == 0) return text;
  return result + counted(left_out, "line") +
         " left out: without -o, or with --json, the whole answer is on standard output\n";
}

// The answer goes where it is asked for, the drawing into its file.
ExitCode show(const ShownAnswer& shown, const VisibilityOptions& options, std::optional<PictureFormat> format,
              Streams& streams) {
  std::optional<OutputFile> drawing;
  if (format) {
    drawing.emplace(options.out);
    drawing->write(shown.draw(*format));
    drawing->finish();
  }
  if (options.json)
    streams.write("", shown.answer.json);
  else if (format)
    streams.note(shortened(shown.answer.text));
  else
    streams.write("", shown.answer.text);
  if (drawing) drawing->commit();
  return ExitCode::kDone;
}

constexpr const char* kWhereNoIrradiance = "--no-irradiance goes with --at X,Y in the plane";

ExitCode in_space(const VisibilityOptions& options, ValidScene3 scene, std::optional<PictureFormat> format,
                  Streams& streams) {
  const bool proves = options.guarantee.must_be_enclosed();
  if (options.no_irradiance) throw UsageError(kWhereNoIrradiance);
  if (!options.is_pair())
    return show(visibility_in_space(scene, options.at, options.on, proves), options, format, streams);
  if (format) throw UsageError("-o draws a pair of faces in the plane; this version does not in space");
  const Simulation3 simulation(std::move(scene));
  return show({pair_in_space(simulation, options.from, options.to, proves), {}}, options, format, streams);
}

ExitCode visibility(const VisibilityOptions& options, Streams& streams) {
  if (options.polygons.triangulates && !options.edge.empty())
    throw UsageError("--triangulate cuts polygons in space; --edge is for the plane");
  if (!options.points.empty()) return from_points(options, streams);
  if (options.no_irradiance && (options.at.empty() || !options.on.empty())) throw UsageError(kWhereNoIrradiance);
  if (!options.edge.empty()) return from_edge(options, streams);
  if (!options.face.empty()) return from_face_in_space(options, streams);
  if (options.events) return events(options, streams);
  if (options.graph) return graph(options, streams);
  if (options.exact) throw UsageError("--exact goes with --points, --events or --graph");
  require_sense(options);
  const bool is_drawn = is_file(options.out);
  const auto format = is_drawn ? picture_format(options.out) : std::nullopt;
  if (is_drawn && !format) throw UsageError("a drawing is written as .png, .svg or .pdf, not '" + options.out + "'");
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (options.is_pair()) note_unknown_unit(scene, streams);
  if (auto* const there = std::get_if<ValidScene3>(&scene))
    return in_space(options, std::move(*there), format, streams);
  options.guarantee.refuse_in_plane();
  const Simulation2 simulation = simulation_of(std::get<ValidScene2>(std::move(scene)));
  return show(visibility_in_plane({.at = options.at,
                                   .on = options.on,
                                   .from = options.from,
                                   .to = options.to,
                                   .has_no_irradiance = options.no_irradiance,
                                   .is_drawn = format.has_value()},
                                  simulation, streams),
              options, format, streams);
}

}  // namespace

void add_visibility(Commands& commands) {
  const auto options = std::make_shared<VisibilityOptions>();
  CLI::App& command = commands.add(
      "visibility",
      "What points see, what a point of a face sees, what two faces see of each other, critical lines, "
      "which vertices see each other",
      {"hottel visibility scenes/analytic/triangle_345.json --at 1,1",
       "hottel visibility scenes/analytic/triangle_345.json --on three --at 1/2",
       "hottel visibility scenes/analytic/strip_obstructed.json --from bottom --to top --json",
       "hottel visibility scenes/showcase/apartment.json --at 4,3 -o /tmp/seen.png",
       "echo 4,3 | hottel visibility scenes/showcase/apartment.json --points - --range 5 -o /tmp/seen.geojson",
       "printf 'x,y,z,nx,ny,nz\\n1,1,1.5,0,0,1\\n' | hottel visibility scenes/space/two_boxes.json --points -",
       "printf '1,1,1.5\\n2,2,3\\n' | hottel visibility scenes/space/two_boxes.json --points -",
       "hottel visibility scenes/space/two_boxes.json --at 1,1,1 -o /tmp/map.png",
       "hottel visibility scenes/space/two_boxes.json --from lamp --to floor",
       "hottel visibility scenes/analytic/strip_obstructed.json --edge bottom",
       "hottel visibility scenes/analytic/strip_obstructed.json --events",
       "hottel visibility scenes/space/two_boxes.json --face lamp",
       "hottel visibility scenes/space/two_boxes.json --events --from lamp --to floor -o /tmp/events.vtp",
       "hottel visibility scenes/showcase/apartment.json --graph -o /tmp/graph.csv"},
      [options](Streams& streams) { return visibility(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  CLI::Option* at = command.add_option("--at", options->at,
                                       "a point X,Y, or with --on a position T from 0 to 1 (numbers may be p/q); in "
                                       "space X,Y,Z, or with --on S,T along the first and the last side");
  CLI::Option* on = command.add_option("--on", options->on, "a face: view factors from its point --at T");
  on->type_name("NAME");
  CLI::Option* from =
      command.add_option("--from", options->from,
                         "a face, or sky; with --to: their exchange, and the critical points on it; in space "
                         "the stretches of lines along which it is measured");
  from->type_name("A");
  CLI::Option* to = command.add_option("--to", options->to, "the other face, or sky");
  to->type_name("B");
  CLI::Option* json = command.add_flag("--json", options->json, "the answer as one JSON object");
  options->polygons.add_to(command);
  CLI::Option* points = command.add_option(
      "--points", options->points,
      "points, one visibility polygon each: csv of lines x,y, GeoJSON or well-known text; - is standard input. In "
      "space lines x,y,z: the faces that each sees, with their solid angles, as .csv, .npz or .vtu. Of a csv with "
      "normals (first line x,y,nx,ny, in space x,y,z,nx,ny,nz) the irradiance, sky view factor and mean radiant "
      "temperature at each, as csv");
  points->type_name("FILE");
  points->excludes(at)->excludes(on)->excludes(from)->excludes(to)->excludes(json);
  command.add_option("--range", options->range, "with --points: nothing beyond this distance of the point")
      ->type_name("R")
      ->needs(points);
  command
      .add_option("--side", options->side,
                  "with --points: front, a point on an outline sees what its front sees; both (default), all around")
      ->check(CLI::IsMember({"front", "both"}))
      ->needs(points);
  CLI::Option* exact =
      command.add_flag("--exact", options->exact, "with --points, --events or --graph: coordinates as p/q");
  exact->excludes("--range");
  command
      .add_flag("--irradiance", options->irradiance,
                "with --points: the mean irradiance at each, for which the scene is solved")
      ->needs(points);
  command.add_flag("--no-irradiance", options->no_irradiance,
                   "with --at X,Y in the plane: without the mean irradiance, for which the whole scene is solved");
  command
      .add_flag(
          "--pieces", options->pieces,
          "with --points in space to a .npz: of each face the pieces that are seen of it (a .vtu always has them)")
      ->needs(points);
  CLI::Option* edge = command.add_option("--edge", options->edge, "a face: what some point of it sees");
  edge->type_name("NAME");
  CLI::Option* face =
      command.add_option("--face", options->face, "in space, a face: which faces some point of it sees");
  face->type_name("NAME");
  CLI::Option* events = command.add_flag(
      "--events", options->events,
      "the critical lines of the scene; in space with --from A and --to B the surfaces of lines along which what these "
      "see of each other changes, by some of their lines: csv, with -o also .vtp, or drawn where they meet B");
  CLI::Option* graph = command.add_flag("--graph", options->graph, "all pairs of vertices that see each other");
  CLI::Option* guarantee = options->guarantee.add_to(command, "what a point sees has proven bounds; ");
  for (CLI::Option* other : {edge, face, events, graph}) guarantee->excludes(other);
  for (CLI::Option* other : {at, on, from, to, points}) {
    edge->excludes(other);
    face->excludes(other);
    graph->excludes(other);
  }
  events->excludes(at)->excludes(on)->excludes(points)->excludes(graph);
  edge->excludes(events)->excludes(exact)->excludes(graph);
  face->excludes(events)->excludes(exact)->excludes(graph)->excludes(edge);
  command
      .add_option("-o", options->out,
                  "draw it: .png, .svg or .pdf; the answer in short is on stderr then. With --points the polygons: "
                  ".csv, .geojson, .wkt or .npz, in space .csv, .npz or .vtu; with --events and --graph a .csv, with "
                  "--events in space also a .vtp "
                  "or a drawing. "
                  "Without it, or with -, the answer "
                  "is on standard "
                  "output")
      ->type_name("FILE");
}

}  // namespace hottel

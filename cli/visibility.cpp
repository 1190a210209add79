// hottel visibility: what a point sees, what a point of a face receives, what two faces see of each other.
#include <functional>
#include <optional>

#include "cli/command.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_sight.h"
#include "io/results/plane/visibility_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/solved_light.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/picture/plane/visibility_picture.h"

namespace hottel {
namespace {

struct VisibilityOptions {
  std::string scene, at, on, from, to, out;
  bool json = false;

  bool is_pair() const { return !from.empty() || !to.empty(); }
};

Rational number(const std::string& text, const std::string& option) {
  const auto value = parse_rational(text);
  if (!value) throw UsageError(option + " takes numbers such as 0.25 or 1/3, not '" + text + "'");
  return *value;
}

Point2 point(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    throw UsageError("--at takes X,Y in a plane scene (and a number t in [0,1] with --on), not '" + text + "'");
  return {number(text.substr(0, comma), "--at"), number(text.substr(comma + 1), "--at")};
}

// What is answered, and a drawing of it on demand.
struct Shown {
  VisibilityAnswer answer;
  std::function<std::string(PictureFormat)> draw;
};

Shown from_point(const PreparedScene2& prepared, const Point2& eye) {
  const PointSight2 sight = point_sight(prepared, eye);
  std::optional<PointLight2> light;
  if (sight.polygon.solid == Solids2::kNone) light = light_at(prepared, sight.polygon);
  return {point_answer(prepared, sight, light), [&prepared, polygon = sight.polygon](PictureFormat format) {
            return visibility_picture_2(prepared, drawing_of(polygon), format);
          }};
}

Shown from_face(const PreparedScene2& prepared, const std::string& name, const Rational& t) {
  if (t < 0 || t > 1) throw UsageError("--at is a position on the edge, between 0 and 1, not " + to_string(t));
  if (name == "sky") throw UsageError("--on is a face, which the sky is not");
  const Face face = face_of(prepared.scene, name);
  require_free_at(prepared, face, t);
  return {face_point_answer(prepared, name, face, t, point_factors_by_face(prepared, face, t)),
          [&prepared, face, t](PictureFormat format) {
            const Point2 eye = point_at(prepared.scene.edges[face.surface], t);
            return visibility_picture_2(prepared, drawing_of(point_sight(prepared, eye).polygon), format);
          }};
}

// A face of --from or --to by name; nothing for the sky.
std::optional<Face> face_or_sky(const Scene2& scene, const std::string& name) {
  if (name == "sky") return std::nullopt;
  return face_of(scene, name);
}

Shown between_faces(const PreparedScene2& prepared, const std::string& from, const std::string& to) {
  PairSight2 sight{from, to, face_or_sky(prepared.scene, from), face_or_sky(prepared.scene, to), {}, {}};
  for (const auto& face : {sight.face_from, sight.face_to})
    if (face) require_free(prepared, *face);
  sight.pair = exact_pair(prepared, sight.face_from, sight.face_to);
  if (const auto& a = sight.face_from) {
    const auto& b = sight.face_to;
    sight.critical = critical_points(prepared.arrangement, prepared.scene, *a, b);
  }
  VisibilityAnswer answer = pair_answer(sight);
  return {std::move(answer), [&prepared, drawing = drawing_of(sight)](PictureFormat format) {
            return pair_picture_2(prepared, drawing, format);
          }};
}

// What CLI11 does not see.
void require_sense(const VisibilityOptions& options) {
  if (options.is_pair() && (options.from.empty() || options.to.empty() || !options.at.empty() || !options.on.empty()))
    throw UsageError("--from A and --to B go together, without --at and --on");
  if (!options.is_pair() && options.at.empty())
    throw UsageError("visibility needs --at X,Y or --on NAME --at T or --from A --to B");
  if (options.from == "sky" && options.to == "sky")
    throw UsageError("--from or --to is a face: the sky exchanges nothing with itself");
}

ExitCode visibility(const VisibilityOptions& options, Streams& streams) {
  require_sense(options);
  const bool is_drawn = !options.out.empty() && options.out != "-";
  const auto format = is_drawn ? picture_format(options.out) : std::nullopt;
  if (is_drawn && !format) throw UsageError("a drawing is written as .svg or .png, not '" + options.out + "'");
  const std::optional<Point2> eye =
      options.is_pair() || !options.on.empty() ? std::nullopt : std::optional(point(options.at));
  const Rational t = options.on.empty() ? Rational(0) : number(options.at, "--at with --on");

  const PreparedScene2 prepared = prepare(read_scene_2(options.scene));
  if (format) require_drawable(prepared.scene);
  if (format && eye) require_drawable(prepared.scene, *eye, options.at);
  const Shown shown = options.is_pair()     ? between_faces(prepared, options.from, options.to)
                      : !options.on.empty() ? from_face(prepared, options.on, t)
                                            : from_point(prepared, *eye);
  std::optional<OutputFile> drawing;
  if (format) {
    drawing.emplace(options.out);
    drawing->write(shown.draw(*format));
    drawing->finish();
  }
  if (options.json)
    streams.write("", shown.answer.json);
  else if (format)
    streams.note(shown.answer.text);
  else
    streams.write("", shown.answer.text);
  if (drawing) drawing->commit();
  return ExitCode::kDone;
}

}  // namespace

void add_visibility(Commands& commands) {
  const auto options = std::make_shared<VisibilityOptions>();
  CLI::App& command =
      commands.add("visibility", "What a point sees, what a point of a face sees, what two faces see of each other",
                   {"hottel visibility scenes/analytic/triangle_345.json --at 1,1",
                    "hottel visibility scenes/analytic/triangle_345.json --on three --at 1/2",
                    "hottel visibility scenes/analytic/strip_obstructed.json --from bottom --to top --json",
                    "hottel visibility scenes/showcase/apartment.json --at 4,3 -o /tmp/seen.png"},
                   [options](Streams& streams) { return visibility(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("--at", options->at, "a point X,Y, or with --on a position T from 0 to 1 (numbers may be p/q)");
  command.add_option("--on", options->on, "a face: view factors from its point --at T")->type_name("NAME");
  command
      .add_option("--from", options->from, "a face, or sky; with --to: their exchange and the critical points on it")
      ->type_name("A");
  command.add_option("--to", options->to, "the other face, or sky")->type_name("B");
  command.add_flag("--json", options->json, "the answer as one JSON object");
  command
      .add_option("-o", options->out,
                  "draw it: .svg or .png; the answer in words is a remark then, on stderr. Without it, or with -, the "
                  "answer is on standard output")
      ->type_name("FILE");
}

}  // namespace hottel

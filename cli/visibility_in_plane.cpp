#include "cli/visibility_in_plane.h"

#include <optional>
#include <utility>
#include <vector>

#include "cli/scene_input.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "geometry/scene_names.h"
#include "io/results/plane/visibility_report.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/queries.h"
#include "solver/plane/simulation/simulation.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/picture/plane/visibility_picture.h"

namespace hottel {
namespace {

Point2 point(const std::string& text) {
  const std::vector<std::string> parts = parts_at_commas(text);
  if (parts.size() != 2)
    throw UsageError("--at takes X,Y in a plane scene (and a number t in [0,1] with --on), not '" + text + "'");
  return {number_of(parts[0], "--at"), number_of(parts[1], "--at")};
}

// Light at one point is that of the whole scene, solved.
PointLight2 light_unless_left_out(const SightRequest2& asked, const Simulation2& simulation,
                                  const VisibilityPolygon2& polygon, const Streams& streams) {
  if (asked.has_no_irradiance) return {{}, {}, "--no-irradiance leaves it out"};
  return light_at(simulation, polygon, streams.stages());
}

ShownAnswer from_point(const SightRequest2& asked, const Simulation2& simulation, const PreparedScene2& prepared,
                       const Point2& eye, const Streams& streams) {
  const PointView2 sight = point_view(prepared, eye);
  std::optional<PointLight2> light;
  if (sight.polygon.solid == Solids2::kNone) light = light_unless_left_out(asked, simulation, sight.polygon, streams);
  return {point_answer(prepared, sight, light), [&prepared, polygon = sight.polygon](PictureFormat format) {
            return visibility_picture_2(prepared, drawing_of(polygon), format);
          }};
}

ShownAnswer from_face(const PreparedScene2& prepared, const std::string& name, const Rational& t) {
  if (t < 0 || t > 1) throw UsageError("--at is a position on the edge, between 0 and 1, not " + to_string(t));
  if (name == "sky") throw UsageError("--on is a face, which the sky is not");
  const Face face = face_of(prepared.scene, name);
  require_free_at(prepared, face, t);
  return {face_point_answer(prepared, name, face, t, point_factors_by_face(prepared, face, t)),
          [&prepared, face, t](PictureFormat format) {
            const Point2 eye = point_at(prepared.scene.edges[face.surface], t);
            return visibility_picture_2(prepared, drawing_of(point_view(prepared, eye).polygon), format);
          }};
}

// A face of --from or --to by name; nothing for the sky.
std::optional<Face> face_or_sky(const Scene2& scene, const std::string& name) {
  if (name == "sky") return std::nullopt;
  return face_of(scene, name);
}

ShownAnswer between_faces(const PreparedScene2& prepared, const std::string& from, const std::string& to) {
  PairSight2 sight{
      from, to, face_or_sky(prepared.scene, from), face_or_sky(prepared.scene, to), {}, {}, prepared.scene.unit};
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

}  // namespace

ShownAnswer visibility_in_plane(const SightRequest2& asked, const Simulation2& simulation, const Streams& streams) {
  const bool is_pair = !asked.from.empty(), is_of_face = !asked.on.empty();
  const std::optional<Point2> eye = is_pair || is_of_face ? std::nullopt : std::optional(point(asked.at));
  const Rational t = is_of_face ? number_of(asked.at, "--at with --on") : Rational(0);
  const PreparedScene2& prepared = *simulation.prepared(streams.stages());
  if (asked.is_drawn) require_drawable(prepared.scene);
  if (asked.is_drawn && eye) require_drawable(prepared.scene, *eye, asked.at);
  if (is_pair) return between_faces(prepared, asked.from, asked.to);
  if (is_of_face) return from_face(prepared, asked.on, t);
  return from_point(asked, simulation, prepared, *eye, streams);
}

}  // namespace hottel

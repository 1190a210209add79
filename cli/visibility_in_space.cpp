#include "cli/visibility_in_space.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "cli/scene_input.h"
#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/exchange/exact_form.h"
#include "geometry/space/exchange/pair_report.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/point_bounds.h"
#include "geometry/space/visibility/seen_faces.h"
#include "geometry/space/visibility/visibility_map.h"
#include "io/results/space/map_report.h"
#include "io/results/space/pair_answer.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/map_picture.h"

namespace hottel {
namespace {

// The facet of a polygon that has a point, or nothing.
std::optional<Polygon3> facet_at(const Polygon3& polygon, const Point3& point) {
  for (Polygon3& facet : facets_of(polygon))
    if (contains(facet, point)) return std::move(facet);
  return std::nullopt;
}

// Moves a point along the normal of a polygon onto that of its facets which it meets so.
void put_on_facet(const Polygon3& polygon, Point3& point) {
  const Vector3 normal = doubled_area(polygon);
  for (const Polygon3& facet : facets_of(polygon)) {
    const Vector3 own = doubled_area(facet);
    const Rational t = dot(own, facet.points[0] - point) / dot(own, normal);
    const Point3 at{point.x + t * normal.x, point.y + t * normal.y, point.z + t * normal.z};
    if (!contains(facet, at)) continue;
    point = at;
    return;
  }
}

// The point of a face, and the normal of the side it is on.
Look3 look_from(const Scene3& scene, const std::string& text, const std::string& on) {
  std::vector<Rational> at;
  for (const std::string& part : parts_at_commas(text)) at.push_back(number_of(part, "--at"));
  if (on.empty()) {
    if (at.size() != 3) throw UsageError("--at takes X,Y,Z in space, not '" + text + "'");
    return {.eye = {at[0], at[1], at[2]}, .normal = {}};
  }
  if (on == "sky") throw UsageError("--on is a face, which the sky is not");
  if (at.size() != 2 && at.size() != 3) throw UsageError("--at takes S,T or X,Y,Z with --on, not '" + text + "'");
  const Face face = face_of(scene, on);
  const Polygon3& polygon = scene.polygons[face.surface];
  Point3 eye;
  if (at.size() == 3) {
    eye = {at[0], at[1], at[2]};
  } else {
    const Point3& first = polygon.points.front();
    const Vector3 along = polygon.points[1] - first, across = polygon.points.back() - first;
    eye = {first.x + at[0] * along.x + at[1] * across.x, first.y + at[0] * along.y + at[1] * across.y,
           first.z + at[0] * along.z + at[1] * across.z};
  }
  if (polygon.is_nearly_plane && at.size() == 2) put_on_facet(polygon, eye);
  const std::optional<Polygon3> facet = facet_at(polygon, eye);
  if (!facet)
    throw UsageError(
        "--at " + text + " is no point of '" + on + "'" +
        (at.size() == 3 ? "" : ": it is " + place_text(eye) + ", S along the first side, T along the last"));
  Vector3 normal = doubled_area(*facet);
  if (face.is_back) normal = {-normal.x, -normal.y, -normal.z};
  return {.eye = std::move(eye), .normal = Point3{normal.x, normal.y, normal.z}};
}

// Whether a point of a polygon's plane lies on what a side of a piece has for its face.
bool has_place(const Piece3& piece, bool is_back, const Point3& eye) {
  const Piece3::Side& side = piece.side(is_back);
  if (side.cover == Piece3::Cover::kFree) return contains(piece.polygon, eye);
  return std::any_of(side.free.begin(), side.free.end(),
                     [&](const Polygon3& polygon) { return contains(polygon, eye); });
}

// The surface that has the side of a plane at a point of one that lies there, where that has not.
std::optional<std::uint32_t> owner_at(const Arrangement3& arrangement, std::uint32_t surface, const Look3& look) {
  for (const std::uint32_t p : arrangement.pieces_on(surface)) {
    const Piece3& piece = arrangement.pieces()[p];
    const bool is_back = dot(doubled_area(piece.polygon), *look.normal - Point3{}) < 0;
    const std::uint32_t owner = piece.side(is_back).owner.surface;
    if (owner != surface && has_place(piece, is_back, look.eye)) return owner;
  }
  return std::nullopt;
}

// A place of a face from which nothing of the scene is seen as from that face: in a solid, or another one's.
void refuse_lost_place(const Scene3& scene, const Arrangement3& arrangement, const std::string& at,
                       const std::string& on, const Look3& look) {
  const Face face = face_of(scene, on);
  const auto sides = arrangement.sides(face);
  if (std::any_of(sides.begin(), sides.end(), [&](const PieceSide3& side) {
        return has_place(arrangement.pieces()[side.piece], side.is_back, look.eye);
      }))
    return;
  for (const Mask3& mask : scene.masks)
    if (!face.is_back && (face.surface == mask.surface || face.surface == mask.base) &&
        contains(scene.polygons[mask.surface], look.eye)) {
      const std::uint32_t other = face.surface == mask.surface ? mask.base : mask.surface;
      throw RequestError("'" + on + "' at " + at + " lies on '" + scene.surfaces[other].name +
                         "' and sees nothing else");
    }
  const std::optional<Polygon3> facet = facet_at(scene.polygons[face.surface], look.eye);
  const PlaneFrame3 frame(facet->points);
  const bool is_up = frame.is_front_up(facet->points) != face.is_back;
  if (const auto mesh = arrangement.solids().behind({&frame, frame.flat(look.eye), is_up}))
    throw RequestError("'" + on + "' at " + at + " looks into the solid '" + arrangement.solids().meshes()[*mesh].name +
                       "'");
  if (const auto owner = owner_at(arrangement, face.surface, look))
    throw RequestError("'" + on + "' at " + at + " is the place of " + (scene.surfaces[*owner].on ? "the patch " : "") +
                       quoted_name(scene.surfaces[*owner].name));
  throw RequestError("'" + on + "' at " + at + " is the place of another surface");
}

// What is seen, by faces, and where that is asked for its proven bounds.
struct SeenFrom3 {
  VisibilityMap3 map;
  std::optional<PointBounds3> bounds;
};

SeenFrom3 seen_from(const Look3& look, const Arrangement3& arrangement, bool proves) {
  const Occluders3 occluders(arrangement.polygons());
  if (look.normal) {
    SeenFrom3 seen{with_owners(map_from(occluders, look), arrangement), {}};
    if (proves)
      seen.bounds = point_bounds(ExactVisibilityMap3(occluders, look.eye), arrangement, *look.normal - Point3{});
    return seen;
  }
  if (!proves) return {faces_seen_from(look.eye, occluders, arrangement), {}};
  const ExactVisibilityMap3 exact(occluders, look.eye);
  return {faces_seen_from(look.eye, exact.map(), arrangement), point_bounds(exact, arrangement)};
}

}  // namespace

ShownAnswer visibility_in_space(const Scene3& scene, const std::string& at, const std::string& on, bool proves) {
  const Look3 look = look_from(scene, at, on);
  const Arrangement3 arrangement(scene);
  if (!on.empty()) refuse_lost_place(scene, arrangement, at, on, look);
  const std::string what = on.empty() ? "(" + at + ")" : "'" + on + "' at (" + at + ")";
  const Solids3& solids = arrangement.solids();
  const std::optional<std::uint32_t> solid = on.empty() ? solids.around(look.eye) : std::nullopt;
  SeenFrom3 seen;
  if (!solid) seen = seen_from(look, arrangement, proves);
  VisibilityAnswer answer =
      solid ? answer_in_solid_3(look, solids.meshes()[*solid].name, what)
            : map_answer(scene, solids, look, seen.map, what, seen.bounds ? &*seen.bounds : nullptr);
  return {std::move(answer), [&scene, look, what, map = std::move(seen.map)](PictureFormat format) {
            MapDrawing3 drawing = drawing_of(scene, look, map);
            drawing.title = "What is seen from " + what;
            return map_picture_3(drawing, format);
          }};
}

VisibilityAnswer pair_in_space(const Simulation3& simulation, const std::string& from, const std::string& to,
                               bool proves) {
  const Scene3& scene = simulation.scene();
  const auto face_or_sky = [&scene](const std::string& name) {
    return name == "sky" ? std::nullopt : std::optional(face_of(scene, name));
  };
  const std::optional<Face> face_from = face_or_sky(from), face_to = face_or_sky(to);
  return with_file_context(scene.file, [&] {
    const double tolerance = simulation.request().factors.tolerance;
    const PairReport3 report = pair_report(*simulation.prepared(), face_from, face_to, tolerance, proves);
    if (proves && !report.is_enclosed())
      throw RequestError("the pair has no enclosure within " + shortest(tolerance) + ": " + quoted_name(from) +
                         " and " + quoted_name(to));
    std::string form;
    if (face_from && face_to)
      if (const ExactForm3 exact = exact_form_3(*simulation.prepared(), *face_from, *face_to); exact.exchange)
        form = exact.exchange->to_string();
    return pair_answer(scene, from, to, report, form);
  });
}

}  // namespace hottel

#include "cli/visibility_in_space.h"

#include <optional>
#include <vector>

#include "geometry/scene_names.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/point_map.h"
#include "io/results/space/map_report.h"
#include "kernel/support/failure.h"
#include "viewer/picture/space/map_picture.h"

namespace hottel {
namespace {

// The numbers of --at.
std::vector<Rational> numbers(const std::string& text) {
  std::vector<Rational> result;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto value = parse_rational(text.substr(begin, end - begin));
    if (!value) throw UsageError("--at takes numbers such as 0.25 or 1/3 with commas, not '" + text + "'");
    result.push_back(*value);
    begin = end + 1;
  }
  return result;
}

// Whether a point of the plane of a polygon lies in it or on its border.
bool contains(const Polygon3& polygon, const Vector3& normal, const Point3& point) {
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point3 &a = polygon.points[k], &b = polygon.points[(k + 1) % n];
    if (dot(normal, cross(b - a, point - a)) < 0) return false;
  }
  return true;
}

// The point of a face, and the normal of the side it is on.
Look3 look_from(const Scene3& scene, const SpaceSightOptions& options) {
  const std::vector<Rational> at = numbers(options.at);
  if (options.on.empty()) {
    if (at.size() != 3) throw UsageError("--at takes X,Y,Z in space, not '" + options.at + "'");
    return {.eye = {at[0], at[1], at[2]}, .normal = {}};
  }
  if (options.on == "sky") throw UsageError("--on is a face, which the sky is not");
  if (at.size() != 2 && at.size() != 3) throw UsageError("--at takes S,T or X,Y,Z with --on, not '" + options.at + "'");
  const Face face = face_of(scene, options.on);
  const Polygon3& polygon = scene.polygons[face.surface];
  Vector3 normal = doubled_area(polygon);
  Point3 eye;
  if (at.size() == 3) {
    eye = {at[0], at[1], at[2]};
  } else {
    const Point3& first = polygon.points.front();
    const Vector3 along = polygon.points[1] - first, across = polygon.points.back() - first;
    eye = {first.x + at[0] * along.x + at[1] * across.x, first.y + at[0] * along.y + at[1] * across.y,
           first.z + at[0] * along.z + at[1] * across.z};
  }
  if (dot(normal, eye - polygon.points.front()) != 0 || !contains(polygon, normal, eye))
    throw UsageError("--at " + options.at + " is no point of '" + options.on + "'");
  if (face.is_back) normal = {-normal.x, -normal.y, -normal.z};
  return {.eye = std::move(eye), .normal = Point3{normal.x, normal.y, normal.z}};
}

}  // namespace

ExitCode visibility_in_space(const Scene3& scene, const SpaceSightOptions& options, Streams& streams) {
  const bool is_drawn = !options.out.empty() && options.out != "-";
  const auto format = is_drawn ? picture_format(options.out) : std::nullopt;
  if (is_drawn && !format) throw UsageError("a drawing is written as .svg or .png, not '" + options.out + "'");
  const Look3 look = look_from(scene, options);
  std::vector<std::vector<Point3>> polygons;
  for (const Polygon3& polygon : scene.polygons) polygons.push_back(polygon.points);
  const PointMap3 map = map_from(Blockers3(polygons), look);
  const std::string what = options.on.empty() ? "(" + options.at + ")" : "'" + options.on + "' at (" + options.at + ")";
  const VisibilityAnswer answer = map_answer(scene, look, map, what);
  std::optional<OutputFile> drawing;
  if (format) {
    MapDrawing3 drawn = drawing_of(scene, look, map);
    drawn.title = "What is seen from " + what;
    drawing.emplace(options.out);
    drawing->write(map_picture_3(drawn, *format));
    drawing->finish();
  }
  if (options.json)
    streams.write("", answer.json);
  else if (format)
    streams.note(answer.text);
  else
    streams.write("", answer.text);
  if (drawing) drawing->commit();
  return ExitCode::kDone;
}

}  // namespace hottel

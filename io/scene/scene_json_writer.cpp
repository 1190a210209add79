#include <fmt/format.h>

#include <string>
#include <vector>

#include "geometry/planarity.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/scene/polyline_runs.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/scene_json.h"
#include "io/scene/table_writer.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::string point(const Point2& p) { return fmt::format("[{}, {}]", json_number(p.x), json_number(p.y)); }

std::string triple(const Rational& x, const Rational& y, const Rational& z) {
  return fmt::format("[{}, {}, {}]", json_number(x), json_number(y), json_number(z));
}

std::string path_text(const std::string& points, const Rational& seconds, bool closed) {
  return fmt::format(", \"path\": {{\"points\": {}], \"seconds\": {}{}}}", points, json_number(seconds),
                     closed ? ", \"closed\": true" : "");
}

std::string entry(const Scene2& scene, const std::string& name, const std::string& points, bool closed,
                  const Surface& surface) {
  return fmt::format("{{\"name\": {}, \"points\": {}{}, {}}}", json_string(name), points,
                     closed ? ", \"closed\": true" : "", surface_members(scene, surface));
}

// Writes the surfaces before the final polylines as edges; returns where those begin.
std::size_t write_edges(const Scene2& scene, std::string& out) {
  const std::vector<Surface>& s = scene.surfaces;
  const std::vector<Edge2>& e = scene.edges;
  const std::size_t first_polyline = first_of_polylines(scene);
  if (first_polyline == 0) return 0;
  JsonBlock block(out, "edges", '[', ']');
  for (std::size_t i = 0; i < first_polyline; ++i)
    block.add(entry(scene, s[i].name, fmt::format("[{}, {}]", point(e[i].from), point(e[i].to)), false, s[i]));
  block.end();
  return first_polyline;
}

void write_polylines(const Scene2& scene, std::size_t first, std::string& out) {
  const std::vector<Surface>& s = scene.surfaces;
  const std::vector<Edge2>& e = scene.edges;
  if (first == s.size()) return;
  JsonBlock block(out, "polylines", '[', ']');
  while (first < s.size()) {
    const std::size_t end = end_of_polyline(scene, first);
    const bool closed = end - first > 1 && e[end - 1].to == e[first].from;
    std::string points = fmt::format("[{}", point(e[first].from));
    for (std::size_t i = first; i + (closed ? 1 : 0) < end; ++i) points += fmt::format(", {}", point(e[i].to));
    block.add(entry(scene, scene.groups[s[first].group].name, points + "]", closed, s[first]));
    first = end;
  }
  block.end();
}

std::string light_members(const Light& light, const LightPlace2& place) {
  std::string text;
  if (!light.is_sun()) text += fmt::format("\"position\": {}", point(place.position));
  if (light.type != LightType::kPoint)
    text += fmt::format("{}\"direction\": {}", text.empty() ? "" : ", ",
                        point(place.turned == 0 ? place.direction : turned_direction(place)));
  if (place.rotation != 0) text += fmt::format(", \"rotation\": {}", json_number(place.rotation));
  if (!place.path) return text;
  std::string points;
  for (const Point2& p : place.path->points) points += (points.empty() ? "[" : ", ") + point(p);
  return text + path_text(points, place.path->seconds, place.path->closed);
}

// Writes corners so that polygons that are nearly plane stay so when they are read back: that depends on the finest
// decimal digit of all corners, and so what has finer ones than they have is a fraction, which has none.
class CornerWriter3 {
 public:
  explicit CornerWriter3(const Scene3& scene) {
    FinestDigit finest;
    for (const Polygon3& polygon : scene.polygons)
      if (polygon.is_nearly_plane && polygon.facets.empty())
        for (const Point3& p : corners_of(polygon))
          for (const Rational& x : {p.x, p.y, p.z}) finest.take(digits(x));
    unit_ = finest.unit();
  }

  std::string text(const std::vector<Point3>& points) const {
    std::string text;
    for (const Point3& p : points)
      text += fmt::format("{}[{}, {}, {}]", text.empty() ? "[" : ", ", number(p.x), number(p.y), number(p.z));
    return text + "]";
  }

 private:
  // As json_number, without quotes.
  static std::string digits(const Rational& x) {
    std::string text = json_number(x);
    std::erase(text, '"');
    return text;
  }
  std::string number(const Rational& x) const {
    if (unit_ == 0 || x.get_den() == 1) return json_number(x);
    FinestDigit own;
    own.take(digits(x));
    return own.unit() == 0 || own.unit() >= unit_ ? json_number(x) : fmt::format("\"{}\"", to_string(x));
  }

  Rational unit_;
};

std::string light_members(const Light& light, const LightPlace3& place) {
  const Point3& at = place.position;
  const Vector3 &along = place.direction, &turn = place.rotation;
  std::string text;
  if (!light.is_sun()) text += fmt::format("\"position\": {}", triple(at.x, at.y, at.z));
  if (light.type != LightType::kPoint)
    text += fmt::format("{}\"direction\": {}", text.empty() ? "" : ", ", triple(along.x, along.y, along.z));
  if (!turn.is_zero()) text += fmt::format(", \"rotation\": {}", triple(turn.x, turn.y, turn.z));
  if (!place.path) return text;
  std::string points;
  for (const Point3& p : place.path->points) points += (points.empty() ? "[" : ", ") + triple(p.x, p.y, p.z);
  return text + path_text(points, place.path->seconds, place.path->closed);
}

template <class Scene>
void write_lights_of(const Scene& scene, std::string& out) {
  write_lights(
      scene, [&](std::size_t k) { return light_members(scene.lights[k], scene.light_places[k]); }, out);
}

void write_polygons(const Scene3& scene, std::string& out) {
  if (scene.polygons.empty()) return;
  const std::vector<std::size_t> members = group_sizes(scene);
  const CornerWriter3 corners(scene);
  auto mask = scene.masks.begin();
  JsonBlock block(out, "polygons", '[', ']');
  for (std::size_t s = 0; s < scene.polygons.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    const Group& group = scene.groups[surface.group];
    std::string holes;
    for (const auto& hole : scene.polygons[s].holes) holes += (holes.empty() ? "" : ", ") + corners.text(hole);
    std::string masks;
    if (mask != scene.masks.end() && mask->surface == s)
      masks = fmt::format(", \"masks\": {}", json_string(scene.surfaces[(mask++)->base].name));
    const bool is_alone = members[surface.group] == 1 && group.name == surface.name && group.body.empty() &&
                          group.behind == Behind::kByOutline;
    block.add(fmt::format(
        "{{\"name\": {}, {}\"points\": {}, {}{}{}}}", json_string(surface.name),
        is_alone ? "" : fmt::format("\"group\": {}, ", json_string(group.name)), corners.text(scene.polygons[s].points),
        holes.empty() ? "" : fmt::format("\"holes\": [{}], ", holes), surface_members(scene, surface), masks));
  }
  block.end();
}

void write_camera(const Camera3& camera, std::string& out) {
  out += fmt::format(
      ",\n  \"camera\": {{\"eye\": {}, \"target\": {}, \"up\": {}, \"field_of_view\": {}, \"pixels\": [{}, {}]}}",
      triple(camera.eye.x, camera.eye.y, camera.eye.z), triple(camera.target.x, camera.target.y, camera.target.z),
      triple(camera.up.x, camera.up.y, camera.up.z), json_number(camera.field_of_view), camera.width, camera.height);
}

std::string grid_members(const Grid3& grid) {
  const std::string w = grid.w ? ", \"w\": " + triple(grid.w->x, grid.w->y, grid.w->z) : "";
  return fmt::format("\"origin\": {}, \"u\": {}, \"v\": {}{}, \"cells\": [{}, {}{}]}}",
                     triple(grid.origin.x, grid.origin.y, grid.origin.z), triple(grid.u.x, grid.u.y, grid.u.z),
                     triple(grid.v.x, grid.v.y, grid.v.z), w, grid.nu, grid.nv,
                     grid.w ? ", " + std::to_string(grid.nw) : "");
}

std::string grid_members(const Grid2& grid) {
  return fmt::format("\"min\": {}, \"max\": {}, \"cells\": [{}, {}]}}", point(grid.min), point(grid.max), grid.nx,
                     grid.ny);
}

// One without a name by itself, others as a list.
template <class AnyGrid>
void write_grids(const std::vector<AnyGrid>& grids, std::string& out) {
  if (grids.empty()) return;
  if (grids.size() == 1 && grids.front().name.empty()) {
    out += ",\n  \"grid\": {" + grid_members(grids.front());
    return;
  }
  out += ",\n  \"grid\": [";
  for (const AnyGrid& grid : grids)
    out += fmt::format("{}\n    {{\"name\": {}, {}", &grid == &grids.front() ? "" : ",", json_string(grid.name),
                       grid_members(grid));
  out += "\n  ]";
}

}  // namespace

std::string write_scene_2(const Scene2& scene) {
  std::string out;
  write_head(scene, 2, out);
  write_polylines(scene, write_edges(scene, out), out);
  write_sky(scene, out);
  write_grids(scene.grids, out);
  write_lights_of(scene, out);
  write_expectations(scene, out);
  return out + "\n}\n";
}

std::string write_scene_3(const Scene3& scene) {
  std::string out;
  write_head(scene, 3, out);
  write_polygons(scene, out);
  write_sky(scene, out);
  write_grids(scene.grids, out);
  if (scene.camera) write_camera(*scene.camera, out);
  write_lights_of(scene, out);
  write_expectations(scene, out);
  return out + "\n}\n";
}

}  // namespace hottel

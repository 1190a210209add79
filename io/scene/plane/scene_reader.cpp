#include "io/scene/plane/scene_reader.h"

#include <array>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/plane/scene/patch_seats.h"
#include "geometry/plane/scene/scene_entries.h"
#include "io/scene/grid_list.h"
#include "io/scene/json_fields.h"
#include "io/scene/table_reader.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

class PlaneReader {
 public:
  explicit PlaneReader(const std::string& name) : table_(scene_) { scene_.file = name; }

  ValidScene2 read(const JsonValue& root) {
    const auto [hottel, dimension, about, materials, edges, polylines, polygons, mesh, sky, closed, grid, camera,
                lights, expect, unit] = read_members(root, {"the scene"}, kSceneKeys);
    if (about) scene_.about = read_string(about, {"about"});
    if (materials) table_.read_materials(materials);
    if (edges) read_shapes(edges, "edges", "edge", &PlaneReader::read_edge);
    if (polylines) read_shapes(polylines, "polylines", "polyline", &PlaneReader::read_polyline);
    refuse_space_only(polygons, mesh, camera);
    if (sky) table_.read_sky(sky);
    if (closed) scene_.closed = read_boolean(closed, {"closed"});
    if (grid)
      scene_.grids = read_grids<Grid2>(
          grid, std::array<std::string_view, 3>{"min", "max", "cells"},
          [this](const JsonValue& value, const std::array<JsonValue, 3>& its) { return grid_of(value, its); });
    if (lights) table_.read_lights(lights, [this](const LightEntry& entry) { read_light(entry); });
    if (expect) table_.read_expectations(expect);
    if (unit) table_.read_unit(unit);
    table_.settle_bands();
    if (!scene_.bases.empty()) seat_patches(scene_, finest_unit({edges, polylines}));
    settle_two_sided(scene_);
    ValidScene2 scene(std::move(scene_));
    refuse_names_of_edges(*scene, polyline_line_);
    return scene;
  }

 private:
  void read_shapes(const JsonValue& list, std::string_view key, const std::string& noun,
                   void (PlaneReader::*read_shape)(const JsonValue&, const std::string&)) {
    require_kind(list, JsonKind::kArray, {key});
    scene_.surfaces.reserve(scene_.surfaces.size() + list.size());
    scene_.edges.reserve(scene_.edges.size() + list.size());
    scene_.groups.reserve(scene_.groups.size() + list.size());
    table_.read_list(list, key, noun,
                     [&](const JsonValue& value, const std::string& name) { (this->*read_shape)(value, name); });
  }

  // What the last digit stands for in the points of lists of edges and polylines, which were read.
  static Rational finest_unit(std::initializer_list<JsonValue> lists) {
    FinestDigit finest;
    for (const JsonValue& list : lists) {
      if (!list) continue;
      for (const JsonValue entry : list.items())
        for (const auto [key, value] : entry.members()) {
          if (key.text() != "points") continue;
          for (const JsonValue point : value.items())
            for (const JsonValue coordinate : point.items()) finest.take(coordinate.text());
        }
    }
    return finest.unit();
  }

  void read_edge(const JsonValue& value, const std::string& default_name) {
    SceneEntry entry = table_.read_entry(value, default_name, "edge");
    for (const JsonValue point : entry.points.items()) require_kind(point, JsonKind::kArray, {entry.owner, "point"});
    if (entry.points.size() < 2) refuse(entry.points, entry.owner + " has fewer than two points");
    if (entry.points.size() > 2)
      refuse(entry.points, entry.owner + " has " + std::to_string(entry.points.size()) + " points; an edge has two",
             {"a chain of edges is an entry of \"polylines\""});
    entry.surface.name = std::move(entry.name);
    entry.surface.line = value.line();
    Edge2 edge;
    Point2* point = &edge.from;
    for (const JsonValue item : entry.points.items()) {
      *point = read_point(item, {entry.owner, "point"});
      point = &edge.to;
    }
    add_edge(scene_, std::move(entry.surface), std::move(edge));
  }

  void read_polyline(const JsonValue& value, const std::string& default_name) {
    constexpr std::array<std::string_view, 1> kMore{"closed"};
    const SceneEntry entry = table_.read_entry(value, default_name, "polyline", kMore);
    polyline_line_.emplace_back(value.line());
    const bool closed = entry.more[0] && read_boolean(entry.more[0], {entry.owner, "closed"});
    if (entry.points.size() < 2) refuse(entry.points, entry.owner + " has fewer than two points");
    std::vector<PolylinePoint2> points;
    points.reserve(entry.points.size());
    for (const JsonValue item : entry.points.items())
      points.push_back({read_point(item, {entry.owner, "point"}), item.line()});
    add_polyline(scene_, entry.surface, entry.name, std::move(points), closed);
  }

  Point2 read_point(const JsonValue& value, const Subject& subject) const {
    require_kind(value, JsonKind::kArray, subject);
    if (value.size() != 2)
      refuse(value,
             subject.text() + " has " + std::to_string(value.size()) + " coordinates; in dimension 2 it has two");
    Point2 point;
    Rational* coordinate = &point.x;
    for (const JsonValue item : value.items()) {
      *coordinate = read_number(item, {subject.owner, "coordinate"});
      coordinate = &point.y;
    }
    return point;
  }

  static void refuse_space_only(const JsonValue& polygons, const JsonValue& mesh, const JsonValue& camera) {
    if (polygons) {
      require_kind(polygons, JsonKind::kArray, {"polygons"});
      if (polygons.size() > 0) refuse(polygons, "polygons belong to dimension 3; this scene has dimension 2");
    }
    if (mesh) refuse(mesh, "mesh belongs to dimension 3; this scene has dimension 2");
    if (camera) refuse(camera, "camera belongs to dimension 3; this scene has dimension 2");
  }

  void read_light(const LightEntry& entry) {
    LightPlace2 place;
    if (entry.path) {
      place.path = LightPath2{{}, entry.seconds, entry.is_closed};
      for (const JsonValue item : entry.path_points.items())
        place.path->points.push_back(read_point(item, {entry.owner, "point of the path"}));
    }
    if (!entry.light.is_sun())
      place.position =
          entry.position ? read_point(entry.position, {entry.owner, "position"}) : place.path->points.front();
    if (entry.direction) place.direction = read_point(entry.direction, {entry.owner, "direction"});
    if (entry.rotation) place.rotation = read_number(entry.rotation, {entry.owner, "rotation"});
    scene_.add_light(entry.light, std::move(place));
  }

  // From min, max and cells.
  Grid2 grid_of(const JsonValue& value, const std::array<JsonValue, 3>& its) const {
    const auto& [min, max, cells] = its;
    require_member(min, "min", value, {"grid"});
    require_member(max, "max", value, {"grid"});
    require_member(cells, "cells", value, {"grid"});
    Grid2 result;
    result.min = read_point(min, {"grid", "min"});
    result.max = read_point(max, {"grid", "max"});
    require_kind(cells, JsonKind::kArray, {"grid", "cells"});
    if (cells.size() != 2) refuse(cells, "grid: cells must be two numbers, along x and along y");
    std::uint32_t* count = &result.nx;
    for (const JsonValue item : cells.items()) {
      *count = read_count(item, kMaxGridCells, {"grid", "cells"});
      count = &result.ny;
    }
    if (const std::string problem = grid_problem(result); !problem.empty()) refuse(max, "grid: " + problem);
    return result;
  }

  Scene2 scene_;
  TableReader table_;
  std::vector<int> polyline_line_;
};

}  // namespace

ValidScene2 read_document_2(const JsonValue& root, const std::string& name_for_messages) {
  return PlaneReader(name_for_messages).read(root);
}

}  // namespace hottel

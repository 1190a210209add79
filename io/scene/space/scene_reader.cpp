#include "io/scene/space/scene_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/patch_seats.h"
#include "geometry/space/scene/seams.h"
#include "io/scene/grid_list.h"
#include "io/scene/json_fields.h"
#include "io/scene/space/mesh_reader.h"
#include "io/scene/table_reader.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Of a group that a mesh has not: those near to its name, or those there are.
std::vector<std::string> group_hints(const std::string& name, const std::vector<std::string>& groups) {
  constexpr std::size_t kMost = 8;
  if (auto near = near_name_hints(name, groups); !near.empty()) return near;
  std::string text = groups.size() == 1 ? "its group is" : "its groups are";
  for (std::size_t k = 0; k < std::min(kMost, groups.size()); ++k)
    text += (k > 0 ? ", " : " ") + quoted_name(groups[k]);
  return {text + (groups.size() > kMost ? ", ..." : "")};
}

class SpaceReader3 {
 public:
  SpaceReader3(const std::string& name, const TextSource& files, Triangulator3* triangulator, PassedOver* passed_over)
      : table_(scene_), files_(files), triangulator_(triangulator), passed_over_(passed_over) {
    scene_.file = name;
  }

  ValidScene3 read(const JsonValue& root) {
    const auto [hottel, dimension, about, materials, edges, polylines, polygons, mesh, sky, closed, grid, camera,
                lights, expect, unit] = read_members(root, {"the scene"}, kSceneKeys);
    if (about) scene_.about = read_string(about, {"about"});
    if (materials) table_.read_materials(materials);
    refuse_plane_only(edges, "edges");
    refuse_plane_only(polylines, "polylines");
    if (grid)
      scene_.grids = read_grids<Grid3>(
          grid, std::array<std::string_view, 5>{"origin", "u", "v", "w", "cells"},
          [this](const JsonValue& value, const std::array<JsonValue, 5>& its) { return grid_of(value, its); });
    if (lights) table_.read_lights(lights, [this](const LightEntry& entry) { read_light(entry); });
    if (polygons) read_polygons(polygons);
    if (mesh) read_meshes(mesh);
    if (sky) table_.read_sky(sky);
    if (closed) scene_.closed = read_boolean(closed, {"closed"});
    if (camera) read_camera(camera);
    if (expect) table_.read_expectations(expect);
    if (unit) table_.read_unit(unit);
    table_.settle_bands();
    seat_patches(scene_, unit_of_digits_);
    settle_two_sided(scene_);
    ValidScene3 scene(std::move(scene_));
    refuse_groups_of_one_name(*scene);
    return scene;
  }

 private:
  static void refuse_plane_only(const JsonValue& list, const std::string& key) {
    if (!list) return;
    require_kind(list, JsonKind::kArray, {key});
    if (list.size() > 0)
      refuse(list, key + " belong to dimension 2; this scene has dimension 3",
             {"surfaces in space are \"polygons\" and the faces of a \"mesh\""});
  }

  void read_polygons(const JsonValue& list) {
    require_kind(list, JsonKind::kArray, {"polygons"});
    scene_.surfaces.reserve(list.size());
    scene_.polygons.reserve(list.size());
    std::vector<std::pair<Surface, Polygon3>> found;
    FinestDigit finest;
    table_.read_list(list, "polygons", "polygon", [&](const JsonValue& value, const std::string& name) {
      found.push_back(read_polygon(value, name, finest));
    });
    for (auto& [surface, polygon] : found) {
      open_seams(polygon);
      accept_nearly_plane(polygon, finest.unit());
      // A patch is put into the plane of its base; it is not cut where it is none by itself.
      if (triangulator_ == nullptr || surface.on || !triangulator_->add(scene_, surface, polygon))
        scene_.add(std::move(surface), std::move(polygon));
    }
    unit_of_digits_ = finest.unit();
    read_masks();
  }

  // The polygons that say that they mask another one.
  void read_masks() {
    if (masks_.empty()) return;
    std::unordered_map<std::string_view, std::uint32_t> index;
    std::vector<std::string> names;
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) {
      index.emplace(scene_.surfaces[s].name, s);
      names.push_back(scene_.surfaces[s].name);
    }
    for (const auto& [mask, value] : masks_) {
      const std::string base = read_string(value, {"polygon " + quoted_name(mask), "masks"});
      const auto surface = index.find(mask), under = index.find(base);
      if (surface == index.end())
        refuse(value, "polygon " + quoted_name(mask) + " is not plane, but masks " + quoted_name(base));
      if (under == index.end())
        refuse(value, "polygon " + quoted_name(mask) + " masks " + quoted_name(base) + ", but there is no such polygon",
               near_name_hints(base, names));
      scene_.masks.push_back({surface->second, under->second});
    }
  }

  // The digits of its coordinates are told to `finest`.
  std::pair<Surface, Polygon3> read_polygon(const JsonValue& value, const std::string& default_name,
                                            FinestDigit& finest) {
    constexpr std::array<std::string_view, 5> kMore{"holes", "group", "obstruction", "masks", "body"};
    SceneEntry entry = table_.read_entry(value, default_name, "polygon", kMore);
    if (entry.behind && !entry.more[1])
      refuse(entry.behind, entry.owner + ": behind is for closed meshes: a \"mesh\", or the polygons of one \"group\"",
             {"give the back a material (\"back\"), or close the mesh"});
    if (entry.more[1]) entry.surface.group = group_of(entry.more[1], entry);
    if (entry.more[4]) read_body(entry.more[4], entry);
    Polygon3 polygon;
    polygon.points.reserve(entry.points.size());
    for (const JsonValue item : entry.points.items())
      polygon.points.push_back(read_corner(item, {entry.owner, "point"}, finest));
    if (const JsonValue holes = entry.more[0]) read_holes(holes, entry.owner, finest, polygon);
    if (entry.more[3] && entry.on)
      refuse(entry.more[3], entry.owner + " lies on another surface (\"on\"): it does not mask one too");
    if (entry.more[3]) masks_.emplace_back(entry.name, entry.more[3]);
    entry.surface.name = std::move(entry.name);
    entry.surface.line = value.line();
    return {std::move(entry.surface), std::move(polygon)};
  }

  void read_body(const JsonValue& value, const SceneEntry& polygon) {
    if (!polygon.more[1])
      refuse(value, polygon.owner + ": body is for the polygons of a \"group\"", {"a body is made of several groups"});
    Group& group = scene_.groups[polygon.surface.group];
    std::string name = read_string(value, {polygon.owner, "body"});
    if (const auto problem = name_problem(name); !problem.empty())
      refuse(value, polygon.owner + ": the body " + quoted_name(name) + " " + std::string(problem));
    if (!group.body.empty() && group.body != name)
      refuse(value, polygon.owner + ": another polygon of the group " + quoted_name(group.name) + " is of the body " +
                        quoted_name(group.body));
    group.body = std::move(name);
  }

  Point3 read_corner(const JsonValue& value, const Subject& subject, FinestDigit& finest) const {
    Point3 point = read_point(value, subject);
    for (const JsonValue coordinate : value.items()) finest.take(coordinate.text());
    return point;
  }

  void read_holes(const JsonValue& holes, const std::string& owner, FinestDigit& finest, Polygon3& polygon) const {
    require_kind(holes, JsonKind::kArray, {owner, "holes"});
    for (const JsonValue hole : holes.items()) {
      require_kind(hole, JsonKind::kArray, {owner, "hole"});
      auto& points = polygon.holes.emplace_back();
      for (const JsonValue item : hole.items()) points.push_back(read_corner(item, {owner, "point of a hole"}, finest));
    }
  }

  // The group of that name, which takes the place of the polygon's own, the last one.
  std::uint32_t group_of(const JsonValue& value, const SceneEntry& polygon) {
    std::string name = read_string(value, {polygon.owner, "group"});
    if (const auto problem = name_problem(name); !problem.empty())
      refuse(value, polygon.owner + ": the group " + quoted_name(name) + " " + std::string(problem));
    const Behind behind = scene_.groups.back().behind;
    scene_.groups.pop_back();
    const auto [entry, is_new] = shared_groups_.emplace(name, static_cast<std::uint32_t>(scene_.groups.size()));
    if (is_new) {
      scene_.groups.emplace_back(std::move(name), behind);
    } else if (Behind& known = scene_.groups[entry->second].behind; polygon.behind) {
      if (known != Behind::kByOutline && known != behind)
        refuse(polygon.behind, polygon.owner + ": another polygon of the group " + quoted_name(name) +
                                   " says that something else is behind it");
      known = behind;
    }
    return entry->second;
  }

  void read_meshes(const JsonValue& meshes) {
    MeshAdder3 adder(scene_, triangulator_, passed_over_);
    if (meshes.kind() != JsonKind::kArray) return read_mesh(meshes, "mesh[0]", adder);
    table_.read_list(meshes, "mesh", "mesh",
                     [&](const JsonValue& value, const std::string& name) { read_mesh(value, name, adder); });
  }

  void read_mesh(const JsonValue& value, const std::string& default_name, MeshAdder3& adder) {
    const auto [file, name, material, scale, back, elements, about, behind, backs] =
        read_members(value, {default_name},
                     std::array<std::string_view, 9>{"file", "name", "material", "scale", "back", "elements", "about",
                                                     "behind", "backs"});
    require_member(file, "file", value, {default_name});
    MeshEntry3 entry;
    entry.name = name ? read_string(name, {default_name, "name"}) : default_name;
    if (const auto problem = name_problem(entry.name); !problem.empty())
      refuse(name, default_name + ": the name " + quoted_name(entry.name) + " " + std::string(problem));
    const std::string owner = "mesh " + quoted_name(entry.name);
    if (material) entry.material = table_.material_of(material, {owner, "material"});
    if (back) entry.back = table_.material_of(back, {owner, "back"});
    if (scale) entry.scale = read_number(scale, {owner, "scale"});
    if (entry.scale <= 0) refuse(scale, owner + ": scale must be greater than 0");
    if (elements) entry.elements = read_count(elements, kMaxElements, {owner, "elements"});
    if (about) read_string(about, {owner, "about"});
    if (behind) entry.behind = read_behind(behind, {owner, "behind"});
    entry.line = value.line();
    const Mesh3 mesh = read_mesh_file(file, owner);
    if (!scene_.bases.empty()) unit_of_digits_ = std::max(unit_of_digits_, unit_of(mesh, entry.scale));
    if (backs) read_backs(backs, owner, mesh, entry);
    adder.add(mesh, entry);
  }

  // What the last digit of the points of a mesh stands for.
  static Rational unit_of(const Mesh3& mesh, const Rational& scale) {
    Rational unit = mesh.unit;
    if (mesh.float_digits > 0)
      for (const MeshFace3& face : mesh.faces) unit = std::max(unit, float_spacing(face.polygon, mesh.float_digits));
    return scale * unit;
  }

  // The materials of backs by groups of the mesh; the faces without one are called so as the mesh is.
  void read_backs(const JsonValue& backs, const std::string& owner, const Mesh3& mesh, MeshEntry3& entry) const {
    require_kind(backs, JsonKind::kObject, {owner, "backs"});
    std::vector<std::string> groups;
    for (const MeshName3& group : mesh.groups) groups.push_back(group.name);
    if (std::ranges::any_of(mesh.faces, [](const MeshFace3& face) { return !face.group; }))
      groups.push_back(entry.name);
    for (const auto [key, value] : backs.members()) {
      const std::string group(key.text());
      if (std::ranges::find(groups, group) == groups.end())
        refuse(key, owner + ": backs: " + mesh.file + " has no group " + quoted_name(group),
               group_hints(group, groups));
      entry.backs.emplace(group, table_.material_of(value, {owner, "the back of " + quoted_name(group)}));
    }
  }

  Mesh3 read_mesh_file(const JsonValue& file, const std::string& owner) const {
    const std::string name = read_string(file, {owner, "file"});
    const std::filesystem::path path = std::filesystem::path(scene_.file).parent_path() / name;
    const auto format = mesh_format_3(path);
    if (!format)
      refuse(file, owner + ": the file " + quoted_name(name) + " is not read by this version: it does not end in " +
                       kMeshEndings3);
    const std::string bytes = read_named_file(files_, path, {file.file(), file.line()}, owner + ": the file");
    return parse_mesh_3(*format, bytes, path.string(), files_);
  }

  Point3 read_point(const JsonValue& value, const Subject& subject) const {
    require_kind(value, JsonKind::kArray, subject);
    if (value.size() != 3)
      refuse(value,
             subject.text() + " has " + std::to_string(value.size()) + " coordinates; in dimension 3 it has three");
    Point3 point;
    Rational* const coordinates[] = {&point.x, &point.y, &point.z};
    std::size_t k = 0;
    for (const JsonValue item : value.items()) *coordinates[k++] = read_number(item, {subject.owner, "coordinate"});
    return point;
  }

  void read_light(const LightEntry& entry) {
    LightPlace3 place;
    if (entry.path) {
      place.path = LightPath3{{}, entry.seconds, entry.is_closed};
      for (const JsonValue item : entry.path_points.items())
        place.path->points.push_back(read_point(item, {entry.owner, "point of the path"}));
    }
    if (!entry.light.is_sun())
      place.position =
          entry.position ? read_point(entry.position, {entry.owner, "position"}) : place.path->points.front();
    if (entry.direction) place.direction = read_point(entry.direction, {entry.owner, "direction"}) - Point3{};
    if (entry.rotation) place.rotation = read_point(entry.rotation, {entry.owner, "rotation"}) - Point3{};
    scene_.add_light(entry.light, std::move(place));
  }

  // From origin, u, v, w and cells; without w it is planar.
  Grid3 grid_of(const JsonValue& value, const std::array<JsonValue, 5>& its) {
    const auto& [origin, u, v, w, cells] = its;
    require_member(origin, "origin", value, {"grid"});
    require_member(u, "u", value, {"grid"});
    require_member(v, "v", value, {"grid"});
    require_member(cells, "cells", value, {"grid"});
    Grid3 grid;
    grid.origin = read_point(origin, {"grid", "origin"});
    grid.u = read_point(u, {"grid", "u"}) - Point3{};
    grid.v = read_point(v, {"grid", "v"}) - Point3{};
    if (w) grid.w = read_point(w, {"grid", "w"}) - Point3{};
    read_cells(cells, grid);
    if (const std::string problem = grid_problem(grid); !problem.empty()) refuse(value, "grid: " + problem);
    return grid;
  }

  void read_cells(const JsonValue& cells, Grid3& grid) {
    require_kind(cells, JsonKind::kArray, {"grid", "cells"});
    if (cells.size() != (grid.w ? 3U : 2U))
      refuse(cells, grid.w ? "grid: cells must be three numbers, along u, v and w"
                           : "grid: cells must be two numbers, along u and along v; a third is of a grid with \"w\"");
    const std::array<std::uint32_t*, 3> counts{&grid.nu, &grid.nv, &grid.nw};
    std::size_t k = 0;
    for (const JsonValue item : cells.items()) *counts[k++] = read_count(item, kMaxGridCells3, {"grid", "cells"});
  }

  void read_camera(const JsonValue& value) {
    const auto [eye, target, up, field_of_view, pixels] = read_members(
        value, {"camera"}, std::array<std::string_view, 5>{"eye", "target", "up", "field_of_view", "pixels"});
    require_member(eye, "eye", value, {"camera"});
    require_member(target, "target", value, {"camera"});
    Camera3 camera;
    camera.eye = read_point(eye, {"camera", "eye"});
    camera.target = read_point(target, {"camera", "target"});
    if (up) camera.up = read_point(up, {"camera", "up"}) - Point3{};
    if (field_of_view) camera.field_of_view = read_number(field_of_view, {"camera", "field_of_view"});
    if (pixels) {
      require_kind(pixels, JsonKind::kArray, {"camera", "pixels"});
      if (pixels.size() != 2) refuse(pixels, "camera: pixels must be two numbers, width and height");
      std::uint32_t* count = &camera.width;
      for (const JsonValue item : pixels.items()) {
        *count = read_count(item, kMaxPixels, {"camera", "pixels"});
        count = &camera.height;
      }
    }
    if (const std::string problem = camera_problem(camera); !problem.empty()) refuse(value, "camera: " + problem);
    scene_.camera = std::move(camera);
  }

  // Polygons and faces differ in name in a valid scene; groups have names of their own.
  static void refuse_groups_of_one_name(const Scene3& scene) {
    std::vector<int> line(scene.groups.size());
    for (std::size_t s = scene.surfaces.size(); s-- > 0;) line[scene.surfaces[s].group] = scene.surfaces[s].line;
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t g = 0; g < scene.groups.size(); ++g)
      if (const auto [other, is_new] = first.emplace(scene.groups[g].name, g); !is_new)
        throw InputError({scene.file, line[g]},
                         "two groups have the name " + quoted_name(scene.groups[g].name) + ", the other one in line " +
                             std::to_string(line[other->second]),
                         {"a polygon alone, the polygons of one \"group\" and a group of a mesh are groups"});
  }

  Scene3 scene_;
  TableReader table_;
  std::vector<std::pair<std::string, JsonValue>> masks_;  // by name, with what they say
  Rational unit_of_digits_;                               // of the points of polygons, and of meshes, the coarsest
  const TextSource& files_;
  Triangulator3* triangulator_;
  PassedOver* passed_over_;
  std::unordered_map<std::string, std::uint32_t> shared_groups_;  // of "group"
};

}  // namespace

ValidScene3 read_document_3(const JsonValue& root, const std::string& name_for_messages, const TextSource& files,
                            Triangulator3* triangulator, PassedOver* passed_over) {
  return SpaceReader3(name_for_messages, files, triangulator, passed_over).read(root);
}

}  // namespace hottel

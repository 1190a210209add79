#include "io/scene/space/mesh_adder.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/seams.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

Polygon3 scaled(Polygon3 polygon, const Rational& scale) {
  if (scale == 1) return polygon;
  const auto scale_loop = [&](std::vector<Point3>& loop) {
    for (Point3& point : loop) point = {point.x * scale, point.y * scale, point.z * scale};
  };
  scale_loop(polygon.points);
  for (std::vector<Point3>& hole : polygon.holes) scale_loop(hole);
  return polygon;
}

std::string byte_text(const MeshFace3& face) { return face.byte ? " (byte " + std::to_string(*face.byte) + ")" : ""; }

InputError error_at(const Mesh3& mesh, const MeshFace3& face, const std::string& text, const std::string& hint = "") {
  return {
      {mesh.file, face.line}, text + byte_text(face), hint.empty() ? std::vector<std::string>() : std::vector{hint}};
}

// Why a face without repeated corners has no area; empty where it has one.
std::string no_area(const std::vector<Point3>& points) {
  if (points.size() < 3) return "it has fewer than three points that differ";
  const Vector3 first = points[1] - points[0];
  const bool has_area = std::any_of(points.begin() + 2, points.end(),
                                    [&](const Point3& point) { return !cross(first, point - points[0]).is_zero(); });
  return has_area ? "" : "its points lie on one line";
}

}  // namespace

MeshAdder3::MeshAdder3(Scene3& scene, Triangulator3* triangulator, PassedOver* passed_over)
    : scene_(scene), triangulator_(triangulator), passed_over_(passed_over) {
  for (std::uint32_t k = 0; k < scene.materials.size(); ++k) own_.emplace(scene.materials[k].name, k);
}

// What is known of a mesh while its faces are added. Of faces without a group, or a material, there is one more, the
// last.
struct MeshAdder3::Adding {
  Adding(const Mesh3& of, const MeshEntry3& its)
      : mesh(of), entry(its), groups(of.groups.size() + 1), materials(of.materials.size() + 1), count(groups.size()) {
    materials.back() = its.material;
    for (const MeshName3& group : of.groups) backs.push_back(back_of(group.name));
    backs.push_back(back_of(its.name));
  }

  // What the scene calls a body of the mesh.
  const std::string& body(const Scene3& scene, const std::string& called) {
    const auto [known, is_new] = bodies.try_emplace(called, called);
    if (!is_new) return known->second;
    const std::string wanted = name_problem(called).empty() ? called : "object";
    const auto is_taken = [&](const std::string& name) {
      return std::ranges::any_of(scene.groups, [&](const Group& group) { return group.body == name; });
    };
    known->second = wanted;
    for (std::size_t k = 2; is_taken(known->second); ++k) known->second = wanted + "~" + std::to_string(k);
    return known->second;
  }

  std::optional<std::uint32_t> back_of(const std::string& group) const {
    const auto own = entry.backs.find(group);
    return own == entry.backs.end() ? entry.back : std::optional(own->second);
  }

  const Mesh3& mesh;
  const MeshEntry3& entry;
  std::vector<std::optional<std::uint32_t>> groups, materials, backs;
  std::map<std::string, std::string> bodies;     // by what the file calls them
  std::vector<std::size_t> count;                // faces of each group so far
  std::optional<InputError> first_without_area;  // of its faces
  bool has_area = false;
};

void MeshAdder3::add(const Mesh3& mesh, const MeshEntry3& entry) {
  Adding adding(mesh, entry);
  scene_.sources.push_back(mesh.file);
  for (const MeshFace3& face : mesh.faces) add_face(adding, face);
  scene_.sources.insert(scene_.sources.end(), mesh.library_files.begin(), mesh.library_files.end());
  if (adding.first_without_area && !adding.has_area) throw InputError(*adding.first_without_area);
  if (passed_over_ != nullptr) passed_over_->add(mesh.passed_over);
}

void MeshAdder3::add_face(Adding& adding, const MeshFace3& face) {
  const Mesh3& mesh = adding.mesh;
  const std::size_t group = face.group.value_or(mesh.groups.size());
  Surface surface;
  surface.name = piece_name(face.group ? mesh.groups[group].name : adding.entry.name, adding.count[group]++);
  Polygon3 polygon = face.polygon;
  const std::size_t repeated = drop_repeated(polygon.points, true, std::equal_to<>());
  if (const std::string why = no_area(polygon.points); !why.empty()) {
    if (!adding.first_without_area)
      adding.first_without_area = error_at(mesh, face, "face " + quoted_name(surface.name) + " has no area: " + why);
    return pass_over(mesh, face, PassedKind::kFaceWithoutArea, quoted_name(surface.name));
  }
  adding.has_area = true;
  surface.group = group_of(adding, face);
  surface.material = material_of(adding, face, surface.name);
  surface.back = adding.backs[group];
  surface.elements = adding.entry.elements;
  surface.line = adding.entry.line > 0 ? adding.entry.line : face.line;
  surface.in_mesh = {static_cast<std::uint32_t>(scene_.sources.size()), face.line};
  if (repeated > 0) pass_over(mesh, face, PassedKind::kRepeatedPoint, "of " + quoted_name(surface.name), repeated);
  open_seams(polygon);
  accept_nearly_plane(polygon, mesh.float_digits > 0 ? float_spacing(polygon, mesh.float_digits) : mesh.unit);
  const auto [problem, hint] = polygon_problem(polygon);
  polygon = scaled(std::move(polygon), adding.entry.scale);
  if (triangulator_ != nullptr && triangulator_->add(scene_, surface, polygon)) return;
  if (!problem.empty()) throw error_at(mesh, face, "face " + quoted_name(surface.name) + " " + problem, hint);
  scene_.add(std::move(surface), std::move(polygon));
}

void MeshAdder3::pass_over(const Mesh3& mesh, const MeshFace3& face, PassedKind kind, const std::string& name,
                           std::size_t count) {
  if (passed_over_ != nullptr) passed_over_->add(kind, {mesh.file + byte_text(face), face.line}, name, count);
}

std::uint32_t MeshAdder3::group_of(Adding& adding, const MeshFace3& face) {
  const std::size_t index = face.group.value_or(adding.mesh.groups.size());
  std::optional<std::uint32_t>& group = adding.groups[index];
  if (group) return *group;
  const std::string& name = face.group ? adding.mesh.groups[index].name : adding.entry.name;
  if (const auto problem = name_problem(name); !problem.empty())
    throw error_at(adding.mesh, face, "the name " + quoted_name(name) + " of a group " + std::string(problem));
  group = static_cast<std::uint32_t>(scene_.groups.size());
  scene_.groups.emplace_back(name, adding.entry.behind);
  if (adding.mesh.is_one_body) scene_.groups.back().body = adding.entry.name;
  if (face.group && index < adding.mesh.bodies.size() && !adding.mesh.bodies[index].empty()) {
    const std::string body = adding.body(scene_, adding.mesh.bodies[index]);
    scene_.groups.back().body = body;
  }
  return *group;
}

std::uint32_t MeshAdder3::material_of(Adding& adding, const MeshFace3& face, const std::string& surface) {
  const Mesh3& mesh = adding.mesh;
  const bool invents = adding.entry.invents_materials;
  std::optional<std::uint32_t>& material = adding.materials[face.material.value_or(mesh.materials.size())];
  if (!material && face.material)
    material = material_of(mesh, mesh.materials[*face.material], invents && !mesh.has_library);
  if (!material && invents) material = material_of(mesh, {kMeshMaterial, face.line}, true);
  if (!material)
    throw error_at(mesh, face, "face " + quoted_name(surface) + " has no material",
                   "give the mesh " + quoted_name(adding.entry.name) + " a \"material\", or the face a usemtl");
  return *material;
}

std::uint32_t MeshAdder3::material_of(const Mesh3& mesh, const MeshName3& name, bool invents) {
  if (const auto own = own_.find(name.name); own != own_.end()) return own->second;
  if (const auto found = mesh.library.find(name.name); found != mesh.library.end())
    return added_material(mesh, name.line, found->second);
  if (invents) {
    if (const auto problem = material_name_problem(name.name); !problem.empty())
      throw InputError({mesh.file, name.line}, problem);
    if (!added_.contains(name.name)) invented_.push_back(name.name);
    return added_material(mesh, name.line, {name.name, Spectrum::scalar(kMeshReflectivity), {}});
  }
  SceneTable known;
  known.materials = scene_.materials;
  for (const auto& [its_name, material] : mesh.library) known.materials.push_back(material);
  std::vector<std::string> hints = undefined_material_hints(known, name.name);
  if (!mesh.missing_library.empty())
    hints.insert(hints.begin(), "the file of materials " + mesh.missing_library + " is not there");
  throw InputError({mesh.file, name.line}, "the material " + quoted_name(name.name) + " is not defined",
                   std::move(hints));
}

std::uint32_t MeshAdder3::added_material(const Mesh3& mesh, int line, Material material) {
  const auto [entry, is_new] = added_.emplace(material.name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (is_new)
    scene_.materials.push_back(std::move(material));
  else if (scene_.materials[entry->second] != material)
    throw InputError({mesh.file, line},
                     "the material " + quoted_name(material.name) + " is another one in another mesh",
                     {"define it in the scene's \"materials\", which come first"});
  return entry->second;
}

MeshScene3 scene_of(const Mesh3& mesh, Triangulator3* triangulator, PassedOver* passed_over) {
  Scene3 scene;
  scene.file = mesh.file;
  MeshEntry3 entry;
  entry.name = std::filesystem::path(mesh.file).stem().string();
  if (!name_problem(entry.name).empty()) entry.name = "mesh";
  entry.invents_materials = true;
  MeshAdder3 adder(scene, triangulator, passed_over);
  adder.add(mesh, entry);
  return {std::move(scene), adder.invented()};
}

}  // namespace hottel

#include "io/scene/space/mesh_adder.h"

#include <filesystem>
#include <functional>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/scene/near_plane.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

Polygon3 scaled(Polygon3 polygon, const Rational& scale) {
  if (scale == 1) return polygon;
  for (Point3& point : polygon.points) {
    point.x *= scale;
    point.y *= scale;
    point.z *= scale;
  }
  return polygon;
}

}  // namespace

MeshAdder3::MeshAdder3(Scene3& scene, Triangulator3* triangulator, PassedOver* passed_over)
    : scene_(scene), triangulator_(triangulator), passed_over_(passed_over) {
  for (std::uint32_t k = 0; k < scene.materials.size(); ++k) own_.emplace(scene.materials[k].name, k);
}

void MeshAdder3::add(const Mesh3& mesh, const MeshEntry3& entry) {
  // Of faces without a group there is one more, the last.
  std::vector<std::optional<std::uint32_t>> groups(mesh.groups.size() + 1), materials(mesh.materials.size() + 1);
  std::vector<std::size_t> count(groups.size());
  materials.back() = entry.material;
  for (const MeshFace3& face : mesh.faces) {
    const auto refuse = [&](const std::string& text, const std::string& hint = "") {
      const std::string byte = face.byte ? " (byte " + std::to_string(*face.byte) + ")" : "";
      throw InputError({mesh.file, face.line}, text + byte,
                       hint.empty() ? std::vector<std::string>() : std::vector{hint});
    };
    const std::size_t group = face.group.value_or(mesh.groups.size());
    const std::string& group_name = face.group ? mesh.groups[group].name : entry.name;
    if (!groups[group]) {
      if (const auto problem = name_problem(group_name); !problem.empty())
        refuse("the name " + quoted_name(group_name) + " of a group " + std::string(problem));
      groups[group] = static_cast<std::uint32_t>(scene_.groups.size());
      scene_.groups.emplace_back(group_name, entry.behind);
    }
    Surface surface;
    surface.name = piece_name(group_name, count[group]++);
    std::optional<std::uint32_t>& material = materials[face.material.value_or(mesh.materials.size())];
    if (!material && face.material)
      material = material_of(mesh, mesh.materials[*face.material], entry.invents_materials && !mesh.has_library);
    if (!material && entry.invents_materials) material = material_of(mesh, {kMeshMaterial, face.line}, true);
    if (!material)
      refuse("face " + quoted_name(surface.name) + " has no material",
             "give the mesh " + quoted_name(entry.name) + " a \"material\", or the face a usemtl");
    surface.material = *material;
    surface.back = entry.back;
    surface.elements = entry.elements;
    surface.group = *groups[group];
    surface.line = entry.line > 0 ? entry.line : face.line;
    Polygon3 polygon = face.polygon;
    const std::size_t repeated = drop_repeated(polygon.points, true, std::equal_to<>());
    if (polygon.points.size() < 3)
      refuse("face " + quoted_name(surface.name) + " has no area: it has fewer than three points that differ");
    if (passed_over_ != nullptr) passed_over_->repeated_points += repeated;
    accept_nearly_plane(polygon, mesh.float_digits > 0 ? float_spacing(polygon, mesh.float_digits) : mesh.unit);
    const auto [problem, hint] = polygon_problem(polygon);
    polygon = scaled(std::move(polygon), entry.scale);
    if (triangulator_ != nullptr && triangulator_->add(scene_, surface, polygon)) continue;
    if (!problem.empty()) refuse("face " + quoted_name(surface.name) + " " + problem, hint);
    scene_.add(std::move(surface), std::move(polygon));
  }
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
  throw InputError({mesh.file, name.line}, "the material " + quoted_name(name.name) + " is not defined",
                   undefined_material_hints(known, name.name));
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
  MeshScene3 result;
  result.scene.file = mesh.file;
  MeshEntry3 entry;
  entry.name = std::filesystem::path(mesh.file).stem().string();
  if (!name_problem(entry.name).empty()) entry.name = "mesh";
  entry.invents_materials = true;
  MeshAdder3 adder(result.scene, triangulator, passed_over);
  adder.add(mesh, entry);
  validate(result.scene);
  result.invented = adder.invented();
  return result;
}

}  // namespace hottel

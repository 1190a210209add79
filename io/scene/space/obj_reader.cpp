#include "io/scene/space/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "io/scene/mtl_reader.h"
#include "io/scene/obj_statements.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What says nothing of shape or diffuse light.
constexpr std::array<std::string_view, 11> kPassedOver{
    "vt", "vn", "s", "lod", "bevel", "usemap", "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib"};
// What has no area, or is curved.
constexpr std::array<std::string_view, 19> kNotMadeOfFaces{"p",    "l",     "vp",   "cstype", "deg",  "bmat", "step",
                                                           "curv", "curv2", "surf", "parm",   "trim", "hole", "scrv",
                                                           "sp",   "end",   "con",  "ctech",  "stech"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader3 {
 public:
  ObjReader3(std::string_view text, const std::string& file, const TextSource& files) : at_(text, file), files_(files) {
    mesh_.file = file;
  }

  ObjMesh3 read() {
    while (at_.next()) read_statement();
    if (mesh_.faces.empty()) throw InputError({mesh_.file, 0}, "has no faces");
    return std::move(mesh_);
  }

 private:
  // A name in force, and its index once a face has it.
  struct Current {
    ObjName3 name;  // empty: none
    std::optional<std::uint32_t> index;
  };

  void read_statement() {
    const std::string_view keyword = at_.keyword();
    if (keyword == "v") return read_vertex();
    if (keyword == "f") return read_face();
    if (keyword == "g" || keyword == "o") return set_group();
    if (keyword == "usemtl") return set(material_, std::string(at_.rest()));
    if (keyword == "mtllib") return read_libraries();
    if (is_one_of(keyword, kPassedOver)) return;
    if (is_one_of(keyword, kNotMadeOfFaces))
      at_.refuse("'" + std::string(keyword) + "' is not read: points, lines and curved surfaces are no plane faces");
    at_.refuse("the keyword " + quoted_name(keyword) + " is not known");
  }

  void read_vertex() {
    const std::vector<std::string_view> words = at_.words();
    // x y z [w], and perhaps a colour r g b.
    if (words.size() < 3 || words.size() == 5 || words.size() > 7)
      at_.refuse("a vertex has " + std::to_string(words.size()) + " numbers; it must have three, x y z");
    std::vector<Rational> numbers;
    for (const std::string_view word : words) numbers.push_back(at_.number(word, "coordinate"));
    if (words.size() % 3 == 1 && numbers[3] != 1)
      at_.refuse("a vertex has the weight " + quoted_name(words[3]) + "; only curves have weights other than 1");
    points_.push_back({std::move(numbers[0]), std::move(numbers[1]), std::move(numbers[2])});
  }

  // "7", "7/3", "7//5" or "7/3/5": the first number counts, from 1 on, or from -1 back.
  std::size_t vertex(std::string_view word) const {
    const auto refuse = [&](const std::string& why) {
      at_.refuse("the vertex " + quoted_name(word) + " of a face " + why);
    };
    long index = 0;
    std::size_t part = 0;
    for (std::string_view rest = word;; ++part) {
      const std::size_t end = std::min(rest.find('/'), rest.size());
      long value = 0;
      const auto [stop, error] = std::from_chars(rest.data(), rest.data() + end, value);
      const bool is_left_out = part == 1 && end == 0 && end < rest.size();  // the texture in v//n
      if (!is_left_out && (error != std::errc() || stop != rest.data() + end || value == 0 || part > 2))
        refuse("is not an index: those are written 7, 7/3, 7//5 or 7/3/5");
      if (part == 0) index = value;
      if (end == rest.size()) break;
      rest.remove_prefix(end + 1);
    }
    const auto count = static_cast<long>(points_.size());
    if (index > count || index < -count)
      refuse("is none of the " + std::to_string(count) + " vertices that stand before it");
    return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
  }

  void read_face() {
    const std::vector<std::string_view> words = at_.words();
    if (words.size() < 3) at_.refuse("a face has fewer than three vertices");
    ObjFace3 face;
    face.polygon.points.reserve(words.size());
    for (const std::string_view word : words) face.polygon.points.push_back(points_[vertex(word)]);
    face.group = used(group_, group_index_, mesh_.groups);
    face.material = used(material_, material_index_, mesh_.materials);
    face.line = at_.line();
    mesh_.faces.push_back(std::move(face));
  }

  void set_group() {
    std::string name;
    for (const std::string_view word : at_.words()) name += (name.empty() ? "" : " ") + std::string(word);
    set(group_, std::move(name));
  }

  void set(Current& current, std::string name) { current = {{std::move(name), at_.line()}, std::nullopt}; }

  static std::optional<std::uint32_t> used(Current& current, std::unordered_map<std::string, std::uint32_t>& index,
                                           std::vector<ObjName3>& names) {
    if (current.name.name.empty() || current.index) return current.index;
    const auto [entry, is_new] = index.emplace(current.name.name, static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(current.name);
    return current.index = entry->second;
  }

  // File names may have blanks: each ends in .mtl, or the line is one name.
  void read_libraries() {
    mesh_.has_library = true;
    std::string_view rest = at_.rest();
    if (rest.empty()) at_.refuse("mtllib names no file");
    while (!rest.empty()) {
      const std::size_t ending = std::min(rest.find(".mtl "), rest.find(".mtl\t"));
      const std::size_t end = ending == std::string_view::npos ? rest.size() : ending + 4;
      read_library(rest.substr(0, end));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
    }
  }

  void read_library(std::string_view name) {
    const std::filesystem::path path = std::filesystem::path(mesh_.file).parent_path() / name;
    if (std::find(libraries_.begin(), libraries_.end(), path) != libraries_.end()) return;
    libraries_.push_back(path);
    for (const Material& material : parse_mtl(files_(path), path.string())) {
      const auto [entry, is_new] = mesh_.library.emplace(material.name, material);
      if (!is_new) at_.refuse("the material " + quoted_name(entry->first) + " stands in two MTL files");
    }
  }

  ObjStatements at_;
  const TextSource& files_;
  ObjMesh3 mesh_;
  std::vector<Point3> points_;
  Current group_, material_;
  std::unordered_map<std::string, std::uint32_t> group_index_, material_index_;
  std::vector<std::filesystem::path> libraries_;
};

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

ObjMesh3 parse_obj_3(std::string_view text, const std::string& file, const TextSource& files) {
  return ObjReader3(text, file, files).read();
}

MeshAdder3::MeshAdder3(Scene3& scene) : scene_(scene) {
  for (std::uint32_t k = 0; k < scene.materials.size(); ++k) own_.emplace(scene.materials[k].name, k);
}

void MeshAdder3::add(const ObjMesh3& mesh, const MeshEntry3& entry) {
  // Of faces without a group there is one more, the last.
  std::vector<std::optional<std::uint32_t>> groups(mesh.groups.size() + 1), materials(mesh.materials.size() + 1);
  std::vector<std::size_t> count(groups.size());
  materials.back() = entry.material;
  for (const ObjFace3& face : mesh.faces) {
    const auto refuse = [&](const std::string& text, const std::string& hint = "") {
      throw InputError({mesh.file, face.line}, text, hint.empty() ? std::vector<std::string>() : std::vector{hint});
    };
    const std::size_t group = face.group.value_or(mesh.groups.size());
    const std::string& group_name = face.group ? mesh.groups[group].name : entry.name;
    if (!groups[group]) {
      if (const auto problem = name_problem(group_name); !problem.empty())
        refuse("the name " + quoted_name(group_name) + " of a group " + std::string(problem));
      groups[group] = static_cast<std::uint32_t>(scene_.groups.size());
      scene_.groups.push_back(group_name);
    }
    Surface surface;
    surface.name = piece_name(group_name, count[group]++);
    std::optional<std::uint32_t>& material = materials[face.material.value_or(mesh.materials.size())];
    if (!material && face.material)
      material = material_of(mesh, mesh.materials[*face.material], entry.invents_materials && !mesh.has_library);
    if (!material && entry.invents_materials) material = material_of(mesh, {kObjMaterial, face.line}, true);
    if (!material)
      refuse("face " + quoted_name(surface.name) + " has no material",
             "give the mesh " + quoted_name(entry.name) + " a \"material\", or the face a usemtl");
    if (const auto& [problem, hint] = polygon_problem(face.polygon); !problem.empty())
      refuse("face " + quoted_name(surface.name) + " " + problem, hint);
    surface.material = *material;
    surface.back = entry.back;
    surface.elements = entry.elements;
    surface.group = *groups[group];
    surface.line = entry.line > 0 ? entry.line : face.line;
    scene_.add(std::move(surface), scaled(face.polygon, entry.scale));
  }
}

std::uint32_t MeshAdder3::material_of(const ObjMesh3& mesh, const ObjName3& name, bool invents) {
  if (const auto own = own_.find(name.name); own != own_.end()) return own->second;
  if (const auto found = mesh.library.find(name.name); found != mesh.library.end())
    return added_material(mesh, name.line, found->second);
  if (invents) {
    if (const auto problem = material_name_problem(name.name); !problem.empty())
      throw InputError({mesh.file, name.line}, problem);
    if (!added_.contains(name.name)) invented_.push_back(name.name);
    return added_material(mesh, name.line, {name.name, Spectrum::scalar(kObjReflectivity), {}});
  }
  SceneTable known;
  known.materials = scene_.materials;
  for (const auto& [its_name, material] : mesh.library) known.materials.push_back(material);
  throw InputError({mesh.file, name.line}, "the material " + quoted_name(name.name) + " is not defined",
                   undefined_material_hints(known, name.name));
}

std::uint32_t MeshAdder3::added_material(const ObjMesh3& mesh, int line, Material material) {
  const auto [entry, is_new] = added_.emplace(material.name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (is_new)
    scene_.materials.push_back(std::move(material));
  else if (scene_.materials[entry->second] != material)
    throw InputError({mesh.file, line},
                     "the material " + quoted_name(material.name) + " is another one in another mesh",
                     {"define it in the scene's \"materials\", which come first"});
  return entry->second;
}

ObjScene3 read_obj_3(const std::filesystem::path& file) {
  return parse_obj_scene_3(read_text_file(file), file.string());
}

ObjScene3 parse_obj_scene_3(std::string_view text, const std::string& file, const TextSource& files) {
  ObjScene3 result;
  result.scene.file = file;
  MeshEntry3 entry;
  entry.name = std::filesystem::path(file).stem().string();
  if (!name_problem(entry.name).empty()) entry.name = "mesh";
  entry.invents_materials = true;
  MeshAdder3 adder(result.scene);
  adder.add(parse_obj_3(text, file, files), entry);
  validate(result.scene);
  result.invented = adder.invented();
  return result;
}

}  // namespace hottel

#include "io/scene/space/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/scene_names.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/mtl_reader.h"
#include "io/scene/obj_statements.h"
#include "io/scene/space/mesh_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What says nothing of shape or diffuse light.
constexpr std::array<std::string_view, 11> kPassedOver{
    "vt", "vn", "s", "lod", "bevel", "usemap", "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib"};
// What is curved.
constexpr std::array<std::string_view, 17> kNotMadeOfFaces{"vp",    "cstype", "deg",  "bmat",  "step", "curv",
                                                           "curv2", "surf",   "parm", "trim",  "hole", "scrv",
                                                           "sp",    "end",    "con",  "ctech", "stech"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader3 {
 public:
  ObjReader3(std::string_view text, const std::string& file, const TextSource& files) : at_(text, file), files_(files) {
    mesh_.file = file;
  }

  Mesh3 read() {
    while (at_.next()) read_statement();
    if (mesh_.faces.empty()) throw InputError({mesh_.file, 0}, "has no faces");
    mesh_.unit = finest_.unit();
    name_bodies();
    return std::move(mesh_);
  }

 private:
  // The objects that the faces of a group are of: none, one, or several.
  struct ObjectsOfGroup {
    std::string first;
    bool are_several = false;
  };

  // A name in force, and its index once a face has it.
  struct Current {
    MeshName3 name;  // empty: none
    std::string typed;
    std::optional<std::uint32_t> index;
  };

  void read_statement() {
    const std::string_view keyword = at_.keyword();
    if (keyword == "v") return read_vertex();
    if (keyword == "f") return read_face();
    if (keyword == "o") object_ = name_of_words();
    if (keyword == "g" || keyword == "o") return set(group_, name_of_words(), std::string(at_.raw_rest()));
    if (keyword == "usemtl") return set(material_, std::string(at_.rest()));
    if (keyword == "mtllib") return read_libraries();
    if (is_one_of(keyword, kPassedOver)) return;
    if (keyword == "l" || keyword == "p") return pass_over(keyword == "l" ? PassedKind::kLine : PassedKind::kPoint);
    if (is_one_of(keyword, kNotMadeOfFaces))
      at_.refuse("'" + std::string(keyword) + "' is not read: curved surfaces are no plane faces");
    at_.refuse("the keyword " + quoted_name(keyword) + " is not known");
  }

  void read_vertex() {
    const std::vector<std::string_view> words = at_.words();
    // x y z [w], and perhaps a colour r g b.
    if (words.size() < 3 || words.size() == 5 || words.size() > 7)
      at_.refuse("a vertex has " + std::to_string(words.size()) + " numbers; it must have three, x y z");
    std::vector<Rational> numbers;
    for (const std::string_view word : words) numbers.push_back(at_.number(word, "coordinate"));
    for (std::size_t k = 0; k < 3; ++k) finest_.take(words[k]);
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
    MeshFace3 face;
    face.polygon.points.reserve(words.size());
    for (const std::string_view word : words) face.polygon.points.push_back(points_[vertex(word)]);
    face.group = used(group_, group_names_, mesh_.groups);
    if (face.group) note_object(*face.group);
    face.material = used(material_, material_names_, mesh_.materials);
    face.line = at_.line();
    mesh_.faces.push_back(std::move(face));
  }

  void pass_over(PassedKind kind, const std::string& name = "") {
    mesh_.passed_over.add(kind, {mesh_.file, at_.line()}, name);
  }

  // What is typed decides which group it is; its name has no comment, and one blank between words.
  std::string name_of_words() const {
    std::string name;
    for (const std::string_view word : at_.words()) name += (name.empty() ? "" : " ") + std::string(word);
    return name;
  }

  void note_object(std::uint32_t group) {
    if (group == objects_.size()) return objects_.push_back({object_});
    objects_[group].are_several |= objects_[group].first != object_;
  }

  // Groups are parts of the object that all their faces are of, where it has others.
  void name_bodies() {
    std::map<std::string, std::size_t> groups;
    for (const ObjectsOfGroup& of : objects_)
      if (!of.are_several) ++groups[of.first];
    for (const ObjectsOfGroup& of : objects_)
      mesh_.bodies.push_back(!of.are_several && groups.at(of.first) > 1 ? of.first : "");
  }

  void set(Current& current, std::string name) { set(current, name, name); }
  void set(Current& current, std::string name, std::string typed) {
    current = {{std::move(name), at_.line()}, std::move(typed), std::nullopt};
  }

  static std::optional<std::uint32_t> used(Current& current, MeshNames3& names, std::vector<MeshName3>& list) {
    if (current.name.name.empty() || current.index) return current.index;
    return current.index = names.index_of(current.typed, current.name, list);
  }

  // File names may have blanks: each ends in .mtl, or the line is one name.
  void read_libraries() {
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
    const auto text = library_text(path);
    if (!text) return;
    mesh_.has_library = true;
    mesh_.library_files.push_back(path.string());
    for (const Material& material : parse_mtl(*text, path.string())) {
      const auto [entry, is_new] = mesh_.library.emplace(material.name, material);
      if (!is_new) at_.refuse("the material " + quoted_name(entry->first) + " stands in two MTL files");
    }
  }

  // Nothing where it is missing: that is told, and refused where a material of it is needed.
  std::optional<std::string> library_text(const std::filesystem::path& path) {
    try {
      return read_named_file(files_, path, {mesh_.file, at_.line()}, "the file of materials");
    } catch (const MissingFile&) {
      if (mesh_.missing_library.empty()) mesh_.missing_library = path.string();
      pass_over(PassedKind::kMissingMaterialsFile, quoted_name(path.string()));
      return std::nullopt;
    }
  }

  ObjStatements at_;
  const TextSource& files_;
  Mesh3 mesh_;
  std::vector<Point3> points_;
  FinestDigit finest_;  // of these
  Current group_, material_;
  std::string object_;                   // in force; empty: none
  std::vector<ObjectsOfGroup> objects_;  // by group
  MeshNames3 group_names_, material_names_;
  std::vector<std::filesystem::path> libraries_;
};

}  // namespace

Mesh3 parse_obj_3(std::string_view text, const std::string& file, const TextSource& files) {
  return ObjReader3(text, file, files).read();
}

}  // namespace hottel

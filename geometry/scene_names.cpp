#include "geometry/scene_names.h"

#include <fnmatch.h>
#include <locale.h>

#include <algorithm>
#include <numeric>
#include <string_view>

#include "geometry/name.h"
#include "geometry/near_names.h"

namespace hottel {
namespace {

constexpr std::size_t kMostNames = 4;  // that are listed

// What may be named in a scene: the fronts and backs of its surfaces, or its surfaces and groups; and the sky.
std::vector<std::string> names_of(const SceneTable& scene, bool of_faces) {
  std::vector<std::string> names;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    names.push_back(face_name(scene, {s, false}));
    if (of_faces) names.push_back(face_name(scene, {s, true}));
  }
  for (const Group& group : scene.groups)
    if (!of_faces) names.push_back(group.name);
  names.emplace_back("sky");
  return names;
}

// "window*" for "window3", "room*" for "room[0]".
std::vector<std::string> beginnings(const SceneTable& scene) {
  std::vector<std::string> names = names_of(scene, false);
  for (std::string& name : names) {
    name.resize(std::min(name.size(), name.find_last_not_of("0123456789[].") + 1));
    name += '*';
  }
  return names;
}

// What there is of surfaces, for a message; empty where there is none.
std::string surfaces_text(const SceneTable& scene) {
  std::vector<std::uint32_t> all(scene.surfaces.size());
  std::iota(all.begin(), all.end(), 0u);
  return all.empty() ? "" : "its surfaces are " + names_text(scene, all);
}

constexpr const char* kGlobCharacters = "*?[";

template <class Matches>
std::vector<std::uint32_t> surfaces_that(const SceneTable& scene, const Matches& matches) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (matches(scene.surfaces[s].name) || matches(scene.groups[scene.surfaces[s].group].name)) result.push_back(s);
  return result;
}

// While it lives, characters of this thread are those of UTF-8.
class Utf8Scope {
 public:
  Utf8Scope() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (utf8_ != nullptr) before_ = uselocale(utf8_);
  }
  ~Utf8Scope() {
    if (utf8_ == nullptr) return;
    uselocale(before_);
    freelocale(utf8_);
  }
  Utf8Scope(const Utf8Scope&) = delete;
  Utf8Scope& operator=(const Utf8Scope&) = delete;

 private:
  locale_t utf8_, before_ = nullptr;
};

std::vector<std::uint32_t> surfaces_described(const SceneTable& scene, const std::string& pattern) {
  const Utf8Scope utf8;
  return surfaces_that(
      scene, [&](const std::string& name) { return fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0; });
}

// Of a pattern names are near to what it is without its own characters.
std::string without_glob_characters(std::string pattern) {
  std::erase_if(pattern, [](char c) { return std::string_view("*?[]").find(c) != std::string_view::npos; });
  return pattern;
}

}  // namespace

std::vector<std::uint32_t> surfaces_matching(const SceneTable& scene, const std::string& pattern) {
  std::vector<std::uint32_t> found = surfaces_that(scene, [&](const std::string& name) { return name == pattern; });
  const std::size_t star = pattern.find('*');
  const bool is_prefix = star != std::string::npos && star + 1 == pattern.size();
  if (found.empty() && is_prefix)
    found = surfaces_that(scene, [&](const std::string& name) { return name.starts_with(pattern.substr(0, star)); });
  const bool is_glob = pattern.find_first_of(kGlobCharacters) != std::string::npos;
  if (found.empty() && is_glob) found = surfaces_described(scene, pattern);
  if (!found.empty()) return found;
  const bool is_name = pattern.find_first_of("*?") == std::string::npos;
  const std::string text = "no surface of " + scene.file + (is_name ? " is called '" : " fits '") + pattern + "'";
  if (is_prefix) throw UnknownName(text, pattern, beginnings(scene), surfaces_text(scene));
  throw UnknownName(text, is_glob ? without_glob_characters(pattern) : pattern, names_of(scene, false),
                    surfaces_text(scene));
}

Face face_of(const SceneTable& scene, const std::string& name) {
  if (const auto surface = scene.find(name)) return {*surface, false};
  const SideName side = side_named(name);
  if (const auto surface = scene.find(side.name); surface && side.is_back) return {*surface, true};
  throw UnknownName("no face of " + scene.file + " is called '" + name + "'", name, names_of(scene, true),
                    surfaces_text(scene));
}

std::string face_name(const SceneTable& scene, const Face& face) {
  return side_text({scene.surfaces[face.surface].name, face.is_back});
}

std::string names_text(const SceneTable& scene, const std::vector<std::uint32_t>& surfaces) {
  const std::size_t named = surfaces.size() <= kMostNames ? surfaces.size() : kMostNames - 1;
  std::string text;
  for (std::size_t k = 0; k < named; ++k) {
    if (k > 0) text += k + 1 == surfaces.size() ? " and " : ", ";
    text += quoted_name(scene.surfaces[surfaces[k]].name);
  }
  if (named < surfaces.size()) text += " and " + std::to_string(surfaces.size() - named) + " more";
  return text;
}

std::string solid_text(const SceneTable& scene, std::uint32_t group) {
  return "the solid " + quoted_name(scene.groups[group].name);
}

Material& material_called(SceneTable& scene, const std::string& name) {
  std::vector<std::string> known;
  for (Material& material : scene.materials) {
    if (material.name == name) return material;
    known.push_back(material.name);
  }
  throw UnknownName("there is no material called '" + name + "'", name, known);
}

std::vector<std::string> undefined_material_hints(const SceneTable& scene, std::string_view name) {
  std::string defined = scene.materials.empty() ? "the scene defines no materials" : "defined are:";
  constexpr std::size_t kMost = 10;
  for (std::size_t i = 0; i < scene.materials.size() && i < kMost; ++i)
    defined += (i > 0 ? ", " : " ") + quoted_name(scene.materials[i].name);
  if (scene.materials.size() > kMost) defined += ", ...";
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  std::vector<std::string> hints = near_name_hints(name, names);
  hints.push_back(defined);
  return hints;
}

}  // namespace hottel

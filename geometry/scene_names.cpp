#include "geometry/scene_names.h"

#include <algorithm>

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

}  // namespace

std::vector<std::uint32_t> surfaces_matching(const SceneTable& scene, const std::string& pattern) {
  const bool is_prefix = !pattern.empty() && pattern.back() == '*';
  const std::string prefix = pattern.substr(0, pattern.size() - (is_prefix ? 1 : 0));
  const auto matches = [&](const std::string& name) { return is_prefix ? name.starts_with(prefix) : name == pattern; };
  std::vector<std::uint32_t> result;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (matches(scene.surfaces[s].name) || matches(scene.groups[scene.surfaces[s].group].name)) result.push_back(s);
  if (result.empty())
    throw UnknownName("no surface of " + scene.file + " is called '" + pattern + "'", pattern,
                      is_prefix ? beginnings(scene) : names_of(scene, false));
  return result;
}

Face face_of(const SceneTable& scene, const std::string& name) {
  if (const auto surface = scene.find(name)) return {*surface, false};
  const SideName side = side_named(name);
  if (const auto surface = scene.find(side.name); surface && side.is_back) return {*surface, true};
  throw UnknownName("no face of " + scene.file + " is called '" + name + "'", name, names_of(scene, true));
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

#include "viewer/edit/free_names.h"

#include <algorithm>
#include <string_view>

namespace hottel {
namespace {

constexpr std::string_view kCopy = " copy";

// The name without a final " copy" or " copy 2"; never empty.
std::string copied_name(const std::string& name) {
  std::string_view rest = name;
  const std::size_t end = rest.find_last_not_of("0123456789");
  if (end != std::string_view::npos && end + 1 < rest.size() && rest[end] == ' ') rest = rest.substr(0, end);
  return rest.ends_with(kCopy) && rest.size() > kCopy.size() ? std::string(rest.substr(0, rest.size() - kCopy.size()))
                                                             : name;
}

// The first of "STEM", "STEM 2", "STEM 3", ... that is free, if `number` is 1; else "STEM NUMBER" and on.
template <class IsFree>
std::string first_of(const std::string& stem, std::size_t number, bool says_one, const IsFree& is_free) {
  for (;; ++number) {
    std::string name = number == 1 && !says_one ? stem : stem + " " + std::to_string(number);
    if (is_free(name)) return name;
  }
}

}  // namespace

FreeNames::FreeNames(const SceneTable& scene) {
  for (const Surface& surface : scene.surfaces) take(surface.name);
  for (const Group& group : scene.groups) take(group.name);
  for (const Light& light : scene.lights) take(light.name);
}

std::string FreeNames::numbered(const std::string& noun) {
  std::string name = first_of(noun, 1, true, [&](const std::string& n) { return !taken_.contains(n); });
  take(name);
  return name;
}

std::string FreeNames::copy_of(const std::string& name) {
  return first_free(copied_name(name) + std::string(kCopy), 1);
}

std::string FreeNames::another(const std::string& name) { return first_free(name, 2); }

std::string FreeNames::first_free(const std::string& stem, std::size_t number) {
  std::string name = first_of(stem, number, false, [&](const std::string& n) { return !taken_.contains(n); });
  take(name);
  return name;
}

void FreeNames::take(const std::string& name) {
  for (std::size_t k = name.find('['); k != std::string::npos; k = name.find('[', k + 1))
    taken_.insert(name.substr(0, k));
  taken_.insert(name);
}

std::string free_copy_of_material(const SceneTable& scene, const std::string& name) {
  return first_of(copied_name(name) + std::string(kCopy), 1, false, [&](const std::string& n) {
    return std::none_of(scene.materials.begin(), scene.materials.end(),
                        [&](const Material& material) { return material.name == n; });
  });
}

}  // namespace hottel

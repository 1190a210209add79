#include "geometry/scene/scene_2.h"

#include <string_view>
#include <unordered_map>

#include "geometry/scene/name.h"

namespace hottel {

std::optional<std::uint32_t> Scene2::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

void validate(const Scene2& scene) {
  std::unordered_map<std::string_view, const Surface2*> first;
  first.reserve(scene.surfaces.size());
  for (const Surface2& surface : scene.surfaces) {
    const auto refuse = [&](const std::string& text, std::vector<std::string> hints = {}) {
      throw InputError({scene.file, surface.line}, text, std::move(hints));
    };
    if (const auto problem = name_problem(surface.name); !problem.empty())
      refuse("the name " + quoted_name(surface.name) + " " + std::string(problem));
    if (const auto [other, is_new] = first.emplace(surface.name, &surface); !is_new) {
      const int line = other->second->line;
      refuse("two surfaces have the name " + quoted_name(surface.name) +
             (line > 0 ? ", the other one in line " + std::to_string(line) : ""));
    }
    if (surface.from == surface.to) refuse("surface " + quoted_name(surface.name) + " has length zero");
    if (surface.material >= scene.materials.size() || (surface.back && *surface.back >= scene.materials.size()))
      refuse("surface " + quoted_name(surface.name) + " has a material that is not defined");
    if (surface.group >= scene.groups.size())
      refuse("surface " + quoted_name(surface.name) + " has a group that is not defined");
  }
}

}  // namespace hottel

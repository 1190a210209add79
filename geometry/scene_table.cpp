#include "geometry/scene_table.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

std::optional<std::uint32_t> SceneTable::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

void validate_table(const SceneTable& table) {
  std::unordered_map<std::string_view, const Surface*> first;
  first.reserve(table.surfaces.size());
  for (const Surface& surface : table.surfaces) {
    const auto refuse = [&](const std::string& text) { throw InputError({table.file, surface.line}, text); };
    if (const auto problem = name_problem(surface.name); !problem.empty())
      refuse("the name " + quoted_name(surface.name) + " " + std::string(problem));
    if (const auto [other, is_new] = first.emplace(surface.name, &surface); !is_new) {
      const int line = other->second->line;
      refuse("two surfaces have the name " + quoted_name(surface.name) +
             (line > 0 ? ", the other one in line " + std::to_string(line) : ""));
    }
    if (surface.material >= table.materials.size() || (surface.back && *surface.back >= table.materials.size()))
      refuse("surface " + quoted_name(surface.name) + " has a material that is not defined");
    if (surface.group >= table.groups.size())
      refuse("surface " + quoted_name(surface.name) + " has a group that is not defined");
  }
}

int channel_count(const SceneTable& table) {
  const bool is_scalar = table.sky_emission.is_scalar &&
                         std::all_of(table.materials.begin(), table.materials.end(), [](const Material& material) {
                           return material.reflectivity.is_scalar && material.emission.is_scalar;
                         });
  return is_scalar ? 1 : 3;
}

}  // namespace hottel

#include "viewer/edit/selection.h"

#include <algorithm>
#include <set>
#include <string>

namespace hottel {

Selection selection_of(Selection surfaces) {
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

Selection whole_groups(const SceneTable& scene, const Selection& selected) {
  std::vector<bool> is_wanted(scene.groups.size());
  for (const std::uint32_t s : selected) is_wanted[scene.surfaces[s].group] = true;
  Selection all;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (is_wanted[scene.surfaces[s].group]) all.push_back(s);
  return all;
}

Selection toggled(const Selection& selected, std::uint32_t touched, const Selection& others) {
  Selection all = selected;
  if (std::ranges::binary_search(selected, touched))
    std::erase_if(all, [&](std::uint32_t s) { return std::ranges::find(others, s) != others.end(); });
  else
    all.insert(all.end(), others.begin(), others.end());
  return selection_of(std::move(all));
}

bool is_furniture(const SceneTable& scene, const Selection& selected) {
  const std::vector<std::size_t> there = group_sizes(scene);
  std::vector<std::size_t> wanted(there.size());
  for (const std::uint32_t s : selected) ++wanted[scene.surfaces[s].group];
  return !selected.empty() && std::ranges::all_of(selected, [&](std::uint32_t s) {
    const std::uint32_t group = scene.surfaces[s].group;
    return there[group] > 1 && wanted[group] == there[group];
  });
}

Selection selection_called_as(const SceneTable& before, const Selection& selected, const SceneTable& now) {
  std::set<std::string> names;
  for (const std::uint32_t s : selected) names.insert(before.surfaces[s].name);
  Selection found;
  for (std::uint32_t s = 0; !names.empty() && s < now.surfaces.size(); ++s)
    if (names.contains(now.surfaces[s].name)) found.push_back(s);
  return found;
}

std::optional<std::uint32_t> light_called_as(const SceneTable& before, const std::optional<std::uint32_t>& light,
                                             const SceneTable& now) {
  if (!light) return std::nullopt;
  const auto found = std::ranges::find(now.lights, before.lights[*light].name, &Light::name);
  if (found == now.lights.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - now.lights.begin());
}

}  // namespace hottel

#include "geometry/plane/scene/polyline_runs.h"

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

std::size_t end_of_polyline(const Scene2& scene, std::size_t first) {
  const std::vector<Surface>& s = scene.surfaces;
  const std::vector<Edge2>& e = scene.edges;
  HOTTEL_REQUIRE(first < s.size());
  const std::string& group = scene.groups[s[first].group].name;
  if (!name_problem(group).empty()) return first;
  std::size_t i = first;
  while (i < s.size() && s[i].group == s[first].group) {
    if (s[i].name != piece_name(group, i - first)) return first;
    if (i > first && (e[i].from != e[i - 1].to || s[i].material != s[first].material || s[i].back != s[first].back ||
                      s[i].elements != s[first].elements || s[i].on != s[first].on))
      return first;
    ++i;
  }
  return i;
}

std::size_t first_of_polylines(const Scene2& scene) {
  std::size_t first = 0;
  std::vector<bool> is_known(scene.groups.size());
  for (std::size_t i = 0; i < scene.surfaces.size();) {
    const std::uint32_t group = scene.surfaces[i].group;
    const std::size_t end = is_known[group] ? i : end_of_polyline(scene, i);
    is_known[group] = true;
    if (end == i) first = i + 1;
    i = std::max(end, i + 1);
  }
  return first;
}

}  // namespace hottel

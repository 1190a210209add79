#include "geometry/plane/scene/closed_groups.h"

namespace hottel {

std::vector<ClosedGroup2> closed_groups(const Scene2& scene) {
  const std::vector<Surface>& s = scene.surfaces;
  const std::vector<Edge2>& e = scene.edges;
  std::vector<std::uint32_t> runs(scene.groups.size(), 0);  // of surfaces in the list
  std::vector<ClosedGroup2> found;
  for (std::size_t begin = 0, end = 0; begin < s.size(); begin = end) {
    const std::uint32_t group = s[begin].group;
    ++runs[group];
    bool follows = true, has_back = false;
    for (end = begin; end < s.size() && s[end].group == group; ++end) {
      follows = follows && !s[end].on && (end == begin || e[end].from == e[end - 1].to);
      has_back |= s[end].back.has_value();
    }
    if (!follows || end - begin < 2 || e[end - 1].to != e[begin].from) continue;
    Rational area = 0;  // twice
    for (std::size_t k = begin; k < end; ++k)
      area += (e[k].from.x - e[begin].from.x) * (e[k].to.y - e[begin].from.y) -
              (e[k].to.x - e[begin].from.x) * (e[k].from.y - e[begin].from.y);
    found.push_back({group, sgn(area), has_back});
  }
  std::erase_if(found, [&](const ClosedGroup2& closed) { return runs[closed.group] != 1; });
  return found;
}

}  // namespace hottel

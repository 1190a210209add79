#include "geometry/plane/scene/closed_groups.h"

namespace hottel {

std::vector<ClosedGroup2> closed_groups(const Scene2& scene) {
  const std::vector<Surface2>& s = scene.surfaces;
  std::vector<std::uint32_t> runs(scene.groups.size(), 0);  // of surfaces in the list
  std::vector<ClosedGroup2> found;
  for (std::size_t begin = 0, end = 0; begin < s.size(); begin = end) {
    const std::uint32_t group = s[begin].group;
    ++runs[group];
    bool follows = true, has_back = false;
    for (end = begin; end < s.size() && s[end].group == group; ++end) {
      follows = follows && (end == begin || s[end].from == s[end - 1].to);
      has_back |= s[end].back.has_value();
    }
    if (!follows || end - begin < 2 || s[end - 1].to != s[begin].from) continue;
    Rational area = 0;  // twice
    for (std::size_t k = begin; k < end; ++k)
      area += (s[k].from.x - s[begin].from.x) * (s[k].to.y - s[begin].from.y) -
              (s[k].to.x - s[begin].from.x) * (s[k].from.y - s[begin].from.y);
    found.push_back({group, sgn(area), has_back});
  }
  std::erase_if(found, [&](const ClosedGroup2& closed) { return runs[closed.group] != 1; });
  return found;
}

}  // namespace hottel

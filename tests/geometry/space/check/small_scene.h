// Scenes in space of a few polygons, made in a line each.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/check/finding.h"
#include "geometry/space/scene/scene.h"

namespace hottel::testing_space {

inline Rational q(const char* text) { return *parse_rational(text); }

// Material 0 is "white", 1 the "lamp".
inline Scene3 empty_scene() {
  Scene3 scene;
  scene.file = "small.json";
  scene.materials.push_back({"white", Spectrum::scalar(Rational(1) / 2), {}});
  scene.materials.push_back({"lamp", Spectrum::scalar(Rational(1) / 10), Spectrum::scalar(Rational(5))});
  return scene;
}

// Puts a polygon into a group, which is a new one if there is none of that name; of its own name where none is given.
inline Surface& add(Scene3& scene, const std::string& name, std::vector<Point3> points, std::string group = "") {
  if (group.empty()) group = name;
  const auto at = std::find_if(scene.groups.begin(), scene.groups.end(), [&](auto& g) { return g.name == group; });
  Surface surface;
  surface.name = name;
  surface.group = static_cast<std::uint32_t>(at - scene.groups.begin());
  surface.line = 10 + static_cast<int>(scene.surfaces.size());
  if (at == scene.groups.end()) scene.groups.emplace_back(group);
  Polygon3 polygon;
  polygon.points = std::move(points);
  scene.add(std::move(surface), std::move(polygon));
  return scene.surfaces.back();
}

// The six walls of a box along the axes: bottom, top, front, rear, left, right; in a group of that name, or each in its
// own where that is empty. Fronts look outward, or inward into a room.
inline void add_box(Scene3& scene, const std::string& group, const Point3& low, const Point3& high, bool is_room) {
  const auto corner = [&](int k) {
    return Point3{(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z};
  };
  constexpr std::array<const char*, 6> kNames{"bottom", "top", "front", "rear", "left", "right"};
  constexpr int kCorners[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (std::size_t side = 0; side < 6; ++side) {
    std::vector<Point3> points;
    for (const int k : kCorners[side]) points.push_back(corner(k));
    if (is_room) std::reverse(points.begin(), points.end());
    const std::string name = (group.empty() ? "" : group + ".") + kNames[side];
    add(scene, name, std::move(points), group);
  }
}

// Fronts inward, every wall in a group of its own.
inline Scene3 unit_room() {
  Scene3 scene = empty_scene();
  add_box(scene, "", {0, 0, 0}, {1, 1, 1}, true);
  scene.surfaces[1].material = 1;
  return scene;
}

// "warning near-contact a b" of each finding, in their order.
inline std::vector<std::string> told(const Scene3& scene, const Findings3& findings) {
  std::vector<std::string> result;
  for (const Finding3& finding : findings) {
    std::string text = std::string(to_string(finding.severity)) + " " + finding.kind;
    for (const std::uint32_t s : finding.surfaces) text += " " + scene.surfaces[s].name;
    result.push_back(std::move(text));
  }
  return result;
}

}  // namespace hottel::testing_space

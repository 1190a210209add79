#include "geometry/space/check/solid_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;

bool emits(const Scene3& scene, std::uint32_t s) {
  for (const bool is_back : {false, true})
    if (const auto material = scene.surfaces[s].material_of(is_back))
      if (!scene.materials[*material].emission.is_zero()) return true;
  return false;
}

// The group of the solid that has all corners of these surfaces in its interior, the one that has the first of them.
std::optional<std::uint32_t> holder_of(const Scene3& scene, const Solids3& solids, const Surfaces& surfaces) {
  std::vector<Point3> corners;
  for (const std::uint32_t s : surfaces)
    for (Point3& corner : corners_of(scene.polygons[s])) corners.push_back(std::move(corner));
  std::sort(corners.begin(), corners.end(), [](const Point3& a, const Point3& b) { return precedes(a, b); });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::optional<std::uint32_t> holder;
  for (const Point3& corner : corners) {
    const auto mesh = solids.around(corner);
    if (!mesh) return std::nullopt;
    if (!holder) holder = solids.meshes()[*mesh].group;
  }
  return holder;
}

}  // namespace

SolidFindings3 solid_findings(const Scene3& scene, const Solids3& solids) {
  SolidFindings3 result;
  result.is_held.assign(scene.groups.size(), 0);
  if (solids.is_empty()) return result;
  std::vector<Surfaces> of_group(scene.groups.size());
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) of_group[scene.surfaces[s].group].push_back(s);
  std::map<std::uint32_t, Surfaces> held;  // groups, by that of the solid
  for (std::uint32_t group = 0; group < of_group.size(); ++group)
    if (const auto holder = holder_of(scene, solids, of_group[group]); holder && *holder != group) {
      held[*holder].push_back(group);
      result.is_held[group] = 1;
    }
  for (const auto& [solid, groups] : held) {
    Surfaces surfaces = of_group[solid];
    const Point3 at = middle(scene.polygons[surfaces.front()]);
    std::vector<std::string> names, lost;
    for (const std::uint32_t group : groups) {
      names.push_back(scene.groups[group].name);
      if (std::any_of(of_group[group].begin(), of_group[group].end(), [&](auto s) { return emits(scene, s); }))
        lost.push_back(names.back());
      surfaces.insert(surfaces.end(), of_group[group].begin(), of_group[group].end());
    }
    result.findings.push_back(
        {Severity::kWarning, "filled-room", std::move(surfaces), at,
         fmt::format("{} is solid, and {} {} in its interior, where nothing is seen{}: was a room meant?",
                     quoted_name(solids.mesh_of(solid)->name), listed_names(names), names.size() == 1 ? "is" : "are",
                     lost.empty() ? "" : "; the light of " + listed_names(lost) + " is lost"),
         "where a room was meant, list the points of its polygons the other way round; else take away what is inside "
         "it, or say \"behind\": \"open\""});
  }
  return result;
}

}  // namespace hottel

#include "geometry/space/check/shells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/arrangement/solids.h"
#include "geometry/space/check/edge_stretches.h"
#include "geometry/space/check/wording.h"
#include "kernel/support/disjoint_sets.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;

// Surfaces of one group with an edge in common are of one part.
class Parts {
 public:
  explicit Parts(const Scene3& scene) : sets_(scene.surfaces.size()), is_closed_(scene.surfaces.size(), 1) {
    const Surfaces unit = units(scene);
    for (const EdgeStretch3& stretch : find_edge_stretches(scene)) {
      std::map<std::uint32_t, std::vector<EdgeUse3>> by_group;
      for (const EdgeUse3& use : stretch.uses) by_group[unit[scene.surfaces[use.surface].group]].push_back(use);
      for (const auto& [group, uses] : by_group) join(uses);
    }
  }

  // The closed ones, each in order.
  std::vector<Surfaces> closed() {
    std::map<std::uint32_t, Surfaces> parts;
    std::vector<char> is_open(is_closed_.size(), 0);
    for (std::uint32_t s = 0; s < is_closed_.size(); ++s) {
      parts[sets_.root(s)].push_back(s);
      if (is_closed_[s] == 0) is_open[sets_.root(s)] = 1;
    }
    std::vector<Surfaces> result;
    for (auto& [first, surfaces] : parts)
      if (is_open[first] == 0 && surfaces.size() >= 4) result.push_back(std::move(surfaces));
    return result;
  }

 private:
  // By group: the first of its body.
  static Surfaces units(const Scene3& scene) {
    std::map<std::string, std::uint32_t> first;
    Surfaces unit;
    for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
      const std::string& body = scene.groups[g].body;
      unit.push_back(body.empty() ? g : first.emplace(body, g).first->second);
    }
    return unit;
  }

  // Where an edge has as many uses each way the parts that have it are closed there.
  void join(const std::vector<EdgeUse3>& uses) {
    const auto forward = std::count_if(uses.begin(), uses.end(), [](const EdgeUse3& use) { return !use.is_reversed; });
    for (const EdgeUse3& use : uses) {
      if (2 * static_cast<std::size_t>(forward) != uses.size()) is_closed_[use.surface] = 0;
      sets_.join_to_smaller(uses.front().surface, use.surface);
    }
  }

  DisjointSets sets_;            // of surfaces
  std::vector<char> is_closed_;  // by surface
};

// Six times the volume on the side of the backs, if the part is closed.
Rational volume(const Scene3& scene, const Surfaces& surfaces) {
  const Point3& origin = scene.polygons[surfaces.front()].points[0];
  Rational sum;
  for (const std::uint32_t s : surfaces)
    sum += dot(doubled_area(scene.polygons[s]), scene.polygons[s].points[0] - origin);
  return sum;
}

// A closed part by itself as a solid, with its fronts outward.
Solids3 as_solid(const Scene3& scene, const Surfaces& surfaces, bool is_inward) {
  Scene3 alone;
  alone.groups.emplace_back(scene.groups[scene.surfaces[surfaces.front()].group].name);
  alone.materials = scene.materials;
  for (const std::uint32_t s : surfaces) {
    Surface surface = scene.surfaces[s];
    surface.group = 0;
    surface.in_mesh = {};
    surface.back.reset();
    Polygon3 polygon = scene.polygons[s];
    if (is_inward) std::reverse(polygon.points.begin() + 1, polygon.points.end());
    alone.add(std::move(surface), std::move(polygon));
  }
  return Solids3(alone);
}

// What holds all corners of a part.
struct CornerBox {
  CornerBox(const Scene3& scene, const Surfaces& surfaces)
      : low(scene.polygons[surfaces.front()].points[0]), high(low) {
    for (const std::uint32_t s : surfaces)
      for (const Point3& p : scene.polygons[s].points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
  }
  // In it, or on its border.
  bool hold(const Point3& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }

  Point3 low, high;
};

// Whether the front of a polygon looks into a solid, in its middle: as a window that lies on a wall does.
bool looks_into(const Solids3& solids, const Polygon3& polygon) {
  const Polygon3 facet = facets_of(polygon).front();
  const PlaneFrame3 frame(facet.points);
  return solids.behind({&frame, frame.flat(middle(facet)), frame.is_front_up(facet.points)}).has_value();
}

// The middle and the corners of a grid; of a volume those of its two ends.
std::vector<Point3> marks_of(const Grid3& grid) {
  const Rational half(1, 2);
  std::vector<Point3> marks{place_in(grid, half, half, half)};
  for (int r = 0; r <= (grid.w ? 1 : 0); ++r)
    for (const int t : {0, 1})
      for (const int s : {0, 1}) marks.push_back(place_in(grid, s, t, r));
  return marks;
}

// Whether something of the scene that is none of these surfaces is in a solid. What `is_of_part` is a face of another
// closed part: where that lies on the border and looks into the solid, its part is outside.
bool holds_anything(const Scene3& scene, const Solids3& solids, const Surfaces& surfaces,
                    const std::vector<char>& is_of_part) {
  const auto is_in = [&](const Point3& point) { return solids.around(point).has_value(); };
  const CornerBox box(scene, surfaces);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (std::binary_search(surfaces.begin(), surfaces.end(), s)) continue;
    const std::vector<Point3> corners = corners_of(scene.polygons[s]);
    if (is_in(middle(scene.polygons[s])) || std::any_of(corners.begin(), corners.end(), is_in) ||
        (is_of_part[s] == 0 &&
         std::all_of(corners.begin(), corners.end(), [&](const Point3& p) { return box.hold(p); }) &&
         looks_into(solids, scene.polygons[s])))
      return true;
  }
  if (std::any_of(scene.light_places.begin(), scene.light_places.end(),
                  [&](const LightPlace3& place) { return is_in(place.position); }))
    return true;
  if (scene.camera && is_in(scene.camera->eye)) return true;
  return std::ranges::any_of(scene.grids,
                             [&](const Grid3& grid) { return std::ranges::any_of(marks_of(grid), is_in); });
}

bool may_have_parts(const Scene3& scene) {
  const std::vector<std::size_t> sizes = group_sizes(scene);
  return std::any_of(sizes.begin(), sizes.end(), [](std::size_t size) { return size >= 4; }) ||
         std::any_of(scene.groups.begin(), scene.groups.end(), [](const Group& group) { return !group.body.empty(); });
}

bool is_room_by_word(const Scene3& scene, const Surfaces& surfaces) {
  return scene.groups[scene.surfaces[surfaces.front()].group].behind == Behind::kOpen ||
         std::any_of(surfaces.begin(), surfaces.end(),
                     [&](std::uint32_t s) { return scene.surfaces[s].back.has_value(); });
}

// "'a'", or "a part of 'a' (12 polygons, 'a[3]' the first)".
std::string shell_text(const Scene3& scene, const Shell3& shell) {
  const Group& own = scene.groups[shell.group];
  const auto is_of_it = [&](const Surface& surface) {
    const Group& group = scene.groups[surface.group];
    return own.body.empty() ? surface.group == shell.group : group.body == own.body;
  };
  const std::string name = quoted_name(own.body.empty() ? own.name : own.body);
  const auto members = static_cast<std::size_t>(std::count_if(scene.surfaces.begin(), scene.surfaces.end(), is_of_it));
  if (members == shell.surfaces.size()) return name;
  return fmt::format("a part of {} ({} polygons, {} the first)", name, shell.surfaces.size(),
                     quoted_name(scene.surfaces[shell.surfaces.front()].name));
}

std::string remedy(const Scene3& scene, const Shell3& shell) {
  const std::string turn = "for a body list the points of each polygon the other way round";
  if (shell.may_be_body) return "was a room meant? F" + turn.substr(1) + ", as `--fix OUT` does";
  return scene.closed ? turn : turn + "; of a room promise that it is closed: \"closed\": true";
}

}  // namespace

std::vector<Surfaces> closed_parts(const Scene3& scene) {
  return may_have_parts(scene) ? Parts(scene).closed() : std::vector<Surfaces>{};
}

std::vector<Shell3> inside_out_shells(const Scene3& scene) {
  std::vector<Surfaces> inward, outward;
  std::vector<char> is_of_part(scene.surfaces.size(), 0);
  for (Surfaces& surfaces : closed_parts(scene)) {
    for (const std::uint32_t s : surfaces) is_of_part[s] = 1;
    const Rational side = volume(scene, surfaces);
    if (side != 0) (side < 0 ? inward : outward).push_back(std::move(surfaces));
  }
  std::vector<Shell3> shells;
  for (const Surfaces& surfaces : inward) {
    const bool has_others = surfaces.size() < scene.surfaces.size();
    if (is_room_by_word(scene, surfaces) || (scene.closed && !has_others)) continue;
    const Point3& corner = scene.polygons[surfaces.front()].points.front();
    const bool is_hollow = std::any_of(outward.begin(), outward.end(), [&](const Surfaces& body) {
      return CornerBox(scene, body).hold(corner) && as_solid(scene, body, false).around(corner).has_value();
    });
    if (is_hollow) continue;
    const Solids3 solid = as_solid(scene, surfaces, true);
    if (solid.is_empty() || holds_anything(scene, solid, surfaces, is_of_part)) continue;
    const bool may_be_body = !scene.closed && (has_others || !scene.sky_emission.is_zero());
    shells.push_back({scene.surfaces[surfaces.front()].group, surfaces, may_be_body});
  }
  return shells;
}

void tell_inside_out(const Scene3& scene, const std::vector<Shell3>& shells, Findings3& findings) {
  for (const Shell3& shell : shells) {
    const auto told = std::find_if(findings.begin(), findings.end(), [&](const Finding3& finding) {
      return finding.kind == "inside-out" && std::find(finding.surfaces.begin(), finding.surfaces.end(),
                                                       shell.surfaces.front()) != finding.surfaces.end();
    });
    if (told != findings.end()) {
      if (shell.may_be_body) told->severity = Severity::kWarning;
      continue;
    }
    findings.push_back(
        {Severity::kWarning, "inside-out", shell.surfaces, middle(scene.polygons[shell.surfaces.front()]),
         shell_text(scene, shell) + " is closed with its fronts inward, and nothing is in it", remedy(scene, shell)});
  }
}

}  // namespace hottel

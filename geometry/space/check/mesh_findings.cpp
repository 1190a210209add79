#include "geometry/space/check/mesh_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/contacts/box_tree.h"
#include "geometry/space/contacts/corner_table.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;

struct PointOrder {
  bool operator()(const Point3& a, const Point3& b) const { return precedes(a, b); }
};

// What lies along edges, for the question whether an edge lies on something.
class Ground {
 public:
  explicit Ground(const std::vector<Polygon3>& polygons) : polygons_(polygons), tree_(boxes_of(polygons)) {}

  // Polygons other than those of `without` (by surface) cover all of the segment.
  template <class Without>
  bool carries(const Side3& segment, const Without& without) const {
    Box3 box;
    include_rounded(segment.from, box);
    include_rounded(segment.to, box);
    Surfaces found;
    tree_.find(box, found);
    std::erase_if(found, without);
    return !found.empty() && is_covered(segment, polygons_, found);
  }

 private:
  static std::vector<Box3> boxes_of(const std::vector<Polygon3>& polygons) {
    std::vector<Box3> boxes(polygons.size());
    for (std::size_t s = 0; s < polygons.size(); ++s)
      for (const Point3& p : polygons[s].points) include_rounded(p, boxes[s]);
    return boxes;
  }

  const std::vector<Polygon3>& polygons_;
  const BoxTree3 tree_;
};

class MeshFinder {
 public:
  explicit MeshFinder(const Scene3& scene)
      : scene_(scene), ground_(scene.polygons), stretches_(find_edge_stretches(scene)) {}

  Meshes3 find() {
    find_units();
    find_reversed();
    look_at_groups();
    find_bare();
    return std::move(meshes_);
  }

 private:
  // The group that stands for that of a surface: its own, or the first of a body.
  std::uint32_t unit_of(std::uint32_t surface) const { return unit_[scene_.surfaces[surface].group]; }
  std::uint32_t group_of(const EdgeUse3& use) const { return unit_of(use.surface); }
  bool is_reversed(const EdgeUse3& use) const {
    return std::binary_search(meshes_.reversed.begin(), meshes_.reversed.end(), use.surface);
  }

  // Groups of a body of which none is closed are one.
  void find_units() {
    const std::size_t count = scene_.groups.size();
    unit_.resize(count);
    std::iota(unit_.begin(), unit_.end(), 0u);
    std::map<std::string, Surfaces> bodies;
    for (std::uint32_t g = 0; g < count; ++g)
      if (!scene_.groups[g].body.empty()) bodies[scene_.groups[g].body].push_back(g);
    if (bodies.empty()) return;
    const std::vector<char> is_closed = closed_groups();
    for (const auto& [name, groups] : bodies)
      if (std::none_of(groups.begin(), groups.end(), [&](std::uint32_t g) { return is_closed[g] != 0; }))
        for (const std::uint32_t g : groups) unit_[g] = groups.front();
  }

  std::vector<char> closed_groups() const {
    std::vector<char> is_closed(scene_.groups.size(), 0);
    for (const Surface& surface : scene_.surfaces)
      if (!surface.on) is_closed[surface.group] = 1;
    for (const EdgeStretch3& stretch : stretches_) {
      std::map<std::uint32_t, int> balance;
      for (const EdgeUse3& use : stretch.uses) balance[group_of(use)] += use.is_reversed ? -1 : 1;
      for (const auto& [group, sum] : balance)
        if (sum != 0) is_closed[group] = 0;
    }
    return is_closed;
  }

  // Polygons whose edges are all in common with one other each, which has its front on the other side there, where
  // those others agree with a third.
  void find_reversed() {
    struct Neighbours {
      std::size_t against = 0, with = 0, alone = 0;
      Surfaces others;
    };
    std::vector<Neighbours> of(scene_.polygons.size());
    for (const EdgeStretch3& stretch : stretches_) {
      const bool is_pair = stretch.uses.size() == 2 && stretch.uses[0].surface != stretch.uses[1].surface;
      const bool is_against = is_pair && stretch.uses[0].is_reversed == stretch.uses[1].is_reversed;
      for (std::size_t k = 0; k < stretch.uses.size(); ++k) {
        Neighbours& here = of[stretch.uses[k].surface];
        ++(!is_pair ? here.alone : is_against ? here.against : here.with);
        if (is_pair) here.others.push_back(stretch.uses[1 - k].surface);
      }
    }
    for (std::uint32_t s = 0; s < of.size(); ++s) {
      if (of[s].against < 3 || of[s].with + of[s].alone > 0) continue;
      if (std::all_of(of[s].others.begin(), of[s].others.end(), [&](std::uint32_t t) { return of[t].with > 0; }))
        meshes_.reversed.push_back(s);
    }
  }

  void look_at_groups() {
    const std::size_t count = scene_.groups.size();
    std::vector<std::size_t> polygons(count, 0), shared(count, 0);
    std::vector<std::vector<EdgeStretch3>> open(count);
    meshes_.is_closed.assign(count, 1);
    meshes_.is_room.assign(count, 0);
    for (const Surface& surface : scene_.surfaces)
      if (!surface.on) ++polygons[unit_[surface.group]];
    for (const EdgeStretch3& stretch : stretches_) {
      std::map<std::uint32_t, EdgeStretch3> by_group;
      for (const EdgeUse3& use : stretch.uses) {
        EdgeStretch3& part =
            by_group.try_emplace(group_of(use), EdgeStretch3{stretch.from, stretch.to, {}}).first->second;
        part.uses.push_back(use);
      }
      for (auto& [group, part] : by_group) {
        const auto forward = static_cast<std::size_t>(
            std::count_if(part.uses.begin(), part.uses.end(), [](const EdgeUse3& use) { return !use.is_reversed; }));
        if (2 * forward != part.uses.size()) meshes_.is_closed[group] = 0;
        if (part.uses.size() == 1) {
          open[group].push_back(std::move(part));
        } else {
          ++shared[group];
          tell_of(part, forward);
        }
      }
    }
    for (std::uint32_t group = 0; group < count; ++group) {
      if (polygons[group] == 0) meshes_.is_closed[group] = 0;
      if (polygons[group] < 3 || shared[group] <= open[group].size()) continue;
      std::erase_if(open[group], [&](const EdgeStretch3& edge) {
        return ground_.carries({edge.from, edge.to}, [&](std::uint32_t s) { return unit_of(s) == group; });
      });
      add_holes(group, std::move(open[group]));
    }
    find_rooms();
    for (std::uint32_t group = 0; group < count; ++group) {
      meshes_.is_closed[group] = meshes_.is_closed[unit_[group]];
      meshes_.is_room[group] = meshes_.is_room[unit_[group]];
    }
  }

  void tell_of(const EdgeStretch3& part, std::size_t forward) {
    if (part.uses.size() > 2) {
      meshes_.crowded.push_back(part);
    } else if (forward != 1 && !is_reversed(part.uses[0]) && !is_reversed(part.uses[1])) {
      meshes_.opposed.push_back(part);
    }
  }

  // Of a group, or of the body that it stands for.
  std::string name_of(std::uint32_t unit) const {
    const bool is_body = std::count(unit_.begin(), unit_.end(), unit) > 1;
    return is_body ? scene_.groups[unit].body : scene_.groups[unit].name;
  }

  // Edges that have ends in common are of one hole.
  void add_holes(std::uint32_t group, std::vector<EdgeStretch3> edges) {
    std::vector<std::size_t> parent(edges.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t k) {
      while (parent[k] != k) k = parent[k] = parent[parent[k]];
      return k;
    };
    std::map<Point3, std::size_t, PointOrder> at;
    for (std::size_t k = 0; k < edges.size(); ++k)
      for (const Point3& end : {edges[k].from, edges[k].to}) {
        const std::size_t a = root(at.try_emplace(end, k).first->second), b = root(k);
        parent[std::max(a, b)] = std::min(a, b);
      }
    std::map<std::size_t, std::size_t> hole;  // by root
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto [place, is_new] = hole.try_emplace(root(k), meshes_.holes.size());
      if (is_new) meshes_.holes.push_back({group, name_of(group), {}});
      meshes_.holes[place->second].edges.push_back(std::move(edges[k]));
    }
  }

  // A closed mesh with a negative volume has its fronts inside.
  void find_rooms() {
    if (scene_.polygons.empty()) return;
    const Point3& origin = scene_.polygons[0].points[0];
    std::vector<Rational> volume(scene_.groups.size());
    for (std::size_t s = 0; s < scene_.polygons.size(); ++s) {
      const std::uint32_t group = unit_of(static_cast<std::uint32_t>(s));
      if (meshes_.is_closed[group] != 0 && !scene_.surfaces[s].on)
        volume[group] += dot(doubled_area(scene_.polygons[s]), scene_.polygons[s].points[0] - origin);
    }
    for (std::size_t group = 0; group < volume.size(); ++group) meshes_.is_room[group] = volume[group] < 0;
  }

  void find_bare() {
    for (const EdgeStretch3& stretch : stretches_) {
      const std::uint32_t own = stretch.uses.front().surface;
      if (stretch.uses.size() == 1 &&
          !ground_.carries({stretch.from, stretch.to}, [&](std::uint32_t s) { return s == own; }))
        meshes_.bare.push_back(stretch);
    }
  }

  const Scene3& scene_;
  const Ground ground_;
  const std::vector<EdgeStretch3> stretches_;
  std::vector<std::uint32_t> unit_;  // by group
  Meshes3 meshes_;
};

Surfaces surfaces_of(const std::vector<EdgeStretch3>& edges) {
  std::set<std::uint32_t> surfaces;
  for (const EdgeStretch3& edge : edges)
    for (const EdgeUse3& use : edge.uses) surfaces.insert(use.surface);
  return {surfaces.begin(), surfaces.end()};
}

std::string edge_text(const EdgeStretch3& edge) { return place_text(edge.from) + " to " + place_text(edge.to); }

Finding3 hole_finding(const Meshes3::Hole& hole) {
  const EdgeStretch3& first = hole.edges.front();
  const std::string group = quoted_name(hole.name);
  std::string message =
      hole.edges.size() == 1
          ? fmt::format("{} is open along an edge, from {}", group, edge_text(first))
          : fmt::format("{} is open along {} edges, the first from {}", group, hole.edges.size(), edge_text(first));
  message += ": no other polygon of it is there, and nothing that they lie on";
  if (hole.edges.size() == 1) message.replace(message.rfind("they lie"), 8, "it lies");
  return {
      Severity::kWarning,      "open-mesh",
      surfaces_of(hole.edges), middle(first.from, first.to),
      std::move(message),      "if it should be closed, add the polygon that is missing, or give both the same points"};
}

}  // namespace

Meshes3 find_meshes(const Scene3& scene) { return MeshFinder(scene).find(); }

Findings3 mesh_findings(const Scene3& scene, const Meshes3& meshes) {
  Findings3 findings;
  for (const Meshes3::Hole& hole : meshes.holes) findings.push_back(hole_finding(hole));
  for (const std::uint32_t s : meshes.reversed)
    findings.push_back({Severity::kWarning,
                        "upside-down",
                        {s},
                        middle(scene.polygons[s]),
                        fmt::format("{} has its front on the other side than all polygons around it",
                                    quoted_name(scene.surfaces[s].name)),
                        "list its points the other way round"});
  for (const EdgeStretch3& edge : meshes.opposed)
    findings.push_back({Severity::kWarning, "opposed-fronts", surfaces_of({edge}), middle(edge.from, edge.to),
                        fmt::format("{} meet from {} with their fronts on different sides",
                                    names_text(scene, surfaces_of({edge})), edge_text(edge)),
                        "list the points of one of them the other way round"});
  for (const EdgeStretch3& edge : meshes.crowded)
    findings.push_back({Severity::kNote, "crowded-edge", surfaces_of({edge}), middle(edge.from, edge.to),
                        fmt::format("{} polygons of one group meet from {}: {}", edge.uses.size(), edge_text(edge),
                                    names_text(scene, surfaces_of({edge}))),
                        "of a closed body two meet at each edge; give bodies that touch groups of their own"});
  return findings;
}

}  // namespace hottel

#include "geometry/space/visibility/view_shells.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

// Larger ones are seldom convex.
constexpr std::size_t kMostPolygons = 24;
constexpr std::size_t kMostRound = 6;

// The normal towards the positive side, as a unit vector; zero where doubles do not tell it to 1e-10.
Direction3 inward_normal(const EyePlanes3& planes, PlaneSide3 side) {
  const BoundedVector& m = planes.normal(side.plane);
  const double size = std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
  if (!(size > 0x1p-400 && size < 0x1p400) || !(m.error < 1e-10 * size)) return {};
  const double factor = side.is_opposite ? -1 / size : 1 / size;
  return {factor * m.x, factor * m.y, factor * m.z};
}

}  // namespace

bool hides_all(const ViewShell3& shell, const ViewCone3& target) {
  if (target.is_wide() || !(shell.around.farthest < target.nearest)) return false;
  constexpr double kSlack = 1e-9;
  return std::all_of(shell.cone.inward.begin(), shell.cone.inward.end(), [&target](const Direction3& m) {
    return m.x * target.x + m.y * target.y + m.z * target.z > target.sine + kSlack;
  });
}

ViewShells3::ViewShells3(EyePlanes3& planes, const ViewCones3& cones) : planes_(planes), cones_(cones) {
  const Occluders3& occluders = planes.occluders();
  const std::size_t count = occluders.size();
  find_neighbours();
  shell_of_.assign(count, kNone);
  std::size_t corners = 0;
  for (std::size_t s = 0; s < count; ++s) corners += occluders.outline(s).size();
  // Shells point to what follows: it must not move.
  polygons_.reserve(count);
  corners_.reserve(corners);
  sides_.reserve(corners);
  inward_.reserve(corners);
  shells_.reserve(count);
  for (std::uint32_t s = 0; s < count; ++s) {
    if (planes.facing(s) == 0 || shell_of_[s] != kNone) continue;
    gather(s);
    if (!add_shell(gathered_))
      for (const std::uint32_t& k : gathered_) add_shell({&k, 1});
  }
  find_buried();
}

void ViewShells3::find_neighbours() {
  const Occluders3& occluders = planes_.occluders();
  neighbours_.resize(occluders.edge_count());
  for (std::uint32_t s = 0; s < occluders.size(); ++s) {
    if (planes_.facing(s) == 0) continue;
    for (const DirectedEdge3& edge : occluders.edges(s)) {
      Neighbours& at = neighbours_[edge.edge.index()];
      const std::size_t place = at.polygons[0] == kNone ? 0 : 1;
      at.are_more |= at.polygons[place] != kNone;
      at.polygons[place] = s;
      at.are_opposite[place] = side_of(s, edge).is_opposite;
    }
  }
}

// The polygon on the other side of the plane of an edge, where it goes on, or on the same side; or kNone.
std::uint32_t ViewShells3::neighbour(std::uint32_t s, PlaneSide3 side, bool goes_on) const {
  const Neighbours& at = neighbours_[side.plane.index()];
  if (at.are_more || at.polygons[1] == kNone || (at.are_opposite[0] != at.are_opposite[1]) != goes_on) return kNone;
  return at.polygons[at.polygons[0] == s ? 1 : 0];
}

// Whether no corner of a polygon is on the eye's side of the plane of another one.
bool ViewShells3::is_beyond(std::uint32_t s, std::uint32_t other) {
  const auto corners = planes_.occluders().outline(s);
  return std::none_of(corners.begin(), corners.end(),
                      [this, other](VertexId3 v) { return planes_.nearness(v, other) > 0; });
}

// Whether a polygon is on or beyond the plane of another one that it goes on from: then so is that one of its.
bool ViewShells3::bulges(std::uint32_t s, DirectedEdge3 edge, std::uint32_t next) {
  const Occluders3::Edge& ends = planes_.occluders().edge(edge.edge);
  const auto corners = planes_.occluders().outline(next);
  const auto off =
      std::find_if(corners.begin(), corners.end(), [&ends](VertexId3 v) { return v != ends.from && v != ends.to; });
  return planes_.nearness(*off, s) <= 0;
}

// Sets gathered_ to a polygon and those that go on from it and bulge, and shell_of_ of these to the next shell.
void ViewShells3::gather(std::uint32_t first) {
  const auto number = static_cast<std::uint32_t>(shells_.size());
  gathered_.assign(1, first);
  shell_of_[first] = number;
  for (std::size_t k = 0; k < gathered_.size(); ++k) {
    const std::uint32_t s = gathered_[k];
    for (const DirectedEdge3& edge : planes_.occluders().edges(s)) {
      const std::uint32_t next = neighbour(s, side_of(s, edge), true);
      if (next == kNone || shell_of_[next] != kNone || gathered_.size() == kMostPolygons) continue;
      if (!bulges(s, edge, next)) continue;
      gathered_.push_back(next);
      shell_of_[next] = number;
    }
  }
}

// Where all corners are on the inner side of all edges from which no polygon goes on, the cones fill the cone of these
// edges: a way from within to where nothing is filled would have to cross one of them.
bool ViewShells3::is_convex(const ViewShell3& shell) {
  return !shell.cone.sides.empty() &&
         std::all_of(shell.cone.sides.begin(), shell.cone.sides.end(), [&](PlaneSide3 side) {
           return std::none_of(shell.cone.corners.begin(), shell.cone.corners.end(),
                               [&](VertexId3 v) { return planes_.sign(v, side) < 0; });
         });
}

// Whether each polygon is on or beyond the planes of the others; asked only of a few.
bool ViewShells3::is_round(std::span<const std::uint32_t> polygons) {
  return polygons.size() <= kMostRound && std::all_of(polygons.begin(), polygons.end(), [&](std::uint32_t s) {
           return std::all_of(polygons.begin(), polygons.end(),
                              [&](std::uint32_t other) { return s == other || is_beyond(other, s); });
         });
}

// Adds a shell, unless it is none.
bool ViewShells3::add_shell(std::span<const std::uint32_t> polygons) {
  const Occluders3& occluders = planes_.occluders();
  const auto number = static_cast<std::uint32_t>(shells_.size());
  const std::size_t corners = corners_.size(), sides = sides_.size();
  const bool is_single = polygons.size() == 1;
  for (const std::uint32_t s : polygons) {
    shell_of_[s] = number;
    for (const VertexId3 v : occluders.outline(s)) {
      const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(corners);
      if (is_single || std::find(begin, corners_.end(), v) == corners_.end()) corners_.push_back(v);
    }
    for (const DirectedEdge3& edge : occluders.edges(s)) {
      const PlaneSide3 side = side_of(s, edge);
      const std::uint32_t next = is_single ? kNone : neighbour(s, side, true);
      if (next == kNone || std::find(polygons.begin(), polygons.end(), next) == polygons.end()) sides_.push_back(side);
    }
  }
  ViewShell3 shell;
  shell.cone.corners = std::span(corners_).subspan(corners);
  shell.cone.sides = std::span(sides_).subspan(sides);
  if (!is_single && !is_convex(shell)) {
    corners_.resize(corners);
    sides_.resize(sides);
    return false;
  }
  const std::size_t first = polygons_.size();
  polygons_.insert(polygons_.end(), polygons.begin(), polygons.end());
  shell.polygons = std::span(polygons_).subspan(first);
  for (const PlaneSide3 side : shell.cone.sides) inward_.push_back(inward_normal(planes_, side));
  shell.cone.inward = std::span(inward_).subspan(sides);
  shell.is_round = is_round(polygons);
  shell.around = cones_.around(shell.polygons, shell.cone.corners);
  shell.cone.axis = shell.around.axis();
  shells_.push_back(shell);
  return true;
}

// All corners of the shell are in its cone.
bool ViewShells3::is_hidden_by(std::uint32_t s, const ViewShell3& shell) {
  const auto corners = planes_.occluders().outline(s);
  const auto is_in = [](std::span<const VertexId3> all, VertexId3 v) {
    return std::find(all.begin(), all.end(), v) != all.end();
  };
  return std::none_of(shell.cone.corners.begin(), shell.cone.corners.end(),
                      [&](VertexId3 v) { return !is_in(corners, v) && planes_.nearness(v, s) < 0; }) &&
         std::none_of(corners.begin(), corners.end(), [&](VertexId3 v) {
           return !is_in(shell.cone.corners, v) &&
                  std::any_of(shell.cone.sides.begin(), shell.cone.sides.end(),
                              [&](PlaneSide3 side) { return planes_.sign(v, side) < 0; });
         });
}

// First by the shells that go on from an edge, then by those that hide a neighbour: so the bottom of a box beneath its
// top.
void ViewShells3::find_buried() {
  const std::size_t count = planes_.occluders().size();
  hiders_.assign(count, kNone);
  const auto try_to_hide = [this](std::uint32_t s, std::uint32_t shell) {
    if (shell != kNone && shell != shell_of_[s] && hiders_[s] == kNone && is_hidden_by(s, shells_[shell]))
      hiders_[s] = shell;
  };
  for (std::uint32_t s = 0; s < count; ++s) {
    if (planes_.facing(s) == 0) continue;
    for (const DirectedEdge3& edge : planes_.occluders().edges(s))
      if (const std::uint32_t next = neighbour(s, side_of(s, edge), false); next != kNone)
        try_to_hide(s, shell_of_[next]);
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    if (planes_.facing(s) == 0) continue;
    for (const DirectedEdge3& edge : planes_.occluders().edges(s))
      if (const std::uint32_t next = neighbour(s, side_of(s, edge), true); next != kNone) try_to_hide(s, hiders_[next]);
  }
}

}  // namespace hottel

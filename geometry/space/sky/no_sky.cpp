#include "geometry/space/sky/no_sky.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/space/arrangement/closed_hull.h"
#include "geometry/space/arrangement/edge_components.h"
#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/stretches/stretch_parts.h"

namespace hottel {
namespace {

// So many polygons are asked about, times those of the shell.
constexpr std::size_t kMostQuestions = 1'000'000;

// A closed shell: +1 or -1 for each of its polygons, so that all are seen from one side.
struct Shell {
  std::uint32_t component;
  std::vector<std::pair<std::uint32_t, int>> polygons;
  Box3 box;
};

// Turns the polygons of a component so that each edge is passed in both directions; nothing where they cannot be.
// `turn_of`, 0 for its polygons, is set for them.
std::optional<Shell> shell_of(const Occluders3& occluders, const EdgeComponents3& components,
                              const SurfaceBoxes3& boxes, std::uint32_t component, std::vector<signed char>& turn_of) {
  const std::vector<std::uint32_t>& polygons = components.all()[component];
  for (const std::uint32_t s : polygons)
    for (const DirectedEdge3& side : occluders.edges(s))
      if (components.of_edge(side.edge).size() != 2) return std::nullopt;
  std::vector<std::pair<std::uint32_t, int>> turned{{polygons.front(), 1}};
  turn_of[polygons.front()] = 1;
  const auto passes = [&](std::uint32_t s, EdgeId3 edge) {
    const auto sides = occluders.edges(s);
    return std::ranges::find(sides, edge, &DirectedEdge3::edge)->is_backward ? -1 : 1;
  };
  Shell shell{component, {}, {}};
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const auto [s, turn] = turned[k];
    shell.box.include(boxes.of(s));
    for (const DirectedEdge3& side : occluders.edges(s))
      for (const std::uint32_t next : components.of_edge(side.edge)) {
        if (next == s) continue;
        const int needed = -turn * passes(s, side.edge) * passes(next, side.edge);
        if (turn_of[next] == 0) {
          turn_of[next] = static_cast<signed char>(needed);
          turned.emplace_back(next, needed);
        } else if (turn_of[next] != needed) {
          return std::nullopt;
        }
      }
  }
  shell.polygons = std::move(turned);
  return shell;
}

// How often a ray from an inner point of a polygon, on one side of it, passes through a shell from its turned fronts to
// their backs, less the other way. Exact.
class WindingNumber {
 public:
  WindingNumber(const Occluders3& occluders, const Shell& shell) : occluders_(occluders), shell_(shell) {}

  int of(std::uint32_t polygon, bool is_back) const {
    const auto corners = occluders_.outline(polygon);
    // Not in the middle, where other things are as well.
    IntegerVector from;
    Integer weight = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Integer share = static_cast<unsigned long>(3 + (5 * k) % 7);
      from = sum(from, multiple(share, occluders_.vertices().exact(corners[k])));
      weight += share;
    }
    const IntegerVector& normal = occluders_.exact_normal(polygon);
    const IntegerVector up = is_back ? opposite(normal) : normal;
    const IntegerVector side =
        difference(occluders_.vertices().exact(corners[1]), occluders_.vertices().exact(corners[0]));
    for (unsigned long attempt = 1;; ++attempt) {
      // Straight up, and leaning a little, differently each time.
      const Integer much = Integer(1) << static_cast<unsigned>(bits(side) + bits(normal) + 8);
      const IntegerVector across = cross(normal, side);
      const IntegerVector way = sum(
          multiple(much, up),
          sum(multiple(31 * attempt, across), multiple(Integer(17 * attempt * attempt) * (bits(normal) + 1), side)));
      if (const auto count = count_along(polygon, from, weight, way)) return *count;
    }
  }

 private:
  // Nothing where the ray meets an edge.
  std::optional<int> count_along(std::uint32_t start, const IntegerVector& from, const Integer& weight,
                                 const IntegerVector& way) const {
    int count = 0;
    for (const auto& [s, turn] : shell_.polygons) {
      if (s == start) continue;
      const auto corners = occluders_.outline(s);
      const auto offset = [&](VertexId3 v) {
        return difference(multiple(weight, occluders_.vertices().exact(v)), from);
      };
      const int height = dot_sign(occluders_.exact_normal(s), offset(corners[0]));
      const int slope = dot_sign(occluders_.exact_normal(s), way);
      if (height == 0 || height * slope < 0) continue;
      // A ray in a plane beside that of the polygon does not meet it.
      if (slope == 0) continue;
      bool has_positive = false, has_negative = false, has_zero = false;
      for (std::size_t k = 0; k < corners.size() && !(has_positive && has_negative); ++k) {
        const int sign =
            determinant_sign(way, offset(corners[k]), offset(corners[k + 1 == corners.size() ? 0 : k + 1]));
        has_positive |= sign > 0;
        has_negative |= sign < 0;
        has_zero |= sign == 0;
      }
      if (has_positive && has_negative) continue;
      if (has_zero) return std::nullopt;
      count += turn * slope;
    }
    return count;
  }

  const Occluders3& occluders_;
  const Shell& shell_;
};

// Whether more than two polygons of a shell have a line in common.
bool touches_itself(const Occluders3& occluders, const Shell& shell) {
  std::vector<LinePart3> parts;
  std::vector<IntegerVector> normals;
  for (const auto& [s, turn] : shell.polygons) {
    const auto corners = occluders.outline(s);
    const auto number = static_cast<std::uint32_t>(normals.size());
    normals.push_back(occluders.exact_normal(s));
    for (std::size_t k = 0; k < corners.size(); ++k)
      parts.push_back({{occluders.vertices().exact(corners[k]), 1},
                       {occluders.vertices().exact(corners[(k + 1) % corners.size()]), 1},
                       {number, true},
                       false});
  }
  const std::vector<AtomicStretch3> stretches = atomic_stretches(parts, true, normals);
  return std::ranges::any_of(stretches, [](const AtomicStretch3& stretch) { return stretch.faces.size() > 2; });
}

// Whether a stretch in the plane of a surface enters the inside of it.
bool enters(const Occluders3& occluders, std::uint32_t surface, const Stretch3& stretch) {
  std::vector<WeightedPoint3> corners;
  for (const VertexId3 v : occluders.outline(surface)) corners.push_back({occluders.vertices().exact(v), 1});
  return part_inside(stretch, corners, occluders.exact_normal(surface)).has_value();
}

}  // namespace

NoSky3::NoSky3(const Occluders3& polygons, const MergedOccluders3& merged, const SurfaceStretches3& stretches) {
  const ClosedHull3 hull(polygons);
  const Occluders3& surfaces = merged.occluders();
  for (const bool is_back : {false, true}) {
    sides_[is_back].resize(surfaces.size());
    for (std::uint32_t m = 0; m < surfaces.size(); ++m)
      sides_[is_back][m] =
          std::ranges::all_of(merged.members(m), [&](std::uint32_t s) { return hull.sees_no_sky(s, is_back); });
  }
  const EdgeComponents3 components(polygons);
  const SurfaceBoxes3 boxes(polygons);
  std::vector<Shell> shells;
  std::vector<signed char> turn_of(polygons.size(), 0);
  for (std::uint32_t c = 0; c < components.all().size(); ++c)
    if (components.all()[c].size() > 3)
      if (std::optional<Shell> shell = shell_of(polygons, components, boxes, c, turn_of))
        shells.push_back(std::move(*shell));
  if (shells.empty()) return;
  // The components whose polygons stand on a surface, or pierce it.
  std::vector<std::vector<std::uint32_t>> on(surfaces.size());
  for (std::uint32_t m = 0; m < surfaces.size(); ++m) {
    for (const bool is_back : {false, true})
      for (const AtomicStretch3& ground : stretches.grounds(m, is_back)) {
        if (!enters(surfaces, m, ground.stretch)) continue;
        for (const StretchFace3& face : ground.faces)
          for (const std::uint32_t s : merged.members(face.surface)) on[m].push_back(components.of_polygon(s));
      }
    std::ranges::sort(on[m]);
    on[m].erase(std::unique(on[m].begin(), on[m].end()), on[m].end());
  }
  const auto stands_on = [&](std::uint32_t component, std::uint32_t polygon) {
    return std::ranges::binary_search(on[merged.surface_of(polygon)], component);
  };
  std::array<std::vector<bool>, 2> is_within{std::vector<bool>(polygons.size()), std::vector<bool>(polygons.size())};
  std::vector<std::uint32_t> others;
  for (const Shell& shell : shells) {
    const std::vector<std::uint32_t>& own = components.all()[shell.component];
    if (std::ranges::any_of(own, [&](std::uint32_t s) { return stands_on(shell.component, s); })) continue;
    if (touches_itself(polygons, shell)) continue;
    const WindingNumber winding(polygons, shell);
    const auto [first, turn_of_first] = shell.polygons.front();
    for (const bool is_back : {false, true}) {
      if (winding.of(first, is_back) == 0) continue;
      for (const auto& [s, turn] : shell.polygons) is_within[is_back != (turn != turn_of_first)][s] = true;
    }
    others.clear();
    boxes.find(shell.box, others);
    std::erase_if(others, [&](std::uint32_t s) {
      return components.of_polygon(s) == shell.component || stands_on(shell.component, s);
    });
    if (others.size() * shell.polygons.size() > kMostQuestions) continue;
    for (const std::uint32_t s : others)
      if (winding.of(s, false) != 0) is_within[0][s] = is_within[1][s] = true;
  }
  for (const bool is_back : {false, true})
    for (std::uint32_t m = 0; m < surfaces.size(); ++m)
      if (std::ranges::all_of(merged.members(m), [&](std::uint32_t s) { return is_within[is_back][s]; }))
        sides_[is_back][m] = true;
}

}  // namespace hottel

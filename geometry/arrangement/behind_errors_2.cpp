#include "geometry/arrangement/behind_errors_2.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

#include "geometry/scene/name.h"
#include "kernel/decimal.h"
#include "kernel/failure.h"

namespace hottel {
namespace {

const Surface2& first_of(const Scene2& scene, std::uint32_t group) {
  return *std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                       [group](const Surface2& s) { return s.group == group; });
}

Rational squared_length(const Rational& x, const Rational& y) { return x * x + y * y; }

// The squared distance from p to the segment.
Rational squared_distance(const Point2& p, const Point2& a, const Point2& b) {
  const Rational ux = b.x - a.x, uy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const Rational along = ux * px + uy * py, whole = squared_length(ux, uy);
  if (along <= 0) return squared_length(px, py);
  if (along >= whole) return squared_length(p.x - b.x, p.y - b.y);
  const Rational across = ux * py - uy * px;
  return across * across / whole;
}

std::string text(const Point2& p) { return "(" + decimal_text(p.x) + ", " + decimal_text(p.y) + ")"; }

// The surface of another group nearest to a point.
std::optional<std::pair<std::uint32_t, Rational>> nearest_other(const Scene2& scene, std::uint32_t group,
                                                                const Point2& p) {
  std::optional<std::pair<std::uint32_t, Rational>> nearest;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface2& surface = scene.surfaces[s];
    if (surface.group == group) continue;
    Rational squared = squared_distance(p, surface.from, surface.to);
    if (!nearest || squared < nearest->second) nearest = {s, std::move(squared)};
  }
  return nearest;
}

// Ends of the group that touch nothing else, or else ends of other surfaces around the cells it looks into.
std::vector<std::string> gap_hints(const UnboundedBehind2& behind) {
  const Scene2& scene = behind.scene;
  const Vertices2& vertices = behind.overlay.vertices;
  std::unordered_map<VertexId, int> degree;
  for (const Segment2& piece : behind.overlay.pieces) {
    ++degree[piece.a];
    ++degree[piece.b];
  }
  const auto scene_point = [&](VertexId v) {
    const ExactPoint2 p = vertices.to_scene(vertices.exact(v));
    return Point2{p.x, p.y};
  };
  std::vector<std::string> hints;
  const auto tell = [&](VertexId v) {
    if (hints.size() == 2) return;
    const Point2 p = scene_point(v);
    std::string hint = "there is a gap at " + text(p);
    if (const auto near = nearest_other(scene, behind.group, p); near && near->second > 0) {
      RootSum distance;
      distance.add(1, near->second);
      hint += ", " + decimal_text(distance) + " from " + quoted_name(scene.surfaces[near->first].name);
    }
    if (std::find(hints.begin(), hints.end(), hint) == hints.end()) hints.push_back(std::move(hint));
  };
  for (const PieceSideId side : behind.backs)
    for (const Segment2& piece = behind.overlay.pieces[static_cast<std::size_t>(side / 2)];
         const VertexId v : {piece.a, piece.b})
      if (degree[v] == 1) tell(v);
  if (!hints.empty() || behind.backs.empty()) return hints;
  for (const PieceSideId side : behind.cells.sides(behind.cells.of(behind.backs.front())))
    for (const Segment2& piece = behind.overlay.pieces[static_cast<std::size_t>(side / 2)];
         const VertexId v : {piece.a, piece.b})
      if (degree[v] == 1) tell(v);
  return hints;
}

}  // namespace

void refuse_unbounded(const UnboundedBehind2& behind) {
  const std::string name = quoted_name(behind.scene.groups[behind.group].name);
  const FileLine where{behind.scene.file, first_of(behind.scene, behind.group).line};
  if (behind.backs.empty())
    throw InputError(where, name + ": \"behind\" is \"solid\", but every back of it has a material",
                     {"take the \"back\" or the \"behind\" away"});
  const bool is_open = std::all_of(behind.backs.begin(), behind.backs.end(),
                                   [&](PieceSideId side) { return behind.cells.of(side) == 0; });
  std::vector<std::string> hints = gap_hints(behind);
  hints.emplace_back("close the gap, or draw the solid as a closed polyline, counter-clockwise");
  throw InputError(
      where,
      name + ": \"behind\" is \"solid\", but " +
          (is_open ? "the region behind it is open to infinity" : "its own fronts look into the region behind it"),
      std::move(hints));
}

void refuse_conflict(const Scene2& scene, std::uint32_t solid, std::uint32_t open) {
  const Surface2 &one = first_of(scene, solid), &other = first_of(scene, open);
  throw InputError({scene.file, std::max(one.line, other.line)},
                   quoted_name(scene.groups[solid].name) + " says that a region is solid, " +
                       quoted_name(scene.groups[open].name) + " that it is open",
                   {"take one \"behind\" away"});
}

}  // namespace hottel

#include "geometry/plane/arrangement/behind_errors.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/scene/closest_point.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

const Surface& first_of(const Scene2& scene, std::uint32_t group) {
  return *std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                       [group](const Surface& s) { return s.group == group; });
}

std::string text(const Point2& p) { return "(" + decimal_text(p.x) + ", " + decimal_text(p.y) + ")"; }

// The surface of another group nearest to a point.
std::optional<std::pair<std::uint32_t, Rational>> nearest_other(const Scene2& scene, std::uint32_t group,
                                                                const Point2& p) {
  std::optional<std::pair<std::uint32_t, Rational>> nearest;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (scene.surfaces[s].group == group) continue;
    Rational squared = closest_point(scene.edges[s].from, scene.edges[s].to, p).squared;
    if (!nearest || squared < nearest->second) nearest = {s, std::move(squared)};
  }
  return nearest;
}

// Where something ends that nothing else touches.
struct LooseEnd {
  Point2 at;
  bool is_own;  // of the group
};

// The vertices that pieces connect with some of them, themselves included.
std::unordered_set<VertexId> connected_with(const Overlay2& overlay, std::vector<VertexId> some) {
  std::unordered_map<VertexId, std::vector<VertexId>> neighbours;
  for (const Segment2& piece : overlay.pieces) {
    neighbours[piece.a].push_back(piece.b);
    neighbours[piece.b].push_back(piece.a);
  }
  std::unordered_set<VertexId> connected(some.begin(), some.end());
  while (!some.empty()) {
    const VertexId v = some.back();
    some.pop_back();
    for (const VertexId w : neighbours[v])
      if (connected.insert(w).second) some.push_back(w);
  }
  return connected;
}

// The loose ends around the regions that the backs look into: those of the group, or else those of others that it
// touches, perhaps by way of others.
std::vector<LooseEnd> loose_ends(const UnboundedBehind2& behind) {
  const Vertices2& vertices = behind.overlay.vertices;
  std::unordered_map<VertexId, int> degree;
  for (const Segment2& piece : behind.overlay.pieces) {
    ++degree[piece.a];
    ++degree[piece.b];
  }
  std::vector<LooseEnd> ends;
  const auto piece = [&](PieceSideId side) { return behind.overlay.pieces[piece_of(side)]; };
  std::vector<VertexId> own;
  for (const PieceSideId side : behind.backs) own.insert(own.end(), {piece(side).a, piece(side).b});
  const std::unordered_set<VertexId> connected = connected_with(behind.overlay, std::move(own));
  const auto add = [&](PieceSideId side, bool is_own) {
    for (const VertexId v : {piece(side).a, piece(side).b}) {
      if (degree[v] != 1 || !connected.contains(v)) continue;
      const Point2 at = vertices.to_scene(vertices.exact(v));
      if (std::none_of(ends.begin(), ends.end(), [&](const LooseEnd& end) { return end.at == at; }))
        ends.push_back({at, is_own});
    }
  };
  for (const PieceSideId side : behind.backs) add(side, true);
  if (!ends.empty() || behind.backs.empty()) return ends;
  for (const PieceSideId side : behind.regions.sides(behind.regions.of(behind.backs.front()))) add(side, false);
  return ends;
}

std::string distance_text(const Rational& squared) {
  RootSum distance;
  distance.add(1, squared);
  return decimal_text(distance);
}

// At most two.
std::vector<std::string> gap_hints(const UnboundedBehind2& behind) {
  const std::vector<LooseEnd> ends = loose_ends(behind);
  if (ends.size() == 2 && !ends[0].is_own) {
    const Rational squared = squared_distance(ends[0].at, ends[1].at);
    return {"there is a gap from " + text(ends[0].at) + " to " + text(ends[1].at) + ", " + distance_text(squared) +
            " wide"};
  }
  std::vector<std::string> hints;
  for (std::size_t k = 0; k < ends.size() && k < 2; ++k) {
    std::string hint = "there is a gap at " + text(ends[k].at);
    if (const auto near = nearest_other(behind.scene, behind.group, ends[k].at); near && near->second > 0)
      hint += ", " + distance_text(near->second) + " from " + quoted_name(behind.scene.surfaces[near->first].name);
    hints.push_back(std::move(hint));
  }
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
                                   [&](PieceSideId side) { return behind.regions.of(side) == 0; });
  const bool is_reversed = is_open && std::all_of(behind.backs.begin(), behind.backs.end(), [&](PieceSideId side) {
                             return behind.regions.of(opposite(side)) != 0;
                           });
  std::vector<std::string> hints = gap_hints(behind);
  if (is_open) {
    hints.emplace_back(is_reversed
                           ? "close the gap; or, if its fronts look into the solid, list its points the other way "
                             "round: the front is on the right"
                           : "close the gap, or draw the solid as a closed polyline, counter-clockwise");
    throw InputError(where, name + ": \"behind\" is \"solid\", but the region behind it is open to infinity",
                     std::move(hints));
  }
  hints.emplace_back(hints.empty() ? "divide it where the solid begins, or draw the solid as a closed polyline"
                                   : "close the gap, or take the \"behind\" of a thin wall away: it wants a \"back\"");
  throw InputError(where,
                   name +
                       ": \"behind\" is \"solid\", but the region behind it is the one before it: its own fronts look "
                       "there too",
                   std::move(hints));
}

void refuse_conflict(const Scene2& scene, std::uint32_t solid, std::uint32_t open) {
  const Surface &one = first_of(scene, solid), &other = first_of(scene, open);
  throw InputError({scene.file, std::max(one.line, other.line)},
                   quoted_name(scene.groups[solid].name) + " says that a region is solid, " +
                       quoted_name(scene.groups[open].name) + " that it is open",
                   {"take one \"behind\" away"});
}

}  // namespace hottel

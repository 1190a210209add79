// Which corners of polygons see each other: the visibility graph of a scene in space.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

struct PreparedScene3;
struct Scene3;

// A corner of polygons.
struct GraphVertex3 {
  Point3 point;
  std::uint32_t surface;  // the first listed one that has it
};

// Returns the corners of polygons, of outlines and holes, as the scene lists them, each point once.
std::vector<GraphVertex3> graph_vertices_3(const Scene3& scene);

// Two vertices that see each other.
struct VisiblePair3 {
  std::uint32_t v, w;                  // by number (graph_vertices_3)
  std::optional<std::uint32_t> along;  // the first listed surface with an edge on which the segment between them lies
  friend bool operator==(const VisiblePair3&, const VisiblePair3&) = default;
};

// Returns the pairs of vertices that see each other.
//
//   (1) exact: two vertices see each other iff from each of them directions as near as one likes to the other one are
//       free up to there, no vertex that both see lies between them, and the segment runs in no solid. So a line that
//       only grazes edges is free, and polygons in whose plane it runs hide nothing of it
//   (2) of several vertices on a line only those that follow each other see each other; one in the interior of a solid
//       sees none; the edges of solids and the diagonals of their faces are pairs, those through them are not
//   (3) each pair once, v < w; ascending by v, then by w; the same for any number of threads
//
// progress: fraction done; may throw to stop. COST: on all threads: an exact map from each vertex
// (ExactVisibilityMap3), and some microseconds a pair; a bit a pair of memory.
std::vector<VisiblePair3> visibility_graph_3(const PreparedScene3& prepared,
                                             const std::function<void(double)>& progress = {});

// Returns the double nearest to the distance of two points; infinite beyond the range of doubles.
double length_between(const Point3& a, const Point3& b);

}  // namespace hottel

// Which vertices of a scene see each other: its visibility graph.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// A vertex of a scene: the end of a surface, or a point where surfaces cross.
struct GraphVertex2 {
  VertexId id;               // in the arrangement
  std::uint32_t surface;     // the first listed one that ends there; at a crossing the first listed one through it
  bool is_crossing = false;  // no surface ends there
};

// Returns the vertices of a scene by the numbers that a graph gives them: first the ends of surfaces as the scene lists
// them, each point once, then crossings in the order of the arrangement. REQUIRES that no surface is divided.
std::vector<GraphVertex2> graph_vertices(const PreparedScene2& prepared);

// Two vertices that see each other.
struct VisiblePair2 {
  std::uint32_t v, w;  // by number (graph_vertices)
  PieceSideId along;   // a side of the piece that joins them; kNoPiece where the segment between them is free
  double length;  // the double nearest to their distance, in scene coordinates; infinite beyond the range of doubles
};

// Visits the pairs of vertices of a scene that see each other.
//
//   (1) exact: two vertices see each other iff the open segment between them meets no surface and runs in no solid, or
//       a piece joins them of which a side looks into the open
//   (2) so of several vertices on a line only those that follow each other may see each other, whatever stands at the
//       one between; a vertex in the interior of a solid sees none, one on its border all but what lies through it
//   (3) each pair once, v < w; ascending by v, then by w; the same for any number of threads
//
// The sink is called by one thread, with many pairs at a time. Throws what sink and progress throw, the latter of the
// fraction done; Interrupted soon after a stop was asked for. REQUIRES that no surface is divided.
// COST: the view from each vertex, on all threads: about 20 ns for each triangle that is seen (view.h), and some 0.1 µs
// a pair. What is held is some thousand views.
void visibility_graph(const PreparedScene2& prepared, const std::function<void(std::span<const VisiblePair2>)>& sink,
                      const std::function<void(double)>& progress = {});

}  // namespace hottel

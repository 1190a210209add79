// Edges and polylines become surfaces of a scene, the same way whether they are read or made in code.
#pragma once

#include <string>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Each throws InputError with the scene's file and a line, naming the edge, the polyline or its piece.

// Adds an edge. Refuses one of length zero, at the line of the surface.
void add_edge(Scene2& scene, Surface surface, Edge2 edge);

// A point of a polyline, and the line where it stands, 0 if nowhere.
struct PolylinePoint2 {
  Point2 at;
  int line = 0;
};

// Adds the pieces of a polyline.
//
//   (1) piece k is called NAME[k] and runs from point k to the next one; of a closed polyline the last piece runs from
//       the last point to the first
//   (2) all else they have of `like`, but for the line: that of the point where a piece begins
// Refuses a piece of length zero. REQUIRES two points.
void add_polyline(Scene2& scene, const Surface& like, const std::string& name, std::vector<PolylinePoint2> points,
                  bool closed);

// Adds polylines that were collected in a scene of their own, of the same materials: they stand after all edges.
void append_polylines(Scene2& scene, Scene2 polylines);

// Refuses a polyline with the name of an edge. Edges differ from each other in a valid scene, and so do polylines.
// polyline_lines: where the polylines stand, whose groups are the last ones of the scene. REQUIRES a valid scene whose
// edges come before its polylines.
void refuse_names_of_edges(const Scene2& scene, const std::vector<int>& polyline_lines);

}  // namespace hottel

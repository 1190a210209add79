// What some point of a face in space sees, and which vertices see each other, for people and programs.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/exchange/face_sight.h"
#include "geometry/space/exchange/vertex_graph.h"
#include "io/results/visibility_answer.h"

namespace hottel {

struct Scene3;

// The faces that are seen, and of each whether anything hides a part of it; whether the sky is seen. name: what the
// face was called.
VisibilityAnswer face_answer(const Scene3& scene, const std::string& name, std::span<const SeenFace3> seen);

// A graph to be written: vertices by number, and pairs.
struct VisibilityGraph3 {
  std::vector<GraphVertex3> vertices;
  std::vector<VisiblePair3> pairs;
};

// `vertex0,vertex1,x0,y0,z0,x1,y1,z1,length,along,surface0,surface1`, one line a pair. along: the first listed surface
// with an edge there, else empty. Coordinates are the nearest doubles, or p/q where is_exact; lengths are doubles.
// Throws RequestError where one is beyond the range of doubles (a coordinate unless is_exact).
void write_graph_csv_3(const Scene3& scene, const VisibilityGraph3& graph, bool is_exact,
                       const std::function<void(std::string_view)>& sink);
// The same as a JSON object: `vertices` by number, and `pairs`.
std::string graph_json_3(const Scene3& scene, const VisibilityGraph3& graph);
// How many vertices and pairs there are, in a sentence.
std::string graph_summary_3(const VisibilityGraph3& graph);

}  // namespace hottel

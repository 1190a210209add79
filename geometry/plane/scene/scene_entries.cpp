#include "geometry/plane/scene/scene_entries.h"

#include <string_view>
#include <unordered_map>
#include <utility>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

void add_edge(Scene2& scene, Surface surface, Edge2 edge) {
  if (edge.from == edge.to)
    throw InputError({scene.file, surface.line}, "edge " + quoted_name(surface.name) + " has length zero");
  scene.add(std::move(surface), std::move(edge));
}

void add_polyline(Scene2& scene, const Surface& like, const std::string& name, std::vector<PolylinePoint2> points,
                  bool closed) {
  HOTTEL_REQUIRE(points.size() >= 2);
  const std::size_t pieces = points.size() - (closed ? 0 : 1);
  const Point2 first = points.front().at;
  for (std::size_t k = 0; k < pieces; ++k) {
    const bool closes = k + 1 == points.size();
    Edge2 edge{std::move(points[k].at), closes ? first : points[k + 1].at};
    Surface surface = like;
    surface.name = piece_name(name, k);
    surface.line = points[k].line;
    if (edge.from == edge.to)
      throw InputError(
          {scene.file, surface.line},
          "polyline " + quoted_name(name) + ": its piece " + quoted_name(surface.name) + " has length zero",
          {closes ? "\"closed\" joins the last point to the first: leave the repeated point out"
                  : "a point stands twice in a row"});
    scene.add(std::move(surface), std::move(edge));
  }
}

void append_polylines(Scene2& scene, Scene2 polylines) {
  const auto groups = static_cast<std::uint32_t>(scene.groups.size());
  for (std::size_t s = 0; s < polylines.surfaces.size(); ++s) {
    polylines.surfaces[s].group += groups;
    scene.add(std::move(polylines.surfaces[s]), std::move(polylines.edges[s]));
  }
  for (Group& group : polylines.groups) scene.groups.push_back(std::move(group));
}

void refuse_names_of_edges(const Scene2& scene, const std::vector<int>& polyline_lines) {
  if (polyline_lines.empty()) return;
  const std::size_t edges = scene.groups.size() - polyline_lines.size();
  std::unordered_map<std::string_view, int> polylines;
  for (std::size_t i = 0; i < polyline_lines.size(); ++i)
    polylines.emplace(scene.groups[edges + i].name, polyline_lines[i]);
  for (std::size_t i = 0; i < edges; ++i)
    if (const auto found = polylines.find(scene.groups[i].name); found != polylines.end()) {
      const int line = scene.surfaces[i].line;
      throw InputError({scene.file, found->second}, "polyline " + quoted_name(found->first) +
                                                        " has the name of an edge" +
                                                        (line > 0 ? ", the one in line " + std::to_string(line) : ""));
    }
}

}  // namespace hottel

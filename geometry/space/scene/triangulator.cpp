#include "geometry/space/scene/triangulator.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/name.h"
#include "geometry/space/scene/bent_loops.h"

namespace hottel {

std::vector<Polygon3> triangles_of_not_plane(const Polygon3& polygon) {
  const std::vector<std::vector<Point3>> loops = loops_of(polygon);
  if (std::any_of(loops.begin(), loops.end(), [](const auto& loop) { return loop.size() < 3; })) return {};
  const std::vector<Point3> points = corners_of(polygon);
  if (are_in_one_plane(points)) return {};
  std::vector<Polygon3> triangles;
  for (const auto& [a, b, c] : triangles_of_loops(loops)) triangles.push_back({{points[a], points[b], points[c]}});
  return triangles;
}

bool Triangulator3::add(Scene3& scene, const Surface& surface, const Polygon3& polygon) {
  if (polygon.is_nearly_plane) return false;
  std::vector<Polygon3> pieces = triangles_of_not_plane(polygon);
  if (pieces.empty()) return false;
  if (names_.empty()) first_problem_ = polygon_problem(polygon).text;
  names_.push_back(surface.name);
  triangles_ += pieces.size();
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    Surface piece = surface;
    piece.name = piece_name(surface.name, k);
    scene.add(std::move(piece), std::move(pieces[k]));
  }
  return true;
}

std::string Triangulator3::note() const {
  if (names_.empty()) return "";
  if (names_.size() == 1)
    return fmt::format("{} {}; it is read as {} triangles", quoted_name(names_[0]), first_problem_, triangles_);
  return fmt::format("{} polygons are not plane and are read as {} triangles: {}; {} {}", names_.size(), triangles_,
                     listed_names(names_), quoted_name(names_[0]), first_problem_);
}

}  // namespace hottel

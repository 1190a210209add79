// What many points see: the visibility polygon of each, corners as correctly rounded doubles.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/strip_obstructed.json"));
//   const std::vector<Point2> points = {{0, Rational(1, 2)}, {0, Rational(3, 2)}};
//   for (const RoundedPolygon2& polygon : visibility_polygons(*simulation.prepared(), points))
//     for (const auto& [x, y, after] : polygon.corners)
//       std::printf("%g %g %s\n", x, y, polygon_side_name(*simulation.prepared(), after).c_str());
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/plane/arrangement/piece_side.h"
#include "geometry/plane/point.h"
#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

struct PreparedScene2;

// What is wanted, and who is told how far the work has come.
struct PolygonsOptions2 {
  bool wants_exact = false;                   // rational corners too: some µs each
  std::optional<Rational> range = {};         // nothing beyond this distance (polygon_within); corners are rounded only
  bool fronts_only = false;                   // on an outline: what its fronts see (keep_fronts)
  std::function<void(double)> progress = {};  // of the fraction done, from any thread; may throw to stop
};

// Returns the visibility polygon of each point, in order; points are in scene coordinates.
//
//   (1) the same, bit for bit, for any number of threads
//   (2) a point in a solid sees nothing: its polygon has no corners (RoundedPolygon2)
// Throws ContractViolation where exact corners are wanted within a range, Interrupted soon after a stop was asked for.
// COST: some µs a vertex of the scene, once; then for each point the view, and about 40 ns a corner (some 10 µs within
// a range). Who asks again and again for few points keeps a VisibilityPolygons2 (visibility_polygons.h).
std::vector<RoundedPolygon2> visibility_polygons(const PreparedScene2& prepared, std::span<const Point2> eyes,
                                                 const PolygonsOptions2& options = {});

// Returns the name of what is seen after a corner: that of the face, "sky", "#range" along an arc, "" along a ray from
// the point or an edge at it. No face can be called like the last three: names have no '#'.
std::string polygon_side_name(const PreparedScene2& prepared, PieceSideId after);

}  // namespace hottel

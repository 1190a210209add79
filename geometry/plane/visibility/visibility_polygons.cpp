#include "geometry/plane/visibility/visibility_polygons.h"

#include <atomic>

#include "geometry/plane/visibility/front_visibility.h"
#include "geometry/plane/visibility/point_view.h"
#include "geometry/plane/visibility/range_polygon.h"
#include "geometry/plane/visibility/solid_around.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {

VisibilityPolygons2::VisibilityPolygons2(const Arrangement2& arrangement)
    : arrangement_(arrangement),
      location_(arrangement.vertices(), arrangement.triangulation()),
      rounding_(arrangement) {}

void VisibilityPolygons2::look(const Point2& point, bool wants_exact, RoundedPolygon2& polygon,
                               RoundingCounts2& counts) const {
  thread_local View2 view;
  thread_local std::vector<ViewCorner2> corners;
  const Vertices2& vertices = arrangement_.vertices();
  const Point2 at = vertices.from_scene(point);
  const Eye2 eye(vertices, at);
  location_.look_around(eye, view);
  view_corners(arrangement_, eye, view, corners);
  polygon.corners.clear();
  polygon.exact.clear();
  polygon.solid = solid_around(arrangement_, view);
  const EyeRounding2 rounding(rounding_, at, point);
  for (const ViewCorner2& corner : corners) {
    const RoundedPoint2 p = rounding(corner, counts);
    polygon.corners.push_back({p.x, p.y, corner.after});
    if (wants_exact) polygon.exact.push_back(rounding.exact(corner));
  }
}

RoundedPolygon2 VisibilityPolygons2::of(const Point2& eye, const PolygonsOptions2& options) const {
  HOTTEL_REQUIRE(!options.range || !options.wants_exact);
  if (options.range || options.fronts_only) {
    VisibilityPolygon2 polygon = visibility_polygon(arrangement_, location_, eye);
    if (options.fronts_only) keep_fronts(arrangement_, polygon);
    return options.range ? polygon_within(polygon, *options.range) : rounded_polygon(polygon, options.wants_exact);
  }
  RoundedPolygon2 result;
  RoundingCounts2 counts;
  look(eye, options.wants_exact, result, counts);
  return result;
}

std::vector<RoundedPolygon2> VisibilityPolygons2::all(std::span<const Point2> eyes,
                                                      const PolygonsOptions2& options) const {
  std::vector<RoundedPolygon2> result(eyes.size());
  std::atomic<std::size_t> done{0};
  constexpr std::size_t kGrain = 16;
  parallel_ranges(eyes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      throw_if_interrupted();
      result[k] = of(eyes[k], options);
    }
    const std::size_t so_far = done += end - begin;
    if (options.progress) options.progress(static_cast<double>(so_far) / static_cast<double>(eyes.size()));
  });
  return result;
}

std::optional<Rational> VisibilityPolygons2::area(const Point2& eye) const {
  return visibility_polygon(arrangement_, location_, eye).area;
}

std::vector<RoundedPolygon2> visibility_polygons(const PreparedScene2& prepared, std::span<const Point2> eyes,
                                                 const PolygonsOptions2& options) {
  return VisibilityPolygons2(prepared.arrangement).all(eyes, options);
}

std::string polygon_side_name(const PreparedScene2& prepared, PieceSideId after) {
  if (after == kNoPiece) return "";
  if (after == kRange) return "#range";
  return face_name(prepared.scene, prepared.arrangement, after);
}

}  // namespace hottel

#include "geometry/plane/visibility/point_place.h"

#include <algorithm>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/solid_around.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {
namespace {

bool is_between(const Rational& a, const Rational& value, const Rational& b) {
  return (a <= value && value <= b) || (b <= value && value <= a);
}

bool is_on(const Edge2& edge, const Point2& p) {
  const auto& [from, to] = edge;
  return is_between(from.x, p.x, to.x) && is_between(from.y, p.y, to.y) &&
         (to.x - from.x) * (p.y - from.y) == (to.y - from.y) * (p.x - from.x);
}

}  // namespace

PointPlace2 place_of(const PreparedScene2& prepared, const Point2& point) {
  PointPlace2 place;
  const std::vector<Edge2>& edges = prepared.scene.edges;
  for (std::uint32_t s = 0; s < edges.size(); ++s)
    if (is_on(edges[s], point)) place.surfaces.push_back(s);

  const Vertices2& vertices = prepared.arrangement.vertices();
  const PointLocation2 location(vertices, prepared.arrangement.triangulation());
  View2 view;
  location.look_around(Eye2(vertices, vertices.from_scene(point)), view);
  if (const std::uint32_t solid = solid_around(prepared.arrangement, view); solid != Solids2::kNone)
    place.solid = solid;
  else
    place.sees_sky = view.seen.empty() ||
                     std::ranges::any_of(view.seen, [](const View2::Seen& seen) { return seen.behind == kSky; });
  return place;
}

}  // namespace hottel

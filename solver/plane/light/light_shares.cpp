#include "solver/plane/light/light_shares.h"

#include "geometry/plane/exchange/element_table.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/naming_file.h"
#include "solver/plane/light/beam.h"

namespace hottel {
namespace {

Point2 minus(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }

LightShares shares_of(const PreparedScene2& prepared, const ElementTable2& table, const PointLocation2& location,
                      const Light& light, const LightPlace2& place) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const Eye2 eye(vertices, vertices.from_scene(place.position));
  View2 view;
  location.look_around(eye, view);
  LightShares shares;
  shares.of_element.resize(table.count(), Enclosure{0, 0});
  if (const std::uint32_t solid = solid_around(prepared.arrangement, view); solid != Solids2::kNone) {
    shares.solid = prepared.scene.groups[solid].name;
    return shares;
  }
  const auto at = [&](std::uint32_t label) -> Enclosure& {
    return label == table.sky() ? shares.sky : shares.of_element[label];
  };
  const std::size_t m = view.seen.size();
  if (m < 2) {  // alone with the sky, whatever vertex stands in it
    shares.sky = {1, 1};
    return shares;
  }
  const Beam2 beam(light, place);
  const Point2 from = eye.exact();
  std::vector<Point2> direction;
  for (const View2::Seen& seen : view.seen) direction.push_back(minus(vertices.exact(seen.vertex), from));
  for (std::size_t k = 0; k < m; ++k) {
    Enclosure& share = at(table.of(view.seen[k].behind));
    share = sum_of_nonnegative(share, beam.share(direction[k], direction[k + 1 == m ? 0 : k + 1]));
  }
  return shares;
}

}  // namespace

std::vector<LightShares> light_shares(const PreparedScene2& prepared, Granularity granularity) {
  std::vector<LightShares> result;
  const Scene2& scene = prepared.scene;
  if (scene.lights.empty()) return result;
  const ElementTable2 table(scene, prepared.arrangement, prepared.division, granularity);
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    result.push_back(naming_file(
        scene.file, [&] { return shares_of(prepared, table, location, scene.lights[k], scene.light_places[k]); }));
  return result;
}

}  // namespace hottel

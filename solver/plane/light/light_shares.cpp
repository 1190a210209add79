#include "solver/plane/light/light_shares.h"

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/solid_around.h"
#include "geometry/plane/visibility/sun_view.h"
#include "geometry/unit_of_length.h"
#include "kernel/ball.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/light/beam.h"

namespace hottel {
namespace {

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

LightShares shares_of_sun(const PreparedScene2& prepared, const ElementTable2& table, const LightPlace2& place) {
  constexpr long kPrecision = 256;
  const SunView2 view(prepared.arrangement, turned_direction(place));
  std::vector<Rational> width(std::size_t{table.count()} + 1);
  for (const SunView2::Strip& strip : view.strips()) width[table.of(strip.side)] += view.width(strip);
  const Point2& d = view.direction();
  const Ball length = Ball::root(Rational(d.x * d.x + d.y * d.y).get_num(), kPrecision);
  const Rational scale = prepared.arrangement.vertices().scale() * metres_per_unit(prepared.scene);
  const auto across = [&](const Rational& wide) {
    return Ball::of(Rational(wide * scale), kPrecision).over(length, kPrecision).bounds();
  };
  LightShares shares;
  shares.of_element.resize(table.count(), Enclosure{0, 0});
  Rational whole = 0;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    if (width[label] == 0) continue;
    shares.of_element[label] = across(width[label]);
    whole += width[label];
  }
  shares.whole = whole == 0 ? Enclosure{0, 0} : across(whole);
  return shares;
}

}  // namespace

std::vector<LightShares> light_shares(const PreparedScene2& prepared, Granularity granularity) {
  std::vector<LightShares> result;
  const Scene2& scene = prepared.scene;
  if (scene.lights.empty()) return result;
  const ElementTable2& table = *prepared.elements(granularity);
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    result.push_back(with_file_context(scene.file, [&] {
      return scene.lights[k].is_sun() ? shares_of_sun(prepared, table, scene.light_places[k])
                                      : shares_of(prepared, table, location, scene.lights[k], scene.light_places[k]);
    }));
  return result;
}

}  // namespace hottel

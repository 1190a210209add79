#include "solver/plane/light/tested_shares.h"

#include <cmath>

#include "geometry/name.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/light/beam.h"
#include "solver/plane/light/light_shares.h"
#include "solver/plane/light/lit_region.h"

namespace hottel {
namespace {

// A light that tests points.
class Tester {
 public:
  Tester(const PreparedScene2& prepared, const PointLocation2& location, const Light& light, const LightPlace2& place,
         LightTest test)
      : vertices_(prepared.arrangement.vertices()),
        region_(prepared, location, light, place),
        beam_(light, place),
        test_(test) {}

  // The share of a run whose front is on the right.
  double share(const Segment2& run) const {
    const Point2 a = vertices_.exact(run.a), b = vertices_.exact(run.b), along = minus(b, a);
    const Point2 centroid{(a.x + b.x) / 2, (a.y + b.y) / 2}, way = minus(centroid, region_.eye().exact());
    const Rational height = along.x * way.y - along.y * way.x;  // length times distance of the line, on the right
    if (height <= 0) return 0;
    const double intensity = beam_.uncut_intensity(way);
    if (intensity == 0) return 0;
    const double part = test_ == LightTest::kCentroid ? passes(centroid) : (passes(a) + passes(b)) / 2.0;
    return part > 0 ? part * to_double(height / (way.x * way.x + way.y * way.y)) * intensity : 0;
  }

 private:
  int passes(const Point2& point) const {
    return beam_.contains(minus(point, region_.eye().exact())) && region_.reaches(Eye2(vertices_, point)) ? 1 : 0;
  }

  const Vertices2& vertices_;
  LitRegion2 region_;
  Beam2 beam_;
  LightTest test_;
};

// A sun that tests points.
class SunTester {
 public:
  SunTester(const PreparedScene2& prepared, const LightPlace2& place, LightTest test)
      : vertices_(prepared.arrangement.vertices()),
        view_(prepared.arrangement, turned_direction(place)),
        scale_over_length_(to_double(vertices_.scale() * metres_per_unit(prepared.scene)) /
                           std::hypot(to_double(view_.direction().x), to_double(view_.direction().y))),
        test_(test) {}

  // Of a run whose front is on the right: what it is across the rays, which come from there.
  double share(const Segment2& run) const {
    const Rational across = view_.across(run.a) - view_.across(run.b);
    if (across <= 0) return 0;
    const Point2 a = vertices_.exact(run.a), b = vertices_.exact(run.b);
    const double part =
        test_ == LightTest::kCentroid ? passes({(a.x + b.x) / 2, (a.y + b.y) / 2}) : (passes(a) + passes(b)) / 2.0;
    return part * to_double(across) * scale_over_length_;
  }

 private:
  int passes(const Point2& point) const { return view_.reaches(Eye2(vertices_, point)) ? 1 : 0; }

  const Vertices2& vertices_;
  SunView2 view_;
  double scale_over_length_;
  LightTest test_;
};

template <class Tester>
void test_elements(const ElementTable2& table, const Tester& tester, const Light& light, LightShares& shares) {
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    double sum = 0;
    for (const Segment2& run : table.runs(label)) sum += tester.share(run);
    if (!std::isfinite(sum))
      throw RequestError("the share of light " + quoted_name(light.name) + " that '" + table.elements()[label].name +
                         "' gets is beyond the range of doubles");
    shares.of_element[label] = {sum, sum};
  }
}

}  // namespace

std::vector<LightShares> light_shares(const PreparedScene2& prepared, Granularity granularity, LightTest test) {
  std::vector<LightShares> result = light_shares(prepared, granularity);
  const Scene2& scene = prepared.scene;
  if (test == LightTest::kExact || scene.lights.empty()) return result;
  const ElementTable2& table = *prepared.elements(granularity);
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k].test = test;
    with_file_context(scene.file, [&] {
      const Light& light = scene.lights[k];
      const LightPlace2& place = scene.light_places[k];
      if (light.is_sun())
        test_elements(table, SunTester(prepared, place, test), light, result[k]);
      else
        test_elements(table, Tester(prepared, location, light, place, test), light, result[k]);
    });
  }
  return result;
}

}  // namespace hottel

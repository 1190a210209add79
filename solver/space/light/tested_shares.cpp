#include "solver/space/light/tested_shares.h"

#include <cmath>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/space/visibility/visibility_finder.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/light/scene_light_shares.h"

namespace hottel {
namespace {

Vector3 sum(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector3 multiple(const Rational& factor, const Vector3& v) { return {factor * v.x, factor * v.y, factor * v.z}; }

// The corners of a convex polygon in scene coordinates, what crosses it, as long as its area is large, and the centre
// of its area.
struct ExactPatch {
  std::vector<Point3> corners;
  Vector3 area;
  Point3 centroid;

  ExactPatch(const Vertices3& vertices, const Patch3& patch) {
    const auto place = [&](const Rational& origin, const Integer& value) -> Rational {
      return origin + vertices.scale() * Rational(value) / Rational(patch.weight);
    };
    const Point3& origin = vertices.origin();
    for (const IntegerVector& corner : patch.corners)
      corners.push_back({place(origin.x, corner.x), place(origin.y, corner.y), place(origin.z, corner.z)});
    const Point3& first = corners.front();
    std::vector<Vector3> doubled;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      doubled.push_back(cross(corners[k] - first, corners[k + 1] - first));
    for (const Vector3& part : doubled) area = sum(area, part);
    // All of them have one direction, so that their sizes are as their products with the sum.
    const Rational whole = 3 * dot(area, area);
    Vector3 way;
    for (std::size_t k = 0; k < doubled.size(); ++k)
      way = sum(way, multiple(dot(doubled[k], area) / whole, sum(corners[k + 1] - first, corners[k + 2] - first)));
    centroid = {first.x + way.x, first.y + way.y, first.z + way.z};
    area = multiple(Rational(1, 2), area);
  }
};

// The root of a positive rational, of any size.
double root(const Rational& square) {
  const auto bits = [](const Integer& number) { return static_cast<long>(mpz_sizeinbase(number.get_mpz_t(), 2)); };
  const long half = (bits(square.get_num()) - bits(square.get_den())) / 2;
  return std::scalbln(std::sqrt(to_double(scaled_by_power_of_two(square, -2 * half))), half);
}

// A light that tests points.
class Tester {
 public:
  Tester(const PreparedScene3& prepared, const Light& light, const LightPlace3& place, LightTest test)
      : vertices_(prepared.occluders().vertices()),
        map_(exact_visibility_map_of(prepared, light, place)),
        finder_(map_),
        beam_(beam_of(light, place)),
        sun_(place.direction),
        square_metres_(to_double(square_metres_per_unit(prepared.scene))),
        test_(test) {}

  double share(const Patch3& patch) const {
    const ExactPatch exact(vertices_, patch);
    if (map_.sun()) {
      const Rational across = -dot(exact.area, sun_);
      const double part = across > 0 ? lit_part(exact) : 0;
      return part > 0 ? part * root(across * across / dot(sun_, sun_)) * square_metres_ : 0;
    }
    const Vector3 way = exact.centroid - map_.eye();
    const Rational height = -dot(exact.area, way), square = dot(way, way);  // area, cosine and distance
    if (height <= 0) return 0;
    const double intensity = beam_.uncut_intensity(map_.toward(exact.centroid));
    const double part = intensity > 0 ? lit_part(exact) : 0;
    return part > 0 ? part * root(height * height / (square * square * square)) * intensity : 0;
  }

 private:
  double lit_part(const ExactPatch& patch) const {
    if (test_ == LightTest::kCentroid) return passes(patch.centroid) ? 1 : 0;
    int lit = 0;
    for (const Point3& corner : patch.corners) lit += passes(corner) ? 1 : 0;
    return static_cast<double>(lit) / static_cast<double>(patch.corners.size());
  }
  bool passes(const Point3& point) const { return beam_.side(map_.toward(point)) >= 0 && finder_.sees(point); }

  const Vertices3& vertices_;
  ExactVisibilityMap3 map_;
  VisibilityFinder3 finder_;
  BeamPower3 beam_;
  Vector3 sun_;           // of a sun: the direction of its rays
  double square_metres_;  // of a square of the unit of the scene
  LightTest test_;
};

void test_elements(const ElementTable3& table, const Tester& tester, const Light& light, LightShares& shares) {
  shares.of_element.assign(table.count(), Enclosure{0, 0});
  if (!shares.solid.empty()) return;
  parallel_for(
      table.count(),
      [&](std::size_t label) {
        double sum = 0;
        for (const ElementTable3::Part& part : table.free_parts(static_cast<std::uint32_t>(label)))
          sum += tester.share(part.patch);
        shares.of_element[label] = {sum, sum};
      },
      1);
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (!std::isfinite(shares.of_element[label].lower))
      throw RequestError("the share of light " + quoted_name(light.name) + " that '" + table.elements()[label].name +
                         "' gets is beyond the range of doubles");
}

}  // namespace

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity, LightTest test) {
  if (test == LightTest::kExact) return light_shares(prepared, granularity);
  std::vector<LightShares> result = light_shares(prepared, Granularity::kFace);  // what of them goes to the sky
  const Scene3& scene = prepared.scene;
  if (scene.lights.empty()) return result;
  const ElementTable3& table = *prepared.elements(granularity);
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k].test = test;
    with_file_context(scene.file, [&] {
      const LightPlace3& place = scene.light_places[k];
      test_elements(table, Tester(prepared, scene.lights[k], place, test), scene.lights[k], result[k]);
    });
  }
  return result;
}

}  // namespace hottel

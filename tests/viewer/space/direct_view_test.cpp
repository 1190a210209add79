// Direct light in pictures: point by point, by area at the borders of shadows and beams, and in the mean that of
// elements.
#include "viewer/picture/space/direct_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/space/light/scene_lights.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/projection.h"
#include "viewer/picture/space/render_picture.h"
#include "viewer/picture/space/side_plane.h"

namespace hottel::direct_view_test {
namespace {

Simulation3 stage() {
  return Simulation3(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/stage.json"),
                     {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-4}});
}

Vector3 toward(const PreparedScene3& prepared, const Face& side) {
  const IntegerVector& n = prepared.occluders().exact_normal(side.surface);
  const int sign = side.is_back ? -1 : 1;
  return {Rational(sign * n.x), Rational(sign * n.y), Rational(sign * n.z)};
}

// Sixteen by sixteen points of a pixel of a side, each looked at exactly.
double sampled(const PreparedScene3& prepared, const SceneLights3& lights, const Camera3& camera, const Face& side,
               std::uint32_t x, std::uint32_t y) {
  constexpr int kAcross = 16;
  const Projection3 projection(camera);
  const SidePlane3 plane(prepared, side, camera.eye);
  double sum = 0;
  for (int k = 0; k < kAcross * kAcross; ++k) {
    const Pixel place{x + (k % kAcross + 0.5) / kAcross, y + (k / kAcross + 0.5) / kAcross};
    std::vector<double> here(3);
    lights.add(plane.point(plane.way(projection.direction(place))), toward(prepared, side), here);
    sum += here[0];
  }
  return sum / (kAcross * kAcross);
}

TEST(DirectView3, IsTheMeanOfPointsInEachPixel) {
  const Simulation3 simulation = stage();
  const PreparedScene3& prepared = *simulation.prepared();
  const auto solution = simulation.radiosities();
  const auto table = prepared.elements(Granularity::kElement);
  const Camera3 camera = camera_of_scene(prepared, 96);
  const std::vector<SeenSide3> seen = seen_sides_3(prepared, camera);
  const SceneLights3 lights(prepared);
  PixelValues3 pixels{camera.width, camera.height, 3, {}};
  pixels.values.assign(std::size_t{camera.width} * camera.height * 3, 0);
  add_direct_light_3(prepared, *table, *solution, camera, seen, pixels);
  const auto element = elements_of_sides_3(prepared, *table);
  int compared = 0, partly = 0;
  double most = 0;
  for (const double value : pixels.values) most = std::max(most, value);
  for (const SeenSide3& side : seen)
    for_each_covered_pixel(side.outline, camera.width, camera.height, [&](const PixelCover3& cover) {
      if (cover.part < 1 || (cover.x + 3 * cover.y) % 5 != 0 || !element[side.side.number()]) return;
      const double reflectivity = solution->channels[0].elements[*element[side.side.number()]].reflectivity;
      const double expected = reflectivity * sampled(prepared, lights, camera, side.side, cover.x, cover.y);
      const double found = pixels.at(cover.x, cover.y)[0];
      EXPECT_NEAR(found, expected, 0.02 * most) << cover.x << ' ' << cover.y;
      ++compared;
      partly += expected > 0 && found < 0.5 * most ? 1 : 0;
    });
  EXPECT_GT(compared, 500);
  EXPECT_GT(partly, 20);
}

// What is taken from elements is what is added to pixels: light stays in the mean.
TEST(DirectView3, TakesFromElementsWhatTheirSharesSay) {
  const Simulation3 simulation = stage();
  const auto solution = simulation.radiosities();
  const PreparedScene3& prepared = *simulation.prepared();
  const auto table = prepared.elements(Granularity::kElement);
  const ElementPaint3 all = light_paint_3(prepared.scene, *solution);
  const ElementPaint3 reflected = reflected_paint_3(prepared, *table, *solution, *simulation.light_shares());
  double taken = 0, expected = 0;
  for (std::uint32_t i = 0; i < table->count(); ++i) {
    if (!table->has_row(i)) continue;
    EXPECT_GE(reflected.value(i)[0], 0);
    EXPECT_LE(reflected.value(i)[0], all.value(i)[0]);
    taken += (all.value(i)[0] - reflected.value(i)[0]) * table->elements()[i].area.value;
    for (std::size_t k = 0; k < simulation.light_shares()->size(); ++k)
      expected += solution->channels[0].elements[i].reflectivity * (*simulation.light_shares())[k].of_element[i].upper *
                  to_double(prepared.scene.lights[k].power.value[0]);
  }
  EXPECT_NEAR(taken, expected, 1e-9 * expected);
}

// A picture of flat elements has round spots once direct light is told apart, and as much light.
TEST(DirectView3, GivesFlatElementsTheBordersOfLight) {
  const Simulation3 simulation = stage();
  const auto view = [&](bool is_apart) {
    return RenderedView3(*simulation.prepared(), Granularity::kElement, *simulation.radiosities(),
                         {.wanted_width = 60, .light_shares = is_apart ? simulation.light_shares() : nullptr})
        .file(PictureFormat::kPng);
  };
  EXPECT_NE(view(true), view(false));
}

}  // namespace
}  // namespace hottel::direct_view_test

// Direct light in pictures: point by point, by area at the borders of shadows and beams, and in the mean that of
// elements.
#include "viewer/picture/space/direct_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
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

// The mean over many points of what a side has of a pixel, each looked at exactly.
double sampled(const PreparedScene3& prepared, const SceneLights3& lights, const Camera3& camera, const SeenSide3& side,
               std::uint32_t x, std::uint32_t y) {
  constexpr std::uint32_t kAcross = 16;
  const Projection3 projection(camera);
  const SidePlane3 plane(prepared, side.side, camera.eye);
  PixelPolygon large;  // kAcross times as large, with the pixel at its origin
  for (const Pixel& p : side.outline) large.push_back({kAcross * (p.x - x), kAcross * (p.y - y)});
  double sum = 0, area = 0;
  for_each_covered_pixel(large, kAcross, kAcross, [&](const PixelCover3& cover) {
    if (!(cover.part > 0)) return;
    const Pixel place{x + cover.middle.x / kAcross, y + cover.middle.y / kAcross};
    std::vector<double> here(3);
    lights.add(plane.point(plane.way(projection.direction(place))), toward(prepared, side.side), here);
    sum += cover.part * here[0];
    area += cover.part;
  });
  return area > 0 ? sum / area : 0;
}

// Where edges of what is seen are, too: the border of a beam may pass beside what a face has of a pixel.
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
  double most = 0;
  for (const double value : pixels.values) most = std::max(most, value);
  const auto is_chosen = [](const PixelCover3& cover) { return (cover.x + 3 * cover.y) % 5 == 0; };
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> expected;
  int on_edges = 0, partly = 0;
  for (const SeenSide3& side : seen)
    for_each_covered_pixel(side.outline, camera.width, camera.height, [&](const PixelCover3& cover) {
      if (!is_chosen(cover) || !element[side.side.number()]) return;
      const double reflectivity = solution->channels[0].elements[*element[side.side.number()]].reflectivity;
      expected[{cover.x, cover.y}] +=
          cover.part * reflectivity * sampled(prepared, lights, camera, side, cover.x, cover.y);
      on_edges += cover.part < 1 ? 1 : 0;
    });
  for (const auto& [place, value] : expected) {
    const double found = pixels.at(place.first, place.second)[0];
    EXPECT_NEAR(found, value, 0.02 * most) << place.first << ' ' << place.second;
    partly += value > 0 && found < 0.5 * most ? 1 : 0;
  }
  EXPECT_GT(expected.size(), 500u);
  EXPECT_GT(on_edges, 100);
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

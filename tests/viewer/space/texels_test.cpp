// Lightmaps: where their texels lie, what each has, and where there is none.
#include "viewer/picture/space/texels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "geometry/scene_names.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/space/light/sent_out.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::texels_test {
namespace {

Simulation3 solved(const std::string& file, std::uint32_t elements) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + file);
  if (elements > 0)
    for (Surface& surface : scene.surfaces) surface.elements = elements;
  return Simulation3(std::move(scene), {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-4}});
}

TEST(Texels3, LieAsThePolygonGoesAround) {
  const Scene3 scene = solved("lights/stage.json", 0).scene();
  const Grid3 grid = texel_grid_3(scene, face_of(scene, "back wall"), 3, 2);
  EXPECT_EQ(cell_centre(grid, 0), (Point3{1, 4, Rational(3, 4)}));
  EXPECT_EQ(cell_centre(grid, 5), (Point3{5, 4, Rational(9, 4)}));
}

// Radiosity is emission and what is reflected of light that is known in another way; spots included.
TEST(Texels3, HaveTheLightOfTheirMiddles) {
  const Simulation3 simulation = solved("lights/stage.json", 1);
  const auto solution = simulation.radiosities();
  const PreparedScene3& prepared = *simulation.prepared();
  const GatheredSource3 source(prepared, Granularity::kElement, *solution, light_responses_3(*solution),
                               *simulation.light_shares());
  const Face floor = face_of(simulation.scene(), "floor");
  const Grid3 grid = texel_grid_3(simulation.scene(), floor, 13, 9);
  const IlluminationGrid3 texels = texels_3(prepared, source, floor, grid);
  const SentOut3 sent_out(prepared, Granularity::kElement, *solution);
  const SceneLights3 lights(prepared);
  int bright = 0, none = 0;
  for (std::uint32_t k = 0; k < 13 * 9; ++k) {
    const double found = texels.at(k % 13, k / 13, 0);
    const Point3 middle = cell_centre(grid, k);
    const bool is_below_block = middle.x > Rational(3, 2) && middle.x < Rational(5, 2) && middle.y > 2 && middle.y < 3;
    EXPECT_EQ(std::isnan(found), is_below_block) << k;
    none += is_below_block ? 1 : 0;
    if (is_below_block) continue;
    std::vector<double> irradiance(3);
    sent_out.irradiance(middle, {0, 0, 1}, irradiance);
    const double reflected = irradiance[0];
    lights.add(middle, {0, 0, 1}, irradiance);
    bright += irradiance[0] > 2 * reflected ? 1 : 0;
    EXPECT_NEAR(found, 0.6 * irradiance[0], 1e-9 * irradiance[0]) << k;  // each face is one element: nothing runs
  }
  EXPECT_GT(bright, 5);
  EXPECT_GT(none, 2);
}

TEST(Texels3, AreOfPlaneFaces) {
  Scene3 scene = solved("space/cube.json", 1).scene();
  scene.polygons[0].is_nearly_plane = true;
  EXPECT_THROW(texel_grid_3(scene, {0, false}, 2, 2), UsageError);
}

}  // namespace
}  // namespace hottel::texels_test

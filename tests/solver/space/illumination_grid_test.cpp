// Mean irradiance on a planar grid: shares of the sphere known by symmetry, elements, the sky, solids.
#include "solver/space/light/illumination_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::illumination_grid_test {
namespace {

// The unit cube, black but for its ceiling, which sends out 6.
Scene3 black_cube(std::uint32_t elements) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json");
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(0);
    material.emission = Spectrum::scalar(material.name == "lamp" ? 6 : 0);
  }
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return scene;
}

Simulation3 simulation_of(Scene3 scene, Granularity granularity = Granularity::kFace) {
  return Simulation3(std::move(scene), {.factors = {.granularity = granularity, .tolerance = 1e-6}});
}

IlluminationGrid3 light(const Simulation3& simulation, const Grid3& grid) {
  return illuminate_points(*simulation.prepared(), simulation.request().factors.granularity, *simulation.radiosities(),
                           grid);
}

constexpr double kTiny = 1e-13;
const Grid3 kMiddle{{0, 0, Rational(1, 2)}, {1, 0, 0}, {0, 1, 0}, 1, 1};  // its cell has its centre in that of the cube

TEST(IlluminationGrid3, TheMiddleOfACubeSeesASixthOfEachFace) {
  EXPECT_NEAR(light(simulation_of(black_cube(1)), kMiddle).at(0, 0), 1, kTiny);
  EXPECT_NEAR(light(simulation_of(black_cube(4), Granularity::kElement), kMiddle).at(0, 0), 1, kTiny);
}

// A square of side a at the height h has the solid angle
// 4 asin(a² / (a² + 4 h²)).
TEST(IlluminationGrid3, CellsAreAtTheirCentres) {
  const Grid3 upright{{Rational(1, 2), 0, 0}, {0, 0, 1}, {0, 1, 0}, 4, 1};  // four heights in the middle
  const IlluminationGrid3 grid = light(simulation_of(black_cube(1)), upright);
  for (std::uint32_t k = 0; k < 4; ++k) {
    const double h = 1 - (k + 0.5) / 4;
    EXPECT_NEAR(grid.at(k, 0), 6 * 4 * std::asin(1 / (1 + 4 * h * h)) / (4 * std::numbers::pi), kTiny) << k;
  }
}

// Outside one sees black backs and the sky: cells there have no light where the scene promises to be closed.
TEST(IlluminationGrid3, CellsOutsideAClosedSceneAreNan) {
  const Grid3 across{{-1, Rational(1, 2), Rational(1, 2)}, {3, 0, 0}, {0, Rational(1, 100), 0}, 6, 1};
  for (const bool is_closed : {false, true}) {
    Scene3 scene = black_cube(1);
    scene.closed = is_closed;
    scene.sky_emission = Spectrum::scalar(2);
    const IlluminationGrid3 grid = light(simulation_of(scene), across);
    for (std::uint32_t k = 0; k < 6; ++k)
      EXPECT_EQ(std::isnan(grid.at(k, 0)), is_closed && (k < 2 || k > 3)) << is_closed << " " << k;
  }
}

TEST(IlluminationGrid3, EachElementCountsByItsOwnSolidAngle) {
  const Simulation3 simulation = simulation_of(black_cube(2), Granularity::kElement);
  const auto& elements = simulation.factors()->matrix.elements();
  RadiositySolution solution = *simulation.radiosities();
  for (const char* name : {"ceiling#0", "ceiling#1", "ceiling#2", "ceiling#3"}) {
    double sum = 0;
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      solution.channels[0].elements[i].radiosity = elements[i].name == name ? 24 : 0;
      sum += solution.channels[0].elements[i].radiosity;
    }
    ASSERT_EQ(sum, 24);
    EXPECT_NEAR(illuminate_points(*simulation.prepared(), Granularity::kElement, solution, kMiddle).at(0, 0), 1, kTiny);
  }
}

TEST(IlluminationGrid3, DivisionChangesNothingWhereElementsAreAlike) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
  for (Material& material : scene.materials) material.reflectivity = Spectrum::scalar(0);  // only lamps send light
  const Grid3 grid{{0, 0, Rational(1, 3)}, {1, 0, 0}, {0, 1, 0}, 4, 4};
  const IlluminationGrid3 whole = light(simulation_of(scene), grid);
  for (Surface& surface : scene.surfaces) surface.elements = 3;
  const IlluminationGrid3 divided = light(simulation_of(scene, Granularity::kElement), grid);
  ASSERT_EQ(whole.values.size(), divided.values.size());
  for (std::size_t k = 0; k < whole.values.size(); ++k) {
    if (std::isnan(whole.values[k])) {
      EXPECT_TRUE(std::isnan(divided.values[k]));
    } else {
      EXPECT_NEAR(whole.values[k], divided.values[k], kTiny * (1 + whole.values[k]));
    }
  }
}

TEST(IlluminationGrid3, TheSkyCarriesItsEmissionAndFacesAreSeenOnOneSide) {
  Scene3 scene = parse_scene_3(R"({"hottel": 1, "dimension": 3, "sky": {"emission": 12}, "materials": {
    "lamp": {"emission": 6}}, "polygons": [
    {"name": "plate", "points": [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]], "material": "lamp"}]})",
                               "plate.json");
  const Simulation3 simulation = simulation_of(std::move(scene));
  // At half its side above and below its middle the plate is a sixth of all directions.
  const Grid3 upright{{0, -1, -2}, {0, 2, 0}, {0, 0, 4}, 1, 2};
  const IlluminationGrid3 grid = light(simulation, upright);
  EXPECT_NEAR(grid.at(0, 0), 12 * 5.0 / 6, kTiny * 12);  // its back is black
  EXPECT_NEAR(grid.at(0, 1), 6 / 6.0 + 12 * 5.0 / 6, kTiny * 12);
}

TEST(IlluminationGrid3, CellsInSolidsAreNan) {
  const Simulation3 simulation = simulation_of(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": 1}}, "polygons": [
        {"name": "a", "group": "t", "points": [[0,0,0],[0,1,0],[1,0,0]], "material": "m"},
        {"name": "b", "group": "t", "points": [[0,0,0],[1,0,0],[0,0,1]], "material": "m"},
        {"name": "c", "group": "t", "points": [[0,0,0],[0,0,1],[0,1,0]], "material": "m"},
        {"name": "d", "group": "t", "points": [[1,0,0],[0,1,0],[0,0,1]], "material": "m"}]})",
      "solid.json"));
  const Grid3 row{{Rational(-1, 8), 0, Rational(1, 8)}, {1, 0, 0}, {0, Rational(1, 4), 0}, 4, 1};
  const IlluminationGrid3 grid = light(simulation, row);
  for (std::uint32_t k = 0; k < 4; ++k) {
    const double x = -0.125 + (k + 0.5) / 4;  // at y = z = 1/8 the solid is 0 < x < 3/4
    EXPECT_EQ(std::isnan(grid.at(k, 0)), x > 0 && x < 0.75) << k;
  }
}

TEST(IlluminationGrid3, DoesNotDependOnThreads) {
  const Simulation3 simulation = simulation_of(black_cube(2), Granularity::kElement);
  const Grid3 grid{{0, 0, Rational(1, 3)}, {1, 0, 0}, {0, 1, 0}, 5, 3};
  const IlluminationGrid3 many = light(simulation, grid);
  const ThreadLimit one(1);
  EXPECT_EQ(light(simulation, grid).values, many.values);
}

}  // namespace
}  // namespace hottel::illumination_grid_test

// Mean irradiance of cells: known factors, means of many points, solids, lights, bounds.
#include "solver/space/light/average_irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/light/oriented_lights.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::average_irradiance_test {
namespace {

constexpr double kOppositeFaces = 0.19982489569838746;  // F of two opposite faces of a cube

Scene3 scene_of(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name + ".json");
}

// The unit cube, black but for its ceiling, which sends out 6.
Scene3 black_cube() {
  Scene3 scene = scene_of("cube");
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(0);
    material.emission = Spectrum::scalar(material.name == "lamp" ? 6 : 0);
  }
  return scene;
}

IlluminationGrid3 averages(const Simulation3& simulation, const Grid3& grid, bool proves = false) {
  return average_irradiance(*simulation.prepared(), *simulation.radiosities(), grid,
                            {.granularity = simulation.request().factors.granularity, .proves = proves});
}

double mean(const IlluminationGrid3& grid) {
  double sum = 0;
  for (std::uint32_t v = 0; v < grid.grid.nv; ++v)
    for (std::uint32_t u = 0; u < grid.grid.nu; ++u) sum += grid.at(u, v);
  return sum / (grid.grid.nu * grid.grid.nv);
}

// Of the cells of a finer grid by its points, one by one: slow and obvious.
IlluminationGrid3 of_points(const Simulation3& simulation, Grid3 grid, std::uint32_t times) {
  IlluminationGrid3 result{grid, 1, std::vector<double>(std::size_t{grid.nu} * grid.nv, 0.0)};
  const std::uint32_t nu = grid.nu;
  grid.nu *= times;
  grid.nv *= times;
  const auto lights = oriented_lights_on_grid(*simulation.prepared(), simulation.request().factors.granularity,
                                              *simulation.radiosities(), grid);
  for (std::size_t k = 0; k < lights.size(); ++k)
    result.values[k / grid.nu / times * nu + k % grid.nu / times] += lights[k].irradiance[0] / (times * times);
  return result;
}

TEST(AverageIrradiance, TheCellsOfAFloorTogetherHaveWhatTheFloorHas) {
  const Simulation3 simulation(black_cube());
  for (const auto& [nu, nv] : {std::pair(1u, 1u), {4u, 4u}, {5u, 3u}}) {
    const IlluminationGrid3 found = averages(simulation, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, nu, nv});
    EXPECT_NEAR(mean(found), 6 * kOppositeFaces, 1e-12) << nu;
    EXPECT_LT(found.max_error().value(), 1e-8);
  }
}

TEST(AverageIrradiance, IsOfTheSideThatLooksAlongUTimesV) {
  const Simulation3 simulation(black_cube());
  const Grid3 up{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1}, down{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1, 1};
  EXPECT_GT(averages(simulation, up).at(0, 0), 1);
  EXPECT_TRUE(std::isnan(averages(simulation, down).at(0, 0)));  // the cube promises to be closed
}

TEST(AverageIrradiance, IsTheMeanOfManyPoints) {
  for (const char* name : {"two_boxes", "cornell_box"}) {
    const Simulation3 simulation(scene_of(name), {.factors = {.tolerance = 1e-4}});
    const Scene3& scene = simulation.scene();
    const Grid3 grid = std::string(name) == "two_boxes"
                           ? Grid3{{Rational(1, 10), Rational(1, 10), 1}, {1, 0, 0}, {0, 1, 0}, 3, 2}
                           : Grid3{scene.polygons[0].points[0], {100, 0, 0}, {0, 0, 100}, 1, 1};
    const IlluminationGrid3 found = averages(simulation, grid), slow = of_points(simulation, grid, 24);
    for (std::uint32_t v = 0; v < grid.nv; ++v)
      for (std::uint32_t u = 0; u < grid.nu; ++u)
        EXPECT_NEAR(found.at(u, v), slow.at(u, v), 2e-3 * (1 + slow.at(u, v))) << name;
  }
}

// A box of half the height of the cube, in a corner.
Scene3 cube_with_box() {
  Scene3 scene = black_cube();
  const Rational half(1, 2);
  const auto at = [&](int x, int y, int z) { return Point3{x * half, y * half, z * half}; };
  scene.groups.emplace_back("box");
  const auto add = [&](const char* name, std::vector<Point3> points) {
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
    scene.add(surface, {std::move(points), {}});
  };
  add("box.0", {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
  add("box.1", {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
  add("box.2", {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
  add("box.3", {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
  add("box.4", {at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)});
  add("box.5", {at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)});
  return scene;
}

TEST(AverageIrradiance, IsOverTheFreePartAndNanInSolids) {
  const Simulation3 simulation(cube_with_box());
  const Rational height(1, 4);
  const Grid3 halves{{0, 0, height}, {1, 0, 0}, {0, Rational(1, 2), 0}, 2, 1};
  const IlluminationGrid3 found = averages(simulation, halves, true);
  EXPECT_TRUE(std::isnan(found.at(0, 0)));
  EXPECT_EQ(found.errors[0], 0);
  const Grid3 both{{0, 0, height}, {1, 0, 0}, {0, Rational(1, 2), 0}, 1, 1};
  const IlluminationGrid3 of_both = averages(simulation, both, true);
  EXPECT_NEAR(of_both.at(0, 0), found.at(1, 0), found.errors[1] + of_both.errors[0] + 1e-12);
  EXPECT_GT(found.at(1, 0), 0.1);
}

TEST(AverageIrradiance, BoundsHoldAndAreNarrowWhereAllIsProven) {
  const Simulation3 simulation(cube_with_box());
  const Grid3 grid{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4};
  const IlluminationGrid3 wide = averages(simulation, grid), narrow = averages(simulation, grid, true);
  EXPECT_LT(narrow.max_error().value(), 1e-8);
  for (std::size_t cell = 0; cell < wide.errors.size(); ++cell) {
    EXPECT_EQ(std::isnan(wide.values[cell]), std::isnan(narrow.values[cell]));
    if (std::isnan(wide.values[cell])) continue;
    EXPECT_LE(std::abs(wide.values[cell] - narrow.values[cell]), wide.errors[cell] + narrow.errors[cell]);
  }
}

TEST(AverageIrradiance, HasTheLightOfLamps) {
  Scene3 scene = cube_with_box();
  for (Material& material : scene.materials) material.emission = Spectrum::scalar(0);
  Light light;
  light.name = "lamp";
  light.power = Spectrum::scalar(100);
  LightPlace3 place;
  place.position = {Rational(1, 3), Rational(2, 3), Rational(7, 8)};
  scene.add_light(light, place);
  const Simulation3 simulation(scene);
  const Grid3 grid{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2};
  const IlluminationGrid3 found = averages(simulation, grid);
  for (const auto& [u, v] : {std::pair(1u, 0u), {0u, 1u}, {1u, 1u}})
    EXPECT_NEAR(found.at(u, v), of_points(simulation, grid, 40).at(u, v), 0.02 * found.at(u, v)) << u << v;
}

}  // namespace
}  // namespace hottel::average_irradiance_test

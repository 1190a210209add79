// Mean irradiance in a volume: its layers, furnaces, a wall by itself, solids, and rays as a slow second way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/light/oriented_lights.h"
#include "solver/space/simulation/simulation.h"
#include "tests/oracle/space/nearest_polygon.h"

namespace hottel::volume_light_test {
namespace {

Scene3 scene_of(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name + ".json");
}

IlluminationGrid3 light_in(Scene3 scene, const Grid3& grid) {
  return *Simulation3(std::move(scene), {.factors = {.tolerance = 1e-6}, .light = {.grid = grid}}).light();
}

Grid3 volume(Point3 origin, Vector3 u, Vector3 v, Vector3 w, std::array<std::uint32_t, 3> cells) {
  return {std::move(origin), std::move(u), std::move(v), cells[0], cells[1], "", std::move(w), cells[2]};
}

// A closed cube whose walls, half of them mirrors of light, are equally warm: a black body.
TEST(VolumeLight, IsThatOfTheWallsInAFurnace) {
  constexpr double kTemperature = 500, kSigma = 5.670374419e-8;
  Scene3 scene = scene_of("cube");
  const double emissive = kSigma * std::pow(kTemperature, 4);
  for (Material& material : scene.materials) {
    const Rational e = material.name == "lamp" ? Rational(1, 4) : Rational(9, 10);
    material = Material{.name = material.name,
                        .reflectivity = Spectrum::scalar(1 - e),
                        .emission = Spectrum::scalar(e * Rational(emissive))};
  }
  scene.closed = true;
  // Oblique, and beyond the room on all sides.
  const Grid3 grid = volume({-1, -1, -1}, {3, Rational(1, 8), 0}, {0, 3, 0}, {Rational(1, 8), 0, 3}, {6, 5, 7});
  const IlluminationGrid3 light = light_in(scene, grid);
  const std::vector<OrientedLight> around = lights_around(light);
  std::size_t inside = 0;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const Point3 centre = cell_centre(grid, cell);
    const auto is_within = [](const Rational& x) { return x > 0 && x < 1; };
    const double temperature = mean_radiant_temperature(around[cell].mean_irradiance);
    if (is_within(centre.x) && is_within(centre.y) && is_within(centre.z)) {
      EXPECT_NEAR(light.values[cell], emissive, 1e-12 * emissive) << cell;
      EXPECT_NEAR(temperature, kTemperature, 1e-9);
      ++inside;
    } else {
      EXPECT_TRUE(std::isnan(light.values[cell])) << cell;
      EXPECT_TRUE(std::isnan(temperature));
    }
  }
  EXPECT_GT(inside, 4U);
}

// A square of side 2 seen from the height h above its middle has the solid angle 4 asin(1 / (1 + h²)).
TEST(VolumeLight, IsTheSolidAngleOfAWallByItself) {
  const Scene3 scene = parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"warm": {"emission": 7}},
    "polygons": [{"name": "wall", "points": [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]], "material": "warm"}]})",
                                     "wall.json");
  const IlluminationGrid3 light = light_in(scene, volume({-3, -1, -1}, {6, 0, 0}, {0, 2, 0}, {0, 0, 5}, {3, 1, 10}));
  for (std::uint32_t k = 0; k < 10; ++k) {
    const double h = -1 + (k + 0.5) / 2;
    const double expected = h > 0 ? 7 * std::asin(1 / (1 + h * h)) / std::numbers::pi : 0;  // behind it is dark
    EXPECT_NEAR(light.values[3 * k + 1], expected, 1e-14) << h;
    EXPECT_NEAR(light.values[3 * k], light.values[3 * k + 2], 1e-15);
  }
}

// Bit for bit.
TEST(VolumeLight, HasPlanarGridsAsItsLayers) {
  const Simulation3 simulation(scene_of("two_boxes"), {.factors = {.tolerance = 1e-6}});
  const Vector3 u{6, 0, 0}, v{0, 6, 0};
  const Grid3 grid = volume({0, 0, 0}, u, v, {0, 0, 2}, {5, 4, 3});
  const auto asked = [&](const Grid3& where) { return *simulation.with_request({.light = {.grid = where}}).light(); };
  const std::vector<double> all = asked(grid).values;
  for (std::uint32_t k = 0; k < grid.nw; ++k) {
    const std::vector<double> layer = asked({{0, 0, Rational(2 * k + 1) / Rational(3)}, u, v, grid.nu, grid.nv}).values;
    for (std::size_t n = 0; n < layer.size(); ++n) {
      const double here = all[k * layer.size() + n];
      EXPECT_TRUE(here == layer[n] || (std::isnan(here) && std::isnan(layer[n]))) << k << " " << n;
    }
  }
}

// A tetrahedron, x + y + z < 1, in the open.
TEST(VolumeLight, IsNoneInSolids) {
  const Scene3 scene = parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": 1}}, "polygons": [
        {"name": "a", "group": "t", "points": [[0,0,0],[0,1,0],[1,0,0]], "material": "m"},
        {"name": "b", "group": "t", "points": [[0,0,0],[1,0,0],[0,0,1]], "material": "m"},
        {"name": "c", "group": "t", "points": [[0,0,0],[0,0,1],[0,1,0]], "material": "m"},
        {"name": "d", "group": "t", "points": [[1,0,0],[0,1,0],[0,0,1]], "material": "m"}]})",
      "solid.json");
  const Grid3 grid = volume({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 4, 4});
  const IlluminationGrid3 light = light_in(scene, grid);
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const Point3 centre = cell_centre(grid, cell);
    EXPECT_EQ(std::isnan(light.values[cell]), centre.x + centre.y + centre.z < 1) << cell;
  }
}

oracle::SpacePolygon corners(const Polygon3& polygon) {
  oracle::SpacePolygon result;
  for (const Point3& p : polygon.points) result.push_back({p.x, p.y, p.z});
  return result;
}

// The mean over directions of a lattice on the sphere, turned at random, each followed through all polygons in
// rationals.
double mean_by_rays(const Scene3& scene, const RadiositySolution& solution, const ExchangeMatrix& matrix,
                    const Point3& eye, int count) {
  std::vector<oracle::SpacePolygon> polygons;
  for (const Polygon3& polygon : scene.polygons) polygons.push_back(corners(polygon));
  const oracle::RayCaster cast(polygons, {eye.x, eye.y, eye.z});
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  const double turn = phase(random), golden = std::numbers::pi * (3 - std::sqrt(5.0));
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z), angle = turn + golden * k;
    const Point3 way{Rational(r * std::cos(angle)), Rational(r * std::sin(angle)), Rational(z)};
    const int met = cast({way.x, way.y, way.z}).polygon;
    if (met == oracle::NearestPolygon::kNoPolygon) continue;
    const Polygon3& polygon = scene.polygons[static_cast<std::size_t>(met)];
    const Vector3 normal = cross(polygon.points[1] - polygon.points[0], polygon.points[2] - polygon.points[0]);
    const bool is_back = dot(normal, {way.x, way.y, way.z}) > 0;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      const Element& element = matrix.elements()[i];
      if (element.surface == static_cast<std::uint32_t>(met) && element.is_back == is_back && matrix.has_row(i))
        sum += solution.channels[0].elements[i].radiosity;
    }
  }
  return sum / count;
}

TEST(VolumeLight, IsTheMeanOverRaysThroughAllPolygons) {
  Scene3 scene = scene_of("two_boxes");
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    scene.materials[m] = Material{.name = scene.materials[m].name,
                                  .reflectivity = Spectrum::scalar(0),
                                  .emission = Spectrum::scalar(static_cast<unsigned long>(m * m + 1))};
  const Simulation3 simulation(std::move(scene), {.factors = {.tolerance = 1e-6}});
  const Grid3 grid = volume({Rational(1, 7), Rational(1, 9), Rational(1, 5)}, {5, 0, 0}, {0, 5, Rational(1, 10)},
                            {0, 0, 5}, {2, 2, 3});
  const auto light = simulation.with_request({.light = {.grid = grid}}).light();
  const auto solution = simulation.with_request({.light = {.grid = grid}}).radiosities();
  const auto factors = simulation.with_request({.light = {.grid = grid}}).factors();
  const std::size_t channels = light->channels;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    const double found = light->values[cell * channels];
    if (std::isnan(found)) continue;
    const double slow = mean_by_rays(simulation.scene(), *solution, factors->matrix, cell_centre(grid, cell), 2000);
    EXPECT_NEAR(found, slow, 0.02 * std::max(1.0, found)) << cell;
  }
}

TEST(VolumeLight, HasNoAverages) {
  const Grid3 grid = volume({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1});
  EXPECT_THROW(Simulation3(scene_of("cube"), {.light = {.grid = grid, .is_average = true}}), UsageError);
}

}  // namespace
}  // namespace hottel::volume_light_test

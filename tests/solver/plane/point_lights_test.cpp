// Light at many points from one solution.
#include "solver/plane/light/point_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "solver/plane/simulation/queries.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel::point_lights_test {
namespace {

// Without its promise to be closed: there is light outside.
Simulation2 apartment() {
  Scene2 scene = read_scene_2(HOTTEL_SOURCE_DIR "/scenes/showcase/apartment.json");
  scene.closed = false;
  return Simulation2(std::move(scene));
}

// (1)
TEST(PointLights2, SayOfEachPointWhatLightAtSays) {
  const Simulation2 simulation = apartment();
  const auto prepared = simulation.prepared();
  const Arrangement2& arrangement = prepared->arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const PointLights2 lights = point_lights(simulation);
  for (const Point2& eye : std::vector<Point2>{{4, 3}, {3, 1}, prepared->scene.edges[5].from, {Rational(1, 3), 100}}) {
    const PointLight2 alone = light_at(simulation, visibility_polygon(arrangement, location, eye));
    EXPECT_EQ(lights.at(location, eye), alone.mean_irradiance);
    EXPECT_EQ(lights.at(location, eye), light_at(simulation, eye).mean_irradiance);
    EXPECT_EQ(lights.channel_names(), alone.channel_names);
  }
}

// (2)
TEST(PointLights2, AreNanInSolids) {
  const PointLight2 light = light_at(apartment(), Point2{6, 3});  // in a wardrobe
  ASSERT_FALSE(light.mean_irradiance.empty());
  for (const double value : light.mean_irradiance) EXPECT_TRUE(std::isnan(value));
}

// However far away: products of such distances are beyond doubles.
TEST(PointLights2, AreTheSkysFarAway) {
  const Simulation2 simulation = apartment();
  for (const char* far : {"1e100", "1e200", "1e300", "1e308", "1e400"}) {
    const Rational x = *parse_rational(far);
    for (const Point2& eye : std::vector<Point2>{{x, 0}, {-x, x}, {1, -x}, {x, x / 3}}) {
      const PointLight2 light = light_at(simulation, eye);
      ASSERT_FALSE(light.mean_irradiance.empty());
      for (const double value : light.mean_irradiance)
        EXPECT_NEAR(value, to_double(simulation.scene().sky_emission.value[0]), 1e-12) << far;
    }
  }
}

}  // namespace
}  // namespace hottel::point_lights_test

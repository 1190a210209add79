// Light at many points from one solution.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "solver/plane/light/solved_light.h"

namespace hottel {
namespace {

TEST(PointLights2, SayOfEachPointWhatLightAtSays) {
  const PreparedScene2 prepared = prepare(read_scene_2(HOTTEL_SOURCE_DIR "/scenes/showcase/apartment.json"));
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const PointLights2 lights(prepared);
  for (const Point2& eye : std::vector<Point2>{{4, 3}, {3, 1}, prepared.scene.edges[5].from, {Rational(1, 3), 100}}) {
    const PointLight2 alone = light_at(prepared, visibility_polygon(arrangement, location, eye));
    EXPECT_EQ(lights.at(location, eye), alone.mean_irradiance);
    EXPECT_EQ(lights.channel_names(), alone.channel_names);
  }
}

TEST(PointLights2, AreNanInSolids) {
  const PreparedScene2 prepared = prepare(read_scene_2(HOTTEL_SOURCE_DIR "/scenes/showcase/apartment.json"));
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  for (const double value : PointLights2(prepared).at(location, {6, 3})) EXPECT_TRUE(std::isnan(value));  // wardrobe
}

}  // namespace
}  // namespace hottel

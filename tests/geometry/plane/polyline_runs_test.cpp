#include "geometry/plane/scene/polyline_runs.h"

#include <gtest/gtest.h>

#include <functional>

#include "geometry/plane/scene/scene_builder.h"
#include "kernel/support/failure.h"

namespace hottel::polyline_runs_test {
namespace {

// An edge (0), an open polyline of three pieces (1..3), a closed one (4..6).
Scene2 edge_and_polylines() {
  SceneBuilder2 builder;
  builder.add_material("white").add_material("black");
  builder.add_edge("edge", {0, 0}, {1, 0}, "white");
  builder.add_polyline("open", {{0, 1}, {1, 1}, {2, 1}, {3, 2}}, "white", {.back = "black"});
  builder.add_polyline("closed", {{0, 2}, {1, 2}, {1, 3}}, "white", {.closed = true});
  return builder.build();
}

TEST(PolylineRuns2, AreThePolylinesOfAFile) {
  const Scene2 scene = edge_and_polylines();
  EXPECT_EQ(end_of_polyline(scene, 0), 0u);
  EXPECT_EQ(end_of_polyline(scene, 1), 4u);
  EXPECT_EQ(end_of_polyline(scene, 2), 2u);  // it begins in the middle
  EXPECT_EQ(end_of_polyline(scene, 4), 7u);
  EXPECT_EQ(first_of_polylines(scene), 1u);
  EXPECT_EQ(first_of_polylines(Scene2{}), 0u);
  EXPECT_THROW(end_of_polyline(scene, 7), ContractViolation);
}

TEST(PolylineRuns2, EndWhereAnythingDiffers) {
  const std::vector<std::function<void(Scene2&)>> changes{
      [](Scene2& s) { s.surfaces[2].name = "open[7]"; },    [](Scene2& s) { s.groups[1].name = "other"; },
      [](Scene2& s) { s.edges[2].from = {1, 5}; },          [](Scene2& s) { s.surfaces[3].material = 1; },
      [](Scene2& s) { s.surfaces[3].back = std::nullopt; }, [](Scene2& s) { s.surfaces[3].elements = 2; }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Scene2 scene = edge_and_polylines();
    changes[k](scene);
    EXPECT_EQ(end_of_polyline(scene, 1), 1u) << k;
    EXPECT_EQ(first_of_polylines(scene), 4u) << k;
  }
}

TEST(PolylineRuns2, ARunThatWasInterruptedIsNoSecondPolyline) {
  Scene2 scene = edge_and_polylines();
  scene.keep({1, 4, 5, 6, 2, 3});
  EXPECT_EQ(end_of_polyline(scene, 0), 1u);
  EXPECT_EQ(first_of_polylines(scene), 6u);
}

}  // namespace
}  // namespace hottel::polyline_runs_test

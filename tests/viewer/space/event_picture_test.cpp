// The drawing of event surfaces: traces where the lines meet the face, in the colours of their kinds.
#include "viewer/picture/space/event_picture.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "viewer/picture/recording_canvas.h"

namespace hottel::event_picture_test {
namespace {

TEST(EventPainter3, DrawsTheTracesInThePolygonAndALegend) {
  Scene3 scene;
  scene.materials.push_back({.name = "m", .reflectivity = {}, .emission = {}});
  scene.groups.emplace_back("all");
  const std::vector<std::vector<Point3>> polygons{{{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}},
                                                  {{3, 1, 8}, {3, 3, 8}, {5, 3, 8}, {5, 1, 8}},
                                                  {{3, 1, 4}, {5, 1, 4}, {5, 3, 5}, {3, 3, 5}}};
  for (const auto& points : polygons) {
    Surface surface;
    surface.name = "p" + std::to_string(scene.surfaces.size());
    scene.add(surface, {points, {}});
  }
  const auto events = event_surfaces(prepare(scene), Face{1, false}, Face{0, false});
  ASSERT_FALSE(events.empty());
  const EventPainter3 painter(scene, Face{0, false}, events);
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  EXPECT_GT(canvas.count(Mark::kCurve), events.size());
  EXPECT_EQ(canvas.count(Mark::kEdge), 4u);
  EXPECT_TRUE(event_picture_3(scene, Face{0, false}, events, PictureFormat::kSvg).find("<svg") != std::string::npos);
}

}  // namespace
}  // namespace hottel::event_picture_test

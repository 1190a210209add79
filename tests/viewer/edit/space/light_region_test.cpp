// Where lights may be dragged in space.
#include "viewer/edit/space/light_region.h"

#include <gtest/gtest.h>

#include <string>

#include "io/scene/scene_json.h"

namespace hottel::light_region_test {
namespace {

// The faces of a box as one group, with their fronts outward, or inward.
std::string box(const std::string& name, int low, int high, bool is_room) {
  const auto corner = [&](int k) {
    const auto side = [&](int bit) { return std::to_string((k >> bit) & 1 ? high : low); };
    return "[" + side(0) + "," + side(1) + "," + side(2) + "]";
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string text;
  for (int f = 0; f < 6; ++f) {
    text += std::string(text.empty() ? "" : ",") + R"({"name": ")" + name + std::to_string(f) + R"(", "group": ")" +
            name + R"(", "material": "white", "points": [)";
    for (int k = 0; k < 4; ++k) text += std::string(k > 0 ? "," : "") + corner(faces[f][is_room ? 3 - k : k]);
    text += "]}";
  }
  return text;
}

// A room of 10 x 10 x 10 with a block in it and a room beside it, and a bulb in the first.
Scene3 rooms() {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"white": {"reflectivity": 0.5}}, "polygons": [)" +
                           box("hall", 0, 10, true) + "," + box("block", 4, 6, false) + "," +
                           box("cell", 20, 30, true) +
                           R"(], "lights": [{"type": "point", "name": "bulb", "position": [1, 1, 1], "power": 1}]})",
                       "rooms.json");
}

std::string refusal(const Point3& to, const std::optional<Point3>& before = Point3{1, 1, 1}) {
  Scene3 scene = rooms();
  scene.light_places[0].position = to;
  const Solids3 solids(scene);
  return light_refusal(scene, 0, solids, before ? &*before : nullptr);
}

TEST(LightRegion, IsBesideSurfacesAndOutOfSolids) {
  EXPECT_EQ(refusal({9, 9, 9}), "");
  EXPECT_EQ(refusal({3, 10, 3}), "bulb lies on the surface 'hall3'; a light has to be beside it");
  EXPECT_EQ(refusal({5, 5, 5}), "there is the solid 'block'");
}

TEST(LightRegion, DoesNotLeaveAllRooms) {
  EXPECT_EQ(refusal({11, 5, 5}), "that is outside of the room 'hall'");
  EXPECT_EQ(refusal({25, 25, 25}), "");
  EXPECT_EQ(refusal({11, 5, 5}, Point3{12, 5, 5}), "");
  EXPECT_EQ(refusal({11, 5, 5}, std::nullopt), "");
  EXPECT_EQ(refusal({Rational(1, 1000000), 5, 5}), "");
}

}  // namespace
}  // namespace hottel::light_region_test

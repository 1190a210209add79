// What is_convex_room and faces_nothing say of scenes, and that it is so.
#include "geometry/space/arrangement/nothing_between.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"

namespace hottel::nothing_between_test {
namespace {

constexpr const char* kFloor = R"({"points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"})";
constexpr const char* kFloorDown = R"({"points": [[0,0,0],[0,1,0],[1,1,0],[1,0,0]], "material": "m"})";
constexpr const char* kCeiling = R"({"points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "m"})";
constexpr const char* kFront = R"({"points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "m"})";
constexpr const char* kRear = R"({"points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "m"})";
constexpr const char* kLeft = R"({"points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "m"})";
constexpr const char* kRight = R"({"points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "m"})";
constexpr const char* kFive[] = {kCeiling, kFront, kRear, kLeft, kRight};

Scene3 scene_of(const std::string& polygons) {
  return parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [)" + polygons + "]}",
      "scene.json");
}
// A cube without a floor, and this instead.
Scene3 cube_on(const std::string& floor) {
  std::string polygons = floor;
  for (const char* wall : kFive) polygons += std::string(polygons.empty() ? "" : ", ") + wall;
  return scene_of(polygons);
}
bool is_room(const Scene3& scene) { return is_convex_room(scene, Occluders3(scene.polygons)); }
bool sees_nothing(const Scene3& scene) { return faces_nothing(scene, Occluders3(scene.polygons)); }

TEST(IsConvexRoom3, OfACubeWithFrontsInside) {
  EXPECT_TRUE(is_room(cube_on(kFloor)));
  EXPECT_TRUE(is_room(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json")));
  EXPECT_FALSE(is_room(cube_on("")));
  EXPECT_FALSE(is_room(cube_on(kFloorDown)));
  EXPECT_FALSE(is_room(scene_of("")));
  EXPECT_FALSE(is_room(scene_of(kFloor)));
  EXPECT_FALSE(is_room(scene_of(std::string(kFloor) + ", " + kCeiling)));
  EXPECT_FALSE(is_room(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json")));
}

// The long side of one strip is met in its middle by the short sides of two.
TEST(IsConvexRoom3, WallsMayBeDividedAnyhow) {
  const std::string strip = R"({"points": [[0,0,0],[1,0,0],[1,"1/3",0],[0,"1/3",0]], "material": "m"})";
  const std::string west = R"({"points": [[0,"1/3",0],["1/7","1/3",0],["1/7",1,0],[0,1,0]], "material": "m"})";
  const std::string east = R"({"points": [["1/7","1/3",0],[1,"1/3",0],[1,1,0],["1/7",1,0]], "material": "m"})";
  EXPECT_TRUE(is_room(cube_on(strip + ", " + west + ", " + east)));
  EXPECT_FALSE(is_room(cube_on(strip + ", " + west)));
  const std::string gap = R"({"points": [["1/7","1/3",0],[1,"1/3",0],[1,1,0],["1001/7000",1,0]], "material": "m"})";
  EXPECT_FALSE(is_room(cube_on(strip + ", " + west + ", " + gap)));
}

TEST(IsConvexRoom3, NotWithABackOrAPlateOutsideOrAWallThatJutsIn) {
  const std::string with_back = R"({"points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m", "back": "m"})";
  EXPECT_FALSE(is_room(cube_on(with_back)));
  const std::string plate = R"(, {"points": [[5,0,0],[6,0,0],[6,1,0]], "material": "m"})";
  EXPECT_FALSE(is_room(cube_on(kFloor + plate)));
  const std::string low = R"({"points": [[0,0,0],[1,0,0],[1,1,"1/1000"],[0,1,"1/1000"]], "material": "m"})";
  const std::string high = R"({"points": [[0,0,0],[1,0,0],[1,1,"-1/1000"],[0,1,"-1/1000"]], "material": "m"})";
  EXPECT_FALSE(is_room(cube_on(low)));   // the rear wall goes on below
  EXPECT_FALSE(is_room(cube_on(high)));  // a slit below the rear wall
}

TEST(IsConvexRoom3, NothingHidesAnythingThere) {
  for (const std::uint32_t elements : {1u, 3u}) {
    Scene3 scene = cube_on(kFloor);
    for (Surface& surface : scene.surfaces) surface.elements = elements;
    const ExchangeMatrix matrix =
        exact_exchange(prepare(std::move(scene)), {.granularity = Granularity::kElement, .wants_visibility = true});
    EXPECT_EQ(matrix.entry_count(), 30u * elements * elements * elements * elements);
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i)) {
        EXPECT_EQ(entry.visibility, 1);
        EXPECT_LT(entry.to, matrix.size());  // not the sky
      }
  }
}

TEST(FacesNothing3, OfABodyFromOutsideAndOfPlatesInOnePlane) {
  EXPECT_FALSE(sees_nothing(cube_on(kFloor)));
  EXPECT_TRUE(sees_nothing(scene_of("")));
  EXPECT_TRUE(sees_nothing(scene_of(kFloor)));
  EXPECT_TRUE(sees_nothing(
      scene_of(std::string(kFloor) + R"(, {"points": [[5,0,0],[6,0,0],[6,1,0]], "material": "m", "back": "m"})")));
  const std::string roof = R"({"points": [[0,0,0],[0,1,0],[-1,1,-1],[-1,0,-1]], "material": "m"}, )";
  EXPECT_TRUE(sees_nothing(scene_of(roof + kFloor)));  // a ridge
  EXPECT_FALSE(sees_nothing(scene_of(roof + kFloorDown)));
  EXPECT_FALSE(sees_nothing(scene_of(std::string(kFloor) + ", " + kLeft)));
}

TEST(FacesNothing3, TheSkyIsAllThatIsSeenThere) {
  const std::string roof = R"({"points": [[0,0,0],[0,1,0],[-1,1,-1],[-1,0,-1]], "material": "m"}, )";
  const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(roof + kFloor)));
  ASSERT_EQ(matrix.entry_count(), 2u);
  for (const std::uint32_t i : {0u, 2u}) {
    EXPECT_EQ(matrix.row(i).front().to, matrix.size());
    EXPECT_NEAR(matrix.row(i).front().factor.value, 1, 1e-12);
  }
}

}  // namespace
}  // namespace hottel::nothing_between_test

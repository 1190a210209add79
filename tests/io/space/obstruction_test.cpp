#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/space/scene/scene.h"
#include "io/scene/scene_json.h"
#include "tests/refusal.h"

namespace hottel::obstruction_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kHead = "{\"hottel\": 1, \"dimension\": 3, \"materials\": {\"m\": {}}, \"polygons\": [\n";
constexpr const char* kPlace = "{\"name\": \"lid\", \"points\": [[0,0,0],[1,0,0],[1,1,0]], ";

Scene3 read(const std::string& members) {
  return parse_scene_3(std::string(kHead) + kPlace + members + "}]}", "scene.json");
}

std::string refusal(const std::string& members) {
  return refusal_by([&] { read(members); });
}

TEST(Obstruction, IsAPolygonWithoutAnyMaterial) {
  const Scene3 scene = read("\"obstruction\": true");
  EXPECT_TRUE(scene.surfaces[0].is_obstruction);
  EXPECT_EQ(scene.surfaces[0].material_of(false), std::nullopt);
  EXPECT_EQ(scene.surfaces[0].material_of(true), std::nullopt);
  EXPECT_FALSE(read("\"obstruction\": false, \"material\": \"m\"").surfaces[0].is_obstruction);
}

TEST(Obstruction, IsWrittenAndReadBack) {
  const std::string text = write_scene_3(read("\"obstruction\": true"));
  EXPECT_THAT(text, HasSubstr("\"points\": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], \"obstruction\": true}"));
  EXPECT_EQ(write_scene_3(parse_scene_3(text, "again.json")), text);
}

TEST(Obstruction, IsRefusedWithAMaterial) {
  for (const char* members : {"\"obstruction\": true, \"material\": \"m\"", "\"obstruction\": true, \"back\": \"m\""})
    EXPECT_EQ(refusal(members), "scene.json:2: polygon 'lid' is an obstruction: it has no material, on either side");
  EXPECT_THAT(refusal("\"obstruction\": 1"), StartsWith("scene.json:2: polygon 'lid': obstruction"));
  EXPECT_THAT(refusal("\"obstruction\": false"), HasSubstr("material"));
  Scene3 scene = read("\"obstruction\": true");
  scene.surfaces[0].back = 0;
  EXPECT_THAT(refusal_by([&] { validate(scene); }), HasSubstr("surface 'lid' is an obstruction: its back has no"));
}

TEST(Obstruction, IsOfScenesInSpaceOnly) {
  EXPECT_THAT(refusal_by([] {
                parse_scene_2(
                    "{\"hottel\": 1, \"dimension\": 2, \"materials\": {\"m\": {}}, \"edges\": [\n"
                    "{\"name\": \"a\", \"points\": [[0,0],[1,0]], \"obstruction\": true}]}",
                    "scene.json");
              }),
              HasSubstr("obstruction"));
}

}  // namespace
}  // namespace hottel::obstruction_test

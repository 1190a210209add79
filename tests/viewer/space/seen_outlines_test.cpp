// Outlines of what a camera sees: which borders are lines, and that they are where surfaces meet in the picture.
#include "viewer/picture/space/seen_outlines.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "viewer/picture/space/camera_view.h"
#include "viewer/picture/space/seen_picture.h"

namespace hottel::seen_outlines_test {
namespace {

std::vector<OutlineStroke3> strokes_of(const std::string& polygons, const std::string& eye = "[3, -5, 4]") {
  const std::string text = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}, "n": {"reflectivity": 0.5}},
    "camera": {"eye": )" + eye +
                           R"(, "target": [0.5, 0.5, 0.5], "pixels": [400, 300]}, "polygons": [)" + polygons + "]}";
  const PreparedScene3 prepared = prepare(parse_scene_3(text, "lines.json"));
  return seen_outlines_3(prepared, *prepared.scene.camera);
}

std::string polygon(const std::string& points, const std::string& more = "") {
  return R"({"points": [)" + points + R"(], "material": "m")" + more + "}";
}

const std::string kCube =
    polygon("[0,0,0],[0,1,0],[1,1,0],[1,0,0]") + "," + polygon("[0,0,1],[1,0,1],[1,1,1],[0,1,1]") + "," +
    polygon("[0,0,0],[1,0,0],[1,0,1],[0,0,1]") + "," + polygon("[0,1,0],[0,1,1],[1,1,1],[1,1,0]") + "," +
    polygon("[0,0,0],[0,0,1],[0,1,1],[0,1,0]") + "," + polygon("[1,0,0],[1,1,0],[1,1,1],[1,0,1]");

TEST(SeenOutlines, OfACubeAreTheNineEdgesThatAreSeen) { EXPECT_EQ(strokes_of(kCube).size(), 9u); }

TEST(SeenOutlines, AreNotBetweenElements) {
  std::string divided = kCube;
  divided.replace(divided.find(R"("m"})"), 4, R"("m", "elements": 3})");
  EXPECT_EQ(strokes_of(divided).size(), 9u);
}

TEST(SeenOutlines, AreNotBetweenTrianglesOfOneGroup) {
  const std::string two = polygon("[0,0,0],[1,0,0],[1,1,0]", R"(, "group": "g")") + ",";
  EXPECT_EQ(strokes_of(two + polygon("[0,0,0],[1,1,0],[0,1,0]", R"(, "group": "g")")).size(), 4u);
  EXPECT_EQ(strokes_of(two + polygon("[0,0,0],[1,1,0],[0,1,0]")).size(), 5u) << "two surfaces";
  EXPECT_EQ(strokes_of(two + R"({"points": [[0,0,0],[1,1,0],[0,1,0]], "material": "n", "group": "g"})").size(), 5u)
      << "two materials";
  // Across a corner in the middle of a side.
  EXPECT_EQ(strokes_of(two + polygon("[0,0,0],[0.5,0.5,0],[0,1,0]", R"(, "group": "g")") + "," +
                       polygon("[0.5,0.5,0],[1,1,0],[0,1,0]", R"(, "group": "g")"))
                .size(),
            4u);
}

// The side of a prism of n sides, of one group.
std::string prism(int n) {
  std::string text;
  const auto corner = [&](int k, int z) {
    const double angle = 2 * std::numbers::pi * k / n;
    return fmt::format("[{:.6f},{:.6f},{}]", std::cos(angle), std::sin(angle), z);
  };
  for (int k = 0; k < n; ++k)
    text += (k > 0 ? "," : "") +
            polygon(corner(k, 0) + "," + corner(k + 1, 0) + "," + corner(k + 1, 1) + "," + corner(k, 1),
                    R"(, "group": "g")");
  return text;
}

TEST(SeenOutlines, ABendIsALineWhereItIsSharp) {
  const std::string level = "[3, -5, 0.5]";
  // Of the front the lower, the upper and the two silhouettes, and each edge between.
  EXPECT_EQ(strokes_of(prism(4), "[0.5, -5, 0.5]").size(), 2u * 2 + 3);
  const std::size_t round = strokes_of(prism(16), level).size(), sharp = strokes_of(prism(8), level).size();
  EXPECT_EQ(round % 2, 0u) << "the lower and the upper, as many";
  EXPECT_GT(sharp, 2u * 3 + 2);
  const std::vector<OutlineStroke3> lines = strokes_of(prism(16), level);
  EXPECT_EQ(std::ranges::count_if(lines,
                                  [](const OutlineStroke3& line) {
                                    return std::fabs(line.from.x - line.to.x) < 1 &&
                                           std::fabs(line.from.y - line.to.y) > 10;
                                  }),
            2)
      << "the silhouettes";
}

TEST(SeenOutlines, EndWhereTheyAreHidden) {
  const std::string behind = polygon("[0,1,0],[1,1,0],[1,1,1],[0,1,1]");
  const std::string before = polygon("[0.5,-1,-9],[9,-1,-9],[9,-1,9],[0.5,-1,9]");
  const std::vector<OutlineStroke3> lines = strokes_of(behind + "," + before, "[0.5, -5, 0.5]");
  ASSERT_EQ(lines.size(), 4u) << "three of the one behind, of which two are cut, and the side of the one before";
  for (const OutlineStroke3& line : lines) {
    EXPECT_LE(line.from.x, 200 + 1e-9);
    EXPECT_LE(line.to.x, 200 + 1e-9);
  }
}

// What is seen at places of a picture: the side of a surface, or the sky.
class SeenSides {
 public:
  explicit SeenSides(const PreparedScene3& prepared, const Camera3& camera)
      : table_(prepared.scene, prepared.arrangement(), prepared.occluders(), Granularity::kFace) {
    paint_.values.assign(table_.count(), 0);
    paint_.unknown = paint_.black = paint_.sky = {0};
    seen_.emplace(SeenScene3{prepared, table_, paint_}, camera);
  }
  int at(const Pixel& place) const {
    const SeenPicture3::Part* part = seen_->at(place);
    return part == nullptr ? -1 : part->element ? static_cast<int>(*part->element) : -2;
  }

 private:
  ElementTable3 table_;
  ElementPaint3 paint_;
  std::optional<SeenPicture3> seen_;
};

bool cross(const OutlineStroke3& a, const OutlineStroke3& b) {
  const auto side = [](const OutlineStroke3& line, const Pixel& p) {
    return (line.to.x - line.from.x) * (p.y - line.from.y) - (line.to.y - line.from.y) * (p.x - line.from.x);
  };
  return side(a, b.from) * side(a, b.to) <= 0 && side(b, a.from) * side(b, a.to) <= 0;
}

class SeenOutlinesOf : public testing::TestWithParam<const char*> {};

// A second way: what is seen at two places beside each other.
TEST_P(SeenOutlinesOf, AreWhereSidesMeetInThePicture) {
  const PreparedScene3 prepared = prepare(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + GetParam()));
  Camera3 camera = prepared.scene.camera ? *prepared.scene.camera : default_camera_3(prepared);
  camera.width = 80;
  camera.height = 60;
  const SeenSides sides(prepared, camera);
  const std::vector<OutlineStroke3> lines = seen_outlines_3(prepared, camera);
  ASSERT_FALSE(lines.empty());
  std::size_t borders = 0;
  for (std::uint32_t y = 0; y < camera.height; ++y)
    for (std::uint32_t x = 0; x + 1 < camera.width; ++x) {
      const Pixel here{x + 0.4987, y + 0.5013}, beside{x + 1.4987, y + 0.5013};
      if (sides.at(here) == sides.at(beside)) continue;
      ++borders;
      EXPECT_TRUE(std::ranges::any_of(lines,
                                      [&](const OutlineStroke3& line) {
                                        return cross(line, {here, beside});
                                      }))
          << x << ' ' << y;
    }
  EXPECT_GT(borders, 50u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SeenOutlinesOf,
                         testing::Values("two_boxes.json", "pierced_triangles.json", "attic.json", "city_block.json"));

TEST(SeenOutlines, OfAnEyeInASolidThereAreNone) {
  const std::string solid = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}},
    "camera": {"eye": [0.2, 0.1, 0.2], "target": [3, 0, 0]}, "polygons": [)" +
                            polygon("[0,0,0],[0,1,0],[1,0,0]", R"(, "group": "g")") + "," +
                            polygon("[0,0,0],[1,0,0],[0,0,1]", R"(, "group": "g")") + "," +
                            polygon("[0,0,0],[0,0,1],[0,1,0]", R"(, "group": "g")") + "," +
                            polygon("[1,0,0],[0,1,0],[0,0,1]", R"(, "group": "g")") + "]}";
  const PreparedScene3 prepared = prepare(parse_scene_3(solid, "solid.json"));
  if (prepared.arrangement().solids().around(prepared.scene.camera->eye)) {
    EXPECT_THROW(static_cast<void>(seen_outlines_3(prepared, *prepared.scene.camera)), RequestError);
  }
}

}  // namespace
}  // namespace hottel::seen_outlines_test

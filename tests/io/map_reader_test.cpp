// Maps as scenes: what read_map_2 promises (io/scene/plane/map_reader.h), by number.
#include "io/scene/plane/map_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/scene/scene_json.h"
#include "tests/refusal.h"

namespace hottel::map_reader_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene2 parse(const std::string& text, MapSide2 side = MapSide2::kInside) { return parse_map_2(text, "map", side); }
std::string refusal(const std::string& text) {
  return refusal_by([&] { parse(text); });
}

// Twice the area of a polyline that closes, positive counter-clockwise.
Rational doubled_area(const Scene2& scene, std::uint32_t group) {
  Rational sum = 0;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    if (scene.surfaces[s].group == group) {
      const Edge2& e = scene.edges[s];
      sum += e.from.x * e.to.y - e.to.x * e.from.y;
    }
  return sum;
}

std::vector<std::string> names_of(const Scene2& scene) {
  std::vector<std::string> names;
  for (const Group& group : scene.groups) names.push_back(group.name);
  return names;
}

constexpr const char* kHall = "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0),\n(1 1, 2 1, 2 2, 1 2, 1 1))";

TEST(MapReader, CoordinatesAreExactAndRingsArePolylinesInTheOrderOfTheFile_1) {
  const Scene2 scene = parse("POLYGON ((0.1 1/3, 4e0 0.1, 4 3, 0.1 1/3)) LINESTRING (0 0, 1 1, 2 0)");
  EXPECT_THAT(names_of(scene), ElementsAre("polyline[0]", "polyline[1]"));
  ASSERT_EQ(scene.surfaces.size(), 5u);
  EXPECT_EQ(scene.edges[0].from, (Point2{Rational(1, 10), Rational(1, 3)}));
  EXPECT_EQ(scene.edges[4].to, (Point2{2, 0}));
  EXPECT_EQ(scene.surfaces[3].name, "polyline[1][0]");
}

TEST(MapReader, OutlinesLookInwardAndHolesOutwardInWhateverSenseTheyAreListed_2) {
  for (const char* outline : {"(0 0, 4 0, 4 3, 0 3, 0 0)", "(0 0, 0 3, 4 3, 4 0, 0 0)"})
    for (const char* hole : {"(1 1, 2 1, 2 2, 1 2, 1 1)", "(1 1, 1 2, 2 2, 2 1, 1 1)"}) {
      const std::string text = std::string("POLYGON (") + outline + ", " + hole + ")";
      const Scene2 inside = parse(text), outside = parse(text, MapSide2::kOutside);
      EXPECT_EQ(doubled_area(inside, 0), -24);
      EXPECT_EQ(doubled_area(inside, 1), 2);
      EXPECT_EQ(doubled_area(outside, 0), 24);
      EXPECT_EQ(doubled_area(outside, 1), -2);
      EXPECT_EQ(inside.edges[0].from, (Point2{0, 0}));
    }
}

TEST(MapReader, FeaturesNameFrontsMaterialsAndElements_2_3_4_5) {
  const Scene2 scene = parse(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": "way/7", "properties": {"front": "outside", "material": "brick", "elements": 3, "height": 9},
     "geometry": {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,0]]]}},
    {"type": "Feature", "id": 12, "properties": {"name": "quay", "back": "stone"},
     "geometry": {"type": "MultiLineString", "coordinates": [[[5,5],[6,5]], [[6,6],["13/2",6]]]}},
    {"type": "Feature", "properties": null,
     "geometry": {"type": "GeometryCollection", "geometries": [
       {"type": "MultiPolygon", "coordinates": [[[[9,9],[9,8],[8,9],[9,9]]]]}]}}]})");
  EXPECT_THAT(names_of(scene), ElementsAre("way/7", "quay", "quay~2", "polyline[3]"));
  EXPECT_EQ(doubled_area(scene, 0), 1);
  EXPECT_EQ(scene.materials[scene.surfaces[0].material].name, "brick");
  EXPECT_EQ(scene.surfaces[0].elements, 3u);
  EXPECT_EQ(scene.surfaces[0].back, std::nullopt);
  EXPECT_EQ(scene.materials[*scene.surfaces[3].back].name, "stone");
  EXPECT_EQ(scene.materials[scene.surfaces[3].material].name, "white");
  EXPECT_EQ(scene.materials[0].reflectivity, Spectrum::scalar(Rational(1, 2)));
  EXPECT_EQ(scene.edges[4].to.x, Rational(13, 2));
  EXPECT_EQ(doubled_area(scene, 3), -1);
}

TEST(MapReader, SaysTheSameInBothFormats) {
  EXPECT_EQ(write_scene_2(parse(kHall)),
            write_scene_2(parse(R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,3],[0,0]],
                                    [[1,1],[2,1],[2,2],[1,2],[1,1]]]})")));
  EXPECT_EQ(write_scene_2(parse(kHall)), write_scene_2(parse_scene_2(write_scene_2(parse(kHall)), "map")));
}

TEST(MapReader, RefusesRingsThatCrossThemselvesSayingWhere_6) {
  EXPECT_EQ(refusal("\nPOLYGON ((0 0, 4 0, 0 3, 4 3, 0 0))"),
            "map:2: the ring 'polyline[0]' of a polygon crosses itself at (2, 1.5)");
  EXPECT_THAT(refusal("POLYGON ((0 0, 4 0,\n0 3, 6 3, 0 0))"),
              HasSubstr("map:1: the ring 'polyline[0]' of a polygon crosses itself at (2.4"));
  EXPECT_THAT(refusal("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0),\n(1 1, 5 1, 1 5, 7 5, 1 1))"),
              HasSubstr("map:2: the ring 'polyline[1]' of a polygon crosses itself at"));
  // Touching is no crossing, nor is a way there and back, and a line may cross itself.
  parse("POLYGON ((0 0, 4 0, 4 3, 2 0, 0 3, 0 0))");
  parse("POLYGON ((0 0, 2 1, 4 0, 4 3, 2 1, 0 3, 0 0))");
  parse("POLYGON ((0 0, 4 0, 4 3, 6 3, 4 3, 0 3, 0 0))");
  parse("LINESTRING (0 0, 4 0, 0 3, 4 3, 0 0)");
}

TEST(MapReader, PassesOverRepeatedPointsAndEmptyGeometriesAndCountsThem_7) {
  const std::string plain = write_scene_2(parse("POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0)) LINESTRING (5 5, 6 6)"));
  for (const auto& [text, note] : std::vector<std::pair<std::string, std::string>>{
           {"POLYGON ((0 0, 4 0, 4 0, 4 3, 0 3, 0 0)) LINESTRING (5 5, 6 6)", "1 repeated point passed over at map:1"},
           {"POLYGON ((0 0, 0 0, 4 0, 4 3, 0 3, 0 0, 0 0, 0 0), EMPTY) POLYGON EMPTY LINESTRING (5 5, 6 6, 12/2 6)",
            "4 repeated points passed over, the first at map:1\n2 empty geometries passed over, the first at map:1"},
           {"MULTIPOLYGON (EMPTY, ((0 0, 4 0, 4 3, 0 3, 0 0))) LINESTRING (5 5, 6 6)",
            "1 empty geometry passed over at map:1"},
           {R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null},
                {"type": "Feature", "geometry": {"type": "Polygon",
                 "coordinates": [[[0,0],[4,0],[4.0,0],[4,3],[0,3],[0,0]], []]}},
                {"type": "LineString", "coordinates": []}, {"type": "MultiPolygon", "coordinates": [[]]},
                {"type": "LineString", "coordinates": [[5,5],[5,5],[6,6]]}]})",
            "2 repeated points passed over, the first at map:3\n4 empty geometries passed over, the first at map:1"}}) {
    PassedOver passed_over;
    EXPECT_EQ(write_scene_2(parse_map_2(text, "map", MapSide2::kInside, &passed_over)), plain) << text;
    EXPECT_EQ(passed_over.note(), note) << text;
  }
}

TEST(MapReader, PassesOverHeightsPointsAndLinesWithoutLength_7) {
  const std::string plain = write_scene_2(parse("POLYGON ((0 0, 4 0, 4 3, 0 0))"));
  for (const auto& [text, note] : std::vector<std::pair<std::string, std::string>>{
           {"POLYGON Z ((0 0 7, 4 0 7, 4 3 7, 0 0 7))", "4 third coordinates passed over, the first at map:1"},
           {"POLYGONZM((0 0 7 1,4 0 7 1,4 3 7 1,0 0 7 1))", "4 third coordinates passed over, the first at map:1"},
           {"POLYGON ((0 0, 4 0 7, 4 3, 0 0))", "1 third coordinate passed over at map:1"},
           {"POLYGON ((0 0, 4 0, 4 3, 0 0))\nMULTIPOINT (1 1, (2 2)) POINT M (1 1 1)",
            "3 points passed over, the first at map:2\n1 third coordinate passed over at map:2"},
           {"LINESTRING (1 1, 1 1) POLYGON ((0 0, 4 0, 4 3, 0 0))", "1 line without length passed over at map:1"},
           {R"({"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2]},
                {"type": "Polygon", "coordinates": [[[0,0,1],[4,0,1],[4,3,1],[0,0,1]]]}]})",
            "1 point passed over at map:1\n4 third coordinates passed over, the first at map:2"}}) {
    PassedOver passed_over;
    EXPECT_EQ(write_scene_2(parse_map_2(text, "map", MapSide2::kInside, &passed_over)), plain) << text;
    EXPECT_EQ(passed_over.note(), note) << text;
  }
}

TEST(MapReader, ReadsWellKnownTextAsDatabasesWriteIt) {
  const std::string plain = write_scene_2(parse("POLYGON ((0 0, 4 0, 4 3, 0 0)) LINESTRING (0 0, 1 1, 1 0, 0 0)"));
  for (const char* text : {"SRID=4326;POLYGON((0 0,4 0,4 3,0 0));\nSRID=4326; LINESTRING(0 0,1 1,1 0,0 0);",
                           "srid = 0 ; TRIANGLE((0 0,4 0,4 3,0 0)) LINEARRING(0 0,1 1,1 0,0 0)",
                           "GEOMETRYCOLLECTION(TRIANGLE((0 0,4 0,4 3,0 0)), LINEARRING(0 0,1 1,1 0,0 0))"})
    EXPECT_EQ(write_scene_2(parse(text)), plain) << text;
}

TEST(MapReader, TakesANumberForAName_5) {
  const Scene2 scene = parse(R"({"type": "Feature", "id": "a", "properties": {"name": 5},
      "geometry": {"type": "LineString", "coordinates": [[0,0],[1,1]]}})");
  EXPECT_THAT(names_of(scene), ElementsAre("5"));
}

TEST(MapReader, RefusesWhatIsNoWallByItsLine_6) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"\nPOINT (1 2)", "map:2: 'POINT' has no walls"},
           {"POLYGON ((0 0, 4 0, 4 3))", "map:1: a ring of a polygon is not closed"},
           {"POLYGON ((0 0, 4 0,\n 0 0))", "map:1: a ring of a polygon has fewer than three corners"},
           {"POLYGON ((0 0, 1 1, 2 2, 0 0))", "map:1: a ring of a polygon has no area"},
           {"POLYGON Z ((0 0 0, 1 1 1, 2 2 2, 0 0 0))", "map:1: a ring of a polygon has no area"},
           {"LINESTRING (0 0 1 2 3, 1 1)", "map:1: a position has more than 4 coordinates"},
           {"LINESTRING (0 0)", "map:1: a line has fewer than two points"},
           {"LINESTRING (0 0,\n0 0, 0 0)", "map:1: a line has no length"},
           {"POLYGON ((1 1, 1 1,\n1 1))", "map:1: a ring of a polygon has fewer than three corners"},
           {"POLYGON ((0 0, 4 0, 4 0,\n0 0, 0 0))", "map:1: a ring of a polygon has fewer than three corners"},
           {"\nLINEARRING (0 0, 1 1, 2 0)", "map:2: a LINEARRING is not closed"},
           {"\nPOLYGONX ((0 0, 1 1, 2 0, 0 0))", "map:2: 'POLYGONX' is not understood"},
           {"SRID=x;POLYGON ((0 0, 1 1, 2 0, 0 0))", "map:1: a coordinate is not a number: 'x'"},
           {"SRID 4326;LINESTRING (0 0, 1 1)", "map:1: '=' is expected"},
           {"POLYGON (EMPTY,\n(0 0, 1 1, 2 0, 0 0))", "map:2: a polygon has a hole, and its outline is empty"},
           {R"({"type": "Polygon", "coordinates": [[], [[0,0],[1,0],[1,1],[0,0]]]})", "its outline is empty"},
           {"LINESTRING (0 0, x 1)", "map:1: a coordinate is not a number: 'x'"},
           {"CIRCULARSTRING (0 0, 1 1, 2 0)", "'CIRCULARSTRING' is not understood"},
           {"POLYGON EMPTY", "map: there is no line and no polygon in it"},
           {" ", "map: the file is empty"},
           {"{\"type\": \"Point\",\n \"coordinates\": [1, 2]}", "map:1: 'Point' has no walls"},
           {"{\"type\": \"LineString\",\n \"coordinates\": [[1, 2],\n[3]]}", "map:3: a position in the plane has two"},
           {"{\"type\": \"LineString\",\n \"coordinates\": [[1, 2],\n[3, 4, null]]}", "map:3: a coordinate must be"},
           {R"({"type": "Feature", "geometry": null})", "map: there is no line and no polygon in it"},
           {R"({"type": "Feature", "properties": {"front": "left"}, "geometry": {"type": "LineString"}})",
            "front is 'left'"},
           {R"({"type": "Feature", "id": "a#b", "geometry": {"type": "LineString", "coordinates": [[0,0],[1,1]]}})",
            "map:1: the name 'a#b' must not contain '#'"},
           {R"({"coordinates": []})", "has no \"type\""}})
    EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

}  // namespace
}  // namespace hottel::map_reader_test

// Polygons of many points as files.
#include "io/results/plane/polygon_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/results/plane/drawn_polygon.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::polygon_files_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A box on a plane that sees the sky, and a face with a comma and letters beyond ASCII.
PreparedScene2 scene() {
  return prepare(parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [{"name": "wall, \u00e4\ud83d\ude00", "points": [[-3, 1], [3, 1]], "material": "m"}],
    "polylines": [{"name": "box", "points": [[-1,-3],[1,-3],[1,-1],[-1,-1]], "closed": true, "material": "m"}]})",
                               "test.json"));
}

std::string written(PolygonFormat2 format, const std::vector<Point2>& eyes, const PolygonFileOptions2& options = {},
                    const std::vector<std::vector<double>>& irradiance = {}) {
  const PreparedScene2 prepared = scene();
  const auto polygons = visibility_polygons(prepared, eyes, {.wants_exact = options.is_exact, .range = options.range});
  std::string text;
  const auto writer = polygon_writer_2(format, prepared, options, [&](std::string_view part) { text += part; });
  for (std::size_t k = 0; k < eyes.size(); ++k)  // in batches of one
    writer->add({std::span(eyes).subspan(k, 1), std::span(polygons).subspan(k, 1),
                 irradiance.empty() ? std::span(irradiance) : std::span(irradiance).subspan(k, 1)});
  writer->finish();
  return text;
}

const Point2 kUnder{0, 0}, kInBox{0, -2};

TEST(PolygonFiles, ACsvHasALineForEachCornerAndTheSideAfterIt) {
  EXPECT_EQ(written(PolygonFormat2::kCsv, {kInBox, kUnder}, {.channel_names = {"all"}}, {{NAN}, {0.25}}),
            "point,corner,x,y,face,irradiance,area,perimeter\n"
            "0,,,,#in box,NaN,,\n"
            "1,0,-3,1,sky,0.25,,\n"
            "1,1,-1,-1,box[2],0.25,,\n"
            "1,2,1,-1,sky,0.25,,\n"
            "1,3,3,1,\"wall, ä😀\",0.25,,\n");
}

TEST(PolygonFiles, ExactCornersAreFractions) {
  const std::string csv = written(PolygonFormat2::kCsv, {{Rational(1, 3), -5}}, {.is_exact = true});
  EXPECT_THAT(csv, HasSubstr("0,0,"));
  const auto json =
      nlohmann::json::parse(written(PolygonFormat2::kGeoJson, {{Rational(1, 3), -5}}, {.is_exact = true}));
  const auto& properties = json["features"][0]["properties"];
  EXPECT_EQ(properties["exact"].size(), properties["faces"].size());
}

TEST(PolygonFiles, GeoJsonClosesNoUnboundedRegion) {
  const auto json = nlohmann::json::parse(written(PolygonFormat2::kGeoJson, {kUnder, kInBox}));
  const auto& open = json["features"][0];
  EXPECT_EQ(open["geometry"]["type"], "MultiLineString");
  EXPECT_EQ(open["properties"]["bounded"], false);
  EXPECT_EQ(open["geometry"]["coordinates"],
            nlohmann::json::parse("[[[-1.0, -1.0], [1.0, -1.0]], [[3.0, 1.0], [-3.0, 1.0]]]"));
  EXPECT_EQ(open["properties"]["faces"], nlohmann::json::parse(R"(["box[2]", "sky", "wall, ä😀", "sky"])"));
  EXPECT_EQ(open["properties"]["sky"], nlohmann::json::parse("[1, 3]"));
  const auto& solid = json["features"][1];
  EXPECT_TRUE(solid["geometry"].is_null());
  EXPECT_EQ(solid["properties"]["solid"], "box");
}

TEST(PolygonFiles, ARangeGivesRingsWhoseArcsHaveChordsNearTheCircle) {
  const auto json = nlohmann::json::parse(written(PolygonFormat2::kGeoJson, {kUnder}, {.range = Rational(5)}));
  const auto& feature = json["features"][0];
  EXPECT_EQ(feature["geometry"]["type"], "Polygon");
  const auto& ring = feature["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_EQ(ring.size(), feature["properties"]["faces"].size() + 1);
  EXPECT_EQ(feature["properties"]["sky"].size(), 0u);
  std::size_t arcs = 0;
  for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
    if (feature["properties"]["faces"][k] != "#range") continue;
    ++arcs;
    const double x = (ring[k][0].get<double>() + ring[k + 1][0].get<double>()) / 2,
                 y = (ring[k][1].get<double>() + ring[k + 1][1].get<double>()) / 2;
    EXPECT_LT(5 - std::hypot(x, y), 5e-3);
    EXPECT_NEAR(std::hypot(ring[k][0].get<double>(), ring[k][1].get<double>()), 5, 1e-14);
  }
  EXPECT_GT(arcs, 20u);
}

TEST(PolygonFiles, WellKnownTextHasOneLineAPoint) {
  EXPECT_EQ(written(PolygonFormat2::kWkt, {kUnder, kInBox}),
            "MULTILINESTRING ((-1 -1, 1 -1), (3 1, -3 1))\nPOLYGON EMPTY\n");
  const std::string ranged = written(PolygonFormat2::kWkt, {kUnder}, {.range = Rational(1, 2)});
  EXPECT_THAT(ranged, testing::StartsWith("POLYGON ((0.5 0, "));
  EXPECT_THAT(ranged, testing::EndsWith(", 0.5 0))\n"));
}

// The bytes of an array in an archive, after its header, which must hold `shape`.
std::string array(const std::string& archive, const std::string& name, const std::string& head) {
  const std::size_t entry = archive.find(name + ".npy");
  EXPECT_NE(entry, std::string::npos) << name;
  const std::size_t start = entry + name.size() + 4, end = archive.find('\n', start);
  EXPECT_THAT(archive.substr(start, end - start), HasSubstr(head)) << name;
  std::uint32_t size;
  std::memcpy(&size, archive.data() + entry - 30 + 22, sizeof size);
  return archive.substr(end + 1, start + size - end - 1);
}
template <class Number>
std::vector<Number> numbers(const std::string& bytes) {
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

TEST(PolygonFiles, AnNpzHoldsCornersBeginsFacesAndNames) {
  const std::string zip =
      written(PolygonFormat2::kNpz, {kUnder, kInBox}, {.channel_names = {"r", "g"}}, {{1, 2}, {NAN, NAN}});
  EXPECT_THAT(numbers<double>(array(zip, "xy", "'<f8', 'fortran_order': False, 'shape': (4, 2)")),
              ElementsAre(-3, 1, -1, -1, 1, -1, 3, 1));
  EXPECT_THAT(numbers<std::int64_t>(array(zip, "begin", "'<i8', 'fortran_order': False, 'shape': (3,)")),
              ElementsAre(0, 4, 4));
  EXPECT_THAT(numbers<std::int32_t>(array(zip, "face", "'<i4', 'fortran_order': False, 'shape': (4,)")),
              ElementsAre(1, 4, 1, 3));
  EXPECT_THAT(numbers<std::int32_t>(array(zip, "solid", "(2,)")), ElementsAre(-1, 5));
  EXPECT_EQ(numbers<double>(array(zip, "irradiance", "(2, 2)")).size(), 4u);
  for (const char* unbounded : {"area", "perimeter"})
    for (const double value : numbers<double>(array(zip, unbounded, "(2,)"))) EXPECT_TRUE(std::isnan(value));
  const std::string names = array(zip, "names", "'<U8', 'fortran_order': False, 'shape': (6,)");
  ASSERT_EQ(names.size(), 6u * 8 * 4);
  const auto codes = numbers<char32_t>(names);
  EXPECT_EQ(std::u32string(codes.data() + 3 * 8, 8), U"wall, ä😀");
  EXPECT_EQ(std::u32string(codes.data() + 1 * 8, 4), std::u32string(U"sky\0", 4));
}

TEST(PolygonFiles, EndingsAreThoseOfTheFormats) {
  EXPECT_EQ(polygon_format_2("a/b.csv"), PolygonFormat2::kCsv);
  EXPECT_EQ(polygon_format_2("b.geojson"), PolygonFormat2::kGeoJson);
  EXPECT_EQ(polygon_format_2("b.json"), PolygonFormat2::kGeoJson);
  EXPECT_EQ(polygon_format_2("b.wkt"), PolygonFormat2::kWkt);
  EXPECT_EQ(polygon_format_2("b.npz"), PolygonFormat2::kNpz);
  EXPECT_EQ(polygon_format_2("b.svg"), std::nullopt);
}

TEST(PolygonFiles, CornersBeyondDoublesAreRefusedUnlessExact) {
  const PreparedScene2 far = prepare(parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [{"name": "wall", "points": [["1e400", 0], [0, 0]], "material": "m"}]})",
                                                   "far.json"));
  const std::vector<Point2> eyes{{0, 1}};
  const auto polygons = visibility_polygons(far, eyes, {.wants_exact = true});
  for (const PolygonFormat2 format :
       {PolygonFormat2::kCsv, PolygonFormat2::kGeoJson, PolygonFormat2::kWkt, PolygonFormat2::kNpz}) {
    const auto writer = polygon_writer_2(format, far, {}, [](std::string_view) {});
    EXPECT_THROW(writer->add({eyes, polygons, {}}), RequestError);
  }
  std::string text;
  const auto exact =
      polygon_writer_2(PolygonFormat2::kCsv, far, {.is_exact = true}, [&](std::string_view part) { text += part; });
  exact->add({eyes, polygons, {}});
  EXPECT_THAT(text, HasSubstr("1" + std::string(400, '0') + ",0,"));
}

}  // namespace
}  // namespace hottel::polygon_files_test

// Lists of points in csv, GeoJSON and well-known text: exact as typed, or refused with the line.
#include "io/external/plane/point_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel::point_list_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<Point2> read(const std::string& text) { return read_points_2(text, "points"); }

Point2 at(const std::string& x, const std::string& y) { return {*parse_rational(x), *parse_rational(y)}; }

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PointList, NumbersOfACsvAreExactAsTyped) {
  EXPECT_THAT(read("x,y\n0.1,1/3\n -2.5e-3 ,\t12 \r\n\n1e400,0\n"),
              ElementsAre(at("1/10", "1/3"), at("-1/400", "12"), at("1e400", "0")));
  EXPECT_THAT(read("\xEF\xBB\xBF X , Y\n1,2"), ElementsAre(at("1", "2")));
  EXPECT_THAT(read("\"1\",\"2\"\n.5,-.5"), ElementsAre(at("1", "2"), at("1/2", "-1/2")));
}

TEST(PointList, GeoJsonIsReadByTheTextOfItsNumbers) {
  EXPECT_THAT(read(R"({"type": "Point", "coordinates": [0.1, 1e400]})"), ElementsAre(at("1/10", "1e400")));
  EXPECT_THAT(read(R"( {"type": "MultiPoint", "bbox": [0, 0, 1, 1], "coordinates": [[1, 2], [3, "4/3"]]})"),
              ElementsAre(at("1", "2"), at("3", "4/3")));
  EXPECT_THAT(read(R"({"type": "FeatureCollection", "name": "here", "features": [
      {"type": "Feature", "id": 7, "properties": null, "geometry": {"type": "Point", "coordinates": [1, 2]}},
      {"type": "Feature", "properties": {"a": [1]}, "geometry": {"type": "GeometryCollection", "geometries": [
          {"type": "Point", "coordinates": [3, 4]}, {"type": "MultiPoint", "coordinates": [[5, 6]]}]}}]})"),
              ElementsAre(at("1", "2"), at("3", "4"), at("5", "6")));
}

TEST(PointList, WellKnownTextMayGoOnForManyLines) {
  EXPECT_THAT(read("POINT (0.1 1/3)"), ElementsAre(at("1/10", "1/3")));
  EXPECT_THAT(read("point(1 2)\nMultiPoint ((3 4), (5 6))\nMULTIPOINT(7 8,9 10)\nPOINT EMPTY\n"),
              ElementsAre(at("1", "2"), at("3", "4"), at("5", "6"), at("7", "8"), at("9", "10")));
  EXPECT_THAT(read("GEOMETRYCOLLECTION (POINT (1 2), GEOMETRYCOLLECTION (MULTIPOINT (3 4)), POINT EMPTY)"),
              ElementsAre(at("1", "2"), at("3", "4")));
}

TEST(PointList, WhatIsNoPointIsRefusedWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "points: there is no point in it"},
      {"x,y\n", "points: there is no point in it"},
      {"POINT EMPTY", "points: there is no point in it"},
      {"1,2\n3\n", "points:2: a point has two coordinates"},
      {"1,2,3\n", "points:1: a point has two coordinates"},
      {"1,2\n\n3,north\n", "points:3: a coordinate is not a number: 'north'"},
      {"1,nan", "points:1: a coordinate is not a number"},
      {"1,1/0", "points:1: a coordinate is not a number"},
      {"1,1e5000", "points:1: a coordinate is not a number"},
      {"lon,lat\n1,2", "points:1: 'lon,lat' is no first line that is known"},
      {"point,corner,x,y,face\n", "points:1: 'point,corner,x,y,face' is no first line that is known"},
      {"x,y,id\n1,2,3", "points:1: 'x,y,id' is no first line that is known"},
      {"1,1,1,0,0,0", "points:1: a point has two coordinates x,y, in space three x,y,z, not 6"},
      {"1 2", "points:1: '1 2' is no point: commas stand between its numbers"},
      {"1,2\n1;2", "points:2: '1;2' is no point: commas stand between its numbers"},
      {"POINT (1 2)\nLINESTRING (1 2, 3 4)", "points:2: 'LINESTRING' is no list of points"},
      {"POINT ZM (1 2 3 4 5)", "points:1: a position has more than 4 coordinates"},
      {"POINT (1\n2", "points:2: ')' is expected, not the end"},
      {"POINT (1)", "points:1: a coordinate is expected, not ')'"},
      {"POINT\n(1 x)", "points:2: a coordinate is not a number: 'x'"},
      {"SRID=4326;POINT(1 2)", "points:1: 'SRID' is no list of points"},
      {"{\"type\": \"Point\",\n\"coordinates\": [1]}", "points:2: a position in the plane has two coordinates, not 1"},
      {"{\"type\": \"Point\", \"coordinates\": [1, 2, 3, 4, 5]}", "points:1: a position in the plane has two"},
      {"{\"type\": \"Point\", \"coordinates\": [1, null]}", "points:1: a coordinate must be"},
      {"{\"type\": \"Polygon\", \"coordinates\": []}", "points:1: 'Polygon' is no list of points"},
      {"{\"type\": \"Feature\", \"geometry\": null}", "points:1: a feature has no place"},
      {"{\"type\": \"Feature\"}", "points:1: a GeoJSON object has no \"geometry\""},
      {"{\"coordinates\": [1, 2]}", "points:1: a GeoJSON object has no \"type\""},
      {"{\"type\": \"MultiPoint\", \"coordinates\": 3}", "points:1: \"coordinates\" must be a list"},
      {"{\"type\": \"Point\", \"coordinates\": [1, 2]", "points:1: "},
  };
  for (const auto& [text, message] : cases) EXPECT_THAT(refusal(text), StartsWith(message)) << text;
  std::string nested;
  for (int k = 0; k < 100000; ++k) nested += "GEOMETRYCOLLECTION (";
  EXPECT_THAT(refusal(nested), HasSubstr("nested too deep"));
}

TEST(PointList, ThirdCoordinatesArePassedOver) {
  for (const char* text : {"POINT Z (1 2 3)", "POINT (1 2 3)", "POINTZ(1 2 3)", "MULTIPOINT M ((1 2 3))",
                           "{\"type\": \"Point\", \"coordinates\": [1, 2, 3]}"}) {
    PassedOver passed_over;
    EXPECT_EQ(read_points_2(text, "points", &passed_over), (std::vector<Point2>{{1, 2}})) << text;
    EXPECT_EQ(passed_over.note(), "1 third coordinate passed over at points:1") << text;
  }
}

}  // namespace
}  // namespace hottel::point_list_test

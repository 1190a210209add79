// hottel visibility --points, --edge, --events and --graph, as a stranger runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::visibility_points_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

constexpr const char* kRoom = R"({"hottel": 1, "dimension": 2,
  "materials": {"m": {"reflectivity": 0.5}, "lamp": {"emission": 1}},
  "polylines": [{"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "m"},
                {"name": "box", "points": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true, "material": "m"}],
  "edges": [{"name": "lamp", "points": [[3, "5/2"], ["7/2", "5/2"]], "material": "lamp"}]})";

class Room : public Workplace {
 public:
  Room() { write("room.json", kRoom); }
};

TEST(VisibilityPoints, OfEveryFormatInAreTheSame) {
  const Room room;
  room.write("p.csv", "x,y\n0.1,1/3\n3,1\n");
  room.write("p.json", R"({"type": "MultiPoint", "coordinates": [[0.1, "1/3"], [3, 1]]})");
  room.write("p.wkt", "POINT (0.1 1/3)\nPOINT (3 1)\n");
  const Outcome csv = room.run("hottel visibility room.json --points p.csv");
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_THAT(csv.err, IsEmpty());
  EXPECT_EQ(room.run("hottel visibility room.json --points p.json").out, csv.out);
  EXPECT_EQ(room.run("hottel visibility room.json --points - < p.wkt").out, csv.out);
  EXPECT_EQ(room.run("hottel visibility room.json --points - -o - < p.csv").out, csv.out);
  EXPECT_EQ(room.run("hottel visibility room.json --points p.csv -o out.csv; cat out.csv").out, csv.out);
}

TEST(VisibilityPoints, CornersAreThoseOfOnePointAlone) {
  const Room room;
  const auto alone = nlohmann::json::parse(room.run("hottel visibility room.json --at 1/3,1/7 --json").out);
  const auto rows = lines_of(room.run("echo 1/3,1/7 | hottel visibility room.json --points - --exact").out);
  ASSERT_EQ(rows.size(), alone["polygon"].size() + 1);
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const auto& exact = alone["polygon"][k]["exact"];
    EXPECT_THAT(rows[k + 1], StartsWith("0," + std::to_string(k) + "," + exact[0].get<std::string>() + "," +
                                        exact[1].get<std::string>() + ","));
  }
}

TEST(VisibilityPoints, SaysInWhichSolidAPointIsAndGoesOn) {
  const Room room;
  const Outcome outcome = room.run("printf '3/2,3/2\\n3,1\\n' | hottel visibility room.json --points -");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(lines_of(outcome.out).at(1), "0,,,,#in box,,");
  EXPECT_THAT(lines_of(outcome.out).at(2), StartsWith("1,0,"));
  EXPECT_THAT(outcome.err,
              HasSubstr("points in solids, which see nothing: 1, the first is point 0, in the solid 'box'"));
}

TEST(VisibilityPoints, IrradianceIsThatOfOnePointAlone) {
  const Room room;
  const auto alone = nlohmann::json::parse(room.run("hottel visibility room.json --at 3,1 --json").out);
  room.write("p.csv", "3,1\n3/2,3/2\n");
  const Outcome outcome =
      room.run("hottel visibility room.json --points p.csv --irradiance -o p.geojson; cat p.geojson");
  const auto features = nlohmann::json::parse(outcome.out)["features"];
  EXPECT_EQ(features[0]["properties"]["irradiance"], alone["mean_irradiance"]["all"]);
  EXPECT_TRUE(features[1]["properties"]["irradiance"].is_null());
}

TEST(VisibilityPoints, BadPointsAreRefusedWithTheirLineAndNothingIsWritten) {
  const Room room;
  room.write("p.csv", "1,2\n\n3,north\n");
  const Outcome file = room.run("hottel visibility room.json --points p.csv -o out.csv");
  EXPECT_EQ(file.code, 3);
  EXPECT_THAT(file.err, HasSubstr("p.csv:3: a coordinate is not a number: 'north'"));
  EXPECT_THAT(room.files(), ElementsAre("p.csv", "room.json"));
  const Outcome stream = room.run("echo POINT Z | hottel visibility room.json --points -");
  EXPECT_EQ(stream.code, 3);
  EXPECT_EQ(stream.out, "");
  EXPECT_THAT(stream.err, HasSubstr("standard input:1: "));
  EXPECT_EQ(room.run("hottel visibility room.json --points none.csv").code, 3);
}

TEST(VisibilityPoints, OfASceneWithoutASolutionNeedNone) {
  const Room room;
  room.write("mirrors.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 1, "emission": 1}},
    "polylines": [{"name": "r", "points": [[0,0],[0,1],[1,1],[1,0]], "closed": true, "material": "m"}]})");
  EXPECT_EQ(room.run("echo 1/2,1/2 | hottel visibility mirrors.json --points -").code, 0);
  const Outcome light = room.run("echo 1/2,1/2 | hottel visibility mirrors.json --points - --irradiance -o out.csv");
  EXPECT_EQ(light.code, 1);
  EXPECT_THAT(light.err, HasSubstr("mirrors.json"));
  EXPECT_THAT(room.files(), ElementsAre("mirrors.json", "room.json"));
}

TEST(VisibilityPoint, IsToldToLieOutsideAndToHaveNoLight) {
  const Room room;
  std::string closed = kRoom;
  closed.insert(closed.find("\"materials\""), "\"closed\": true, ");
  room.write("closed.json", closed);
  const std::string outside = room.run("hottel visibility closed.json --at 9,9").out;
  EXPECT_THAT(outside, StartsWith("from (9, 9), outside the convex hull of the scene\n"));
  EXPECT_THAT(outside,
              HasSubstr("\nno mean irradiance: the scene is promised to be closed, and no face with a material "
                        "is seen\n"));
  EXPECT_THAT(room.run("hottel visibility closed.json --at 3,1").out, HasSubstr("\nmean irradiance\n  all "));
  room.write("line.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [{"points": [[0, 0], [1, 0]], "material": "m"}, {"points": [[2, 0], [3, 0]], "material": "m"}]})");
  for (const char* point : {"1/2,1", "1/2,0"})
    EXPECT_THAT(room.run(std::string("hottel visibility line.json --at ") + point).out,
                HasSubstr(", on or beside the line that holds the whole scene\n"));
}

TEST(VisibilityEdge, SaysWhichPartsOfWhichFacesAreSeen) {
  const Room room;
  const Outcome text = room.run("hottel visibility room.json --edge 'room[3]'");  // the floor
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("what some point of 'room[3]' sees\n"));
  const auto json = nlohmann::json::parse(room.run("hottel visibility room.json --edge 'room[3]' --json").out);
  EXPECT_EQ(json["sees_sky"], false);
  std::vector<std::string> faces;
  for (const auto& face : json["faces"]) faces.push_back(face["face"]);
  EXPECT_THAT(faces, ElementsAre("lamp", "room[0]", "room[1]", "room[2]", "box[0]", "box[1]", "box[3]"));
  EXPECT_EQ(json["faces"][4]["share"]["exact"], "1");
  EXPECT_EQ(room.run("hottel visibility room.json --edge door").code, 2);
}

TEST(VisibilityEvents, ListsLinesAsCsvAndAsJson) {
  const Room room;
  const Outcome csv = room.run("hottel visibility room.json --events");
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_EQ(lines_of(csv.out).at(0),
            "x0,y0,x1,y1,along,behind_x,behind_y,behind_left,behind_right,ahead_x,ahead_y,ahead_left,ahead_right,"
            "from_behind_left,from_behind_right,from_ahead_left,from_ahead_right");
  const auto json = nlohmann::json::parse(room.run("hottel visibility room.json --events --json").out);
  EXPECT_EQ(json["lines"].size() + 1, lines_of(csv.out).size());
  EXPECT_EQ(room.run("hottel visibility room.json --events -o e.csv; cat e.csv").out, csv.out);
  EXPECT_NE(room.run("hottel visibility room.json --events --exact").out, csv.out);
}

TEST(VisibilityGraph, ListsPairsAsCsvAndAsJson) {
  const Room room;
  const Outcome csv = room.run("hottel visibility room.json --graph");
  EXPECT_EQ(csv.code, 0) << csv.err;
  const auto lines = lines_of(csv.out);
  EXPECT_EQ(lines.at(0), "vertex0,vertex1,x0,y0,x1,y1,length,along,surface0,surface1");
  EXPECT_EQ(lines.at(1), "0,1,3,2.5,3.5,2.5,0.5,lamp,lamp,lamp");
  EXPECT_THAT(csv.err, HasSubstr("10 vertices; " + std::to_string(lines.size() - 1) +
                                 " pairs that see each other, 9 of them along edges\n"));
  const auto json = nlohmann::json::parse(room.run("hottel visibility room.json --graph --json").out);
  ASSERT_EQ(json["pairs"].size() + 1, lines.size());
  EXPECT_EQ(json["vertices"].size(), 10u);
  EXPECT_EQ(json["vertices"][1]["exact"], (nlohmann::json{"7/2", "5/2"}));
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const auto& pair = json["pairs"][k]["vertices"];
    EXPECT_THAT(lines[k + 1], StartsWith(pair[0].dump() + "," + pair[1].dump() + ","));
  }
  EXPECT_EQ(room.run("hottel visibility room.json --graph -o g.csv; cat g.csv").out, csv.out);
  EXPECT_THAT(room.run("hottel visibility room.json --graph --exact").out, HasSubstr("\n0,1,3,5/2,7/2,5/2,0.5,lamp,"));
  EXPECT_EQ(room.run("hottel visibility room.json --graph --quiet | head -1").code, 0);
}

TEST(VisibilityGraph, SaysWhichVerticesAreCrossings) {
  const Workplace place;
  place.write("cross.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
    {"name": "a", "points": [[0, 0], [1, 1]], "material": "m"}, {"name": "b", "points": [[0, 1], [1, 0]], "material": "m"}]})");
  const Outcome csv = place.run("hottel visibility cross.json --graph");
  EXPECT_THAT(csv.err,
              HasSubstr("5 vertices (1 crossing from number 4); 8 pairs that see each other, 4 of them along"));
  EXPECT_THAT(csv.out, HasSubstr("\n0,4,0,0,0.5,0.5,0.7071067811865476,a,a,a\n"));
}

TEST(VisibilityGraph, OfASceneBeyondDoublesIsWrittenExactly) {
  const Workplace place;
  place.write("far.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
    {"name": "a", "points": [["1e400", 0], ["1e400", 1]], "material": "m"}]})");
  const Outcome refused = place.run("hottel visibility far.json --graph");
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("beyond the range of doubles; --exact writes"));
  EXPECT_THAT(place.run("hottel visibility far.json --graph --exact").out, HasSubstr(",1,1,a,a,a\n"));
}

}  // namespace
}  // namespace hottel::visibility_points_test

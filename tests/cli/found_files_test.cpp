// Files as people have them: what exporters write, and what is told of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "tests/cli/program.h"

namespace hottel::found_files_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::json;

// The factor between two names in a list of factors; -1 where there is none.
double factor(const std::string& csv, const std::string& from, const std::string& to) {
  for (const std::string& line : lines_of(csv))
    if (line.starts_with(from + "," + to + ","))
      return std::strtod(line.c_str() + from.size() + to.size() + 2, nullptr);
  return -1;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c + "\nendloop\nendfacet\n";
}

// A cube of side 1 from (x, 0, 0) with its fronts outward or inward, as triangles of STL.
std::string cube(int x, bool is_inward) {
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const auto corner = [x](int k) {
    return std::to_string(x + (k & 1)) + " " + std::to_string(k >> 1 & 1) + " " + std::to_string(k >> 2 & 1);
  };
  std::string text;
  for (const auto& q : quads)
    for (const auto& [b, c] : {std::pair(1, 2), {2, 3}})
      text += facet(corner(q[0]), corner(q[is_inward ? c : b]), corner(q[is_inward ? b : c]));
  return text;
}

// Exit code 2, and the file is as it was.
TEST(FoundFiles, AnOutputDoesNotTakeThePlaceOfWhatIsRead) {
  const Workplace place;
  const std::string room = std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json";
  place.write("p.csv", "1,1\n");
  ASSERT_EQ(place.run("hottel factors " + room + " --quiet -o f.csv").code, 0);
  place.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  place.write("s.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {}},
    "mesh": {"file": "box.obj", "material": "m"}})");
  const auto expect_refused = [&](const std::string& line, const std::string& file, const std::string& told) {
    const std::string before = place.read(file);
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_THAT(outcome.err, HasSubstr(told + ": give the output another name"));
    EXPECT_EQ(place.read(file), before);
  };
  expect_refused("hottel visibility " + room + " --points p.csv -o p.csv", "p.csv",
                 "-o p.csv is a file that --points reads");
  expect_refused("hottel factors " + room + " --method file:f.csv -o ./f.csv", "f.csv",
                 "-o ./f.csv is a file that --method reads");
  expect_refused("hottel convert s.json box.obj", "box.obj", "OUT box.obj is a file that s.json reads");
  EXPECT_EQ(place.run("hottel convert s.json s.json").code, 0);  // a scene may be rewritten in its place
}

// Wall of 4 x 4 less a hole of 2 x 2 in its middle, which a lid 2 above looks at. The factor to all of the wall less
// that to the hole, each by the closed form of View3D's handbook for parallel rectangles.
constexpr double kLidToWall = 0.31782818381715;
const std::string kKeyhole =
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nv 1 1 2\nv 3 1 2\nv 3 3 2\nv 1 3 2\n"
    "g wall\nf 1 2 3 4 1 5 6 7 8 5\ng lid\nf 12 11 10 9\n";

TEST(FoundFiles, AFaceThatRunsToItsHoleAndBackHasThatHole) {
  const Workplace place;
  place.write("keyhole.obj", kKeyhole);
  place.write("hole.off",
              "OFF\n12 2 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 1 0\n1 3 0\n3 3 0\n3 1 0\n1 1 2\n3 1 2\n3 3 2\n1 3 2\n"
              "10 0 1 2 3 0 4 5 6 7 4\n4 11 10 9 8\n");
  const Outcome obj = place.run("hottel factors keyhole.obj --per group --areas");
  EXPECT_EQ(obj.code, 0) << obj.err;
  EXPECT_NEAR(factor(obj.out, "lid", "wall"), kLidToWall, 1e-12);
  EXPECT_THAT(obj.out, HasSubstr(",12,4\n")) << "the area of the wall is that of both less the hole";
  EXPECT_NEAR(factor(place.run("hottel factors hole.off").out, "hole[1]", "hole[0]"), kLidToWall, 1e-12);
  EXPECT_EQ(place.run("hottel convert keyhole.obj keyhole.json").code, 0);
  EXPECT_THAT(place.read("keyhole.json"), HasSubstr("\"holes\": [[[1, 1, 0]"));
  // As it is typed in a scene file.
  place.write("seam.json",
              R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
                {"name": "wall", "material": "m", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0],[0,0,0],
                  [1,1,0],[1,3,0],[3,3,0],[3,1,0],[1,1,0]]},
                {"name": "lid", "material": "m", "points": [[1,3,2],[3,3,2],[3,1,2],[1,1,2]]}]})");
  EXPECT_NEAR(factor(place.run("hottel factors seam.json").out, "lid", "wall"), kLidToWall, 1e-12);
}

TEST(FoundFiles, FacesWithoutAreaArePassedOverWithOneNote) {
  const Workplace place;
  place.write("mesh.stl", "solid a\n" + facet("0 0 0", "1 0 0", "1 1 0") + facet("0 0 0", "0 0 0", "0 0 0") +
                              facet("0 0 0", "0.5 0.5 0", "1 1 0") + facet("0 0 0", "1 1 0", "0 1 0") + "endsolid a\n");
  for (const char* line : {"hottel factors mesh.stl", "hottel check mesh.stl", "hottel check mesh.stl --fix fixed.json",
                           "hottel convert mesh.stl mesh.obj", "hottel solve mesh.stl -o out"}) {
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 0) << line << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("2 faces without area passed over, the first 'mesh[1]' at mesh.stl:9\n"));
  }
  EXPECT_THAT(place.run("hottel factors mesh.stl --pairs facing").out, HasSubstr("mesh[3],sky,"))
      << "faces keep their numbers";
}

TEST(FoundFiles, SolidsAreGroupsByName) {
  const Workplace place;
  const std::string inlet = facet("0 0 0", "1 0 0", "0 1 0"), wall = facet("0 0 1", "0 1 1", "1 0 1");
  place.write("multi.stl", "solid inlet\n" + inlet + "endsolid inlet\nsolid hot wall\n" + wall + "endsolid hot wall\n");
  const Outcome outcome = place.run("hottel factors multi.stl --per group");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(factor(outcome.out, "inlet", "hot wall"), 0.11504922814961, 1e-12);
  EXPECT_NEAR(factor(outcome.out, "hot wall", "inlet"), 0.11504922814961, 1e-12);
  place.write("one.stl", "solid inlet\n" + inlet + wall + "endsolid inlet\n");
  EXPECT_THAT(place.run("hottel factors one.stl").out, HasSubstr("one[0],one[1],"));
}

TEST(FoundFiles, PartsThatCloseTogetherAreOneSolid) {
  const Workplace place;
  const std::string all = cube(0, false), half = all.substr(0, all.size() / 2), rest = all.substr(all.size() / 2);
  place.write("parts.stl", "solid a\n" + half + "endsolid a\nsolid b\n" + rest + "endsolid b\n");
  for (const char* file : {"parts.stl", "parts.json"}) {
    const Outcome inside = place.run(std::string("hottel visibility ") + file + " --at 1/2,1/3,1/4");
    EXPECT_EQ(inside.code, 0) << inside.err;
    EXPECT_THAT(inside.out, HasSubstr("solid 'parts'")) << file;
    EXPECT_EQ(place.run("hottel convert parts.stl parts.json").code, 0);
  }
  // Where one closes alone the others are asked alone.
  place.write("more.stl", "solid a\n" + half + "endsolid a\nsolid b\n" + rest + "endsolid b\nsolid c\n" +
                              cube(3, false) + "endsolid c\n");
  EXPECT_THAT(place.run("hottel visibility more.stl --at 1/2,1/3,1/4").out, Not(HasSubstr("solid '")));
  EXPECT_THAT(place.run("hottel visibility more.stl --at 7/2,1/3,1/4").out, HasSubstr("solid 'c'"));
}

TEST(FoundFiles, WhatIsTypedAfterGDecidesWhichGroupItIs) {
  const Workplace place;
  place.write("hash.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\ng Wall #1\nf 1 2 3\ng Wall #2\nf 6 5 4\n"
              "g Wall #1\nf 1 2 3\n");
  const Outcome outcome = place.run("hottel factors hash.obj --per group");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(factor(outcome.out, "Wall", "Wall~2"), 0.11504922814961, 1e-12);
  EXPECT_NEAR(factor(outcome.out, "Wall~2", "Wall"), 0.11504922814961, 1e-12);
  EXPECT_THAT(outcome.out, Not(HasSubstr("~3")));
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(FoundFiles, LinesPointsAndAMissingLibraryAreToldOnce) {
  const Workplace place;
  place.write("loose.obj", "mtllib no.mtl\nusemtl a\n" + kTriangle + "f 1 2 3\nl 1 2\nl 2 3\np 1\n");
  const Outcome outcome = place.run("hottel factors loose.obj");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("1 point passed over at loose.obj:9\n"));
  EXPECT_THAT(outcome.err, HasSubstr("2 lines passed over, the first at loose.obj:7\n"));
  EXPECT_THAT(outcome.err, HasSubstr("1 missing file of materials passed over: 'no.mtl' at loose.obj:1\n"));
  // A material that the scene gives is enough; else it is told what is missing.
  const std::string head = R"({"hottel": 1, "dimension": 3, "mesh": {"file": "loose.obj"}, "materials": {")";
  place.write("given.json", head + R"(a": {"emission": 1}}})");
  EXPECT_EQ(place.run("hottel solve given.json -o out").code, 0);
  place.write("not_given.json", head + R"(b": {"emission": 1}}})");
  const Outcome refused = place.run("hottel factors not_given.json");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, StartsWith("loose.obj:2: the material 'a' is not defined\n"));
  EXPECT_THAT(refused.err, HasSubstr("no.mtl is not there"));
}

TEST(FoundFiles, ThirdCoordinatesAndPointsOfMapsArePassedOver) {
  const Workplace place;
  place.write("z.wkt", "POLYGON Z ((0 0 7, 4 0 7, 4 4 7, 0 4 7, 0 0 7))");
  place.write("z.geojson",
              R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"name": "hall"}, "geometry": {"type": "Polygon",
 "coordinates": [[[0,0,1],[4,0,1],[4,4,1],[0,4,1],[0,0,1]]]}},
{"type": "Feature", "geometry": {"type": "Point", "coordinates": [2, 0]}}]})");
  const Outcome wkt = place.run("hottel factors z.wkt"), geo = place.run("hottel factors z.geojson");
  EXPECT_EQ(wkt.code, 0) << wkt.err;
  EXPECT_THAT(wkt.err, StartsWith("5 third coordinates passed over, the first at z.wkt:1\n"));
  EXPECT_THAT(wkt.out, HasSubstr("polyline[0][0],polyline[0][2],0.4142135623730950"));
  EXPECT_EQ(geo.code, 0) << geo.err;
  EXPECT_THAT(geo.err, StartsWith("1 point passed over at z.geojson:4\n"
                                  "5 third coordinates passed over, the first at z.geojson:3\n"));
}

TEST(FoundFiles, EveryCommandReadsDrawingsAndMapsAndStandardInput) {
  const Workplace place;
  place.write("room.svg", "<svg xmlns='http://www.w3.org/2000/svg'><rect id='room' width='4' height='3'/></svg>");
  place.write("yard.wkt", "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0)) LINESTRING (6 0, 6 3)");
  for (const char* line : {"hottel factors room.svg",
                           "hottel solve room.svg -o a",
                           "hottel check room.svg",
                           "hottel plan room.svg",
                           "hottel visibility room.svg --at 1,-1",
                           "hottel compare room.svg --methods exact -o b",
                           "hottel reference c room.svg",
                           "hottel view room.svg --screenshot d.png",
                           "hottel convert room.svg room.json",
                           "hottel factors - <room.svg",
                           "hottel factors - <room.json",
                           "hottel factors - --front outside <yard.wkt",
                           "hottel check --front outside yard.wkt",
                           "hottel solve --front outside yard.wkt -o e",
                           "hottel plan --front outside yard.wkt",
                           "hottel visibility --front outside yard.wkt --at 5,1",
                           "hottel compare --front outside yard.wkt --methods exact -o f",
                           "hottel reference g yard.wkt --front outside",
                           "hottel view --front outside yard.wkt --screenshot h.png",
                           "hottel convert --front outside yard.wkt i.json",
                           "hottel solve - <room.json",
                           "hottel convert - j.json <room.json"})
    EXPECT_EQ(place.run(line).code, 0) << line << "\n" << place.run(line).err;
  EXPECT_EQ(place.run("hottel factors - <room.json").out, place.run("hottel factors room.json").out);
  EXPECT_NE(place.run("hottel factors yard.wkt").out, place.run("hottel factors yard.wkt --front outside").out);
  EXPECT_THAT(place.run("hottel factors room.svg --front outside").err,
              HasSubstr("--front is for the polygons of a map"));
  EXPECT_EQ(place.run("hottel view - <room.json").code, 2);
  EXPECT_THAT(place.run("echo '{' | hottel factors -").err, StartsWith("standard input:1: "));
}

TEST(FoundFiles, MeshesOfEveryFormatComeByStandardInput) {
  const Workplace place;
  ASSERT_EQ(place.run(std::string("cp ") + HOTTEL_SOURCE_DIR + "/scenes/space/cube.json .").code, 0);
  for (const char* format : {"obj", "ply", "off", "stl"}) {
    const std::string file = std::string("cube.") + format;
    ASSERT_EQ(place.run("hottel convert cube.json " + file).code, 0) << format;
    const Outcome piped = place.run("hottel factors - --quiet <" + file),
                  named = place.run("hottel factors --quiet " + file);
    EXPECT_EQ(piped.code, 0) << piped.err;
    EXPECT_EQ(lines_of(piped.out).size(), lines_of(named.out).size()) << format;
    EXPECT_GT(lines_of(piped.out).size(), 20u) << format;
  }
  const Outcome commented = place.run("(echo '# a cube'; echo; cat cube.obj) | hottel factors - --quiet");
  EXPECT_EQ(commented.code, 0) << commented.err;
  EXPECT_EQ(place.run("echo 'mesh' | hottel factors -").code, 3);
}

TEST(FoundFiles, AFileUnderTheEndingOfAnotherFormatIsTold) {
  const Workplace place;
  const std::string json = R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [{"points": [[0, 0], [1, 0]], "material": "m"}]})",
                    stl = "solid a\n" + cube(0, true) + "endsolid a\n",
                    obj = "# OFF\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string as_json = "it begins as JSON does: a scene is called .json, a map .geojson";
  for (const auto& [file, text, hint] : {std::tuple("a.stl", json, as_json),
                                         {"a.svg", json, as_json},
                                         {"a.obj", stl, "it begins as STL does: call it .stl"},
                                         {"a.json", stl, "it begins as STL does: call it .stl"},
                                         {"a.ply", obj, "it begins as OBJ does: call it .obj"},
                                         {"a.json", "<svg/>", "it begins as SVG does: call it .svg"}}) {
    place.write(file, text);
    const Outcome outcome = place.run(std::string("hottel plan ") + file);
    EXPECT_EQ(outcome.code, 3) << file;
    EXPECT_THAT(outcome.err, StartsWith(std::string(file) + ":"));
    EXPECT_EQ(lines_of(outcome.err).back(), "  " + hint) << outcome.err;
  }
  for (const auto& [file, text] : {std::pair("b.json", "{]"), {"b.obj", "v 0 0\n"}, {"b.svg", "<svg>"}}) {
    place.write(file, text);
    EXPECT_THAT(place.run(std::string("hottel plan ") + file).err, Not(HasSubstr("it begins as"))) << file;
  }
  EXPECT_EQ(place.run("hottel plan missing.stl").err, "missing.stl: there is no such file\n");
}

TEST(FoundFiles, APointOnAnOutlineMaySeeWhatItsFrontSees) {
  const Workplace place;
  place.write("square.wkt", "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))");
  const Outcome front = place.run("echo 0,0 | hottel visibility square.wkt --points - --side front -o seen.wkt");
  EXPECT_EQ(front.code, 0) << front.err;
  EXPECT_EQ(place.read("seen.wkt"), "POLYGON ((5 0, 5 5, 0 5, 0 0, 5 0))\n");
  EXPECT_THAT(place.run("echo 0,0 | hottel visibility square.wkt --points -").err, HasSubstr("unbounded"));
}

TEST(FoundFiles, ANumpyFileIsToldWhichMatrixItIs) {
  const Workplace place;
  place.write("keyhole.obj", kKeyhole);
  EXPECT_THAT(place.run("hottel factors keyhole.obj -o f.npy").err,
              HasSubstr("f.npy: view factors F, 5 x 5, from the row to the column; what these are is in f.npy.json\n"));
  EXPECT_THAT(place.run("hottel factors keyhole.obj --script-f -o f.npy").err, HasSubstr("f.npy: script-F, 5 x 5"));
}

const std::string kHeat =
    R"({"hottel": 1, "dimension": 3, "materials": {"paint": {"emissivity": 0.9, "temperature": 300}},
  "mesh": {"file": "body.stl", "material": "paint"})";

TEST(FoundFiles, BodiesInsideOutAreToldAndTurned) {
  const Workplace place;
  place.write("body.stl", "solid cad\n" + cube(0, true) + "endsolid cad\n");
  place.write("sky.json", kHeat + R"(, "sky": {"temperature": 250}})");
  const Outcome found = place.run("hottel check sky.json --json");
  EXPECT_EQ(found.code, 0) << found.err;
  const Json finding = Json::parse(found.out)["findings"][0];
  EXPECT_EQ(finding["kind"], "inside-out");
  EXPECT_EQ(finding["severity"], "warning");
  EXPECT_EQ(finding["file"], "body.stl");
  EXPECT_EQ(finding["line"], 2);
  EXPECT_THAT(place.run("hottel check sky.json").out, StartsWith("body.stl:2: warning: inside-out at "));

  const Outcome fixed = place.run("hottel check sky.json --fix out.stl");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_THAT(fixed.out, HasSubstr("body.stl:2: reversed: the points of 12 polygons of 'mesh[0]' go the other way"));
  EXPECT_THAT(place.run("hottel check out.stl").out, Not(HasSubstr("inside-out")));
  EXPECT_THAT(place.run("hottel factors out.stl").out, HasSubstr("out[0],sky,1,"));

  // It may be a furnace: nothing is outside, or it is promised; a light in it makes it a room.
  place.write("furnace.json", kHeat + "}");
  const Outcome furnace = place.run("hottel check furnace.json --fix same.json");
  EXPECT_THAT(furnace.out, HasSubstr("furnace.json: nothing was repaired\n"));
  EXPECT_THAT(furnace.out, HasSubstr("warning: inside-out"));
  place.write("promise.json", kHeat + R"(, "closed": true, "sky": {"temperature": 250}})");
  EXPECT_THAT(place.run("hottel check promise.json").out, Not(HasSubstr("inside-out")));
  place.write("lit.json", kHeat + R"(, "sky": {"temperature": 250},
    "lights": [{"type": "point", "position": [0.5, 0.5, 0.5], "power": 1}]})");
  EXPECT_THAT(place.run("hottel check lit.json").out, Not(HasSubstr("inside-out")));
}

TEST(FoundFiles, EachPartOfAMeshIsTurnedByItself) {
  const Workplace place;
  place.write("body.stl", "solid cad\n" + cube(0, true) + cube(3, false) + "endsolid cad\n");
  place.write("two.json", kHeat + "}");
  const Outcome fixed = place.run("hottel check two.json --fix fixed.json");
  EXPECT_THAT(fixed.out, HasSubstr("reversed: the points of 12 polygons of 'mesh[0]'"));
  EXPECT_THAT(place.run("hottel visibility fixed.json --at 0.5,0.4,0.3").out, HasSubstr("solid"));
  EXPECT_THAT(place.run("hottel visibility fixed.json --at 3.5,0.4,0.3").out, HasSubstr("solid"));
  EXPECT_EQ(place.run("hottel check fixed.json --fix fixed.json").err,
            "fixed.json is left as it is: nothing is repaired\n");
}

TEST(FoundFiles, DoublesAreDropped) {
  const Workplace place;
  place.write("double.obj", kTriangle + "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\nf 4 6 5\nf 3 1 2\n");
  const Outcome fixed = place.run("hottel check double.obj --fix single.off");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_THAT(fixed.out, HasSubstr("double.obj:9: dropped: 'double[2]' is dropped: 'double[0]' is the same\n"));
  EXPECT_THAT(place.read("single.off"), HasSubstr("6 2 0"));
}

TEST(FoundFiles, InputsAreNotOverwrittenUnlessTheyAreNamed) {
  const Workplace place;
  place.write("room.mtl", "newmtl a\nKd 0.3 0.3 0.3\nmap_Kd wall.png\n");
  place.write("in.obj", "mtllib room.mtl\nusemtl a\n" + kTriangle + "f 1 2 3\n");
  const std::string before = place.read("room.mtl");
  for (const char* line : {"hottel convert in.obj room.obj", "hottel check in.obj --fix room.obj"}) {
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_THAT(outcome.err, HasSubstr("would overwrite room.mtl"));
  }
  EXPECT_EQ(place.read("room.mtl"), before);
  EXPECT_EQ(place.run("hottel convert in.obj other.obj").code, 0);
}

// A room of 4 x 4 x 3 with a panel that hangs in it, and a door that leaves a slit along its top.
TEST(FoundFiles, ALeakIsWhereTheGapIsWidest) {
  const Workplace place;
  place.write("room.json", R"({"hottel": 1, "dimension": 3, "closed": true, "materials": {"m": {"emission": 1}},
"polygons": [
{"name": "lamp", "material": "m", "back": "m", "points": [[1,1,2],[2,1,2],[2,2,2],[1,2,2]]},
{"name": "floor", "material": "m", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]]},
{"name": "ceiling", "material": "m", "points": [[0,4,3],[4,4,3],[4,0,3],[0,0,3]]},
{"name": "north", "material": "m", "points": [[0,4,0],[4,4,0],[4,4,3],[0,4,3]]},
{"name": "west", "material": "m", "points": [[0,0,0],[0,4,0],[0,4,3],[0,0,3]]},
{"name": "east", "material": "m", "points": [[4,4,0],[4,0,0],[4,0,3],[4,4,3]]},
{"name": "south", "material": "m", "points": [[4,0,0],[3,0,0],[3,0,2.001],[1,0,2.001],[1,0,0],[0,0,0],[0,0,3],[4,0,3]]},
{"name": "door", "material": "m", "points": [[3,0,0],[1,0,0],[1,0,2],[3,0,2]]}]})");
  const Outcome outcome = place.run("hottel check room.json");
  EXPECT_EQ(outcome.code, 1);
  const std::string first = lines_of(outcome.out).at(0);
  EXPECT_THAT(first, HasSubstr("error: not-closed at (2, 0, 2"));
  EXPECT_THAT(first, HasSubstr("lies on nothing; the nearest other surface, '"));
  EXPECT_THAT(first, HasSubstr("is 0.001 away from its middle"));
  EXPECT_THAT(first, HasSubstr("'door'"));
  EXPECT_THAT(first, Not(HasSubstr("edge of 'lamp'")));
}

TEST(FoundFiles, TemperaturesThatMayBeCelsiusAreHintedAt) {
  const Workplace place;
  const auto scene = [](const std::string& t, const std::string& more) {
    return R"({"hottel": 1, "dimension": 2, "materials": {"w": {"emissivity": 0.5, "temperature": )" + t +
           R"(}}, "polylines": [{"name": "r", "material": "w", "closed": true, "points": [[0,0],[0,1],[1,1],[1,0]]}])" +
           more + "}";
  };
  place.write("room.json", scene("20", ""));
  EXPECT_THAT(place.run("hottel check room.json").out,
              HasSubstr("note: kelvin: these are colder than 100 K: 'w' (20 K)\n"));
  place.write("warm.json", scene("293", ""));
  EXPECT_THAT(place.run("hottel check warm.json").out, Not(HasSubstr("kelvin")));
  const std::string plate = R"("edges": [{"name": "p", "material": "w", "points": [[0,0],[0,1]]}])";
  const auto open = [&](const std::string& sky) {
    return R"({"hottel": 1, "dimension": 2, "materials": {"w": {"emissivity": 0.5, "temperature": 20}}, )" + plate +
           R"(, "sky": {"temperature": )" + sky + "}}";
  };
  place.write("space.json", open("3"));
  place.write("earth.json", open("280"));
  EXPECT_THAT(place.run("hottel check space.json").out, Not(HasSubstr("kelvin")));
  EXPECT_THAT(place.run("hottel check earth.json").out, HasSubstr("note: kelvin"));
}

}  // namespace
}  // namespace hottel::found_files_test

#include "io/scene/space/stl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "tests/io/space/mesh_bytes.h"
#include "tests/refusal.h"

namespace hottel::stl_reader_test {
namespace {

using testing::HasSubstr;
using testing_mesh::bytes;

Scene3 read(const std::string& text) { return scene_of(parse_stl_3(text, "in/room.stl")).scene; }
std::string refusal(const std::string& text) {
  return refusal_by([&] { read(text); });
}
std::vector<std::string> lines(const std::string& text) { return testing_mesh::lines(read(text)); }

std::string facet(const std::string& normal, const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal " + normal + "\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}

const std::string kFirst = facet("0 0 -1", "0 0 0", "1 0 0", "0 .1 0");
const std::string kSecond = facet("nan nan nan", "0 0 0", "1 0 0", "0 0 1e-1");
const std::vector<std::string> kRead{"room[0]: 0,0,0 1,0,0 0,1/10,0", "room[1]: 0,0,0 1,0,0 0,0,1/10"};

TEST(StlReader, ReadsTextExactlyAndTrustsNoNormal) {
  const std::string whole = "solid a room\n" + kFirst + kSecond + "endsolid a room\n";
  EXPECT_EQ(lines(whole), kRead);
  EXPECT_EQ(read(whole).surfaces[0].line, 2);
  EXPECT_EQ(read(whole).surfaces[1].line, 9);
  EXPECT_EQ(read(whole).groups.size(), 1u);
  EXPECT_EQ(read(whole).materials[0].name, "white");
}

TEST(StlReader, KeywordsMayBeCapitalsAndSolidsSeveral) {
  std::string capitals = "solid\n" + kFirst + "endsolid\nsolid facet\n" + kSecond + "endsolid facet";
  const std::vector<std::string> read_small{kRead[0], "facet[0]" + kRead[1].substr(7)};
  const std::vector<std::string> read_large{kRead[0], "FACET[0]" + kRead[1].substr(7)};
  EXPECT_EQ(lines(capitals), read_small);
  EXPECT_EQ(lines("\n" + capitals), read_small);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  for (std::size_t at = capitals.find('\n'); at != std::string::npos; at = capitals.find('\n', at + 2))
    capitals.replace(at, 1, "\r\n");
  EXPECT_EQ(lines(capitals), read_large);
}

TEST(StlReader, SolidsAreGroupsByNameOfOneBody) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> result;
    const Scene3 scene = read(text);
    for (const Surface& surface : scene.surfaces)
      result.push_back(scene.groups[surface.group].body + "/" + scene.groups[surface.group].name + "/" + surface.name);
    return result;
  };
  const auto solid = [](const std::string& name, const std::string& facets) {
    return "solid " + name + "\n" + facets + "endsolid\n";
  };
  EXPECT_EQ(names(solid("one", kFirst + kSecond)), (std::vector<std::string>{"/room/room[0]", "/room/room[1]"}));
  EXPECT_EQ(names(solid("hot wall", kFirst) + solid("in", kSecond) + solid("hot wall", kFirst) + solid("", kSecond)),
            (std::vector<std::string>{"room/hot wall/hot wall[0]", "room/in/in[0]", "room/hot wall/hot wall[1]",
                                      "room/room/room[0]"}));
  // Names that cannot be any are cleaned, and kept apart.
  EXPECT_EQ(names(solid("a#1", kFirst) + solid("a_1", kSecond) + solid("sky", kFirst) + solid("x:back", kSecond)),
            (std::vector<std::string>{"room/a_1/a_1[0]", "room/a_1~2/a_1~2[0]", "room/sky_/sky_[0]",
                                      "room/x:back_/x:back_[0]"}));
}

TEST(StlReader, RefusesKeywordsThatDoNotFollow) {
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = "solid a\n" + kFirst + "endsolid\n";
    text.replace(text.find(from), from.size(), to);
    return refusal(text);
  };
  EXPECT_EQ(with("facet", "face"), "in/room.stl:2: there is 'face' where facet or endsolid has to be");
  EXPECT_EQ(with("normal", "n"), "in/room.stl:2: there is 'n' where normal has to be");
  EXPECT_EQ(with("outer", "inner"), "in/room.stl:3: there is 'inner' where outer has to be");
  EXPECT_EQ(with("vertex", "v"), "in/room.stl:4: there is 'v' where vertex has to be");
  EXPECT_EQ(with("  endloop", "  vertex 1 1 0\n  endloop"), "in/room.stl:7: there is 'vertex' where endloop has to be");
  EXPECT_EQ(with("   vertex 1 0 0\n", ""), "in/room.stl:6: there is 'endloop' where vertex has to be");
  EXPECT_EQ(with("endfacet", "end"), "in/room.stl:8: there is 'end' where endfacet has to be");
  EXPECT_EQ(with("endsolid\n", "endsolid\nfacet\n"), "in/room.stl:10: there is 'facet' where solid has to be");
  EXPECT_THAT(with("1 0 0", "1 inf 0"), HasSubstr("in/room.stl:5: coordinate is not a number: 'inf'"));
  EXPECT_THAT(with("1 0 0", "1 0 0 0"), HasSubstr("in/room.stl:5: there is '0' where vertex has to be"));
  EXPECT_EQ(with("1 0 0", "0 .2 0"), "in/room.stl:2: face 'room[0]' has no area: its points lie on one line");
}

TEST(StlReader, TextsEndWithTheirSolids) {
  const std::string whole = "solid a\n" + kFirst + kSecond + "endsolid";
  for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(refusal(whole.substr(0, length)), "");
  EXPECT_EQ(refusal("solid a\n" + kFirst), "in/room.stl:9: the file ends before endsolid, after 1 whole triangles");
  EXPECT_EQ(refusal("solid a\nendsolid a\n"), "in/room.stl: has no triangles");
  EXPECT_EQ(refusal("solid\n" + kFirst + std::string("endsolid\0", 9)),
            "in/room.stl:9: the line has a NUL byte: this is no text");
}

std::string binary(const std::string& header, const std::vector<std::vector<float>>& triangles) {
  std::string text =
      header + std::string(80 - header.size(), '\0') + bytes(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& corners : triangles)
    text += bytes<float>({std::nanf(""), 0, -1}) + bytes(corners) + std::string("\xFF\x7F");
  return text;
}

TEST(StlReader, BinaryFloatsAreWhatTheyAre) {
  constexpr float kLeast = std::numeric_limits<float>::denorm_min(), kMost = std::numeric_limits<float>::max();
  // A file that begins with solid may be binary.
  for (const char* header : {"", "made by hand", "solid a room\nfacet normal 0 0 0"}) {
    const Scene3 scene = read(binary(header, {{0, 0, 0, 0.1f, 0, 0, 0, -kLeast, kMost}, {0, 0, 0, 0, 1, 0, 0, 0, -1}}));
    ASSERT_EQ(scene.polygons.size(), 2u);
    EXPECT_EQ(scene.polygons[0].points,
              (std::vector<Point3>{{0, 0, 0}, {Rational(0.1f), 0, 0}, {0, Rational(-kLeast), Rational(kMost)}}));
    EXPECT_EQ(scene.surfaces[1].name, "room[1]");
    EXPECT_EQ(scene.surfaces[1].line, 0);
  }
}

TEST(StlReader, RefusesWrongTrianglesOfABinaryFileByTheirByte) {
  const std::vector<float> good{0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (const float x : {std::nanf(""), std::numeric_limits<float>::infinity()})
    EXPECT_EQ(refusal(binary("", {good, {0, 0, 0, 1, x, 0, 0, 1, 1}})),
              "in/room.stl: a coordinate of triangle 1 is not finite (byte 162)");
  EXPECT_EQ(refusal(binary("", {{0, 0, 0, 1, 0, 0, 2, 0, 0}})),
            "in/room.stl: face 'room[0]' has no area: its points lie on one line (byte 84)");
  EXPECT_EQ(refusal(binary("", {{0, 0, 0, 1, 0, 0, -0.0f, 0, -0.0f}})),
            "in/room.stl: face 'room[0]' has no area: it has fewer than three points that differ (byte 84)");
  PassedOver passed_over;
  const Mesh3 mesh = parse_stl_3(binary("", {good, {0, 0, 0, 1, 0, 0, 2, 0, 0}, good}), "in/room.stl");
  EXPECT_EQ(scene_of(mesh, nullptr, &passed_over).scene->surfaces[1].name, "room[2]");
  EXPECT_EQ(passed_over.note(), "1 face without area passed over: 'room[1]' at in/room.stl (byte 134)");
  EXPECT_EQ(refusal(binary("", {})), "in/room.stl: has no triangles");
}

TEST(StlReader, BinaryFilesHaveTheLengthThatTheySay) {
  const std::string whole = binary("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}});
  for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(refusal(whole.substr(0, length)), "");
  EXPECT_EQ(refusal(whole.substr(0, 150)),
            "in/room.stl: is no STL file, or no whole one: a binary one of 2 triangles (bytes 80 to 83) has 184 bytes, "
            "not 150; one of text begins with solid");
  EXPECT_EQ(refusal(whole + "x"),
            "in/room.stl: is no STL file, or no whole one: a binary one of 2 triangles (bytes 80 to 83) has 184 bytes, "
            "not 185; one of text begins with solid");
  std::string many = whole;
  many.replace(80, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_EQ(refusal(many),
            "in/room.stl: is no STL file, or no whole one: a binary one of 4294967295 triangles (bytes 80 to 83) has "
            "214748364834 bytes, not 184; one of text begins with solid");
  EXPECT_EQ(refusal("ply\n"),
            "in/room.stl: is no STL file: it does not begin with solid, and it has 4 bytes where a "
            "binary one has 84 or more");
}

}  // namespace
}  // namespace hottel::stl_reader_test

#include "io/scene/space/ply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "tests/io/space/mesh_bytes.h"
#include "tests/refusal.h"

namespace hottel::ply_reader_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_mesh::bytes;

Scene3 read(const std::string& text) { return scene_of(parse_ply_3(text, "in/room.ply")).scene; }
std::string refusal(const std::string& text) {
  return refusal_by([&] { read(text); });
}
std::vector<std::string> lines(const std::string& text) { return testing_mesh::lines(read(text)); }

std::string text_header(const std::string& elements) { return "ply\nformat ascii 1.0\n" + elements + "end_header\n"; }

const std::string kPoints = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";
const std::string kTwoTriangles =
    text_header("element vertex 4\n" + kPoints + "element face 2\n" + kFaces) + "0 0 0\n1 0 0\n0 0.1 0\n0 0 1/3\n";
const std::vector<std::string> kTwoRead{"room[0]: 0,0,0 1,0,0 0,1/10,0", "room[1]: 0,0,0 1,0,0 0,0,1/3"};

TEST(PlyReader, ReadsTextExactly) {
  EXPECT_EQ(lines(kTwoTriangles + "3 0 1 2\n3 0 1 3\n"), kTwoRead);
  const Scene3 scene = read(kTwoTriangles + "3 0 1 2\n3 0 1 3");
  EXPECT_EQ(scene.surfaces[0].line, 14);
  EXPECT_EQ(scene.surfaces[1].line, 15);
  ASSERT_EQ(scene.groups.size(), 1u);
  EXPECT_EQ(scene.groups[0].name, "room");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].name, "white");
  EXPECT_EQ(scene.materials[0].reflectivity.value[0], kMeshReflectivity);
}

TEST(PlyReader, ReadsLinesHoweverTheyEnd) {
  for (const char* end : {"\r\n", "\r"}) {
    std::string text = kTwoTriangles + "3 0 1 2\n3 0 1 3\n";
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
      text.replace(at, 1, end);
    EXPECT_EQ(lines(text), kTwoRead);
    EXPECT_EQ(read(text).surfaces[1].line, 15);
  }
  // Words may stand in any lines.
  EXPECT_EQ(lines(kTwoTriangles + "3 0\n1\n\n2 3\n0 1 3"), kTwoRead);
}

// A right triangle with legs 2 and 1 at z = 3, its coordinates in some type.
template <class T>
std::string binary_triangle(const std::string& type, std::endian order) {
  return std::string("ply\nformat binary_") + (order == std::endian::big ? "big" : "little") +
         "_endian 1.0\ncomment x\nelement vertex 3\nproperty " + type + " x\nproperty " + type + " y\nproperty " +
         type + " z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n" +
         bytes<T>({0, 0, 3, 2, 0, 3, 0, 1, 3}, order) + bytes<std::uint8_t>(3) + bytes<std::int32_t>({0, 1, 2}, order);
}

TEST(PlyReader, BinaryValuesBeginRightAfterTheHeaderHoweverItsLinesEnd) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* line :
         {"ply", "format binary_little_endian 1.0", "element vertex 3", "property uchar x", "property uchar y",
          "property uchar z", "element face 1", "property list uchar uchar vertex_index", "end_header"})
      text += std::string(line) + end;
    // The first value is that of a line feed.
    EXPECT_THAT(lines(text + bytes<std::uint8_t>({10, 13, 10, 13, 13, 10, 10, 10, 10, 3, 0, 1, 2})),
                ElementsAre("room[0]: 10,13,10 13,13,10 10,10,10"));
  }
}

TEST(PlyReader, ReadsEveryTypeInBothByteOrders) {
  const std::vector<std::string> expected{"room[0]: 0,0,3 2,0,3 0,1,3"};
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const char* name : {"char", "int8"}) EXPECT_EQ(lines(binary_triangle<std::int8_t>(name, order)), expected);
    for (const char* name : {"uchar", "uint8"}) EXPECT_EQ(lines(binary_triangle<std::uint8_t>(name, order)), expected);
    for (const char* name : {"short", "int16"}) EXPECT_EQ(lines(binary_triangle<std::int16_t>(name, order)), expected);
    for (const char* name : {"ushort", "uint16"})
      EXPECT_EQ(lines(binary_triangle<std::uint16_t>(name, order)), expected);
    for (const char* name : {"int", "int32"}) EXPECT_EQ(lines(binary_triangle<std::int32_t>(name, order)), expected);
    for (const char* name : {"uint", "uint32"}) EXPECT_EQ(lines(binary_triangle<std::uint32_t>(name, order)), expected);
    for (const char* name : {"float", "float32"}) EXPECT_EQ(lines(binary_triangle<float>(name, order)), expected);
    for (const char* name : {"double", "float64"}) EXPECT_EQ(lines(binary_triangle<double>(name, order)), expected);
  }
}

// The mesh of a triangle (0, 0, 0), (x, 0, 0), (0, 1, 0) in a little-endian file.
template <class T>
std::string binary_with(T x) {
  const char* type = sizeof(T) == 4 ? "float" : "double";
  std::string text = binary_triangle<T>(type, std::endian::little);
  text.replace(text.size() - 13 - 6 * sizeof(T), sizeof(T), bytes(x));
  return text;
}

TEST(PlyReader, BinaryFloatsAreWhatTheyAre) {
  for (const float x : {0.1f, -0.1f, 1e-45f, 3.4028235e38f})
    EXPECT_EQ(read(binary_with(x)).polygons[0].points[1].x, Rational(x));
  for (const double x : {0.1, 5e-324, 1.7976931348623157e308})
    EXPECT_EQ(read(binary_with(x)).polygons[0].points[1].x, Rational(x));
  EXPECT_EQ(read(binary_with(-0.5)).polygons[0].points[1].x, Rational(-1, 2));
  EXPECT_THAT(refusal(binary_with(-0.0)), HasSubstr("has fewer than three points that differ"));
}

TEST(PlyReader, RefusesWhatIsNotFinite) {
  constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
  for (const float x : {std::nanf(""), kFloatInfinity, -kFloatInfinity}) {
    EXPECT_THAT(refusal(binary_with(x)), HasSubstr("in/room.ply: x of vertex 1 of 3 is not finite (byte "));
    EXPECT_THAT(refusal(binary_with(static_cast<double>(x))), HasSubstr("x of vertex 1 of 3 is not finite (byte "));
  }
  for (const char* word : {"nan", "inf", "-Infinity", "1e9999", "0x1", "1,5"})
    EXPECT_THAT(refusal(text_header("element vertex 1\n" + kPoints) + "0 0 " + word), HasSubstr("in/room.ply:8: z "));
}

TEST(PlyReader, PassesOverOtherPropertiesAndElements) {
  const std::string elements =
      "comment made by hand\nobj_info 7\nelement camera 1\nproperty list uchar float view\nproperty double fov\n"
      "element nothing 4000000000\n"
      "element vertex 3\nproperty uchar red\nproperty double z\nproperty list int short marks\nproperty float x\n"
      "property int y\n"
      "element face 1\nproperty uchar alpha\nproperty list uchar uint vertex_indices\nproperty list char float st\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  const std::vector<std::string> expected{"room[0]: 1,0,3 2,0,3 1,5,3"};
  EXPECT_EQ(lines(text_header(elements) + "2 0.5 nan 60\n255 3 0 1 0\n0 3 2 7 8 2 0\n9 3 1 -7 1 5\n" +
                  "1 3 0 1 2 2 0.5 0.5\n0 1\n"),
            expected);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string text = text_header(elements);
    text.replace(text.find("ascii"), 5, order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
    const auto vertex = [&](double z, const std::vector<std::int16_t>& marks, float x, std::int32_t y) {
      return bytes<std::uint8_t>(255) + bytes(z, order) + bytes(static_cast<std::int32_t>(marks.size()), order) +
             bytes(marks, order) + bytes(x, order) + bytes(y, order);
    };
    text += bytes<std::uint8_t>(2) + bytes<float>({0.5f, std::nanf("")}, order) + bytes(60.0, order);
    text += vertex(3, {}, 1, 0) + vertex(3, {7, 8}, 2, 0) + vertex(3, {-7}, 1, 5);
    text += bytes<std::uint8_t>(1) + bytes<std::uint8_t>(3) + bytes<std::uint32_t>({0, 1, 2}, order);
    text += bytes<std::int8_t>(2) + bytes<float>({0.5f, 0.5f}, order);
    text += bytes<std::int32_t>({0, 1}, order);
    EXPECT_EQ(lines(text), expected);
  }
}

TEST(PlyReader, FacesMayStandBeforeTheirVertices) {
  EXPECT_THAT(lines(text_header("element face 1\n" + kFaces + "element vertex 4\n" + kPoints) +
                    "4 3 2 1 0\n0 0 0\n0 1 0\n1 1 0\n1 0 0\n"),
              ElementsAre("room[0]: 1,0,0 1,1,0 0,1,0 0,0,0"));
}

TEST(PlyReader, RefusesFacesThatAreNone) {
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n2 0 1\n"), "in/room.ply:15: face 1 has fewer than three vertices: 2");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n3 0 1 4\n"),
            "in/room.ply:15: the vertex 4 of face 1 is none of the 4, counted from 0");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n3 0 1 -1\n"),
            "in/room.ply:15: the vertex -1 of face 1 is none of the 4, counted from 0");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n-1\n"), "in/room.ply:15: the list 'vertex_indices' has the length -1");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n3 0 1 x\n"), "in/room.ply:15: vertex_indices is not an integer: 'x'");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 0\n3 0 1 1\n"),
            "in/room.ply:14: face 'room[0]' has no area: it has fewer than three points that differ");
  EXPECT_EQ(refusal(kTwoTriangles + "3 0 1 2\n3 0 1 1\n"), "");
  std::string binary = binary_triangle<float>("float", std::endian::little);
  const std::string face = std::to_string(binary.size() - 13);
  binary.replace(binary.size() - 4, 4, bytes<std::int32_t>(3));
  EXPECT_EQ(refusal(binary), "in/room.ply: the vertex 3 of face 0 is none of the 3, counted from 0 (byte " +
                                 std::to_string(binary.size() - 4) + ")");
  binary.replace(binary.size() - 4, 4, bytes<std::int32_t>(1));
  EXPECT_EQ(refusal(binary),
            "in/room.ply: face 'room[0]' has no area: it has fewer than three points that differ (byte " + face + ")");
  binary.replace(binary.size() - 13, 1, bytes<std::uint8_t>(2));
  EXPECT_EQ(refusal(binary), "in/room.ply: face 0 has fewer than three vertices: 2 (byte " + face + ")");
}

TEST(PlyReader, FilesEndWhereTheirHeadersSay) {
  const std::string whole = kTwoTriangles + "3 0 1 2\n3 0 1 3\n";
  for (std::size_t length = 0; length < whole.size() - 1; ++length) EXPECT_NE(refusal(whole.substr(0, length)), "");
  EXPECT_EQ(refusal(whole.substr(0, whole.size() - 4)), "in/room.ply:15: the file ends within face 1 of 2");
  EXPECT_EQ(refusal(whole + "3"), "in/room.ply:16: after the last element there is '3'");
  const std::string binary = binary_triangle<double>("double", std::endian::big);
  for (std::size_t length = 0; length < binary.size(); ++length) EXPECT_NE(refusal(binary.substr(0, length)), "");
  EXPECT_THAT(refusal(binary.substr(0, binary.size() - 1)), HasSubstr(": the file ends within face 0 of 1 (byte "));
  EXPECT_EQ(refusal(binary + "\n"),
            "in/room.ply: after the last element there are 1 bytes more (byte " + std::to_string(binary.size()) + ")");
}

TEST(PlyReader, KeepsNothingOfCountsThatDoNotFit) {
  for (const char* count : {"5", "4000000000", "18446744073709551615"}) {
    const std::string many = std::string("element vertex ") + count + "\n" + kPoints + "element face 1\n" + kFaces;
    EXPECT_THAT(
        refusal(text_header(many) + "0 0 0\n"),
        HasSubstr("in/room.ply:3: the header says " + std::string(count) + " of element 'vertex', and the file ends"));
    std::string binary = text_header(many);
    binary.replace(binary.find("ascii"), 5, "binary_little_endian");
    EXPECT_THAT(refusal(binary + std::string(59, '\0')),
                HasSubstr("of element 'vertex' and the file has 59 bytes more"));
  }
  EXPECT_THAT(refusal(text_header("element vertex 18446744073709551616\n")), HasSubstr("is no integer from 0 on"));
  // Lengths of lists.
  std::string list =
      text_header("element vertex 3\n" + kPoints + "element face 1\nproperty list uint int vertex_index\n");
  list.replace(list.find("ascii"), 5, "binary_little_endian");
  list += std::string(36, '\0');
  EXPECT_THAT(refusal(list + bytes<std::uint32_t>(0xffffffff)), HasSubstr("the file ends within face 0 of 1"));
  EXPECT_THAT(refusal(kTwoTriangles + "3 0 1 2\n9223372036854775807 0 1 2"),
              HasSubstr("the file ends within face 1 of 2"));
}

TEST(PlyReader, RefusesWrongHeaders) {
  const auto header = [](const std::string& lines) {
    return refusal("ply\nformat ascii 1.0\n" + lines + "end_header\n");
  };
  EXPECT_THAT(refusal(""), HasSubstr("in/room.ply:1: the file does not begin with the line 'ply'"));
  EXPECT_THAT(refusal("plyx\n"), HasSubstr("does not begin with the line 'ply'"));
  EXPECT_THAT(refusal("ply"), HasSubstr("in/room.ply:1: the file ends within its header"));
  EXPECT_THAT(refusal("ply\nformat ascii 1.0\n"), HasSubstr("in/room.ply:3: the file ends within its header"));
  EXPECT_THAT(refusal("ply\nend_header\n"), HasSubstr("the header does not say the format"));
  EXPECT_THAT(refusal("ply\nformat ascii 2.0\n"), HasSubstr("in/room.ply:2: the version is '2.0'"));
  EXPECT_THAT(refusal("ply\nformat binary 1.0\n"), HasSubstr("the format 'binary' is not known"));
  EXPECT_THAT(refusal("ply\nformat ascii\n"), HasSubstr("a format is written like"));
  EXPECT_THAT(header("format ascii 1.0\n"), HasSubstr("in/room.ply:3: the header says the format twice"));
  EXPECT_THAT(header("elements 3\n"), HasSubstr("the keyword 'elements' of the header is not known"));
  EXPECT_THAT(header("element vertex\n"), HasSubstr("an element is written like"));
  EXPECT_THAT(header("element vertex -1\n"), HasSubstr("is no integer from 0 on: '-1'"));
  EXPECT_THAT(header("element vertex 0\nelement vertex 0\n"), HasSubstr("the element 'vertex' is there twice"));
  EXPECT_THAT(header("property float x\n"), HasSubstr("a property stands before any element"));
  EXPECT_THAT(header("element vertex 0\nproperty x\n"), HasSubstr("a property is written like"));
  EXPECT_THAT(header("element vertex 0\nproperty list uchar vertex_index\n"), HasSubstr("a property is written like"));
  EXPECT_THAT(header("element vertex 0\nproperty real x\n"), HasSubstr("the type 'real' is not known"));
  EXPECT_THAT(header("element f 0\nproperty list float int i\n"), HasSubstr("of type 'float', which is no integer"));
  EXPECT_THAT(header("element vertex 0\n" + kPoints + kPoints),
              HasSubstr("in/room.ply:7: the property 'x' of element 'vertex' is there twice"));
}

TEST(PlyReader, RefusesWhatIsNoMesh) {
  const auto of = [](const std::string& elements, const std::string& body) {
    return refusal(text_header(elements) + body);
  };
  EXPECT_EQ(of("", ""), "in/room.ply: has no faces");
  EXPECT_EQ(of("element vertex 1\n" + kPoints, "0 0 0\n"), "in/room.ply: has no faces");
  EXPECT_EQ(of("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"),
            "in/room.ply:3: element 'vertex' has no number z");
  EXPECT_EQ(of("element vertex 1\nproperty float x\nproperty float y\nproperty list uchar int z\n", "0 0 0\n"),
            "in/room.ply:3: element 'vertex' has no number z");
  EXPECT_EQ(of("element face 1\nproperty int x\n", "3"), "in/room.ply:3: element 'face' has no list vertex_indices");
  EXPECT_EQ(of("element face 1\nproperty int vertex_index\n", "3"),
            "in/room.ply:3: 'vertex_index' of element 'face' is no list of integers");
  EXPECT_EQ(of("element face 1\nproperty list uchar float vertex_index\n", "0"),
            "in/room.ply:3: 'vertex_index' of element 'face' is no list of integers");
  EXPECT_EQ(of("element face 1\n" + kFaces + "property list uchar int vertex_index\n", "0 0"),
            "in/room.ply:3: element 'face' has two lists: vertex_indices and vertex_index");
  EXPECT_THAT(of("element face 1\n" + kFaces, "3 0 1 2\n"), HasSubstr("is none of the 0, counted from 0"));
  EXPECT_THAT(of("element tristrips 1\n" + kFaces, "3 0 1 2\n"), HasSubstr("element 'tristrips' is not read"));
  EXPECT_THAT(refusal(kTwoTriangles + std::string("3 0 1 2\n3 0\0 1 3\n", 17)),
              HasSubstr("in/room.ply:15: the line has a NUL byte"));
}

}  // namespace
}  // namespace hottel::ply_reader_test

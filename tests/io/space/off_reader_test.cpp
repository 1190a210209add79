#include "io/scene/space/off_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "tests/io/space/mesh_bytes.h"
#include "tests/refusal.h"

namespace hottel::off_reader_test {
namespace {

using testing::HasSubstr;

Scene3 read(const std::string& text) { return scene_of(parse_off_3(text, "in/room.off")).scene; }
std::string refusal(const std::string& text) {
  return refusal_by([&] { read(text); });
}
std::vector<std::string> lines(const std::string& text) { return testing_mesh::lines(read(text)); }

const std::string kVertices = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 .1 0\n0 0 1/3\n";
const std::vector<std::string> kRead{"room[0]: 0,0,0 1,0,0 0,1/10,0", "room[1]: 0,0,0 1,0,0 0,0,1/3"};

TEST(OffReader, ReadsCoordinatesExactly) {
  EXPECT_EQ(lines(kVertices + "3 0 1 2\n3 0 1 3\n"), kRead);
  const Scene3 scene = read(kVertices + "3 0 1 2\n\n3 0 1 3");
  EXPECT_EQ(scene.surfaces[0].line, 7);
  EXPECT_EQ(scene.surfaces[1].line, 9);
  EXPECT_EQ(scene.materials[0].name, "white");
  EXPECT_EQ(scene.groups.size(), 1u);
}

TEST(OffReader, PassesOverCommentsAndTheNumberOfEdges) {
  for (const char* head :
       {"OFF\n4 2 0\n", "OFF\n4 2\n", "OFF 4 2 9\n", "OFF # cube\n\n# no faces yet\n4 # points\n 2\n",
        "# made by hand\nOFF\r\n4 2 -1\r\n", "\n\tOFF\r4 2#faces\r"})
    EXPECT_EQ(lines(head + std::string("0 0 0 # origin\n1 0\n0 0 .1 0 0 0 1/3\n3 0 1 2\n3 0 1 3\n# end")), kRead)
        << head;
  EXPECT_EQ(refusal("OFF\n4 2 x\n"), "in/room.off:2: the number of edges is not an integer: 'x'");
}

TEST(OffReader, PassesOverColoursNormalsAndTextures) {
  const std::string faces = "3 0 1 2 0.5 0.5 0.5 1\n3 0 1 3 255 0 0 # red\n";
  EXPECT_EQ(lines(kVertices + faces), kRead);
  for (const char* head : {"COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"})
    EXPECT_EQ(lines(std::string(head) + "\n4 2 0\n0 0 0 1 2 3 4\n1 0 0 9 9\n0 .1 0\n0 0 1/3 nan nan nan\n" + faces),
              kRead)
        << head;
  // The same columns without a word in the header are no vertices.
  EXPECT_THAT(refusal("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n"), HasSubstr("in/room.off:"));
}

TEST(OffReader, RefusesOtherHeaders) {
  EXPECT_EQ(refusal("OFF BINARY\n..."),
            "in/room.off:1: OFF BINARY is not read by this version: write the file as text");
  EXPECT_THAT(refusal("COFF BINARY\n"), HasSubstr("BINARY is not read"));
  for (const char* head : {"4OFF", "nOFF", "C4nOFF"})
    EXPECT_EQ(refusal(std::string(head) + "\n4 2 0\n"),
              "in/room.off:1: '" + std::string(head) + "' is not read: its points do not have three coordinates");
  for (const char* head : {"", "8", "off", "OFFX", "XOFF", "NCOFF", "{", "OFF490"})
    EXPECT_THAT(refusal(std::string(head) + "\n4 2 0\n"), HasSubstr(", not with OFF (or COFF, NOFF, STOFF, ...)"))
        << head;
  EXPECT_THAT(refusal("\xEF\xBB\xBFOFF\n"), HasSubstr("room.off:1: the file begins with a byte order mark"));
  EXPECT_THAT(refusal(std::string("OFF\n\0\n", 6)), HasSubstr("room.off:2: the line has a NUL byte"));
}

TEST(OffReader, RefusesFacesThatAreNone) {
  const std::string kNoAreaLeft =
      "in/room.off:7: face 'room[0]' has no area: it has fewer than three points that differ";
  EXPECT_EQ(refusal(kVertices + "3 0 1 2\n2 0 1\n"), "in/room.off:8: face 1 has fewer than three vertices: 2");
  EXPECT_EQ(refusal(kVertices + "3 0 1 2\n-3 0 1\n"), "in/room.off:8: face 1 has fewer than three vertices: -3");
  for (const char* vertex : {"4", "-1", "9223372036854775807"})
    EXPECT_EQ(refusal(kVertices + "3 0 1 2\n3 0 1 " + vertex),
              "in/room.off:8: the vertex " + std::string(vertex) + " of face 1 is none of the 4, counted from 0");
  EXPECT_EQ(refusal(kVertices + "3 0 1 2\n3 0 1 2.0"), "in/room.off:8: a vertex of face 1 is not an integer: '2.0'");
  EXPECT_EQ(refusal(kVertices + "3 0 1 0\n3 0 1 1\n"), kNoAreaLeft);
  EXPECT_EQ(refusal(kVertices + "3 0 1 2\n3 0 1 1\n"), "");
  EXPECT_EQ(refusal("OFF\n4 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 1 2 3\n"),
            "in/room.off:7: face 'room[0]' has no area: its points lie on one line");
}

TEST(OffReader, RefusesWhatIsNoNumber) {
  for (const char* word : {"nan", "inf", "1e9999", "1,5", "0x10", "1.2.3"})
    EXPECT_THAT(refusal("OFF\n3 1 0\n0 0 " + std::string(word) + "\n1 0 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("in/room.off:3: coordinate "));
  EXPECT_EQ(refusal("OFF\n-3 1 0\n"), "in/room.off:2: the number of vertices is negative: '-3'");
  EXPECT_EQ(refusal("OFF\n3 x 0\n"), "in/room.off:2: the number of faces is not an integer: 'x'");
}

TEST(OffReader, FilesEndWhereTheirCountsSay) {
  const std::string whole = kVertices + "3 0 1 2\n3 0 1 3\n";
  for (std::size_t length = 0; length < whole.size() - 1; ++length) EXPECT_NE(refusal(whole.substr(0, length)), "");
  EXPECT_EQ(refusal("OFF"), "in/room.off:1: the file ends before the number of vertices");
  EXPECT_EQ(refusal("OFF\n3\n"), "in/room.off:3: the file ends before the number of faces");
  EXPECT_EQ(refusal("OFF\n1 0 0\n10 10\n"), "in/room.off:4: the file ends within vertex 0 of 1");
  EXPECT_EQ(refusal(kVertices + "3 0 1 2\n3 0  1  "), "in/room.off:8: the file ends within face 1 of 2");
  EXPECT_EQ(refusal(whole + "3 0 1 2\n"), "in/room.off:9: after the last face there is '3'");
  EXPECT_EQ(refusal("OFF\n0 0 0\n"), "in/room.off: has no faces");
}

TEST(OffReader, KeepsNothingOfCountsThatDoNotFit) {
  for (const char* count : {"5", "4000000000", "9223372036854775807"}) {
    EXPECT_EQ(refusal("OFF\n" + std::string(count) + " 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"),
              "in/room.off:2: the file says that there are " + std::string(count) + " vertices, and ends before that");
    EXPECT_EQ(refusal("OFF\n3 " + std::string(count) + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"),
              "in/room.off:5: the file says that there are " + std::string(count) + " faces, and ends before that");
  }
  EXPECT_THAT(refusal("OFF\n9223372036854775808 1 0\n"), HasSubstr("is not an integer"));
  EXPECT_THAT(refusal(kVertices + "3 0 1 2\n9223372036854775807 0 1 2"), HasSubstr("the file ends within face 1 of 2"));
}

}  // namespace
}  // namespace hottel::off_reader_test

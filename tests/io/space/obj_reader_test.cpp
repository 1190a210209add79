#include "io/scene/space/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_adder.h"
#include "kernel/support/failure.h"
#include "tests/refusal.h"

namespace hottel::obj_reader_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Files = std::map<std::string, std::string>;

TextSource source_of(const Files& files) {
  return [files](const std::filesystem::path& path) {
    const auto found = files.find(path.string());
    if (found == files.end()) throw InputError({path.string(), 0}, "is not there");
    return found->second;
  };
}

MeshScene3 read(const std::string& text, const Files& files = {}) {
  return scene_of(parse_obj_3(text, "in/room.obj", source_of(files)));
}

std::string refusal(const std::string& text, const Files& files = {}) {
  return refusal_by([&] { read(text, files); });
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// "name: x,y,z x,y,z ..." for each surface.
std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  const Scene3 scene = read(text).scene;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    std::string line = scene.surfaces[s].name + ":";
    for (const Point3& p : scene.polygons[s].points)
      line += " " + to_string(p.x) + "," + to_string(p.y) + "," + to_string(p.z);
    result.push_back(line);
  }
  return result;
}

std::vector<std::string> names(const std::string& text) {
  std::vector<std::string> result;
  const Scene3 scene = read(text).scene;
  for (const Surface& surface : scene.surfaces) result.push_back(scene.groups[surface.group].name + " " + surface.name);
  return result;
}

TEST(ObjReader, ReadsCoordinatesExactly) {
  EXPECT_THAT(lines("v 0.1 1e-3 -.5\nv 1/3 +2 7.\nv 1e2 0 0\nf 1 2 3\n"),
              ElementsAre("room[0]: 1/10,1/1000,-1/2 1/3,2,7 100,0,0"));
}

TEST(ObjReader, CountsVerticesFromOneOnAndFromTheLastBack) {
  const std::string triangle = "room[0]: 0,0,0 1,0,0 1,1,0";
  for (const char* face : {"f 1 2 3", "f -4 -3 -2", "f 1/9 2/8 3/7", "f 1//4 2//5 3//-6", "f 1/1/1 2/2/2 -2/-3/3",
                           "f 1/ 2 3", "\tf\t1  2   3 "}) {
    if (std::string(face) == "f 1/ 2 3") {
      EXPECT_THAT(refusal(kSquare + face), HasSubstr("room.obj:5: the vertex '1/' of a face is not an index"));
      continue;
    }
    EXPECT_THAT(lines(kSquare + face), ElementsAre(triangle)) << face;
  }
  EXPECT_THAT(lines("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf -3 -2 -1\n"),
              ElementsAre(triangle, "room[1]: 5,0,0 6,0,0 6,1,0"));
}

TEST(ObjReader, RefusesVerticesThatAreNone) {
  const auto vertex = [](const std::string& word) { return refusal(kSquare + "f 1 2 " + word + "\n"); };
  EXPECT_EQ(vertex("5"), "in/room.obj:5: the vertex '5' of a face is none of the 4 vertices that stand before it");
  for (const char* word : {"-5", "999999999", "9223372036854775807", "-9223372036854775808"})
    EXPECT_THAT(vertex(word), HasSubstr("is none of the 4 vertices")) << word;
  for (const char* word : {"0", "99999999999999999999", "-99999999999999999999", "x", "3x", "3.0", "3/", "3//", "3/0",
                           "3/1/1/1", "/3", "//3", "-", "+3", "3/x"})
    EXPECT_THAT(vertex(word), HasSubstr("is not an index")) << word;
  EXPECT_EQ(refusal(kSquare + "f 1 2\n"), "in/room.obj:5: a face has fewer than three vertices");
  EXPECT_EQ(refusal("f 1 2 3\n"),
            "in/room.obj:1: the vertex '1' of a face is none of the 0 vertices that stand before it");
}

TEST(ObjReader, PassesOverWeightsOfOneAndColours) {
  EXPECT_THAT(lines("v 0 0 0 1\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0 1 0.1 0.2 0.3\nf 1 2 3 4\n"),
              ElementsAre("room[0]: 0,0,0 1,0,0 1,1,0 0,1,0"));
  EXPECT_EQ(refusal("v 0 0 0 2\n"),
            "in/room.obj:1: a vertex has the weight '2'; only curves have weights other than 1");
  EXPECT_THAT(refusal("v 0 0\n"), HasSubstr("a vertex has 2 numbers"));
  EXPECT_THAT(refusal("v 0 0 0 1 1\n"), HasSubstr("a vertex has 5 numbers"));
  EXPECT_THAT(refusal("v 0 0 0 1 1 1 1 1\n"), HasSubstr("a vertex has 8 numbers"));
}

TEST(ObjReader, RefusesWhatIsNoNumber) {
  for (const char* number : {"nan", "NaN", "inf", "-Infinity", "1e9999", "1.2.3", "0x10", "1,5", "1/0", "1.5/2"})
    EXPECT_THAT(refusal(std::string("v 0 0 0\nv 0 ") + number + " 0\n"), StartsWith("in/room.obj:2: coordinate "))
        << number;
  EXPECT_THAT(refusal("v 0 0 " + std::string(5000, '1') + "\n"), HasSubstr("has 5000 characters"));
}

TEST(ObjReader, ReadsLinesHoweverTheyEnd) {
  const std::vector<std::string> expected{"room[0]: 0,0,0 1,0,0 1,1,0 0,1,0"};
  EXPECT_EQ(lines("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n"), expected);
  EXPECT_EQ(lines("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4"), expected);
  EXPECT_EQ(lines("# a \\\nv 0 0 0 # corner\n\n  v 1 0\\\n 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n3\\\n 4\\\n"), expected);
  // Lines are counted in the file, and a statement stands where it begins.
  EXPECT_THAT(refusal("v 0 0 0\r\n\r\n# x\r\nv 1 0 \\\r\n0\r\nv 1 x 0\r\n"), StartsWith("in/room.obj:6: coordinate"));
  EXPECT_THAT(refusal("v 0 0 0\nv 1 \\\n0 \\\nx\n"), StartsWith("in/room.obj:2: coordinate"));
}

TEST(ObjReader, NamesFacesAfterTheirGroups) {
  const std::string triangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_THAT(names(triangles + "f 1 2 3\no box\nf 1 2 4\ng a  b\nf 1 3 4\ng box\nf 2 3 4\n"),
              ElementsAre("room room[0]", "box box[0]", "a b a b[0]", "box box[1]"));
  EXPECT_THAT(names(triangles + "g box\nf 1 2 3\ng\nf 1 2 4\nf 1 3 4\n"),
              ElementsAre("box box[0]", "room room[0]", "room room[1]"));
  // A group that no face is in is none.
  EXPECT_THAT(names("g default\n" + triangles + "g real\nf 1 2 3\n"), ElementsAre("real real[0]"));
  EXPECT_THAT(refusal(triangles + "g a#1\nf 1 2 3\n"), HasSubstr("in/room.obj:6: the name 'a#1' of a group must not"));
  EXPECT_THAT(refusal(triangles + "g \xff\nf 1 2 3\n"), HasSubstr("is not well-formed UTF-8"));
  EXPECT_THAT(refusal(triangles + "g room\nf 1 2 3\ng\nf 1 2 4\n"), HasSubstr("two surfaces have the name 'room[0]'"));
}

TEST(ObjReader, CallsFacesMeshWhereTheFileCannotGiveThemItsName) {
  for (const char* file : {"sky.obj", "a#b.obj", ".obj"}) {
    const MeshScene3 read = scene_of(parse_obj_3(kSquare + "f 1 2 3 4\n", file, source_of({})));
    EXPECT_EQ(read.scene->surfaces[0].name, std::string(file) == ".obj" ? ".obj[0]" : "mesh[0]");
  }
}

TEST(ObjReader, PassesOverCornersThatRepeatTheOneBeforeAndCountsThem) {
  const std::string plain =
      write_scene_3(scene_of(parse_obj_3(kSquare + "f 1 2 3\nf 1 3 4\n", "in/room.obj", source_of({}))).scene);
  PassedOver passed_over;
  const Mesh3 mesh = parse_obj_3(kSquare + "v 1 1 0.0\nf 1 2 3 3\nf 1 1 3 5 4 1\n", "in/room.obj", source_of({}));
  EXPECT_EQ(write_scene_3(scene_of(mesh, nullptr, &passed_over).scene), plain);
  EXPECT_EQ(passed_over.note(), "4 repeated points passed over, the first of 'room[0]' at in/room.obj:6");
}

TEST(ObjReader, PassesOverFacesWithoutAreaUnlessNoneHasAny_3) {
  PassedOver passed_over;
  const Mesh3 mesh =
      parse_obj_3(kSquare + "v 2 0 0\ng a\nf 1 2 1\nf 1 2 5\nf 1 2 3\ng b\nf 2 5 2\n", "in/room.obj", source_of({}));
  const Scene3 scene = scene_of(mesh, nullptr, &passed_over).scene;
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].name, "a[2]");
  EXPECT_EQ(scene.groups.size(), 1u);
  EXPECT_EQ(passed_over.note(), "3 faces without area passed over, the first 'a[0]' at in/room.obj:7");
}

TEST(ObjReader, WhatIsTypedAfterGDecidesWhichGroupItIs) {
  EXPECT_EQ(lines(kSquare + "g A # one\nf 1 2 3\ng A # two\nf 1 3 4\ng A  # one\nf 1 2 4\ng A # one\nf 2 3 4\n"),
            (std::vector<std::string>{"A[0]: 0,0,0 1,0,0 1,1,0", "A~2[0]: 0,0,0 1,1,0 0,1,0",
                                      "A~3[0]: 0,0,0 1,0,0 0,1,0", "A[1]: 1,0,0 1,1,0 0,1,0"}));
  EXPECT_EQ(names(kSquare + "g A~2\nf 1 2 3\ng A\nf 1 3 4\ng A #\nf 1 2 4\n"),
            (std::vector<std::string>{"A~2 A~2[0]", "A A[0]", "A~3 A~3[0]"}));
}

// A group all of whose faces are of one object is a part of that, if the object has others.
TEST(ObjReader, GroupsOfAnObjectAreOneBody) {
  const auto bodies = [](const std::string& text) {
    std::vector<std::string> result;
    const MeshScene3 mesh = read(kSquare + text);
    for (const Group& group : mesh.scene->groups) result.push_back(group.name + " " + group.body);
    return result;
  };
  const std::string f = "f 1 2 3\n";
  EXPECT_THAT(bodies("g a\n" + f + "g b\n" + f), ElementsAre("a ", "b "));
  EXPECT_THAT(bodies("o a\n" + f + "o b\n" + f), ElementsAre("a ", "b "));
  EXPECT_THAT(bodies("o box\n" + f + "g door\n" + f + "o table\n" + f), ElementsAre("box box", "door box", "table "));
  EXPECT_THAT(bodies("o box\ng a\n" + f + "g b\n" + f + "g c\n" + f + "o rest\ng a\n" + f),
              ElementsAre("a ", "b box", "c box"));
  EXPECT_THAT(bodies("o sky\ng a\n" + f + "g b\n" + f), ElementsAre("a object", "b object"));
}

TEST(ObjReader, PassesOverLinesAndPoints) {
  PassedOver passed_over;
  const Mesh3 mesh = parse_obj_3(kSquare + "l 1 2\np 3\nf 1 2 3\nl 9\n", "in/room.obj", source_of({}));
  scene_of(mesh, nullptr, &passed_over);
  EXPECT_EQ(passed_over.note(),
            "1 point passed over at in/room.obj:6\n2 lines passed over, the first at in/room.obj:5");
}

TEST(ObjReader, KeepsTheLineOfAFace) { EXPECT_EQ(read(kSquare + "\nf 1 2 3\n").scene->surfaces[0].line, 6); }

TEST(ObjReader, RefusesFacesThatAreNoPolygonsByNameAndLine) {
  EXPECT_THAT(refusal("v 0 0 0\nv 1 0 0\nv 1 1 0.125\nv 0 1 0\ng box\nf 1 2 3 4\n"),
              StartsWith("in/room.obj:6: face 'box[0]' is not plane: points lie 0.1"));
  EXPECT_EQ(refusal("v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nf 1 2 3 4\n"),
            "in/room.obj:5: face 'room[0]' crosses itself at the point (1, 1, 0)");
  EXPECT_EQ(refusal(kSquare + "f 2 1 2\nf 1 2 1\n"),
            "in/room.obj:5: face 'room[0]' has no area: it has fewer than three points that differ");
  EXPECT_EQ(refusal(kSquare + "f 1 2 3 1 4\n"), "in/room.obj:5: face 'room[0]' has the point (0, 0, 0) twice");
  EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
            "in/room.obj:4: face 'room[0]' has no area: its points lie on one line");
}

TEST(ObjReader, TakesFacesThatOverlapOrAreNotConvex) {
  EXPECT_EQ(names(kSquare + "f 1 2 3\nf 1 2 4\n"), (std::vector<std::string>{"room room[0]", "room room[1]"}));
  const MeshScene3 read_one = read("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1.5 0.5 0\nf 1 2 3 4\n");
  ASSERT_EQ(read_one.scene->polygons.size(), 1u);
  EXPECT_EQ(read_one.scene->polygons[0].points.size(), 4u);
}

TEST(ObjReader, PassesOverWhatIsNeitherShapeNorLight) {
  EXPECT_EQ(names("vt 0 0\nvn nonsense\ns off\n" + kSquare + "s 1\nlod 1\nbevel on\nf 1 2 3 4\nusemap off\n"),
            std::vector<std::string>{"room room[0]"});
}

TEST(ObjReader, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refusal(kSquare + "F 1 2 3\n"), "in/room.obj:5: the keyword 'F' is not known");
  EXPECT_EQ(refusal(kSquare + "\x01\xff 1 2 3\n"), "in/room.obj:5: the keyword '\\x01\\xFF' is not known");
  for (const char* keyword : {"curv 0 1 1 2", "vp 1 2", "cstype bezier"})
    EXPECT_THAT(refusal(kSquare + keyword + "\n"), HasSubstr("curved surfaces are no plane faces"));
}

TEST(ObjReader, RefusesWhatIsNoMesh) {
  for (const char* text : {"", "\n\n", "# nothing\n", "v 0 0 0\n"})
    EXPECT_EQ(refusal(text), "in/room.obj: has no faces") << text;
  EXPECT_THAT(refusal("\xEF\xBB\xBFv 0 0 0\n"), HasSubstr("room.obj:1: the file begins with a byte order mark"));
  EXPECT_THAT(refusal(std::string("v 0 0 0\nv\0 0 0\n", 16)), HasSubstr("room.obj:2: the line has a NUL byte"));
  EXPECT_THAT(refusal("{\"hottel\": 1}\n"), HasSubstr("the keyword '{\"hottel\":' is not known"));
}

constexpr const char* kMaterials =
    "newmtl grey\nNs 10\nKd 0.8 0.8 .80\nillum 2\nmap_Kd wood.png\n"
    "newmtl lamp light\nKe 9 8 1/3\nnewmtl unused\nKd 1\n";

TEST(ObjReader, TakesMaterialsFromMtlFiles) {
  const MeshScene3 read =
      scene_of(parse_obj_3("mtllib my room.mtl\n" + kSquare +
                               "v 0 0 1\nusemtl lamp light\nf 1 2 5\nusemtl grey\nf 1 2 3 4\nusemtl\nf 1 4 5\n",
                           "in/room.obj", source_of({{"in/my room.mtl", kMaterials}})));
  const Scene3& scene = read.scene;
  ASSERT_EQ(scene.materials.size(), 3u);  // those that faces have, in the order of the faces
  EXPECT_EQ(scene.materials[0].name, "lamp light");
  EXPECT_EQ(scene.materials[0].reflectivity, Spectrum());
  EXPECT_EQ(scene.materials[0].emission.value[2], Rational(1) / 3);
  EXPECT_FALSE(scene.materials[0].emission.is_scalar);
  EXPECT_EQ(scene.materials[1].name, "grey");
  EXPECT_EQ(scene.materials[1].reflectivity.value[0], Rational(4) / 5);
  EXPECT_TRUE(scene.materials[1].reflectivity.is_scalar);
  EXPECT_EQ(scene.materials[2].name, "white");
  EXPECT_EQ(scene.materials[2].reflectivity.value[0], kMeshReflectivity);
  EXPECT_THAT(read.invented, ElementsAre("white"));
  EXPECT_EQ(scene.surfaces[1].material, 1u);
}

TEST(ObjReader, MakesUpMaterialsWhereThereIsNoMtlFile) {
  const MeshScene3 read =
      scene_of(parse_obj_3(kSquare + "v 0 0 1\nusemtl oak\nf 1 2 5\nf 1 4 5\n", "a.obj", source_of({})));
  ASSERT_EQ(read.scene->materials.size(), 1u);
  EXPECT_EQ(read.scene->materials[0].name, "oak");
  EXPECT_THAT(read.invented, ElementsAre("oak"));
}

TEST(ObjReader, ReadsSeveralMtlFilesAndEachOnce) {
  const Files files{{"in/a.mtl", "newmtl a\n"}, {"in/b c.mtl", "newmtl b\n"}};
  EXPECT_EQ(refusal("mtllib a.mtl b c.mtl\nmtllib a.mtl\n" + kSquare + "usemtl b\nf 1 2 3\n", files), "");
  EXPECT_EQ(refusal("mtllib a.mtl\nmtllib other.mtl\n", {{"in/a.mtl", "newmtl a\n"}, {"in/other.mtl", "newmtl a\n"}}),
            "in/room.obj:2: the material 'a' stands in two MTL files");
}

TEST(ObjReader, RefusesMaterialsThatAreNotThere) {
  EXPECT_EQ(refusal("mtllib lost.mtl\n"), "in/room.obj:1: the file of materials in/lost.mtl: is not there");
  EXPECT_EQ(refusal("mtllib\n"), "in/room.obj:1: mtllib names no file");
  EXPECT_EQ(refusal("mtllib a.mtl\n" + kSquare + "usemtl gray\nf 1 2 3\n", {{"in/a.mtl", kMaterials}}),
            "in/room.obj:6: the material 'gray' is not defined");
  EXPECT_EQ(refusal("mtllib a.mtl\n" + kSquare + "usemtl white\nf 1 2 3\n", {{"in/a.mtl", kMaterials}}),
            "in/room.obj:6: the material 'white' is not defined");
}

TEST(ObjReader, PassesOverAMissingMtlFileWhereNoMaterialOfItIsNeeded) {
  const TextSource none = [](const std::filesystem::path& file) -> std::string {
    throw MissingFile({file.string(), 0}, "there is no such file");
  };
  PassedOver passed_over;
  const Mesh3 mesh = parse_obj_3(kSquare + "mtllib no.mtl\nusemtl a\nf 1 2 3\n", "in/room.obj", none);
  EXPECT_EQ(scene_of(mesh, nullptr, &passed_over).scene->materials[0].name, "a");
  EXPECT_EQ(passed_over.note(), "1 missing file of materials passed over: 'in/no.mtl' at in/room.obj:5");
  // One that is there says what its materials are; what only the other could say is refused.
  const TextSource one = [](const std::filesystem::path& file) -> std::string {
    if (file == "in/a.mtl") return "newmtl a\n";
    throw MissingFile({file.string(), 0}, "there is no such file");
  };
  const std::string both = kSquare + "mtllib a.mtl\nmtllib no.mtl\n";
  EXPECT_EQ(refusal_by([&] { scene_of(parse_obj_3(both + "usemtl a\nf 1 2 3\n", "in/room.obj", one)); }), "");
  EXPECT_EQ(refusal_by([&] { scene_of(parse_obj_3(both + "usemtl b\nf 1 2 3\n", "in/room.obj", one)); }),
            "in/room.obj:7: the material 'b' is not defined");
}

TEST(ObjReader, RefusesWrongMtlFilesByTheirLines) {
  const auto of = [](const std::string& text) { return refusal("mtllib a.mtl\n", {{"in/a.mtl", text}}); };
  EXPECT_EQ(of("newmtl a\nKd 1.5 0 0\n"), "in/a.mtl:2: Kd must be from 0 to 1");
  EXPECT_EQ(of("newmtl a\nKe -1\n"), "in/a.mtl:2: Ke must not be negative");
  EXPECT_EQ(of("newmtl a\n\nKd 1 x 0\n"), "in/a.mtl:3: Kd is not a number: 'x'");
  EXPECT_EQ(of("newmtl a\nKd spectral file.rfl\n"), "in/a.mtl:2: Kd must have one number or three: r, g and b");
  EXPECT_EQ(of("newmtl a\nKd\n"), "in/a.mtl:2: Kd must have one number or three: r, g and b");
  EXPECT_EQ(of("newmtl a\nKd 1\nKd 1\n"), "in/a.mtl:3: material 'a' has Kd twice");
  EXPECT_EQ(of("Ke 1\nnewmtl a\n"), "in/a.mtl:1: Ke stands before any newmtl");
  EXPECT_EQ(of("newmtl a\nnewmtl a\n"), "in/a.mtl:2: two materials have the name 'a', the other one in line 1");
  EXPECT_EQ(of("newmtl\n"), "in/a.mtl:1: the name of a material must not be empty");
}

}  // namespace
}  // namespace hottel::obj_reader_test

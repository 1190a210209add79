#include "io/scene/space/mesh_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "io/scene/exact_decimal.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_pieces.h"
#include "kernel/support/failure.h"
#include "tests/io/space/mesh_bytes.h"

namespace hottel::mesh_writer_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr MeshFormat3 kAll[] = {MeshFormat3::kObj, MeshFormat3::kPly, MeshFormat3::kOff, MeshFormat3::kStl};

Scene3 scene_file(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
}

Scene3 scene_of_polygons(const std::string& polygons, const std::string& more = "") {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"white": {"reflectivity": 0.5},
                          "red": {"reflectivity": [0.5, 0.1, 0.1]}, "lamp": {"emission": "1/3"}},
                          "polygons": [)" +
                           polygons + "]" + more + "}",
                       "in/scene.json");
}

Scene3 read_back(const WrittenMesh3& mesh, MeshFormat3 format, const std::string& file) {
  return scene_of(parse_mesh_3(format, mesh.bytes, file,
                               [&](const std::filesystem::path& path) {
                                 EXPECT_EQ(path.filename(), "room.mtl");
                                 return mesh.library;
                               }))
      .scene;
}

TEST(MeshWriter, FacesReadBackExactly) {
  for (const char* name : {"cube.json", "two_boxes.json", "room_axis.obj", "room_turned.obj", "room_boxes.obj"}) {
    const Scene3 scene = scene_file(name);
    for (const MeshFormat3 format : kAll) {
      const WrittenMesh3 mesh = write_mesh_3(scene, format, "room.mtl");
      if (format == MeshFormat3::kStl) continue;
      EXPECT_EQ(read_back(mesh, format, "room").polygons, scene.polygons) << name;
      for (const std::string& note : mesh.notes) EXPECT_THAT(note, Not(HasSubstr("rounded"))) << name;
    }
  }
}

TEST(MeshWriter, ObjKeepsGroupsAndMaterials) {
  for (const char* name : {"room_axis.obj", "room_turned.obj", "room_boxes.obj"}) {
    const Scene3 scene = scene_file(name);
    const WrittenMesh3 mesh = write_mesh_3(scene, MeshFormat3::kObj, "room.mtl");
    const Scene3 again = read_back(mesh, MeshFormat3::kObj, "room.obj");
    EXPECT_EQ(again.groups, scene.groups);
    EXPECT_EQ(again.materials, scene.materials);
    ASSERT_EQ(again.surfaces.size(), scene.surfaces.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      EXPECT_EQ(again.surfaces[s].name, scene.surfaces[s].name);
      EXPECT_EQ(again.surfaces[s].material, scene.surfaces[s].material);
    }
    for (const std::string& note : mesh.notes) EXPECT_THAT(note, StartsWith("materials that are not")) << note;
  }
}

constexpr const char* kSquare = R"({"name": "a", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "white"})";

TEST(MeshWriter, WritesTheTextsOfTheirFormats) {
  const Scene3 scene =
      scene_of_polygons(std::string(kSquare) +
                        R"(, {"name": "b", "points": [[0,0,0],[0,1,0],["1e-30","1e40",-0.125]], "material": "red"})");
  const WrittenMesh3 off = write_mesh_3(scene, MeshFormat3::kOff, "");
  EXPECT_EQ(off.bytes, "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1e-30 1e40 -0.125\n4 0 1 2 3\n3 0 3 4\n");
  EXPECT_EQ(write_mesh_3(scene, MeshFormat3::kPly, "").bytes,
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n1 1 0\n0 1 0\n1e-30 1e40 -0.125\n4 0 1 2 3\n3 0 3 4\n");
  const WrittenMesh3 obj = write_mesh_3(scene, MeshFormat3::kObj, "room.mtl");
  EXPECT_EQ(obj.bytes,
            "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1e-30 1e40 -0.125\n"
            "g a\nusemtl white\nf 1 2 3 4\ng b\nusemtl red\nf 1 4 5\n");
  EXPECT_EQ(obj.library, "newmtl white\nKd 0.5 0.5 0.5\n\nnewmtl red\nKd 0.5 0.1 0.1\n");
}

TEST(MeshWriter, LeavesOutMaterialsThatAMeshHasByItself) {
  const Scene3 scene =
      scene_of(parse_mesh_3(MeshFormat3::kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off")).scene;
  for (const MeshFormat3 format : kAll) {
    const WrittenMesh3 mesh = write_mesh_3(scene, format, "room.mtl");
    EXPECT_EQ(mesh.library, "");
    EXPECT_THAT(mesh.notes, IsEmpty());
    const Scene3 again = read_back(mesh, format, "a.x");
    EXPECT_EQ(again.polygons, scene.polygons);
    EXPECT_EQ(again.materials, scene.materials);
    EXPECT_EQ(again.groups, scene.groups);
  }
}

TEST(MeshWriter, RoundsWhatIsNoDecimalAndSaysHowFar) {
  const Scene3 scene = scene_of_polygons(
      R"({"name": "a", "points": [[0,0,5],["1/3",0,5],[0,0.1,5]], "material": "white"},
         {"name": "b", "points": [[0,0,0],[1,0,"1/21"],[1,1,"11/21"],[0,1,"10/21"]], "material": "white"})");
  for (const MeshFormat3 format : {MeshFormat3::kObj, MeshFormat3::kPly, MeshFormat3::kOff}) {
    const WrittenMesh3 mesh = write_mesh_3(scene, format, "");
    ASSERT_GE(mesh.notes.size(), 1u);
    EXPECT_EQ(mesh.notes[0],
              "4 of 21 coordinates are no decimals and are rounded to doubles; the worst is off by "
              "2.6433881538694202e-17: z = 11/21 of a corner of 'b'");
    EXPECT_TRUE(read_back(mesh, format, "a.x").polygons[1].is_nearly_plane);
    EXPECT_THAT(mesh.bytes, HasSubstr("0.3333333333333333 0 5\n"));
    EXPECT_THAT(mesh.bytes, HasSubstr("0 0.1 5\n"));
  }
}

TEST(MeshWriter, StlHasTheNearestFloatsAndSaysHowFarTheyAreOff) {
  const Rational tie = Rational(1) + Rational(1, 1 << 24),
                 above = tie + Rational(1) / Integer("1" + std::string(40, '0'));
  const Scene3 scene = scene_of_polygons(R"({"name": "a", "points": [[0,0,0],[")" + to_string(tie) + R"(",0,0],[0,")" +
                                         to_string(above) + R"(",0.1]], "material": "white"})");
  const WrittenMesh3 mesh = write_mesh_3(scene, MeshFormat3::kStl, "");
  EXPECT_THAT(mesh.notes,
              Contains(HasSubstr("3 of 9 coordinates are no floats and are rounded to floats; the worst is off by "
                                 "5.960464477539063e-08: ")));
  const Scene3 again = read_back(mesh, MeshFormat3::kStl, "a.stl");
  EXPECT_EQ(again.polygons[0].points[1].x, 1);  // half-way: to even; a double would not tell the next one from it
  EXPECT_EQ(again.polygons[0].points[2].y, Rational(1) + Rational(1, 1 << 23));
  EXPECT_EQ(again.polygons[0].points[2].z, Rational(0.1f));
  // A sliver that rounding makes a line.
  const std::string high = to_string(Rational(1) + Rational(1) / Integer("1" + std::string(40, '0')));
  const Scene3 sliver =
      scene_of_polygons(R"({"name": "s", "points": [[0,1,0],[1,1,0],[2,")" + high + R"(",0]], "material": "white"})");
  EXPECT_THAT(write_mesh_3(sliver, MeshFormat3::kStl, "").notes,
              testing::AllOf(Contains(HasSubstr("of a corner of 's'")),
                             Contains(HasSubstr("no polygons any more: 's'; the first has no area"))));
}

TEST(MeshWriter, StlHasNoZeroForWhatIsNotZero) {
  const Scene3 sliver =
      scene_of_polygons(R"({"name": "s", "points": [[0,0,0],[1,0,0],[2,"1e-60",0]], "material": "white"})");
  EXPECT_THAT([&] { write_mesh_3(sliver, MeshFormat3::kStl, ""); },
              testing::ThrowsMessage<RequestError>(HasSubstr("the coordinate 1e-60 is below the least float")));
}

TEST(MeshWriter, StlIsCutIntoTrianglesWithUnitNormals) {
  const Scene3 scene = scene_of_polygons(kSquare);
  const WrittenMesh3 mesh = write_mesh_3(scene, MeshFormat3::kStl, "");
  EXPECT_EQ(mesh.bytes.size(), 84u + 2 * 50);
  EXPECT_THAT(mesh.notes, Contains("1 of 1 polygons are cut into triangles: 2 faces"));
  for (std::size_t triangle = 0; triangle < 2; ++triangle)
    EXPECT_EQ(mesh.bytes.substr(84 + 50 * triangle, 12), testing_mesh::bytes<float>({0, 0, 1}));
}

TEST(MeshWriter, TellsEachLossOnce) {
  const Scene3 scene = scene_of_polygons(
      std::string(kSquare) +
          R"(, {"name": "b", "points": [[0,0,1],[0,1,1],[1,0,1]], "material": "lamp", "back": "red"})",
      R"(, "closed": true, "sky": {"emission": 1}, "about": "two",
         "camera": {"eye": [1, 0.2, 1.5], "target": [1, 3, 1]})");
  for (const MeshFormat3 format : {MeshFormat3::kPly, MeshFormat3::kOff})
    EXPECT_THAT(
        write_mesh_3(scene, format, "").notes,
        ElementsAre("materials that are not in the file: 'red', 'lamp'", "backs that are not in the file: of 'b'",
                    "names that are not in the file, its faces are NAME[k]: 'a', 'b'",
                    "not kept in the file: the sky, the promise \"closed\", the camera, the text about the scene"));
  EXPECT_THAT(
      write_mesh_3(scene, MeshFormat3::kObj, "m.mtl").notes,
      ElementsAre("materials that are no decimals are rounded to doubles: 'lamp'",
                  "materials that are not in the file: 'red'", "backs that are not in the file: of 'b'",
                  "names that are not in the file, its faces are GROUP[k]: 'a', 'b'",
                  "not kept in the file: the sky, the promise \"closed\", the camera, the text about the scene"));
}

TEST(MeshWriter, RefusesWhatTheFormatCannotHold) {
  const auto refusal = [](const Scene3& scene, MeshFormat3 format) -> std::string {
    try {
      write_mesh_3(scene, format, "m.mtl");
    } catch (const RequestError& error) {
      return error.what();
    }
    return "";
  };
  for (const MeshFormat3 format : kAll)
    EXPECT_EQ(refusal(Scene3(), format), "the scene has no polygons: there is nothing to write as a mesh");
  const Scene3 large = scene_of_polygons(R"({"points": [[0,0,0],["1e39",0,0],[0,1,0]], "material": "white"})");
  EXPECT_THAT(refusal(large, MeshFormat3::kStl), HasSubstr("is beyond the largest float, which STL has"));
  EXPECT_EQ(refusal(large, MeshFormat3::kPly), "");
  const Scene3 obstruction =
      scene_of_polygons(R"({"name": "post", "points": [[0,0,0],[1,0,0],[0,1,0]], "obstruction": true})");
  for (const MeshFormat3 format : kAll)
    EXPECT_THAT(refusal(obstruction, format), HasSubstr("'post' is an obstruction, which a mesh file cannot hold"));
  for (const char* name : {" a", "a ", "a  b", "a\\\\", "a.mtl b"})
    EXPECT_THAT(refusal(scene_of_polygons(R"({"points": [[0,0,0],[1,0,0],[0,1,0]], "material": "white", "group": ")" +
                                          std::string(name) + "\"}"),
                        MeshFormat3::kObj),
                HasSubstr("an OBJ file cannot hold the name"))
        << name;
}

// Sum of normals: that of the polygon iff the triangles cover it once, their fronts with its front.
void expect_triangles_of(const Polygon3& polygon) {
  Vector3 sum;
  for (const Polygon3& triangle : mesh_triangles(polygon)) {
    EXPECT_EQ(triangle.points.size(), 3u);
    EXPECT_EQ(polygon_problem(triangle).text, "");
    const Vector3 area = doubled_area(triangle);
    EXPECT_GT(dot(area, doubled_area(polygon)), 0);
    sum = {sum.x + area.x, sum.y + area.y, sum.z + area.z};
    for (const Point3& point : triangle.points) EXPECT_TRUE(contains(polygon, point));
  }
  EXPECT_EQ(sum, doubled_area(polygon));
}

TEST(MeshTriangles, CoverThePolygonAndHaveAreas) {
  const Polygon3 square{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  EXPECT_EQ(mesh_triangles(square).size(), 2u);
  expect_triangles_of(square);
  // Points in the middle of sides, wherever the points begin: a triangle with 0 to 4 of them on each side.
  for (int code = 0; code < 125; ++code) {
    const int on[3] = {code % 5, code / 5 % 5, code / 25};
    const Point3 corner[3] = {{0, 0, 2}, {5, 0, 7}, {0, 10, 2}};
    std::vector<Point3> points;
    for (int side = 0; side < 3; ++side)
      for (int k = 0; k <= on[side]; ++k) {
        const Point3 &a = corner[side], &b = corner[(side + 1) % 3];
        const Rational t = Rational(k) / (on[side] + 1);
        points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
      }
    for (std::size_t begin = 0; begin < points.size(); ++begin) {
      const Polygon3 polygon{points};
      EXPECT_EQ(mesh_triangles(polygon).size(), points.size() - 2);
      expect_triangles_of(polygon);
      std::rotate(points.begin(), points.begin() + 1, points.end());
    }
  }
}

TEST(MeshTriangles, CoverPolygonsThatAreNotConvexOrHaveHoles) {
  // An L, and a frame whose second hole touches the outline; both sides of both.
  Polygon3 corner{{{0, 0, 0}, {2, 0, 2}, {2, 1, 2}, {1, 1, 1}, {1, 2, 1}, {0, 2, 0}}};
  Polygon3 frame{{{0, 0, 3}, {9, 0, 3}, {9, 9, 3}, {0, 9, 3}},
                 {{{1, 1, 3}, {2, 1, 3}, {2, 2, 3}, {1, 2, 3}}, {{5, 5, 3}, {6, 6, 3}, {9, 5, 3}}}};
  EXPECT_EQ(mesh_triangles(corner).size(), 4u);
  for (Polygon3* polygon : {&corner, &frame})
    for (int side = 0; side < 2; ++side) {
      expect_triangles_of(*polygon);
      std::reverse(polygon->points.begin(), polygon->points.end());
    }
}

TEST(MeshWriter, FacesWithHolesAreCutInEveryFormat) {
  const std::string window = R"({"name": "a", "points": [[0,0,0],[3,0,0],[3,3,0],[0,3,0]],
                                 "holes": [[[1,1,0],[2,1,0],[2,2,0],[1,2,0]]], "material": "white"})";
  const Scene3 scene = scene_of_polygons(window);
  for (const MeshFormat3 format : kAll) {
    const WrittenMesh3 mesh = write_mesh_3(scene, format, "");
    EXPECT_THAT(mesh.notes, Contains("1 of 1 polygons are cut into triangles: 8 faces"));
    Vector3 sum;
    for (const Polygon3& polygon : read_back(mesh, format, "a").polygons) {
      const Vector3 area = doubled_area(polygon);
      sum = {sum.x + area.x, sum.y + area.y, sum.z + area.z};
    }
    EXPECT_EQ(sum, (Vector3{0, 0, 16}));
  }
  // One that is not convex stays whole where it can.
  const Scene3 corner = scene_of_polygons(
      R"({"name": "a", "points": [[0,0,0],[2,0,0],[2,1,0],[1,1,0],[1,2,0],[0,2,0]], "material": "white"})");
  EXPECT_EQ(read_back(write_mesh_3(corner, MeshFormat3::kOff, ""), MeshFormat3::kOff, "a").polygons, corner.polygons);
  EXPECT_EQ(read_back(write_mesh_3(corner, MeshFormat3::kStl, ""), MeshFormat3::kStl, "a").polygons.size(), 4u);
}

TEST(ExactDecimal, ReadsBackToTheSameValue) {
  EXPECT_EQ(exact_decimal_text(Rational(-1, 8)), "-0.125");
  EXPECT_EQ(exact_decimal_text(0), "0");
  EXPECT_EQ(exact_decimal_text(1200), "1200");
  EXPECT_EQ(exact_decimal_text(*parse_rational("1e-30")), "1e-30");
  EXPECT_EQ(exact_decimal_text(*parse_rational("1e30")), "1e30");
  EXPECT_EQ(exact_decimal_text(Rational(1, 3)), std::nullopt);
  EXPECT_EQ(exact_decimal_text(*parse_rational("1e-4096") / 10), std::nullopt);
  EXPECT_EQ(exact_decimal_text(*parse_rational("1e4096") * 3 + 1), std::nullopt);  // 4097 digits
  std::mt19937_64 random(7);
  for (int round = 0; round < 2000; ++round) {
    Rational value(static_cast<long>(random() >> (round % 60)));
    value *= round % 2 == 0 ? 1 : -1;
    for (std::uint64_t k = random() % 40; k > 0; --k) value /= random() % 2 == 0 ? 2 : 5;
    for (std::uint64_t k = random() % 40; k > 0; --k) value *= 10;
    const auto text = exact_decimal_text(value);
    ASSERT_TRUE(text) << value;
    EXPECT_EQ(parse_rational(*text), value) << *text;
  }
}

}  // namespace
}  // namespace hottel::mesh_writer_test

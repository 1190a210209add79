// hottel convert from meshes and to meshes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::mesh_convert_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::Outcome;
using testing_cli::Workplace;

TEST(MeshConvert, MeshesBecomeMeshesExactly) {
  const Workplace place;
  place.write("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 .25 0\n0 0 -1.5\n3 0 1 2\n3 0 3 1\n");
  const Outcome outcome = place.run(
      "hottel convert a.off a.ply && hottel convert a.ply a.stl && hottel convert a.stl a.obj && "
      "hottel convert a.obj b.off && hottel convert b.off b.json --quiet && hottel convert a.off c.json --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(place.read("b.off"), "OFF\n4 2 0\n0 0 0\n1 0 0\n0 0.25 0\n0 0 -1.5\n3 0 1 2\n3 0 3 1\n");
  EXPECT_EQ(place.files(), (std::vector<std::string>{"a.obj", "a.off", "a.ply", "a.stl", "b.json", "b.off", "c.json"}));
  for (const char* file : {"a.off", "a.ply", "a.stl", "a.obj"}) {
    const Outcome factors = place.run(std::string("hottel factors ") + file + " --quiet");
    EXPECT_EQ(factors.code, 0) << factors.err;
    EXPECT_THAT(factors.out, HasSubstr("a[0],"));
  }
}

TEST(MeshConvert, WhatAMeshDoesNotHoldIsTold) {
  const Workplace place;
  place.write("third.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.25}, "n": {}},
    "polygons": [{"name": "w", "points": [[0, 0, 0], ["1/3", 0, 0], [0, 0.1, 0]], "material": "m", "back": "n"}],
    "sky": {"emission": 1}})");
  const Outcome ply = place.run("hottel convert third.json a.ply");
  EXPECT_EQ(ply.code, 0);
  EXPECT_EQ(ply.err,
            "1 of 9 coordinates are no decimals and are rounded to doubles; the worst is off by 1.850371707708594e-17: "
            "x = 1/3 of a corner of 'w'\n"
            "materials that are not in the file: 'm', 'n'\n"
            "backs that are not in the file: of 'w'\n"
            "names that are not in the file, its faces are NAME[k]: 'w'\n"
            "not kept in the file: the sky\n");
  const Outcome stl = place.run("hottel convert third.json a.stl");
  EXPECT_EQ(stl.code, 0);
  EXPECT_THAT(stl.err, StartsWith("2 of 9 coordinates are no floats and are rounded to floats; the worst is off by "));
  EXPECT_EQ(place.run("hottel convert third.json a.obj --quiet").err, "");
  EXPECT_EQ(place.read("a.mtl"), "newmtl m\nKd 0.25 0.25 0.25\n");
  EXPECT_THAT(place.read("a.obj"), StartsWith("mtllib a.mtl\nv 0 0 0\nv 0.3333333333333333 0 0\n"));
}

TEST(MeshConvert, MeshesThatCannotBeWrittenLeaveWhatWasThere) {
  const Workplace place;
  place.write("old.stl", "old");
  place.write("old.mtl", "old");
  place.write("plane.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [{"points": [[0, 0], [1, 0]], "material": "m"}]})");
  place.write("large.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {}},
    "polygons": [{"points": [[0, 0, 0], [1e39, 0, 0], [0, 1, 0]], "material": "m"}]})");
  const Outcome plane = place.run("hottel convert plane.json old.stl");
  EXPECT_EQ(plane.code, 3);
  EXPECT_THAT(plane.err, StartsWith("plane.json: the scene is in the plane (dimension 2)"));
  const Outcome large = place.run("hottel convert large.json old.stl");
  EXPECT_EQ(large.code, 1);
  EXPECT_THAT(large.err, StartsWith("large.json: the coordinate 1e+39 is beyond the largest float"));
  const Outcome blocked = place.run("mkdir old.obj && hottel convert large.json old.obj");
  EXPECT_EQ(blocked.code, 3);
  EXPECT_EQ(place.read("old.stl") + place.read("old.mtl"), "oldold");
  EXPECT_EQ(place.files(), (std::vector<std::string>{"large.json", "old.mtl", "old.obj", "old.stl", "plane.json"}));
}

}  // namespace
}  // namespace hottel::mesh_convert_test

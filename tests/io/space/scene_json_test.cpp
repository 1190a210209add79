// Scenes in space: what is read from JSON, what is refused, and that what is written reads back to the same scene.
#include "io/scene/scene_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "kernel/support/failure.h"
#include "tests/refusal.h"

namespace hottel::scene_json_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Files = std::map<std::string, std::string>;

Scene3 parse(const std::string& text, const Files& files = {}) {
  return parse_scene_3(text, "in/scene.json", [&](const std::filesystem::path& path) {
    const auto found = files.find(path.string());
    if (found == files.end()) throw InputError({path.string(), 0}, "is not there");
    return found->second;
  });
}

std::string refusal(const std::string& text, const Files& files = {}) {
  return refusal_by([&] { parse(text, files); });
}

// A scene with these further members, which begin in line 3.
std::string scene_with(const std::string& members) {
  return "{ \"hottel\": 1, \"dimension\": 3,\n  \"materials\": {\"m\": {}, \"n\": {\"reflectivity\": 0.5}},\n  " +
         members + "}\n";
}
// A scene with these polygons, from line 4 on.
std::string with_polygons(const std::string& polygons) { return scene_with("\"polygons\": [\n" + polygons + "]"); }
std::string with_camera(const std::string& members) { return scene_with("\"camera\": {" + members + "}"); }
std::string with_mesh(const std::string& members) {
  return scene_with("\"mesh\": {\"file\": \"a.obj\"" + members + "}");
}

constexpr const char* kTriangle = "\"points\": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";

const Files kFiles{{"in/a.obj", "v 0 0 0\nv 1 0 0\nv 0.5 2 0\nv 0 0 3\nf 1 2 3\ng box\nusemtl n\nf 1 2 4\nf 2 3 4\n"},
                   {"in/meshes/b.obj", "mtllib b.mtl\nv 9 0 0\nv 9 1 0\nv 9 0 1\nusemtl x\nf 1 2 3\n"},
                   {"in/meshes/b.mtl", "newmtl x\nKd 0.25\n"},
                   {"in/meshes/c.obj", "mtllib c.mtl\nv 8 0 0\nv 8 1 0\nv 8 0 1\nusemtl x\nf 1 2 3\n"},
                   {"in/meshes/c.mtl", "newmtl x\nKd 0.75\n"}};

TEST(SceneJson3, ReadsEveryPartOfAScene) {
  const Scene3 scene = parse(R"({ "hottel": 1, "dimension": 3, "about": "a room",
    "materials": { "white": {"reflectivity": 0.7}, "lamp": {"emission": [9, 8, 6]} },
    "polygons": [ {"name": "wall", "points": [[0,0,0],[1,0,"1/3"],[0,0.1,0]], "material": "white", "back": "lamp",
                   "elements": 4, "about": "plaster", "holes": []},
                  {"points": [[0,0,5],[1,0,5],[0,1,5]], "material": "lamp", "group": "box"},
                  {"points": [[0,0,6],[1,0,6],[0,1,6]], "material": "lamp", "group": "box"} ],
    "edges": [], "polylines": [], "lights": [],
    "sky": {"emission": 2}, "closed": true,
    "camera": {"eye": [1,1,"1/3"], "target": [0,0,0], "up": [0,1,0], "field_of_view": 40.5, "pixels": [640, 480]},
    "expect": [ {"kind": "exact", "quantity": "factor", "of": ["wall", "sky"], "value": 1} ] })");
  EXPECT_EQ(scene.file, "in/scene.json");
  EXPECT_EQ(scene.about, "a room");
  ASSERT_EQ(scene.surfaces.size(), 3u);
  EXPECT_EQ(scene.polygons[0].points[1], (Point3{1, 0, Rational(1) / 3}));
  EXPECT_EQ(scene.polygons[0].points[2].y, Rational(1) / 10);
  EXPECT_EQ(scene.surfaces[0].name, "wall");
  EXPECT_EQ(scene.surfaces[0].back, 1u);
  EXPECT_EQ(scene.surfaces[0].elements, 4u);
  EXPECT_EQ(scene.surfaces[0].line, 3);
  EXPECT_EQ(scene.surfaces[1].name, "polygon[1]");
  EXPECT_EQ(scene.surfaces[1].line, 5);
  EXPECT_THAT(scene.groups, ElementsAre(Group("wall"), Group("box")));
  EXPECT_EQ(scene.surfaces[1].group, 1u);
  EXPECT_EQ(scene.surfaces[2].group, 1u);
  EXPECT_EQ(scene.sky_emission.value[0], 2);
  EXPECT_TRUE(scene.closed);
  EXPECT_EQ(scene.camera, (Camera3{{1, 1, Rational(1) / 3}, {0, 0, 0}, {0, 1, 0}, Rational(81) / 2, 640, 480}));
  EXPECT_EQ(scene.expect.size(), 1u);
}

TEST(SceneJson3, ALightWithoutATypeIsToldWhichThereAre) {
  try {
    parse(scene_with("\"lights\": [{\"name\": \"bulb\"}]"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("in/scene.json:3: light 'bulb' has no \"type\""));
    EXPECT_THAT(error.hints(), ElementsAre(R"(it may be "point", "spot" or "sun")"));
  }
}

TEST(SceneJson3, RefusesWhatBelongsToThePlaneOrIsNotThereYet) {
  EXPECT_EQ(refusal(scene_with("\"edges\": [1]")),
            "in/scene.json:3: edges belong to dimension 2; this scene has dimension 3");
  EXPECT_EQ(refusal(scene_with("\"polylines\": [1]")),
            "in/scene.json:3: polylines belong to dimension 2; this scene has dimension 3");
  EXPECT_EQ(refusal(scene_with("\"lights\": [{}]")), "in/scene.json:3: light 'light[0]' has no \"type\"");
  const std::string polygon = std::string("{\"name\": \"a\", \"material\": \"m\", ") + kTriangle;
  for (const char* behind : {"solid", "open"}) {
    const std::string tail = std::string("\"behind\": \"") + behind + "\"}";
    EXPECT_EQ(
        refusal(with_polygons(polygon + ",\n" + tail)),
        "in/scene.json:5: polygon 'a': behind is for closed meshes: a \"mesh\", or the polygons of one \"group\"");
  }
  EXPECT_THAT(refusal(scene_with("\"unknown\": 1")), HasSubstr("has the unknown key 'unknown'"));
  EXPECT_THAT(refusal(with_polygons(polygon + ", \"closed\": true}")), HasSubstr("has the unknown key 'closed'"));
}

TEST(SceneJson3, RefusesWrongPolygonsByNameAndLine) {
  const auto points = [](const std::string& list) {
    return refusal(with_polygons("{\"name\": \"a\", \"material\": \"m\", \"points\": [" + list + "]}"));
  };
  EXPECT_EQ(points("[0,0], [1,0], [0,1]"),
            "in/scene.json:4: polygon 'a': point has 2 coordinates; in dimension 3 it has three");
  EXPECT_EQ(points("[0,0,0], [1,0,0]"), "in/scene.json:4: polygon 'a' has fewer than three points");
  EXPECT_EQ(points(""), "in/scene.json:4: polygon 'a' has fewer than three points");
  EXPECT_EQ(points("[0,0,0], [1,0,0], [2,0,0]"),
            "in/scene.json:4: polygon 'a' has no area: its points lie on one line");
  EXPECT_THAT(points("[0,0,0], [1,0,0], [1,1,0.1], [0,1,0]"), StartsWith("in/scene.json:4: polygon 'a' is not plane"));
  EXPECT_EQ(points("[0,0,0], [1,1,0], [1,0,0], [0,1,0]"),
            "in/scene.json:4: polygon 'a' crosses itself at the point (0.5, 0.5, 0)");
  EXPECT_THAT(points("[0,0,0], [1,0,\"x\"], [0,1,0]"),
              StartsWith("in/scene.json:4: polygon 'a': coordinate is not a number"));
  EXPECT_EQ(refusal(with_polygons(std::string("{\"name\": \"a\", ") + kTriangle + "}")),
            "in/scene.json:4: polygon 'a' has no \"material\"");
  EXPECT_THAT(refusal(with_polygons(std::string("{\"material\": \"x\", ") + kTriangle + "}")),
              StartsWith("in/scene.json:4: polygon 'polygon[0]': material 'x' is not defined"));
  const std::string a = std::string("{\"name\": \"a\", \"material\": \"m\", ") + kTriangle + "}";
  EXPECT_EQ(refusal(with_polygons(a + ",\n" + a)),
            "in/scene.json:5: two surfaces have the name 'a', the other one in line 4");
}

TEST(SceneJson3, ReadsHoles) {
  const auto with_holes = [](const std::string& holes) {
    return with_polygons(
        "{\"name\": \"a\", \"material\": \"m\", \"points\": [[0,0,0], [3,0,0], [3,3,0], [0,3,0]],\n\"holes\": " +
        holes + "}");
  };
  const Scene3 scene = parse(with_holes(R"([[[1,1,0], ["3/2",1,0], [1,2,0]], [[2,2,0], [2,3,0], [3,2,0]]])"));
  EXPECT_THAT(scene.polygons[0].holes,
              ElementsAre(ElementsAre(Point3{1, 1, 0}, Point3{Rational(3) / 2, 1, 0}, Point3{1, 2, 0}),
                          ElementsAre(Point3{2, 2, 0}, Point3{2, 3, 0}, Point3{3, 2, 0})));
  EXPECT_TRUE(parse(with_holes("[]")).polygons[0].holes.empty());
  EXPECT_THAT(refusal(with_holes("[[]]")), HasSubstr("fewer than three points"));
  EXPECT_EQ(refusal(with_holes("[[[1,1,0], [2,1,0], [3,1,0]]]")),
            "in/scene.json:4: polygon 'a' has a hole without an area: its points lie on one line");
  EXPECT_THAT(refusal(with_holes("[[[1,1,1], [2,1,1], [1,2,1]]]")), HasSubstr("polygon 'a' is not plane"));
  EXPECT_THAT(refusal(with_holes("[[[1,1,0], [2,1,0], [1,2]]]")), HasSubstr("2 coordinates"));
  EXPECT_EQ(refusal(with_holes("[[[4,4,0], [5,4,0], [4,5,0]]]")),
            "in/scene.json:4: polygon 'a' has holes that are not in it, or share an area");
  EXPECT_EQ(refusal(with_holes("[[[1,1,0], [2,1,0], [1,2,0]], [[1,1,0], [2,1,0], [2,2,0], [1,2,0]]]")),
            "in/scene.json:4: polygon 'a' has holes that are not in it, or share an area");
  EXPECT_EQ(refusal(with_holes("[[[1,1,0], [4,1,0], [4,2,0], [1,2,0]]]")),
            "in/scene.json:4: polygon 'a' crosses itself at the point (3, 1, 0)");
}

TEST(SceneJson3, TakesPolygonsThatOverlapOrAreNotConvex) {
  const std::string a = std::string("{\"name\": \"a\", \"material\": \"m\", ") + kTriangle + "}";
  const std::string b = std::string("{\"name\": \"b\", \"material\": \"n\", ") + kTriangle + "}";
  EXPECT_EQ(parse(with_polygons(a + ",\n" + b)).polygons.size(), 2u);
  const std::string points = "\"points\": [[0,0,0], [1,0,0], [0.2,0.2,0], [0,1,0]]";
  EXPECT_EQ(parse(with_polygons("{\"material\": \"m\", " + points + "}")).polygons[0].points.size(), 4u);
}

TEST(SceneJson3, GivesGroupsNamesOfTheirOwn) {
  const auto polygon = [](int z, const std::string& members) {
    const std::string at = ", " + std::to_string(z) + "]";
    return "{\"points\": [[0, 0" + at + ", [1, 0" + at + ", [0, 1" + at + "], \"material\": \"m\", " + members + "}";
  };
  EXPECT_EQ(refusal(with_polygons(polygon(0, R"("name": "a")") + ",\n" + polygon(1, R"("name": "b", "group": "a")"))),
            "in/scene.json:5: two groups have the name 'a', the other one in line 4");
  EXPECT_EQ(refusal(with_polygons(polygon(0, R"("name": "a", "group": "a")"))), "");
  EXPECT_EQ(refusal(with_polygons(polygon(0, R"("group": "x#1")"))),
            "in/scene.json:4: polygon 'polygon[0]': the group 'x#1' must not contain '#'");
}

TEST(SceneJson3, RefusesWrongCameras) {
  const std::string good = R"("eye": [0, 0, 0], "target": [1, 0, 0])";
  EXPECT_EQ(parse(with_camera(good)).camera, (Camera3{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(refusal(with_camera(R"("eye": [0, 0, 0])")), "in/scene.json:3: camera has no \"target\"");
  EXPECT_EQ(refusal(with_camera(R"("target": [0, 0, 0])")), "in/scene.json:3: camera has no \"eye\"");
  EXPECT_THAT(refusal(with_camera(good + ", \"up\": [2, 0, 0]")), HasSubstr("it looks along \"up\""));
  EXPECT_THAT(refusal(with_camera(good + ", \"pixels\": [0, 5]")), HasSubstr("camera: pixels must be an integer"));
  EXPECT_THAT(refusal(with_camera(good + ", \"pixels\": [5]")), HasSubstr("two numbers, width and height"));
  EXPECT_THAT(refusal(with_camera(good + ", \"zoom\": 2")), HasSubstr("unknown key 'zoom'"));
}

TEST(SceneJson3, ReadsAGridAndRefusesWrongOnes) {
  const auto with_grid = [](const std::string& members) { return scene_with("\"grid\": {" + members + "}"); };
  const std::string good = R"("origin": [0, "1/3", 1], "u": [2, 0, 0], "v": [0, 0.5, 0])";
  const Grid3 grid{{0, Rational(1) / 3, 1}, {2, 0, 0}, {0, Rational(1) / 2, 0}, 4, 3};
  EXPECT_EQ(parse(with_grid(good + R"(, "cells": [4, 3])")).grids, std::vector{grid});
  EXPECT_EQ(refusal(with_grid(good)), "in/scene.json:3: grid has no \"cells\"");
  EXPECT_THAT(refusal(with_grid(good + ", \"cells\": [4]")), HasSubstr("two numbers, along u and along v"));
  EXPECT_THAT(refusal(with_grid(good + ", \"cells\": [4, 0]")), HasSubstr("grid: cells must be an integer"));
  EXPECT_THAT(refusal(with_grid(good + ", \"cells\": [4, 20000]")), HasSubstr("grid: cells must be an integer"));
  EXPECT_THAT(refusal(with_grid(R"("origin": [0,0,0], "u": [1,2,3], "v": [2,4,6], "cells": [1,1])")),
              HasSubstr("grid: u and v are parallel, or one is zero"));
  EXPECT_THAT(refusal(with_grid(R"("min": [0,0], "max": [1,1], "cells": [1,1])")), HasSubstr("unknown key 'min'"));
}

TEST(SceneJson3, ReadsVolumesAndWritesThem) {
  const auto with_grid = [](const std::string& members) { return scene_with("\"grid\": {" + members + "}"); };
  const std::string sides = R"("origin": [0, "1/3", 1], "u": [2, 0, 0], "v": [0, 1, 0])";
  const Grid3 grid{{0, Rational(1) / 3, 1}, {2, 0, 0}, {0, 1, 0}, 4, 3, "", Vector3{0, 1, 2}, 5};
  const Scene3 scene = parse(with_grid(sides + R"(, "w": [0, 1, 2], "cells": [4, 3, 5])"));
  EXPECT_EQ(scene.grids, std::vector{grid});
  EXPECT_EQ(grid.cells(), 60U);
  EXPECT_EQ(parse(write_scene_3(scene)).grids, scene.grids);
  EXPECT_THAT(refusal(with_grid(sides + R"(, "w": [0, 1, 2], "cells": [4, 3])")),
              HasSubstr("three numbers, along u, v and w"));
  EXPECT_THAT(refusal(with_grid(sides + R"(, "cells": [4, 3, 5])")), HasSubstr("a third is of a grid with \"w\""));
  EXPECT_THAT(refusal(with_grid(sides + R"(, "w": [3, 4, 0], "cells": [4, 3, 5])")),
              HasSubstr("grid: w lies in the plane of u and v"));
}

TEST(SceneJson3, ReadsAListOfGridsWithNames) {
  const std::string place = R"("origin": [0, 0, 1], "u": [2, 0, 0], "v": [0, 1, 0], "cells": [4, 3])";
  const auto with_grids = [&](const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
      list += (list.empty() ? "{" : ", {") + (name.empty() ? "" : "\"name\": \"" + name + "\", ") + place + "}";
    return scene_with("\"grid\": [" + list + "]");
  };
  const Scene3 scene = parse(with_grids({"floor", "desk 1"}));
  ASSERT_EQ(scene.grids.size(), 2u);
  EXPECT_EQ(scene.grids[0].name, "floor");
  EXPECT_EQ(scene.grids[1], (Grid3{{0, 0, 1}, {2, 0, 0}, {0, 1, 0}, 4, 3, "desk 1"}));
  EXPECT_EQ(parse(write_scene_3(scene)).grids, scene.grids);
  EXPECT_EQ(parse(write_scene_3(parse(with_grids({"a"})))).grids, parse(with_grids({"a"})).grids);
  EXPECT_THAT(refusal(with_grids({})), HasSubstr("grid: the list is empty"));
  EXPECT_THAT(refusal(with_grids({""})), HasSubstr("grid has no \"name\""));
  EXPECT_THAT(refusal(with_grids({"a", "a"})), HasSubstr("grid: two are called 'a'"));
  EXPECT_THAT(refusal(with_grids({"a/b"})), HasSubstr("part of the names of files"));
  EXPECT_THAT(refusal(with_grids({std::string(101, 'a')})), HasSubstr("longer than 100 bytes"));
}

TEST(SceneJson3, AddsMeshesAfterPolygons) {
  const Scene3 scene = parse(scene_with(R"("mesh": [{"file": "a.obj", "name": "house", "material": "m", "back": "n",
        "scale": "1/3", "elements": 2},
      {"file": "meshes/b.obj"}],
    "polygons": [{"name": "last", "points": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], "material": "m"}])"),
                             kFiles);
  std::vector<std::string> names;
  for (const Surface& surface : scene.surfaces) names.push_back(surface.name);
  EXPECT_THAT(names, ElementsAre("last", "house[0]", "box[0]", "box[1]", "mesh[1][0]"));
  EXPECT_THAT(scene.groups, ElementsAre(Group("last"), Group("house"), Group("box"), Group("mesh[1]")));
  EXPECT_EQ(scene.polygons[1].points[2], (Point3{Rational(1) / 6, Rational(2) / 3, 0}));
  EXPECT_EQ(scene.polygons[4].points[0], (Point3{9, 0, 0}));
  EXPECT_EQ(scene.surfaces[1].material, 0u);
  EXPECT_EQ(scene.surfaces[2].material, 1u);  // the scene's own 'n'
  EXPECT_EQ(scene.surfaces[2].back, 1u);
  EXPECT_EQ(scene.surfaces[2].elements, 2u);
  EXPECT_EQ(scene.surfaces[2].line, 3);
  EXPECT_EQ(scene.surfaces[4].line, 5);
  EXPECT_EQ(place_of(scene, scene.surfaces[0]).file, "in/scene.json");
  EXPECT_EQ(place_of(scene, scene.surfaces[2]).file, "in/a.obj");
  EXPECT_EQ(place_of(scene, scene.surfaces[2]).line, 8);
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[2].name, "x");
  EXPECT_EQ(scene.materials[2].reflectivity, Spectrum::scalar(Rational(1) / 4));
}

TEST(SceneJson3, AddsMeshesOfEveryFormat) {
  const Files files{
      {"in/a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
       "1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 0.1 0\n3 0 1 2\n"},
      {"in/b.OFF", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 0.1 1\n3 0 1 2\n"},
      {"in/c.stl",
       "solid c\nfacet normal 0 0 1\nouter loop\nvertex 0 0 2\nvertex 1 0 2\nvertex 0 0.1 2\nendloop\nendfacet\n"
       "endsolid c\n"}};
  const Scene3 scene = parse(scene_with(R"("mesh": [
      {"file": "a.ply", "name": "a", "material": "m", "back": "n", "scale": "1/3", "elements": 2},
      {"file": "b.OFF", "material": "n", "scale": 10, "about": "a triangle"},
      {"file": "c.stl", "name": "c", "material": "m"}])"),
                             files);
  ASSERT_EQ(scene.surfaces.size(), 3u);
  EXPECT_THAT(scene.groups, ElementsAre(Group("a"), Group("mesh[1]"), Group("c")));
  EXPECT_EQ(scene.surfaces[0].name, "a[0]");
  EXPECT_EQ(scene.surfaces[1].name, "mesh[1][0]");
  EXPECT_EQ(scene.surfaces[2].name, "c[0]");
  EXPECT_EQ(scene.surfaces[0].back, 1u);
  EXPECT_EQ(scene.surfaces[0].elements, 2u);
  EXPECT_EQ(scene.surfaces[0].line, 4);
  EXPECT_EQ(scene.surfaces[1].material, 1u);
  EXPECT_EQ(scene.surfaces[1].back, std::nullopt);
  EXPECT_EQ(scene.surfaces[2].line, 6);
  EXPECT_EQ(scene.polygons[0].points[2], (Point3{0, Rational(1) / 30, 0}));
  EXPECT_EQ(scene.polygons[1].points[2], (Point3{0, 1, 10}));
  EXPECT_EQ(scene.polygons[2].points[2], (Point3{0, Rational(1) / 10, 2}));
  // They name no materials.
  for (const char* file : {"a.ply", "b.OFF", "c.stl"})
    EXPECT_THAT(refusal(scene_with("\"mesh\": {\"file\": \"" + std::string(file) + "\"}"), files),
                HasSubstr("face 'mesh[0][0]' has no material"))
        << file;
}

TEST(SceneJson3, SaysWhatIsBehindAGroup) {
  const std::string triangle = std::string("{\"material\": \"m\", \"group\": \"box\", ") + kTriangle;
  const std::string first = triangle + ", \"name\": \"a\"", second = triangle + ", \"name\": \"b\"";
  const auto behind = [&](const std::string& of_first, const std::string& of_second) {
    return parse_scene_3(with_polygons(first + of_first + "},\n" + second + of_second + "}"), "in/scene.json")
        ->groups[0]
        .behind;
  };
  const std::string open = ", \"behind\": \"open\"", solid = ", \"behind\": \"solid\"";
  EXPECT_EQ(behind("", ""), Behind::kByOutline);
  EXPECT_EQ(behind(open, ""), Behind::kOpen);
  EXPECT_EQ(behind("", solid), Behind::kSolid);
  EXPECT_EQ(behind(open, open), Behind::kOpen);
  EXPECT_EQ(refusal(with_polygons(first + open + "},\n" + second + solid + "}")),
            "in/scene.json:5: polygon 'b': another polygon of the group 'box' says that something else is behind it");
  const Scene3 scene = parse_scene_3(with_polygons(first + open + "},\n" + second + "}"), "in/scene.json");
  EXPECT_EQ(parse_scene_3(write_scene_3(scene), "again.json")->groups, scene.groups);
  // A group of one polygon, called as this is.
  const Scene3 alone = parse_scene_3(
      with_polygons("{\"material\": \"m\", \"group\": \"a\", \"name\": \"a\", " + std::string(kTriangle) + open + "}"),
      "in/scene.json");
  ASSERT_EQ(alone.groups[0].behind, Behind::kOpen);
  EXPECT_EQ(parse_scene_3(write_scene_3(alone), "again.json")->groups, alone.groups);
}

TEST(SceneJson3, RefusesWrongMeshes) {
  EXPECT_EQ(refusal(with_mesh(""), kFiles), "in/a.obj:5: face 'mesh[0][0]' has no material");
  EXPECT_EQ(refusal(with_mesh(", \"material\": \"m\", \"scale\": 0"), kFiles),
            "in/scene.json:3: mesh 'mesh[0]': scale must be greater than 0");
  EXPECT_EQ(refusal(with_mesh(", \"material\": \"m\", \"behind\": \"air\""), kFiles),
            "in/scene.json:3: mesh 'mesh[0]': behind is 'air'; it may be \"solid\" or \"open\"");
  EXPECT_EQ(refusal(with_mesh(", \"material\": \"z\""), kFiles),
            "in/scene.json:3: mesh 'mesh[0]': material 'z' is not defined");
  EXPECT_EQ(refusal(with_mesh(", \"name\": \"sky\""), kFiles),
            "in/scene.json:3: mesh[0]: the name 'sky' is kept for the sky");
  EXPECT_EQ(refusal(with_mesh(", \"points\": []"), kFiles), "in/scene.json:3: mesh[0] has the unknown key 'points'");
  EXPECT_EQ(refusal(scene_with("\"mesh\": {}")), "in/scene.json:3: mesh[0] has no \"file\"");
  EXPECT_EQ(refusal(scene_with("\"mesh\": {\"file\": \"lost.obj\"}")),
            "in/scene.json:3: mesh 'mesh[0]': the file in/lost.obj: is not there");
  EXPECT_EQ(refusal(scene_with("\"mesh\": {\"file\": \"a.dxf\"}")),
            "in/scene.json:3: mesh 'mesh[0]': the file 'a.dxf' is not read by this version: it does not end in .obj, "
            ".ply, .off or .stl");
  EXPECT_EQ(refusal(scene_with(R"("mesh": [{"file": "meshes/b.obj"}, {"file": "meshes/c.obj"}])"), kFiles),
            "in/meshes/c.obj:5: the material 'x' is another one in another mesh");
  EXPECT_EQ(refusal(scene_with("\"mesh\": [{\"file\": \"a.obj\", \"material\": \"m\"},\n{\"file\": \"a.obj\", "
                               "\"material\": \"m\", \"scale\": 2}]"),
                    kFiles),
            "in/scene.json:4: two surfaces have the name 'box[0]', the other one in line 3");
  // Materials without an .mtl file are those of the scene.
  Files other = kFiles;
  other["in/a.obj"] = "v 0 0 0\nv 1 0 0\nv 0.5 2 0\nusemtl z\nf 1 2 3\n";
  EXPECT_EQ(refusal(with_mesh(""), other), "in/a.obj:4: the material 'z' is not defined");
}

TEST(SceneJson3, KeepsTheDimensionsApart) {
  const std::string plane = "{\"hottel\": 1,\n\"dimension\": 2}",
                    space = "{\"hottel\": 1,\n\"dimension\": 3, \"mesh\": 7}";
  EXPECT_EQ(refusal(plane), "in/scene.json:2: the scene is in the plane (dimension 2); one in space is wanted");
  try {
    parse_scene_2(space, "s.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "s.json:2: the scene is in space (dimension 3); one in the plane is wanted");
    EXPECT_TRUE(error.hints().empty());
  }
  EXPECT_TRUE(std::holds_alternative<ValidScene2>(parse_scene(plane, "s.json")));
  EXPECT_TRUE(std::holds_alternative<ValidScene3>(parse_scene("{\"hottel\": 1, \"dimension\": 3}", "s.json")));
}

TEST(SceneJson3, RefusesDeepNesting) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(refusal(scene_with("\"polygons\": " + deep)), HasSubstr("nested more than 64 deep"));
}

std::filesystem::path scene_file(const std::string& name) {
  return std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes/space" / name;
}

TEST(SceneJson3, ReadsTheScenesOfTheRepository) {
  EXPECT_EQ(read_scene_3(scene_file("cube.json"))->surfaces.size(), 6u);
  EXPECT_EQ(read_scene_3(scene_file("two_boxes.json"))->surfaces.size(), 17u);
  const Scene3 mesh = read_scene_3(scene_file("room_boxes.obj")), scene = read_scene_3(scene_file("room_boxes.json"));
  EXPECT_EQ(mesh.polygons, scene.polygons);
  EXPECT_EQ(mesh.groups, scene.groups);
  EXPECT_EQ(mesh.groups.size(), 4u);
  EXPECT_TRUE(scene.closed);
}

// In a scene that says it is closed, each edge of a polygon is covered from the other side or lies on other polygons:
// the rooms of these files are boxes whose six walls are named first, and all else lies inside.
TEST(SceneJson3, ClosedScenesOfTheRepositoryAreBoxesWithAllElseInside) {
  for (const char* file : {"cube.json", "two_boxes.json", "room_boxes.json"}) {
    const Scene3 scene = read_scene_3(scene_file(file));
    ASSERT_TRUE(scene.closed);
    Vector3 sum;
    for (std::size_t wall = 0; wall < 6; ++wall) {
      const Vector3 normal = doubled_area(scene.polygons[wall]);
      sum = {sum.x + normal.x, sum.y + normal.y, sum.z + normal.z};
      for (const Polygon3& polygon : scene.polygons)
        for (const Point3& point : polygon.points)
          EXPECT_GE(dot(normal, point - scene.polygons[wall].points[0]), 0) << file << " " << wall;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::vector<Point3>& p = scene.polygons[wall].points;
        int meeting = 0;  // walls that have the same edge the other way round
        for (std::size_t other = 0; other < 6; ++other)
          for (std::size_t i = 0; i < 4; ++i) {
            const std::vector<Point3>& q = scene.polygons[other].points;
            meeting += q[i] == p[(k + 1) % 4] && q[(i + 1) % 4] == p[k];
          }
        EXPECT_EQ(meeting, 1) << file << " " << wall;
      }
    }
    EXPECT_TRUE(sum.is_zero());
  }
}

// Equal but for files and lines.
void expect_same(const Scene3& a, const Scene3& b) {
  EXPECT_EQ(a.about, b.about);
  EXPECT_EQ(a.materials, b.materials);
  for (std::size_t k = 0; k < std::min(a.materials.size(), b.materials.size()); ++k) {
    EXPECT_EQ(a.materials[k].name, b.materials[k].name);
    EXPECT_EQ(a.materials[k].reflectivity.is_scalar, b.materials[k].reflectivity.is_scalar);
  }
  EXPECT_EQ(a.groups, b.groups);
  EXPECT_EQ(a.polygons, b.polygons);
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
    Surface other = b.surfaces[s];
    other.line = a.surfaces[s].line;
    EXPECT_EQ(a.surfaces[s], other) << a.surfaces[s].name;
  }
  EXPECT_EQ(a.sky_emission, b.sky_emission);
  EXPECT_EQ(a.closed, b.closed);
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.grids, b.grids);
  EXPECT_EQ(a.expect.size(), b.expect.size());
}

TEST(WriteScene3, ReadsBackToTheSameScene) {
  for (const char* file : {"cube.json", "two_boxes.json", "room_boxes.json", "room_boxes.obj"}) {
    const Scene3 scene = read_scene_3(scene_file(file));
    const std::string text = write_scene_3(scene);
    const Scene3 again = parse(text);
    expect_same(scene, again);
    EXPECT_EQ(write_scene_3(again), text);
  }
}

TEST(WriteScene3, ReadsBackToTheSameSceneWhateverTheNumbers) {
  std::mt19937_64 random(7);
  const auto number = [&]() -> Rational {
    const Rational value = Rational(static_cast<long>(random() % 2000001) - 1000000) / Rational(1 + random() % 999);
    switch (random() % 3) {
      case 0:
        return value * *parse_rational("1e" + std::to_string(random() % 200));
      case 1:
        return value / *parse_rational("1e" + std::to_string(random() % 200));
      default:
        return value;
    }
  };
  for (int k = 0; k < 100; ++k) {
    Scene3 scene;
    scene.materials.push_back({"m \"1\"", Spectrum::scalar(Rational(1) / 3), {{1, 2, number() * 0}, false}});
    for (std::uint32_t s = 0; s < 1 + random() % 5; ++s) {
      Polygon3 polygon;
      for (int i = 0; i < 3; ++i) polygon.points.push_back({number(), number(), number()});
      Surface surface;
      surface.name = "p" + std::to_string(s);
      if (random() % 2) surface.back = 0;
      surface.elements = 1 + static_cast<std::uint32_t>(random() % 3);
      if (scene.groups.empty() || random() % 2)
        scene.groups.push_back(random() % 2 ? surface.name : "g" + surface.name);
      surface.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
      scene.add(surface, polygon);
    }
    if (random() % 2) scene.camera = Camera3{{number(), number(), number()}, {0, 0, 0}, {0, 1, number()}, 50, 3, 4};
    if (random() % 2) scene.grids = {{{number(), number(), 1}, {1, 0, number()}, {number(), 2, 0}, 3, 4}};
    if (random() % 2) scene.grids.push_back({{number(), 0, 1}, {1, 0, 0}, {number(), 2, 0}, 3, 4, "second"});
    if (scene.grids.size() == 2) scene.grids[0].name = "first 1";
    validate(scene);
    expect_same(scene, parse(write_scene_3(scene)));
  }
}

TEST(WriteScene3, HasALayoutThatPeopleRead) {
  const std::string text = R"({
  "hottel": 1,
  "dimension": 3,
  "about": "two triangles",
  "materials": {
    "white": {"reflectivity": 0.7}
  },
  "polygons": [
    {"name": "a", "points": [[0, 0, 0], [1, 0, 0.1], [0, "1/3", 0]], "material": "white"},
    {"name": "b", "group": "box", "points": [[0, 0, 2], [1, 0, 2], [0, 1, 2]], "material": "white", "back": "white", "elements": 3}
  ],
  "sky": {"emission": 1},
  "closed": true,
  "camera": {"eye": [1, 0, 0], "target": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 40, "pixels": [800, 600]}
}
)";
  EXPECT_EQ(write_scene_3(parse(text)), text);
  EXPECT_EQ(write_scene_3(Scene3()), "{\n  \"hottel\": 1,\n  \"dimension\": 3\n}\n");
}

}  // namespace
}  // namespace hottel::scene_json_test

#include "geometry/plane/scene/scene_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "tests/refusal.h"

namespace hottel::scene_builder_test {
namespace {

SceneBuilder2 with_white() {
  SceneBuilder2 builder("room");
  builder.add_material("white", {.reflectivity = "0.7"});
  return builder;
}

TEST(Number, IsExactWhateverItIsWrittenAs) {
  EXPECT_EQ(Number(3).value(), 3);
  EXPECT_EQ(Number(-3L).value(), -3);
  EXPECT_EQ(Number(std::numeric_limits<std::uint64_t>::max()).value(), Rational("18446744073709551615"));
  EXPECT_EQ(Number(std::numeric_limits<std::int64_t>::min()).value(), Rational("-9223372036854775808"));
  EXPECT_EQ(Number(0.1).value(), Rational("3602879701896397/36028797018963968"));
  EXPECT_EQ(Number(0.5f).value(), Rational(1, 2));
  EXPECT_EQ(Number(5e-324).value(), scaled_by_power_of_two(1, -1074));
  EXPECT_EQ(Number("0.1").value(), Rational(1, 10));
  EXPECT_EQ(Number(std::string("1/3")).value(), Rational(1, 3));
  EXPECT_EQ(Number(Rational(1, 3)).value(), Rational(1, 3));
  EXPECT_EQ(Number(Rational(1) / 3 + 1).value(), Rational(4, 3));
  EXPECT_EQ(Number(Integer(7)).value(), 7);
}

TEST(Number, IsInLowestTerms) {
  const Rational typed(2, 4);  // as mpq_class leaves it
  EXPECT_EQ(Number(typed).value().get_den(), 2);
  EXPECT_EQ(Number("2/4").value().get_den(), 2);
}

TEST(Number, SaysWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Number& number : {Number(nan), Number(infinity), Number(-infinity), Number(""), Number("wide"),
                               Number("1/0"), Number("1e5000"), Number(std::string(5000, '1')), Number(" 1")}) {
    EXPECT_FALSE(number.problem().text.empty());
    EXPECT_THROW(number.value(), UsageError) << number.problem().text;
  }
  EXPECT_EQ(Number(nan).problem().text, "is not a number: 'nan'");
  EXPECT_EQ(Number("1/0").problem().text, "is not a number: '1/0'");
  Rational none;
  none.get_den() = 0;
  EXPECT_EQ(Number(none).problem().text, "is not a number: its denominator is 0");
}

TEST(Number, IsNoTruthValueAndNoCharacter) {
  static_assert(!std::is_convertible_v<bool, Number>);
  static_assert(!std::is_convertible_v<char, Number>);
  static_assert(!std::is_convertible_v<long double, Number>);
  static_assert(std::is_convertible_v<unsigned short, Number>);
}

// What a scene is but for lines and the file's name.
void expect_same(Scene2 built, Scene2 read) {
  for (Scene2* scene : {&built, &read})
    for (Surface& surface : scene->surfaces) surface.line = 0;
  EXPECT_EQ(built.surfaces, read.surfaces);
  EXPECT_EQ(built.edges, read.edges);
  EXPECT_EQ(built.groups, read.groups);
  ASSERT_EQ(built.materials.size(), read.materials.size());
  for (std::size_t m = 0; m < read.materials.size(); ++m) {
    const Material &a = built.materials[m], &b = read.materials[m];
    EXPECT_EQ(a, b);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.reflectivity.is_scalar, b.reflectivity.is_scalar) << a.name;
    EXPECT_EQ(a.emission.is_scalar, b.emission.is_scalar) << a.name;
  }
  EXPECT_EQ(built.sky_emission, read.sky_emission);
  EXPECT_EQ(built.sky_emission.is_scalar, read.sky_emission.is_scalar);
  EXPECT_EQ(built.closed, read.closed);
  EXPECT_EQ(built.grids, read.grids);
  EXPECT_EQ(built.about, read.about);
}

TEST(SceneBuilder2, GivesTheSceneOfAFileOfTheSameEntries) {
  const Scene2 read = parse_scene_2(R"({ "hottel": 1, "dimension": 2, "about": "a room",
    "materials": { "white": {"reflectivity": 0.7}, "lamp": {"emission": [9, 8, "1/3"], "reflectivity": 0.1},
                   "steel": {"emissivity": 0.3, "temperature": 900}, "black": {} },
    "edges":     [ {"name": "lamp", "points": [[1, 2.9], ["4/3", "2.9"]], "material": "lamp", "back": "white", "elements": 4},
                   {"points": [[2, 1], [3, 1]], "material": "steel", "behind": "open"} ],
    "polylines": [ {"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "white"},
                   {"points": [[1,1],[2,2],[3,2]], "material": "white", "back": "black", "elements": 2, "behind": "open"} ],
    "sky": {"emission": [1, 2, "1/3"]}, "closed": true,
    "grid": {"min": [0,0], "max": [4,3], "cells": [400,300]} })",
                                    "scene.json");
  SceneBuilder2 builder;
  builder.add_material("white", {.reflectivity = "0.7"})
      .add_material("lamp", {.reflectivity = "0.1", .emission = {9, 8, "1/3"}})
      .add_material("steel", {.emissivity = "0.3", .temperature = 900})
      .add_material("black");
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  builder.add_edge("lamp", {1, "2.9"}, {"4/3", "2.9"}, "lamp", {.back = "white", .elements = 4});
  builder.add_polyline("", {{1, 1}, {2, 2}, {3.0, 2}}, "white",
                       {.back = "black", .elements = 2, .behind = Behind::kOpen});
  builder.add_edge("", Point2{2, 1}, {3, 1}, "steel", {.behind = Behind::kOpen});
  builder.set_sky({1, 2, "1/3"}).set_closed().set_grid({0, 0}, {4, 3}, 400, 300).set_about("a room");
  expect_same(builder.build(), read);
  const ValidScene2 built = builder.build();
  for (const Surface& surface : built->surfaces) EXPECT_EQ(surface.line, 0);
  EXPECT_EQ(builder.build()->file, "scene made in code");
  expect_same(parse_scene_2(write_scene_2(builder.build()), "written"), read);
}

TEST(SceneBuilder2, HasOneGridOrSeveralWithNames) {
  SceneBuilder2 builder = with_white();
  builder.add_edge("wall", {0, 0}, {1, 0}, "white").add_grid("desk", {0, 0}, {1, 1}, 2, 3);
  builder.add_grid("floor", {0, 0}, {"1/3", 1}, 4, 5);
  EXPECT_EQ(builder.build()->grids,
            (std::vector<Grid2>{{{0, 0}, {1, 1}, 2, 3, "desk"}, {{0, 0}, {Rational(1, 3), 1}, 4, 5, "floor"}}));
  EXPECT_EQ(parse_scene_2(write_scene_2(builder.build()), "written")->grids, builder.build()->grids);
  EXPECT_THROW(builder.add_grid("desk", {0, 0}, {1, 1}, 1, 1), InputError);
  EXPECT_THROW(builder.add_grid("", {0, 0}, {1, 1}, 1, 1), InputError);
  EXPECT_THROW(builder.add_grid("a:b", {0, 0}, {1, 1}, 1, 1), InputError);
  EXPECT_EQ(builder.build()->grids.size(), 2u);
  EXPECT_EQ(builder.set_grid({0, 0}, {1, 1}, 1, 1).build()->grids, (std::vector<Grid2>{{{0, 0}, {1, 1}, 1, 1}}));
  EXPECT_THROW(builder.add_grid("desk", {0, 0}, {1, 1}, 1, 1), InputError) << "beside one without a name";
}

TEST(SceneBuilder2, MayGoOnAfterBuild) {
  SceneBuilder2 builder = with_white();
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}}, "white");
  EXPECT_EQ(builder.build()->surfaces.size(), 2u);
  builder.add_edge("wall", {0, 0}, {1, 0}, "white");
  const Scene2 scene = builder.build();
  ASSERT_EQ(scene.surfaces.size(), 3u);
  EXPECT_EQ(scene.surfaces[0].name, "wall");
  EXPECT_EQ(scene.groups[scene.surfaces[2].group].name, "room");
}

TEST(SceneBuilder2, RefusesWhatAFileMayNotSay) {
  SceneBuilder2 builder = with_white();
  const auto edge = [&](const char* name, TypedPoint2 to, const char* material, EdgeOptions2 options = {}) {
    return refusal_by([&] { builder.add_edge(name, {0, 0}, to, material, options); });
  };
  EXPECT_EQ(edge("wall", {0, 0}, "white"), "room: edge 'wall' has length zero");
  EXPECT_EQ(edge("", {0, "0.0"}, "white"), "room: edge 'edge[0]' has length zero");
  EXPECT_EQ(edge("wall", {0, "1/0"}, "white"), "room: edge 'wall': coordinate is not a number: '1/0'");
  EXPECT_EQ(edge("wall", {0, std::numeric_limits<double>::infinity()}, "white"),
            "room: edge 'wall': coordinate is not a number: 'inf'");
  EXPECT_EQ(edge("sky", {1, 0}, "white"), "room: edge[0]: the name 'sky' is kept for the sky");
  EXPECT_EQ(edge("wall", {1, 0}, "whiet"), "room: edge 'wall': material 'whiet' is not defined");
  EXPECT_EQ(edge("wall", {1, 0}, "white", {.back = "black"}), "room: edge 'wall': back 'black' is not defined");
  EXPECT_EQ(edge("wall", {1, 0}, "white", {.elements = 0}),
            "room: edge 'wall': elements must be an integer from 1 to 1000000");
  const auto polyline = [&](const std::vector<TypedPoint2>& points, bool closed) {
    return refusal_by([&] { builder.add_polyline("box", points, "white", {.closed = closed}); });
  };
  EXPECT_EQ(polyline({{0, 0}}, true), "room: polyline 'box' has fewer than two points");
  EXPECT_EQ(polyline({{0, 0}, {1, 0}, {1, 0}}, false), "room: polyline 'box': its piece 'box[1]' has length zero");
  EXPECT_EQ(polyline({{0, 0}, {1, 0}, {0, 0}}, true), "room: polyline 'box': its piece 'box[2]' has length zero");
  const auto material = [&](const char* name, const MaterialOptions& options) {
    return refusal_by([&] { builder.add_material(name, options); });
  };
  EXPECT_EQ(material("white", {}), "room: material 'white' is there already");
  EXPECT_EQ(material("", {}), "room: the name of a material must not be empty");
  EXPECT_EQ(material("m", {.reflectivity = "1.1"}), "room: material 'm': reflectivity must be from 0 to 1");
  EXPECT_EQ(material("m", {.emission = {0, -1, 0}}), "room: material 'm': emission must not be negative");
  EXPECT_EQ(material("m", {.emission = "much"}), "room: material 'm': emission is not a number: 'much'");
  EXPECT_EQ(material("m", {.reflectivity = 0, .emissivity = 1}),
            "room: material 'm' mixes two ways to say what it emits");
  EXPECT_EQ(material("m", {.temperature = 300}), "room: material 'm' has a temperature but no emissivity");
  EXPECT_EQ(refusal_by([&] { builder.set_sky(-1); }), "room: sky: emission must not be negative");
  EXPECT_EQ(refusal_by([&] {
              builder.set_grid({0, 0}, {0, 1}, 1, 1);
            }),
            "room: grid: max must be greater than min in both coordinates");
  EXPECT_EQ(refusal_by([&] {
              builder.set_grid({0, 0}, {1, 1}, 1, 0);
            }),
            "room: grid: cells must be integers from 1 to 16384");
  // Nothing of it is left.
  const Scene2 scene = builder.build();
  EXPECT_TRUE(scene.surfaces.empty());
  EXPECT_TRUE(scene.groups.empty());
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(SceneBuilder2, RefusesNamesThatAreNotUnique) {
  SceneBuilder2 builder = with_white();
  builder.add_polyline("box", {{0, 0}, {1, 0}}, "white").add_edge("box", {2, 0}, {3, 0}, "white");
  EXPECT_EQ(refusal_by([&] { builder.build(); }), "room: polyline 'box' has the name of an edge");
  builder = with_white();
  builder.add_polyline("box", {{0, 0}, {1, 0}}, "white").add_polyline("box", {{2, 0}, {3, 0}}, "white");
  EXPECT_EQ(refusal_by([&] { builder.build(); }), "room: two surfaces have the name 'box[0]'");
}

}  // namespace
}  // namespace hottel::scene_builder_test

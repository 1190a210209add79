#include "io/scene/scene_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/refusal.h"

namespace hottel::scene_json_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Scene2 parse(const std::string& text) { return parse_scene_2(text, "scene.json"); }

// The message with which a text is refused; empty when it is not refused as a scene error.
std::string refusal(const std::string& text) {
  return refusal_by([&] { parse(text); });
}

// A scene with these further members, which begin in line 3.
std::string scene_with(const std::string& members) {
  return "{ \"hottel\": 1, \"dimension\": 2,\n  \"materials\": {\"m\": {}},\n  " + members + "}\n";
}

// A scene with these edges, from line 4 on.
std::string with_edges(const std::string& edges) { return scene_with("\"edges\": [\n" + edges + "]"); }
std::string with_polylines(const std::string& lines) { return scene_with("\"polylines\": [\n" + lines + "]"); }

Rational x_of(const std::string& typed) {
  return parse(with_edges(R"({"points": [[)" + typed + R"(, 0], [0, 1]], "material": "m"})")).edges[0].from.x;
}

TEST(SceneJson, ReadsEveryPartOfAScene) {
  const Scene2 scene = parse(R"({ "hottel": 1, "dimension": 2, "about": "a room",
    "materials": { "white": {"reflectivity": 0.7, "about": "paint"}, "lamp": {"emission": [9, 8, 6], "reflectivity": 0.1} },
    "edges":     [ {"name": "lamp", "points": [[1, 2.9], ["4/3", "2.9"]], "material": "lamp", "back": "white", "elements": 4},
                   {"points": [[2, 1], [3, 1]], "material": "white"} ],
    "polylines": [ {"name": "room", "points": [[0,0],[0,3],
                                               [4,3],[4,0]], "closed": true, "material": "white"},
                   {"points": [[1,1],[2,2]], "material": "white"} ],
    "polygons": [ ], "lights": [ ],
    "sky": {"emission": [1, 2, "1/3"]}, "closed": true,
    "grid": {"min": [0,0], "max": [4,3], "cells": [400,300]},
    "expect": [ {"kind": "exact", "quantity": "factor", "of": ["lamp", "sky"], "value": 0.10, "form": "1/10",
                 "derivation": "by eye"} ] })");
  EXPECT_EQ(scene.file, "scene.json");
  EXPECT_EQ(scene.about, "a room");
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].reflectivity.value[1], Rational(7, 10));
  EXPECT_TRUE(scene.materials[0].reflectivity.is_scalar);
  EXPECT_FALSE(scene.materials[1].emission.is_scalar);
  EXPECT_EQ(scene.materials[1].emission.value[2], 6);

  std::vector<std::string> names;
  for (const Surface& s : scene.surfaces) names.push_back(s.name);
  EXPECT_THAT(names,
              ::testing::ElementsAre("lamp", "edge[1]", "room[0]", "room[1]", "room[2]", "room[3]", "polyline[1][0]"));
  EXPECT_THAT(scene.groups, ::testing::ElementsAre("lamp", "edge[1]", "room", "polyline[1]"));
  const Surface& lamp = scene.surfaces[0];
  EXPECT_EQ(scene.edges[0].from, (Point2{1, Rational(29, 10)}));
  EXPECT_EQ(scene.edges[0].to, (Point2{Rational(4, 3), Rational(29, 10)}));
  EXPECT_EQ(lamp.material, 1u);
  EXPECT_EQ(lamp.back, 0u);
  EXPECT_EQ(lamp.elements, 4u);
  EXPECT_EQ(lamp.line, 3);
  EXPECT_EQ(scene.edges[5].from, (Point2{4, 0}));
  EXPECT_EQ(scene.edges[5].to, (Point2{0, 0}));
  EXPECT_EQ(scene.surfaces[3].line, 5);
  EXPECT_EQ(scene.surfaces[4].line, 6);
  EXPECT_EQ(scene.surfaces[5].group, 2u);
  EXPECT_FALSE(scene.surfaces[5].back);

  EXPECT_TRUE(scene.closed);
  EXPECT_EQ(scene.sky_emission.value[2], Rational(1, 3));
  EXPECT_EQ(scene.grids, (std::vector<Grid2>{{{0, 0}, {4, 3}, 400, 300}}));
  ASSERT_EQ(scene.expect.size(), 1u);
  EXPECT_EQ(scene.expect[0].value, "0.10");
  EXPECT_THAT(scene.expect[0].of, ::testing::ElementsAre("lamp", "sky"));
  EXPECT_EQ(scene.find("room[2]"), 4u);
  EXPECT_FALSE(scene.find("room"));
}

TEST(SceneJson, NumbersAreExactlyWhatIsTyped) {
  EXPECT_EQ(x_of("0.1"), Rational(1, 10));
  EXPECT_EQ(x_of("\"0.1\""), Rational(1, 10));
  EXPECT_EQ(x_of("\"-1/3\""), Rational(-1, 3));
  EXPECT_EQ(x_of("-0"), 0);
  EXPECT_EQ(x_of("9223372036854775807"), Rational("9223372036854775807"));
  EXPECT_EQ(x_of("18446744073709551617"), Rational("18446744073709551617"));
  EXPECT_EQ(x_of("-9223372036854775809"), Rational("-9223372036854775809"));
  EXPECT_EQ(x_of("1234567890123456789012345678901234567890"), Rational("1234567890123456789012345678901234567890"));
  EXPECT_EQ(x_of("0.1234567890123456789012345678901234567890"),
            Rational("1234567890123456789012345678901234567890") / Rational("1" + std::string(40, '0')));
  EXPECT_EQ(x_of("2.5E-3"), Rational(1, 400));
}

TEST(SceneJson, NumbersBeyondTheRangeOfDoubleAreReadExactly) {
  const Rational huge("1" + std::string(400, '0'));
  EXPECT_EQ(x_of("1e400"), huge);
  EXPECT_EQ(x_of("-1e+400"), -huge);
  EXPECT_EQ(x_of("1e-400"), 1 / huge);
  EXPECT_EQ(x_of("\"1e4096\""), Rational("1" + std::string(4096, '0')));
}

TEST(SceneJson, ASkyOfATemperatureSendsSigmaTToTheFourth) {
  const Scene2 scene = parse(scene_with("\"sky\": {\"temperature\": \"541/2\"}"));
  const Rational t(541, 2);
  EXPECT_EQ(scene.sky_emission.value[0], *parse_rational("5.670374419e-8") * t * t * t * t);
  EXPECT_TRUE(scene.sky_emission.is_scalar);
  EXPECT_EQ(refusal(scene_with("\"sky\": {\"temperature\": 1, \"emission\": 0}")),
            "scene.json:3: sky has both emission and temperature");
  EXPECT_EQ(refusal(scene_with("\"sky\": {\"temperature\": -1}")),
            "scene.json:3: sky: temperature must not be negative");
}

TEST(SceneJson, AnInsulatedMaterialReflectsAllAndStaysInsulated) {
  const Scene2 scene = parse(R"({"hottel": 1, "dimension": 2, "materials": {
    "a": {"insulated": true}, "b": {"insulated": false, "reflectivity": 1}}})");
  EXPECT_EQ(scene.materials[0], scene.materials[1]);
  EXPECT_TRUE(scene.materials[0].is_insulated());
  EXPECT_FALSE(scene.materials[1].is_insulated());
  EXPECT_TRUE(scene.materials[0].reflectivity.is_scalar && scene.materials[0].emission.is_scalar);
  const std::string text = write_scene_2(scene);
  EXPECT_NE(text.find("\"a\": {\"insulated\": true}"), std::string::npos) << text;
  EXPECT_NE(text.find("\"b\": {\"reflectivity\": 1}"), std::string::npos) << text;
}

// Temperatures stay temperatures, and whatever is written reads back as it was given, channel by channel.
TEST(SceneJson, WritesTemperaturesAsSuch) {
  const auto written = [](const std::string& material) {
    const Scene2 scene = parse(R"({"hottel": 1, "dimension": 2, "materials": {"m": )" + material + "}}");
    const std::string text = write_scene_2(scene);
    const Material &before = scene.materials[0], again = parse(text).materials[0];
    EXPECT_EQ(before, again) << text;
    EXPECT_EQ(before.reflectivity.is_scalar, again.reflectivity.is_scalar) << text;
    EXPECT_EQ(before.emission.is_scalar, again.emission.is_scalar) << text;
    const std::size_t begin = text.find("\"m\": ") + 5;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  for (const char* kept :
       {R"({"emissivity": 0.9, "temperature": 288.15})", R"({"emissivity": [0.9, 0.5, 0], "temperature": 288})",
        R"({"emissivity": 0.9, "temperature": [5, 5, 5]})", R"({"emissivity": 1, "temperature": "1/3"})",
        R"({"reflectivity": 0.5, "emission": 10})", R"({"reflectivity": 1, "emission": 10})",
        R"({"reflectivity": [0.1, 0.2, 0.3], "emission": [1, 2, 3]})"})
    EXPECT_EQ(written(kept), kept);
  EXPECT_EQ(written(R"({"emissivity": 0.9})"), R"({"reflectivity": 0.1})");
  EXPECT_EQ(written(R"({"emissivity": [0.9, 0.5, 0], "temperature": [288, 288, 7]})"),
            R"({"emissivity": [0.9, 0.5, 0], "temperature": 288})");
  EXPECT_EQ(written(R"({"reflectivity": [0, 0, 0], "emission": "5.670374419e-8"})"),
            R"({"reflectivity": [0, 0, 0], "emission": 0.00000005670374419})");
  written(R"({"emissivity": [0.9, 0.5, 0.1], "temperature": [288, 289, 290]})");
  for (const char* sky : {"{\"temperature\": 263.15}", "{\"emission\": 2}", "{\"temperature\": [263, 263, 263]}",
                          "{\"emission\": [1, 2, 3]}"}) {
    const std::string text = write_scene_2(parse(scene_with(std::string("\"sky\": ") + sky)));
    EXPECT_NE(text.find(std::string("\"sky\": ") + sky), std::string::npos) << text;
  }
}

TEST(SceneJson, AUnitIsANameAndKept) {
  const Scene2 scene = parse(scene_with("\"unit\": \"mm\""));
  EXPECT_EQ(scene.unit, "mm");
  EXPECT_EQ(parse(write_scene_2(scene)).unit, "mm");
  EXPECT_EQ(refusal(scene_with("\"unit\": \"\"")), "scene.json:3: unit must not be empty");
  EXPECT_EQ(refusal(scene_with("\"unit\": 1")), "scene.json:3: unit must be a string, not a number");
  EXPECT_EQ(refusal(scene_with("\"unit\": \"a\\nb\"")), "scene.json:3: unit must not contain a control character");
}

TEST(SceneJson, EmissivityAndTemperatureMakeAGrayBodyExactly) {
  const Scene2 scene = parse(R"({"hottel": 1, "dimension": 2, "materials": {
    "steel": {"emissivity": 0.3, "temperature": 900}, "cold": {"emissivity": [0.1, 0.2, 1]}}})");
  const Rational sigma = *parse_rational("5.670374419e-8");
  EXPECT_EQ(scene.materials[0].reflectivity, Spectrum::scalar(Rational(7, 10)));
  EXPECT_EQ(scene.materials[0].emission, Spectrum::scalar(Rational(3, 10) * sigma * Rational("656100000000")));
  EXPECT_TRUE(scene.materials[0].emission.is_scalar);
  EXPECT_EQ(scene.materials[1].reflectivity.value[0], Rational(9, 10));
  EXPECT_TRUE(scene.materials[1].emission.is_zero());
}

TEST(SceneJson, RefusesWhatIsNotJson) {
  EXPECT_EQ(refusal(""), "scene.json: the file is empty");
  EXPECT_EQ(refusal(" \n\t"), "scene.json: the file is empty");
  EXPECT_THAT(refusal("\xEF\xBB\xBF{}"), StartsWith("scene.json:1: the file begins with a byte order mark"));
  EXPECT_THAT(refusal(std::string("\xFF\xFE{\0", 4)), StartsWith("scene.json:1: the file is UTF-16"));
  EXPECT_THAT(refusal(with_edges("{]")), StartsWith("scene.json:4: this is not JSON"));
  EXPECT_THAT(refusal("{\"hottel\": 1,\n\"about\": tru\n}"), StartsWith("scene.json:2: this is not JSON"));
  EXPECT_THAT(refusal("{\"hottel\": 1,\n\"about\": \"tru\n\"}"), StartsWith("scene.json:2: this is not JSON"));
  EXPECT_THAT(refusal("{\"hottel\": 1,\n\n"), StartsWith("scene.json:2: this is not JSON"));
  EXPECT_THAT(refusal("{\"hottel\": 1} x"), StartsWith("scene.json:1: this is not JSON"));
  EXPECT_THAT(refusal(std::string("{\"hottel\": 1,\n\"dimension\": 2}\0x", 32)),
              StartsWith("scene.json:2: this is not JSON"));
  EXPECT_THAT(refusal(scene_with("\"sky\": {\"emission\": NaN}")), StartsWith("scene.json:3: this is not JSON"));
  EXPECT_THAT(refusal(scene_with("\"about\": \"\xC3\x28\"")), StartsWith("scene.json:3: this is not JSON"));
  EXPECT_EQ(refusal(scene_with("// no comments\n\"closed\": true")),
            "scene.json:3: this is not JSON: '//' is not understood");
  EXPECT_EQ(refusal("{\"hottel\": 0x10}"), "scene.json:1: this is not JSON: '0x10' is not understood");
  EXPECT_EQ(refusal("{'hottel': 1}"), "scene.json:1: this is not JSON: ''hottel'' is not understood");
  EXPECT_EQ(refusal("{\"hottel\": .5}"), "scene.json:1: this is not JSON: '.5' is not understood");
  EXPECT_EQ(refusal("{\"hottel\": 1, \"edges\": [\n1,\n]}"),
            "scene.json:3: this is not JSON: a comma stands before ']' with nothing after it");
  EXPECT_EQ(refusal("{\"hottel\": 1\n\"edges\": []}"),
            "scene.json:2: this is not JSON: a comma is missing before a text in double quotes");
  EXPECT_EQ(refusal("{\"hottel\": 1, \"edges\": [{}\n{}]}"),
            "scene.json:2: this is not JSON: a comma is missing before '{'");
  EXPECT_EQ(refusal("{\"hottel\": 0,5}"),
            "scene.json:1: this is not JSON: a number stands after a comma where the name of a member is expected");
  EXPECT_EQ(refusal("5"), "scene.json:1: the scene must be an object, not a number");
  EXPECT_EQ(refusal("\n[]"), "scene.json:2: the scene must be an object, not a list");
}

TEST(SceneJson, RefusesDeepNestingWithoutRecursion) {
  for (const std::size_t depth : {70u, 1'000'000u}) {
    EXPECT_EQ(refusal(scene_with("\"edges\": " + std::string(depth, '['))),
              "scene.json:3: lists and objects are nested more than 64 deep");
    std::string objects;
    for (std::size_t i = 0; i < depth; ++i) objects += "{\"a\":";
    EXPECT_EQ(refusal(objects), "scene.json:1: lists and objects are nested more than 64 deep");
  }
}

TEST(SceneJson, RefusesDuplicateKeysAtEveryLevel) {
  EXPECT_EQ(refusal("{\"hottel\": 1,\n\"hottel\": 1}"), "scene.json:2: the key 'hottel' is given twice");
  EXPECT_EQ(refusal(scene_with("\"materials\": {}")), "scene.json:3: the key 'materials' is given twice");
  EXPECT_EQ(refusal("{\"materials\": {\"a\": {},\n\"\\u0061\": {}}}"), "scene.json:2: the key 'a' is given twice");
  EXPECT_EQ(refusal(scene_with("\"sky\": {\"emission\": 1, \"emission\": 1}")),
            "scene.json:3: the key 'emission' is given twice");
  EXPECT_EQ(refusal(with_edges("{\"material\": \"m\",\n\"material\": \"m\"}")),
            "scene.json:5: the key 'material' is given twice");
  std::string many;
  for (int i = 0; i < 40; ++i) many += "\"k" + std::to_string(i) + "\": {},";
  EXPECT_EQ(refusal("{\"materials\": {" + many + "\"k7\": {}}}"), "scene.json:1: the key 'k7' is given twice");
}

TEST(SceneJson, RefusesUnknownKeysAtEveryLevel) {
  EXPECT_EQ(refusal(scene_with("\"colour\": 1")), "scene.json:3: the scene has the unknown key 'colour'");
  EXPECT_EQ(refusal(with_edges("{\"Points\": []}")), "scene.json:4: edge 'edge[0]' has the unknown key 'Points'");
  EXPECT_EQ(refusal(with_edges("{\"name\": \"a\", \"closed\": true}")),
            "scene.json:4: edge 'a' has the unknown key 'closed'");
  EXPECT_EQ(refusal(with_polylines("{\"name\": \"a\",\n \"x\": 1}")),
            "scene.json:5: polyline 'a' has the unknown key 'x'");
  EXPECT_EQ(refusal("{\"hottel\": 1, \"dimension\": 2, \"materials\": {\"m\": {\"rho\": 1}}}"),
            "scene.json:1: material 'm' has the unknown key 'rho'");
  EXPECT_EQ(refusal(scene_with("\"sky\": {\"colour\": 1}")), "scene.json:3: sky has the unknown key 'colour'");
  EXPECT_EQ(refusal(scene_with("\"grid\": {\"origin\": 1}")), "scene.json:3: grid has the unknown key 'origin'");
  EXPECT_EQ(refusal(scene_with("\"expect\": [{\"x\": 1}]")), "scene.json:3: expectation[0] has the unknown key 'x'");
}

TEST(SceneJson, RefusesOtherVersionsAndDimensions) {
  EXPECT_EQ(refusal("{}"), "scene.json:1: the scene has no \"hottel\"");
  EXPECT_EQ(refusal("{\"hottel\": 1}"), "scene.json:1: the scene has no \"dimension\"");
  EXPECT_EQ(refusal("{\n\"hottel\": 2, \"dimension\": 2}"), "scene.json:2: hottel is '2'; this version reads 1");
  EXPECT_EQ(refusal("{\"hottel\": \"1\", \"dimension\": 2}"), "scene.json:1: hottel must be a number, not a string");
  EXPECT_EQ(refusal("{\"hottel\": 1,\n \"dimension\": 4}"),
            "scene.json:2: dimension is '4'; this version reads 2 and 3");
  EXPECT_EQ(refusal("{\"hottel\": 1,\n \"dimension\": 3\n}"),
            "scene.json:2: the scene is in space (dimension 3); one in the plane is wanted");
}

TEST(SceneJson, RefusesWrongTypes) {
  EXPECT_EQ(refusal(scene_with("\"edges\": {}")), "scene.json:3: edges must be a list, not an object");
  EXPECT_EQ(refusal(scene_with("\"closed\": 1")), "scene.json:3: closed must be true or false, not a number");
  EXPECT_EQ(refusal(scene_with("\"sky\": 1")), "scene.json:3: sky must be an object, not a number");
  EXPECT_EQ(refusal(scene_with("\"about\": null")), "scene.json:3: about must be a string, not null");
  EXPECT_EQ(refusal(with_edges("7")), "scene.json:4: edge[0] must be an object, not a number");
  EXPECT_EQ(refusal(with_edges("{\"name\": 7}")), "scene.json:4: edge[0]: name must be a string, not a number");
  EXPECT_EQ(refusal(with_edges(R"({"points": 1, "material": "m"})")),
            "scene.json:4: edge 'edge[0]': points must be a list, not a number");
  EXPECT_EQ(refusal(with_edges(R"({"points": [[0,0],[1,true]], "material": "m"})")),
            "scene.json:4: edge 'edge[0]': coordinate must be a number or a string that holds one, not true or false");
  EXPECT_EQ(refusal(with_edges(R"({"points": [[0,0],[1,1,1]], "material": "m"})")),
            "scene.json:4: edge 'edge[0]': point has 3 coordinates; in dimension 2 it has two");
  EXPECT_EQ(refusal(with_edges(R"({"points": [0,1], "material": "m"})")),
            "scene.json:4: edge 'edge[0]': point must be a list, not a number");
  for (const char* wrong : {"0", "-1", "2.5", "1000001", "1e40"})
    EXPECT_EQ(
        refusal(with_edges(std::string(R"({"points": [[0,0],[1,1]], "material": "m", "elements": )") + wrong + "}")),
        "scene.json:4: edge 'edge[0]': elements must be an integer from 1 to 1000000");
}

TEST(SceneJson, RefusesWhatIsNotANumber) {
  for (const char* wrong : {"nan", "inf", "", " 1", "1 ", "0x10", "1/0", "1.5/2", "1/2e5000", "xe5000", "1e5000.5",
                            "1,5", "--1", "/", "e1"})
    EXPECT_THAT(
        refusal(with_edges(std::string(R"({"name": "a", "points": [[0,0],[1,")") + wrong + R"("]], "material": "m"})")),
        StartsWith("scene.json:4: edge 'a': coordinate is not a number: "))
        << wrong;
  for (const char* number : {"1e-5000", "\"1e5000\"", "\"-.5E+04097\"", "\"1e99999999999999999999\""})
    EXPECT_THAT(refusal(with_edges(std::string(R"({"points": [[0,0],[1,)") + number + R"(]], "material": "m"})")),
                StartsWith("scene.json:4: edge 'edge[0]': coordinate is beyond the range in which numbers are read: "))
        << number;
  EXPECT_THAT(refusal(with_edges("{\"points\": [[0,0],[1,1e5000\n]], \"material\": \"m\"}")),
              StartsWith("scene.json:4: a number is beyond the range"));
  const std::string long_one = "0." + std::string(4095, '1');
  EXPECT_EQ(refusal(with_edges(R"({"points": [[0,0],[1,)" + long_one + R"(]], "material": "m"})")),
            "scene.json:4: edge 'edge[0]': coordinate has 4097 characters; a number may have 4096");
  EXPECT_EQ(refusal(with_edges(R"({"points": [[0,0],[1,)" + long_one.substr(0, 4096) + R"(]], "material": "m"})")), "");
}

TEST(SceneJson, RefusesMissingMaterials) {
  EXPECT_EQ(refusal(with_edges("{\"name\": \"a\", \"points\": [[0,0],[1,1]]}")),
            "scene.json:4: edge 'a' has no \"material\"");
  EXPECT_EQ(refusal(with_edges("{\"name\": \"a\", \"material\": \"m\"}")), "scene.json:4: edge 'a' has no \"points\"");
  EXPECT_EQ(refusal(with_edges("{\"name\": \"a\", \"points\": [[0,0],[1,1]],\n \"material\": \"x\"}")),
            "scene.json:5: edge 'a': material 'x' is not defined");
  EXPECT_EQ(refusal(with_polylines(R"({"name": "a", "points": [[0,0],[1,1]], "material": "m", "back": "x"})")),
            "scene.json:4: polyline 'a': back 'x' is not defined");
}

TEST(SceneJson, RefusesMaterialsOutOfRange) {
  const auto material = [](const std::string& members) {
    return refusal("{\"hottel\": 1, \"dimension\": 2, \"materials\": {\n\"m\": {" + members + "}}}");
  };
  EXPECT_EQ(material("\"reflectivity\": 1"), "");
  EXPECT_EQ(material("\"reflectivity\": 1.00000000000000000000001"),
            "scene.json:2: material 'm': reflectivity must be from 0 to 1");
  EXPECT_EQ(material("\"reflectivity\": [0, 1, -1e-300]"),
            "scene.json:2: material 'm': reflectivity must be from 0 to 1");
  EXPECT_EQ(material("\"reflectivity\": [0, 1]"),
            "scene.json:2: material 'm': reflectivity is one number or a list of three, r, g and b, not of 2");
  EXPECT_EQ(material("\"emission\": -1"), "scene.json:2: material 'm': emission must not be negative");
  EXPECT_EQ(material("\"emissivity\": \"4/3\""), "scene.json:2: material 'm': emissivity must be from 0 to 1");
  EXPECT_EQ(material("\"emissivity\": 1, \"temperature\": -1"),
            "scene.json:2: material 'm': temperature must not be negative");
  EXPECT_EQ(material("\"temperature\": 1"), "scene.json:2: material 'm' has a temperature but no emissivity");
  for (const char* a : {"\"reflectivity\": 0", "\"emission\": 0"})
    for (const char* b : {"\"emissivity\": 0", "\"temperature\": 0"})
      EXPECT_EQ(material(std::string(a) + ", " + b), "scene.json:2: material 'm' mixes two ways to say what it emits");
  EXPECT_EQ(refusal(scene_with("\"sky\": {\"emission\": -1}")), "scene.json:3: sky: emission must not be negative");
  EXPECT_EQ(refusal("{\"hottel\": 1, \"dimension\": 2, \"materials\": {\"\": {}}}"),
            "scene.json:1: the name of a material must not be empty");
}

TEST(SceneJson, RefusesNamesThatAreTakenOrMeanSomethingElse) {
  const auto edge = [](const std::string& name) {
    return "{\"name\": \"" + name + "\", \"points\": [[0,0],[1,1]], \"material\": \"m\"}";
  };
  EXPECT_EQ(refusal(with_edges(edge("Küche ☀ [1] :backdoor"))), "");
  EXPECT_EQ(refusal(with_edges(edge(""))), "scene.json:4: edge[0]: the name '' must not be empty");
  EXPECT_EQ(refusal(with_edges(edge("sky"))), "scene.json:4: edge[0]: the name 'sky' is kept for the sky");
  EXPECT_EQ(refusal(with_edges(edge("a#1"))), "scene.json:4: edge[0]: the name 'a#1' must not contain '#'");
  EXPECT_EQ(refusal(with_edges(edge("a:back"))), "scene.json:4: edge[0]: the name 'a:back' must not end in ':back'");
  EXPECT_EQ(refusal(with_edges(edge("a\\nb"))),
            "scene.json:4: edge[0]: the name 'a\\x0Ab' must not contain a control character");
  EXPECT_THAT(refusal(with_edges(edge("a\\u0000"))), HasSubstr("must not contain a control character"));
  EXPECT_THAT(refusal(with_edges(edge("a\\u0085"))), HasSubstr("must not contain a control character"));
  EXPECT_THAT(refusal(with_polylines(edge("sky"))), StartsWith("scene.json:4: polyline[0]: the name 'sky'"));

  EXPECT_EQ(refusal(with_edges(edge("a") + ",\n" + edge("a"))),
            "scene.json:5: two surfaces have the name 'a', the other one in line 4");
  EXPECT_EQ(refusal(with_edges(edge("edge[1]") + ",\n{\"points\": [[0,0],[1,1]], \"material\": \"m\"}")),
            "scene.json:5: two surfaces have the name 'edge[1]', the other one in line 4");
  EXPECT_EQ(refusal(with_polylines(edge("a") + ",\n" + edge("a"))),
            "scene.json:5: two surfaces have the name 'a[0]', the other one in line 4");
  EXPECT_EQ(refusal(scene_with("\"edges\": [" + edge("a") + "],\n\"polylines\": [\n" + edge("a") + "]")),
            "scene.json:5: polyline 'a' has the name of an edge, the one in line 3");
  EXPECT_EQ(refusal(scene_with("\"edges\": [" + edge("room[0]") + "],\n\"polylines\": [\n" + edge("room") + "]")),
            "scene.json:5: two surfaces have the name 'room[0]', the other one in line 3");
}

TEST(SceneJson, RefusesSurfacesWithoutLength) {
  const auto entry = [](const std::string& points, const std::string& more = "") {
    return "{\"name\": \"a\", \"points\": [" + points + "], \"material\": \"m\"" + more + "}";
  };
  EXPECT_EQ(refusal(with_edges(entry(""))), "scene.json:4: edge 'a' has fewer than two points");
  EXPECT_EQ(refusal(with_edges(entry("[0,0]"))), "scene.json:4: edge 'a' has fewer than two points");
  EXPECT_EQ(refusal(with_edges(entry("[0,0],[1,0],[2,0]"))), "scene.json:4: edge 'a' has 3 points; an edge has two");
  EXPECT_EQ(refusal(with_edges(entry("[\"1/2\",0],[0.5,0e7]"))), "scene.json:4: edge 'a' has length zero");
  EXPECT_EQ(refusal(with_polylines(entry("[0,0]"))), "scene.json:4: polyline 'a' has fewer than two points");
  EXPECT_EQ(refusal(with_polylines(entry("[0,0],[1,0],\n[1,0.0]"))),
            "scene.json:4: polyline 'a': its piece 'a[1]' has length zero");
  EXPECT_EQ(refusal(with_polylines(entry("[0,0],[1,0],[1,1],\n[0,0]", ", \"closed\": true"))),
            "scene.json:5: polyline 'a': its piece 'a[3]' has length zero");
  EXPECT_EQ(parse(with_polylines(entry("[0,0],[1,0],[1,1],[0,0]", ", \"closed\": false"))).surfaces.size(), 3u);
  EXPECT_EQ(parse(with_polylines(entry("[0,0],[1,0]", ", \"closed\": true"))).surfaces.size(), 2u);
}

TEST(SceneJson, RefusesWhatItDoesNotSimulate) {
  EXPECT_EQ(refusal(scene_with("\"polygons\": [{}]")),
            "scene.json:3: polygons belong to dimension 3; this scene has dimension 2");
  EXPECT_EQ(refusal(scene_with("\"mesh\": \"a.obj\"")),
            "scene.json:3: mesh belongs to dimension 3; this scene has dimension 2");
  EXPECT_EQ(refusal(scene_with("\"camera\": {}")),
            "scene.json:3: camera belongs to dimension 3; this scene has dimension 2");
}

TEST(SceneJson, ReadsLights) {
  const Scene2 scene = parse(scene_with(R"("lights": [
    {"type": "spot", "name": "torch", "position": [0.5, "1/3"], "direction": [0, 2], "focus": "22.5", "falloff": 2.5,
     "power": [1, 2, 3], "rotation": -30, "about": "turns"},
    {"type": "point", "power": 5, "path": {"points": [[7, 7], [8, 7], [8, 8]], "seconds": 4, "closed": true}} ])"));
  ASSERT_EQ(scene.lights.size(), 2u);
  ASSERT_EQ(scene.light_places.size(), 2u);
  const Light& torch = scene.lights[0];
  EXPECT_EQ(torch.name, "torch");
  EXPECT_EQ(torch.type, LightType::kSpot);
  EXPECT_EQ(torch.focus, Rational(45, 2));
  EXPECT_EQ(torch.falloff, Rational(5, 2));
  EXPECT_EQ(torch.power.value[2], 3);
  EXPECT_EQ(scene.light_places[0].position, (Point2{Rational(1, 2), Rational(1, 3)}));
  EXPECT_EQ(scene.light_places[0].direction, (Point2{0, 2}));
  EXPECT_EQ(scene.light_places[0].rotation, -30);
  EXPECT_EQ(scene.lights[1].name, "light[1]");
  EXPECT_TRUE(scene.lights[1].is_round());
  ASSERT_TRUE(scene.light_places[1].path);
  EXPECT_EQ(scene.light_places[1].position, (Point2{7, 7}));
  EXPECT_EQ(scene.light_places[1].path->seconds, 4);
  const Scene2 again = parse(write_scene_2(scene));
  EXPECT_EQ(again.light_places, scene.light_places);
  for (std::size_t k = 0; k < 2; ++k) {
    Light read = again.lights[k];
    read.line = scene.lights[k].line;
    EXPECT_EQ(read, scene.lights[k]);
  }
}

TEST(SceneJson, RefusesWrongLightsByNameAndLine) {
  const auto light = [](const std::string& text) { return refusal(scene_with("\"lights\": [{" + text + "}]")); };
  EXPECT_EQ(light(R"("type": "spot")"), "scene.json:3: light 'light[0]' has no \"direction\"");
  EXPECT_EQ(light(R"("type": "lamp")"),
            "scene.json:3: light 'light[0]': type is 'lamp'; it may be \"point\", \"spot\" or \"sun\"");
  EXPECT_EQ(light(R"("type": "point", "position": [9, 9])"), "scene.json:3: light 'light[0]' has no \"power\"");
  EXPECT_EQ(light(R"("type": "point", "power": 1)"), "scene.json:3: light 'light[0]' has no \"position\"");
  for (const std::string key : {"direction", "focus", "falloff"})
    EXPECT_EQ(light(R"("type": "point", "power": 1, "position": [9, 9], ")" + key + "\": 10"),
              "scene.json:3: light 'light[0]' is a point light: it has no " + key);
  const std::string spot = R"("type": "spot", "power": 1, "position": [9, 9], "direction": )";
  EXPECT_EQ(light(spot + "[0, 0]"), "scene.json:3: light 'light[0]' shines nowhere: its direction is zero");
  for (const std::string focus : {"0", "-1", "180.001"})
    EXPECT_EQ(light(spot + "[1, 0], \"focus\": " + focus),
              "scene.json:3: light 'light[0]': focus must be greater than 0 and at most 180 degrees");
  EXPECT_EQ(light(spot + "[1, 0], \"falloff\": -1"), "scene.json:3: light 'light[0]': falloff must not be below 0");
  const std::string sun = R"("type": "sun", "direction": [1, -1])";
  EXPECT_EQ(light(sun), "scene.json:3: light 'light[0]' has no \"irradiance\"");
  EXPECT_EQ(light(sun + ", \"irradiance\": -1"), "scene.json:3: light 'light[0]': irradiance must not be negative");
  EXPECT_EQ(light(sun + ", \"irradiance\": 1"), "");
  for (const std::string key : {"position", "path", "power", "focus", "falloff"})
    EXPECT_EQ(light(sun + ", \"irradiance\": 1, \"" + key + "\": 10"),
              "scene.json:3: light 'light[0]' is a sun, infinitely far away: it has no " + key);
  EXPECT_EQ(light(R"("type": "sun", "irradiance": 1, "direction": [0, 0])"),
            "scene.json:3: light 'light[0]' shines nowhere: its direction is zero");
  EXPECT_EQ(light(R"("type": "point", "power": -1, "position": [9, 9])"),
            "scene.json:3: light 'light[0]': power must not be negative");
  EXPECT_EQ(light(R"("type": "point", "power": 1, "path": {"points": [[9, 9]], "seconds": 1})"),
            "scene.json:3: light 'light[0]': path has fewer than two points");
  EXPECT_EQ(light(R"("type": "point", "power": 1, "path": {"points": [[9, 9], [9, 8]], "seconds": 0})"),
            "scene.json:3: light 'light[0]': path: seconds must be greater than 0");
  const std::string path = R"(, "path": {"points": [[9, "1/3"], [9, 8]], "seconds": 1})";
  EXPECT_EQ(light(R"("type": "point", "power": 1, "position": [9, "0.5"])" + path),
            "scene.json:3: light 'light[0]' has its position at (9, 0.5) but its path starts at (9, 1/3): leave the "
            "position out, or say where the path starts");
  EXPECT_EQ(light(R"("type": "point", "power": 1, "position": [9, "1/3"])" + path), "");
  EXPECT_EQ(light(R"("type": "point", "power": 1)" + path), "");
}

TEST(SceneJson, RefusesGridsWithoutCells) {
  const auto grid = [](const std::string& text) { return refusal(scene_with("\"grid\": {" + text + "}")); };
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,1], "cells": [16384,1])"), "");
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,1])"), "scene.json:3: grid has no \"cells\"");
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,0], "cells": [1,1])"),
            "scene.json:3: grid: max must be greater than min in both coordinates");
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,1], "cells": [1])"),
            "scene.json:3: grid: cells must be two numbers, along x and along y");
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,1], "cells": [0,1])"),
            "scene.json:3: grid: cells must be an integer from 1 to 16384");
  EXPECT_EQ(grid(R"("min": [0,0], "max": [1,1], "cells": [1,16385])"),
            "scene.json:3: grid: cells must be an integer from 1 to 16384");
}

TEST(SceneJson, ReadsAListOfGridsWithNames) {
  const auto with_grids = [&](const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
      list += (list.empty() ? "{" : ",\n{") + (name.empty() ? "" : "\"name\": \"" + name + "\", ") +
              R"("min": [0,0], "max": [2,"1/3"], "cells": [4,3]})";
    return scene_with("\"grid\": [" + list + "]");
  };
  const Scene2 scene = parse(with_grids({"floor", "desk 1"}));
  ASSERT_EQ(scene.grids.size(), 2u);
  EXPECT_EQ(scene.grids[0].name, "floor");
  EXPECT_EQ(scene.grids[1], (Grid2{{0, 0}, {2, Rational(1, 3)}, 4, 3, "desk 1"}));
  EXPECT_EQ(parse(write_scene_2(scene)).grids, scene.grids);
  EXPECT_EQ(parse(write_scene_2(parse(with_grids({"a"})))).grids, parse(with_grids({"a"})).grids);
  EXPECT_EQ(refusal(with_grids({})), "scene.json:3: grid: the list is empty");
  EXPECT_EQ(refusal(with_grids({"a", ""})), "scene.json:4: grid has no \"name\"");
  EXPECT_EQ(refusal(with_grids({""})), "scene.json:3: grid has no \"name\"");
  EXPECT_EQ(refusal(with_grids({"a", "a"})), "scene.json:4: grid: two are called 'a'");
  EXPECT_EQ(refusal(with_grids({"Desk A", "desk a"})),
            "scene.json:4: grid: 'Desk A' and 'desk a' differ in case only: on a disk without case their files would "
            "be one");
  EXPECT_EQ(refusal(with_grids({"b", "a/b"})),
            "scene.json:4: grid: a name must not contain / \\ : * ? \" < > or |: it is part of the names of files");
  EXPECT_EQ(refusal(with_grids({std::string(101, 'a')})),
            "scene.json:3: grid: a name must not be longer than 100 bytes");
}

TEST(SceneJson, LineNumbersDoNotDependOnTheLayout) {
  const std::string text = with_edges(
      "{\"points\":[[0,\n0],[1,\r\n 1]],\"material\":\"m\"}\n,\n\n{\"points\":[[0,0],[1,1\n\n]],\"material\":\"m\"}");
  const Scene2 scene = parse(text);
  EXPECT_EQ(scene.surfaces[0].line, 4);
  EXPECT_EQ(scene.surfaces[1].line, 9);
  std::string one_line = text;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  for (const Surface& surface : parse(one_line).surfaces) EXPECT_EQ(surface.line, 1);
  // A number is the last thing before the end of its line.
  EXPECT_EQ(refusal(with_edges("{\"elements\": 0\n, \"points\": [[0,0],[1,1]], \"material\": \"m\"}")),
            "scene.json:4: edge 'edge[0]': elements must be an integer from 1 to 1000000");
}

TEST(ReadScene2, NamesFilesThatCannotBeRead) {
  const auto refusal_of = [](const std::filesystem::path& file) -> std::string {
    try {
      read_scene_2(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal_of("no/such/file.json"), "no/such/file.json: there is no such file");
  const std::filesystem::path folder = ::testing::TempDir();
  EXPECT_EQ(refusal_of(folder), folder.string() + ": is a directory, not a file");
  const std::filesystem::path file = folder / "hottel_scene_json_test.json";
  std::ofstream(file) << "{\n";
  EXPECT_THAT(refusal_of(file), StartsWith(file.string() + ":1: this is not JSON"));
  std::ofstream(file) << with_edges(R"({"points": [[0,0],[1,1]], "material": "m"})");
  EXPECT_EQ(read_scene_2(file)->file, file.string());
  EXPECT_EQ(read_scene_2(file)->surfaces.size(), 1u);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace hottel::scene_json_test

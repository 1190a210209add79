// What is written reads back to the same scene, and no text whatever brings the reader down.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "geometry/plane/scene/moving_lights.h"
#include "io/scene/scene_json.h"

namespace hottel::scene_json_round_trip_test {
namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t n, Random& random) { return random() % n; }

Rational random_number(Random& random) {
  const auto integer = [&](std::size_t digits) {
    std::string text = std::to_string(1 + below(9, random));
    while (text.size() < digits) text += static_cast<char>('0' + below(10, random));
    return Integer(text);
  };
  Rational value(integer(1 + below(20, random)));
  switch (below(5, random)) {
    case 0:
      value /= Rational(integer(1 + below(30, random)));
      break;
    case 1:
      value = *parse_rational(value.get_str() + "e-" + std::to_string(below(40, random)));
      break;
    case 2:
      value = *parse_rational(value.get_str() + "e" + std::to_string(below(4096, random)));
      break;
    case 3:
      value = *parse_rational(value.get_str() + "e-" + std::to_string(below(4096, random)));
      break;
    default:
      break;
  }
  return below(2, random) ? value : Rational(-value);
}

Spectrum random_spectrum(bool at_most_one, Random& random) {
  const auto value = [&] {
    if (below(4, random) == 0) return Rational(0);
    Rational v = abs(random_number(random));
    return at_most_one && v > 1 ? Rational(1, 1 + below(9, random)) : v;
  };
  if (below(2, random)) return Spectrum::scalar(value());
  return {{value(), value(), value()}, false};
}

Point2 random_point(Random& random) { return {random_number(random), random_number(random)}; }

// Edges, then polylines, as every scene that is read from a file.
Scene2 random_scene(Random& random) {
  Scene2 scene;
  scene.file = "random";
  if (below(2, random)) scene.about = "a \"random\" scene\n\\ \x01 \xE2\x98\x80";
  const std::size_t materials = 1 + below(4, random);
  for (std::size_t i = 0; i < materials; ++i)
    scene.materials.push_back(
        {"m \"" + std::to_string(i), random_spectrum(true, random), random_spectrum(false, random)});
  const auto random_surface = [&](const std::string& group) {
    Surface surface;
    surface.material = static_cast<std::uint32_t>(below(materials, random));
    if (below(2, random)) surface.back = static_cast<std::uint32_t>(below(materials, random));
    surface.elements = 1 + static_cast<std::uint32_t>(below(3, random));
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.push_back(group);
    return surface;
  };
  for (std::size_t i = below(6, random); i > 0; --i) {
    Surface surface = random_surface("ed\\ge " + std::to_string(i));
    surface.name = scene.groups.back().name;
    Edge2 edge;
    edge.from = random_point(random);
    edge.to = random_point(random);
    if (edge.from == edge.to) edge.to.x += 1;
    scene.add(surface, edge);
  }
  for (std::size_t i = below(4, random); i > 0; --i) {
    Surface surface = random_surface("line" + std::to_string(i));
    const std::size_t pieces = 1 + below(5, random);
    Edge2 piece;
    piece.from = random_point(random);
    const Point2 first = piece.from;
    for (std::size_t k = 0; k < pieces; ++k) {
      surface.name = scene.groups.back().name + "[" + std::to_string(k) + "]";
      piece.to = k > 0 && k + 1 == pieces && below(2, random) ? first : random_point(random);
      if (piece.from == piece.to) piece.to.x += 1;
      scene.add(surface, piece);
      piece.from = piece.to;
    }
  }
  scene.sky_emission = random_spectrum(false, random);
  scene.closed = below(2, random);
  if (below(2, random)) {
    const auto size = [&] { return Rational(abs(random_number(random))); };
    scene.grids = {Grid2{{-size(), -size()}, {size(), size()}, 3, 16384}};
    if (below(2, random)) scene.grids.front().name = "first \u00fc";
    if (!scene.grids.front().name.empty() && below(2, random))
      scene.grids.push_back({{-size(), -size()}, {size(), size()}, 1, 2, "second"});
  }
  if (below(2, random))
    scene.expect.push_back({"third", "exact", "factor", {"a", "b"}, "", "1/3", "1/3", "a \"proof\"", 0});
  if (below(2, random)) scene.expect.push_back({"", "point", "irradiance", {}, "1/2", "0.50", "", "", 0});
  return scene;
}

void expect_same(const Spectrum& a, const Spectrum& b) {
  EXPECT_EQ(a, b);
  EXPECT_EQ(a.is_scalar, b.is_scalar);
}

// Equal but for files and lines.
void expect_same(const Scene2& a, const Scene2& b) {
  EXPECT_EQ(a.about, b.about);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    EXPECT_EQ(a.materials[i].name, b.materials[i].name);
    expect_same(a.materials[i].reflectivity, b.materials[i].reflectivity);
    expect_same(a.materials[i].emission, b.materials[i].emission);
  }
  EXPECT_EQ(a.groups, b.groups);
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    const Surface &s = a.surfaces[i], &t = b.surfaces[i];
    EXPECT_EQ(s.name, t.name);
    EXPECT_EQ(a.edges[i], b.edges[i]) << s.name;
    EXPECT_TRUE(s.material == t.material && s.back == t.back && s.elements == t.elements) << s.name;
    EXPECT_EQ(s.group, t.group);
  }
  expect_same(a.sky_emission, b.sky_emission);
  EXPECT_EQ(a.closed, b.closed);
  EXPECT_EQ(a.grids, b.grids);
  ASSERT_EQ(a.expect.size(), b.expect.size());
  for (std::size_t i = 0; i < a.expect.size(); ++i) {
    const Expectation &s = a.expect[i], &t = b.expect[i];
    EXPECT_TRUE(s.name == t.name && s.at == t.at && s.kind == t.kind && s.quantity == t.quantity && s.of == t.of &&
                s.value == t.value && s.form == t.form && s.derivation == t.derivation);
  }
}

TEST(WriteScene2, ReadsBackToTheSameScene) {
  Random random(20240229);
  for (int i = 0; i < 300 && !::testing::Test::HasFailure(); ++i) {
    const Scene2 scene = random_scene(random);
    validate(scene);
    const std::string text = write_scene_2(scene);
    const Scene2 again = parse_scene_2(text, "again");
    expect_same(scene, again);
    EXPECT_EQ(write_scene_2(again), text);
  }
}

TEST(WriteScene2, HasALayoutThatPeopleRead) {
  const std::string text = R"({
  "hottel": 1,
  "dimension": 2,
  "about": "a room",
  "materials": {
    "white": {"reflectivity": 0.7},
    "lamp": {"reflectivity": 0.1, "emission": [9, 8, 6]},
    "black": {}
  },
  "edges": [
    {"name": "lamp", "points": [[1, 2.9], ["4/3", 2.9]], "material": "lamp", "back": "white", "elements": 4},
    {"name": "edge[1]", "points": [["1e100", -0.001], ["1e-100", 1000000]], "material": "black"}
  ],
  "polylines": [
    {"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "white"},
    {"name": "shelf", "points": [[1, 1], [2, 1], [2, 2]], "material": "white", "back": "white"}
  ],
  "sky": {"emission": 1},
  "closed": true,
  "grid": {"min": [0, 0], "max": [4, 3], "cells": [400, 300]},
  "expect": [
    {"kind": "exact", "quantity": "factor", "of": ["lamp", "sky"], "value": "0", "form": "0", "derivation": "closed"}
  ]
}
)";
  EXPECT_EQ(write_scene_2(parse_scene_2(text, "text")), text);
  EXPECT_EQ(write_scene_2(Scene2()), "{\n  \"hottel\": 1,\n  \"dimension\": 2\n}\n");
}

TEST(WriteScene2, KeepsTheOrderOfSurfacesWhereItCannotKeepGroups) {
  Scene2 scene = parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
      "edges": [{"name": "e", "points": [[0,0],[1,0]], "material": "m"}],
      "polylines": [{"name": "p", "points": [[0,1],[1,1],[2,1]], "material": "m"},
                    {"name": "q", "points": [[0,2],[1,2],[2,2]], "material": "m"}]})",
                               "text");
  scene.keep({1, 2, 0, 3, 4});  // p[0] p[1] e q[0] q[1]
  const Scene2 again = parse_scene_2(write_scene_2(scene), "again");
  ASSERT_EQ(again.surfaces.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(again.surfaces[i].name, scene.surfaces[i].name);
  EXPECT_THAT(again.groups, ::testing::ElementsAre("p[0]", "p[1]", "e", "q"));
}

// A frame of an animation, written: its lights point to where they have turned.
TEST(WriteScene2, ALightPointsToWhereItHasTurned) {
  Scene2 scene = parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
      "edges": [{"name": "e", "points": [[0,0],[1,0]], "material": "m"}],
      "lights": [{"type": "spot", "position": [0,1], "direction": [0,-1], "focus": 20, "power": 1, "rotation": 15}]})",
                               "text");
  LightPlace2& spot = scene.light_places[0];
  spot = place_after(spot, 6);
  EXPECT_EQ(parse_scene_2(write_scene_2(scene), "again")->light_places[0].direction, (Point2{1, 0}));
  spot = place_after(spot, 1);
  EXPECT_EQ(parse_scene_2(write_scene_2(scene), "again")->light_places[0].direction, turned_direction(spot));
}

TEST(WriteScene2, RefusesNumbersThatNoSceneFileHolds) {
  Scene2 scene;
  scene.sky_emission = Spectrum::scalar(Rational(1) / (Integer("1" + std::string(5000, '0')) + 3));
  EXPECT_THROW(write_scene_2(scene), RequestError);
}

TEST(ParseScene2, MutatedTextsAreScenesOrRefused) {
  Random random(7);
  const std::string alphabet = "{}[]\",:0123456789.eE+-/\\u#\n truefalsn\xFF\xC3";
  int scenes = 0, refusals = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = write_scene_2(random_scene(random));
    if (text.size() > 3000)
      text =
          R"({"hottel":1,"dimension":2,"materials":{"m":{}},"polylines":[{"points":[[0,0],["1/3",1.5],[2,0]],"closed":true,"material":"m"}],"sky":{"emission":[1,2,3]}})";
    switch (below(4, random)) {
      case 0:
        text.resize(below(text.size(), random));
        break;
      case 1:
        text.erase(below(text.size(), random), 1 + below(5, random));
        break;
      case 2:
        text.insert(below(text.size(), random), text.substr(below(text.size(), random), 1 + below(30, random)));
        break;
      default:
        break;
    }
    for (std::size_t flips = below(4, random); flips > 0 && !text.empty(); --flips)
      text[below(text.size(), random)] =
          below(2, random) ? static_cast<char>(below(256, random)) : alphabet[below(alphabet.size(), random)];
    try {
      const Scene2 scene = parse_scene_2(text, "mutant");
      validate(scene);
      ++scenes;
      expect_same(scene, parse_scene_2(write_scene_2(scene), "again"));
    } catch (const InputError& error) {
      ++refusals;
      const std::string message = error.what();
      EXPECT_EQ(message.rfind("mutant", 0), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LE(error.where().line, 1 + std::count(text.begin(), text.end(), '\n')) << message;
    } catch (const RequestError&) {
      // a scene with a number too long to be written again
    }
    ASSERT_FALSE(::testing::Test::HasFailure()) << text;
  }
  EXPECT_GT(scenes, 100);
  EXPECT_GT(refusals, 500);
}

}  // namespace
}  // namespace hottel::scene_json_round_trip_test

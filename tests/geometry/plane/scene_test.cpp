#include "geometry/plane/scene/scene.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/name.h"

namespace hottel::scene_test {
namespace {

Scene2 two_edges() {
  Scene2 scene;
  scene.file = "memory";
  scene.materials.resize(1);
  scene.groups = {"a", "b"};
  scene.surfaces.resize(2);
  scene.edges.resize(2);
  for (std::uint32_t i = 0; i < 2; ++i) {
    scene.surfaces[i].name = scene.groups[i].name;
    scene.edges[i].to = {1, Rational(i)};
    scene.surfaces[i].group = i;
    scene.surfaces[i].line = static_cast<int>(i) + 5;
  }
  return scene;
}

std::string refusal(const Scene2& scene) {
  try {
    validate(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ValidateScene2, AcceptsAScene) {
  EXPECT_EQ(refusal(two_edges()), "");
  EXPECT_EQ(refusal(Scene2()), "");
}

TEST(ValidateScene2, RefusesNamesThatAreNotAllowedOrNotUnique) {
  Scene2 scene = two_edges();
  scene.surfaces[1].name = scene.surfaces[0].name;
  EXPECT_EQ(refusal(scene), "memory:6: two surfaces have the name 'a', the other one in line 5");
  for (const std::string name : {"", "sky", "a#1", "a:back", "a\x7F", "\xFF", "a\nb"}) {
    scene.surfaces[1].name = name;
    EXPECT_TRUE(refusal(scene).starts_with("memory:6: the name ")) << name;
  }
}

TEST(ValidateScene2, RefusesSurfacesWithoutLength) {
  Scene2 scene = two_edges();
  scene.edges[0].to = scene.edges[0].from;
  EXPECT_EQ(refusal(scene), "memory:5: surface 'a' has length zero");
}

TEST(ValidateScene2, RefusesIndicesOutOfRange) {
  Scene2 scene = two_edges();
  scene.surfaces[0].material = 1;
  EXPECT_EQ(refusal(scene), "memory:5: surface 'a' has a material that is not defined");
  scene = two_edges();
  scene.surfaces[0].back = 1;
  EXPECT_EQ(refusal(scene), "memory:5: surface 'a' has a material that is not defined");
  scene = two_edges();
  scene.surfaces[1].group = 2;
  EXPECT_EQ(refusal(scene), "memory:6: surface 'b' has a group that is not defined");
}

TEST(Scene2Find, ReturnsTheSurfaceOfThatName) {
  EXPECT_EQ(two_edges().find("b"), 1u);
  EXPECT_FALSE(two_edges().find("c"));
}

// (1) of Scene2: as many edges as surfaces, each at the place of its own.
TEST(Scene2, KeepsSurfacesAndTheirEdgesTogether) {
  Scene2 scene = two_edges();
  scene.add({.name = "c", .material = 0, .back = {}, .elements = 1, .group = 1, .line = 7}, {{5, 6}, {7, 8}});
  const Scene2 all = scene;
  scene.keep({2, 0});
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_EQ(scene.surfaces[0].name, "c");
  EXPECT_EQ(scene.surfaces[1].name, "a");
  EXPECT_EQ(scene.edges, (std::vector<Edge2>{all.edges[2], all.edges[0]}));
  scene.edges.pop_back();
  EXPECT_THROW(validate(scene), ContractViolation);
}

TEST(PointAt, DividesAnEdgeExactly) {
  const Edge2 edge{{0, 1}, {1, 0}};
  EXPECT_EQ(point_at(edge, 0), edge.from);
  EXPECT_EQ(point_at(edge, 1), edge.to);
  EXPECT_EQ(point_at(edge, Rational(1, 3)), (Point2{Rational(1, 3), Rational(2, 3)}));
}

// What has no dimension is told apart without one.
TEST(SceneTable, IsValidByItself) {
  SceneTable table = two_edges();
  EXPECT_NO_THROW(validate_table(table));
  EXPECT_EQ(channel_count(table), 1);
  table.materials[0].emission.is_scalar = false;
  EXPECT_EQ(channel_count(table), 3);
  table.surfaces[1].name = "a";
  EXPECT_THROW(validate_table(table), InputError);
}

TEST(Name, IsUtf8WithoutControlCharacters) {
  for (const char* good : {"a", "sky2", "Küche", "日本", "\xF0\x9F\x98\x80", ":back door", "a:Back", "\xC2\xA0"})
    EXPECT_TRUE(name_problem(good).empty()) << good;
  // overlong, surrogate, beyond U+10FFFF, cut short, stray continuation, C1 control
  for (const char* bad :
       {"\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x98", "\x80", "\xC2\x85"})
    EXPECT_FALSE(name_problem(bad).empty());
  EXPECT_TRUE(is_utf8("\xC2\x85"));
  EXPECT_FALSE(is_utf8("\xED\xA0\x80"));
  EXPECT_FALSE(name_problem(std::string_view("a\0b", 3)).empty());
}

TEST(Name, IsQuotedOnOneLine) {
  EXPECT_EQ(quoted_name("Küche"), "'Küche'");
  EXPECT_EQ(quoted_name("a\nb\xFF"), "'a\\x0Ab\\xFF'");
  const std::string long_name = std::string(100, 'a') + std::string(100, 'b');
  EXPECT_EQ(quoted_name(long_name), "'" + std::string(40, 'a') + "..." + std::string(16, 'b') + "'");
}

TEST(ValidateScene2, RefusesMaterialsOutOfRange) {
  Scene2 scene = two_edges();
  scene.materials[0].name = "m";
  scene.materials[0].reflectivity = Spectrum::scalar(Rational(11, 10));
  EXPECT_EQ(refusal(scene), "memory: material 'm': reflectivity must be from 0 to 1");
  scene.materials[0].reflectivity = {{0, 1, 0}, true};
  EXPECT_EQ(refusal(scene), "memory: material 'm': reflectivity is a scalar of more than one value");
  scene.materials[0].reflectivity = {};
  scene.materials[0].emission = Spectrum::scalar(-1);
  EXPECT_EQ(refusal(scene), "memory: material 'm': emission must not be negative");
  scene.materials[0].emission = {};
  scene.sky_emission = Spectrum::scalar(-1);
  EXPECT_EQ(refusal(scene), "memory: sky: emission must not be negative");
}

TEST(ValidateScene2, RefusesNumbersThatAreNotInLowestTerms) {
  Scene2 scene = two_edges();
  scene.edges[1].to.x = Rational(2, 4);  // as mpq_class leaves it
  EXPECT_EQ(refusal(scene),
            "memory:6: surface 'b' has a coordinate that is not in lowest terms (mpq_class::canonicalize)");
  scene.edges[1].to.x = 1;
  scene.sky_emission.value.fill(Rational(2, 4));
  EXPECT_EQ(refusal(scene), "memory: sky: emission is not in lowest terms (mpq_class::canonicalize)");
}

TEST(ValidateScene2, RefusesElementsAndGridsOutOfRange) {
  Scene2 scene = two_edges();
  scene.surfaces[0].elements = 0;
  EXPECT_EQ(refusal(scene), "memory:5: surface 'a' has 0 elements; it may have 1 to 1000000");
  scene.surfaces[0].elements = 1;
  scene.grids = {Grid2{{0, 0}, {1, 1}, 0, 1}};
  EXPECT_EQ(refusal(scene), "memory: grid: cells must be integers from 1 to 16384");
  scene.grids = {Grid2{{0, 0}, {1, 0}, 1, 1}};
  EXPECT_EQ(refusal(scene), "memory: grid: max must be greater than min in both coordinates");
}

TEST(ValidateScene2, RefusesSeveralGridsUnlessEachHasANameOfItsOwn) {
  Scene2 scene = two_edges();
  const auto named = [&](const std::vector<std::string>& names) {
    scene.grids.clear();
    for (const std::string& name : names) scene.grids.push_back({{0, 0}, {1, 1}, 2, 1, name});
    return refusal(scene);
  };
  EXPECT_EQ(named({""}), "");
  EXPECT_EQ(named({"desk"}), "");
  EXPECT_EQ(named({"desk", "floor"}), "");
  EXPECT_EQ(named({"desk", ""}), "memory: grid: a name must not be empty");
  EXPECT_EQ(named({"desk", "desk"}), "memory: grid: two are called 'desk'");
  EXPECT_EQ(named({"desk", "Desk"}),
            "memory: grid: 'desk' and 'Desk' differ in case only: on a disk without case their files would be one");
  EXPECT_EQ(named({"a|b"}),
            "memory: grid: a name must not contain / \\ : * ? \" < > or |: it is part of the names of files");
}

}  // namespace
}  // namespace hottel::scene_test

// What is called so in a scene, and how its surfaces are divided.
#include "geometry/scene_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/near_names.h"
#include "geometry/plane/scene/division.h"

namespace hottel::scene_names_test {
namespace {

using ::testing::ElementsAre;

// Two pieces of a polyline "room", and an edge of its own.
Scene2 named_scene() {
  Scene2 scene;
  scene.file = "named.json";
  scene.materials.resize(1);
  scene.groups = {"room", "window1"};
  const auto add = [&](const char* name, const Point2& from, const Point2& to, std::uint32_t group) {
    Surface surface;
    surface.name = name;
    surface.group = group;
    scene.add(surface, {from, to});
  };
  add("room[0]", {0, 0}, {3, 4}, 0);
  add("room[1]", {3, 4}, {4, 5}, 0);
  add("window1", {0, 1}, {0, 2}, 1);
  return scene;
}

template <class Call>
std::vector<std::string> hints_of(const Call& call) {
  try {
    call();
  } catch (const UnknownName& error) {
    return error.hints();
  }
  return {"nothing was thrown"};
}

TEST(SceneNames, SurfacesMatchByTheirNameTheirPolylineOrABeginning) {
  const Scene2 scene = named_scene();
  EXPECT_THAT(surfaces_matching(scene, "room"), ElementsAre(0, 1));
  EXPECT_THAT(surfaces_matching(scene, "room[1]"), ElementsAre(1));
  EXPECT_THAT(surfaces_matching(scene, "win*"), ElementsAre(2));
  EXPECT_THAT(surfaces_matching(scene, "*"), ElementsAre(0, 1, 2));
}

TEST(SceneNames, PatternsDescribeNamesAsAShellDoes) {
  const Scene2 scene = named_scene();
  EXPECT_THAT(surfaces_matching(scene, "*[0-9]"), ElementsAre(2));
  EXPECT_THAT(surfaces_matching(scene, "w?ndow[!2]"), ElementsAre(2));
  EXPECT_THAT(surfaces_matching(scene, "r*m"), ElementsAre(0, 1)) << "their group";
  EXPECT_THAT(surfaces_matching(scene, "room[[]?]"), ElementsAre(0, 1));
  EXPECT_THAT(surfaces_matching(scene, "room[*"), ElementsAre(0, 1));
  EXPECT_THAT(hints_of([&] { surfaces_matching(scene, "?windo1"); }), ElementsAre("did you mean 'window1'?"));
}

TEST(SceneNames, ANameIsFirstWhatItIs) {
  Scene2 scene = named_scene();
  scene.surfaces[2].name = "w[12]*";
  scene.surfaces[1].name = "w1";
  scene.surfaces[0].name = "w\xC3\xA4";
  EXPECT_THAT(surfaces_matching(scene, "w[12]*"), ElementsAre(2));
  EXPECT_THAT(surfaces_matching(scene, "w[12]"), ElementsAre(1));
  EXPECT_THAT(surfaces_matching(scene, "w?"), ElementsAre(0, 1)) << "a letter of two bytes is one";
  EXPECT_THAT(surfaces_matching(scene, "w[a-z\xC3\xA4]"), ElementsAre(0));
}

TEST(SceneNames, FacesAreFrontsAndBacks) {
  const Scene2 scene = named_scene();
  EXPECT_EQ(face_of(scene, "window1").surface, 2u);
  EXPECT_FALSE(face_of(scene, "window1").is_back);
  EXPECT_EQ(face_of(scene, "room[1]:back").surface, 1u);
  EXPECT_TRUE(face_of(scene, "room[1]:back").is_back);
}

TEST(SceneNames, UnknownNamesComeWithNearOnes) {
  const Scene2 scene = named_scene();
  EXPECT_THAT(hints_of([&] { face_of(scene, "windw1"); }), ElementsAre("did you mean 'window1'?"));
  EXPECT_THAT(hints_of([&] { surfaces_matching(scene, "windo3*"); }), ElementsAre("did you mean 'window*'?"));
}

TEST(SceneNames, WhereNoNameIsNearItIsToldWhichThereAre) {
  const Scene2 scene = named_scene();
  const auto all = ElementsAre("its surfaces are 'room[0]', 'room[1]' and 'window1'");
  EXPECT_THAT(hints_of([&] { face_of(scene, "fluorescent"); }), all);
  EXPECT_THAT(hints_of([&] { surfaces_matching(scene, "fluorescent"); }), all);
  EXPECT_THAT(hints_of([&] { surfaces_matching(scene, "fluo*"); }), all);
  EXPECT_THAT(hints_of([] { surfaces_matching(Scene2{}, "fluorescent"); }), ElementsAre());
}

TEST(Division2, PartsAreAsFewAsALengthAllows) {
  Scene2 scene = named_scene();
  EXPECT_EQ(divide_by_length(scene, Rational(5), 100), std::nullopt);
  EXPECT_EQ(scene.surfaces[0].elements, 1u);  // 5 long, exactly
  EXPECT_EQ(divide_by_length(scene, Rational(1), 100), std::nullopt);
  EXPECT_EQ(scene.surfaces[0].elements, 5u);
  EXPECT_EQ(scene.surfaces[1].elements, 2u);  // the root of 2 long
  EXPECT_EQ(scene.surfaces[2].elements, 1u);
  EXPECT_EQ(divide_by_length(scene, Rational(1) - Rational(1, 1'000'000'000), 100), std::nullopt);
  EXPECT_EQ(scene.surfaces[0].elements, 6u);
}

TEST(Division2, TheFirstSurfaceOfTooManyPartsIsTold) {
  Scene2 scene = named_scene();
  divide_into(scene, 7);
  EXPECT_EQ(divide_by_length(scene, Rational(1, 3), 4), 0u);
  EXPECT_EQ(divide_by_length(scene, Rational(1, 3), 15), std::nullopt);
  EXPECT_EQ(scene.surfaces[0].elements, 15u);
}

}  // namespace
}  // namespace hottel::scene_names_test

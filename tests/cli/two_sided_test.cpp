// Materials of both sides, and the backs of meshes by their groups.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::two_sided_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_cli::Outcome;
using testing_cli::Workplace;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

// Screens in a room of the plane, and of space: one says a back of its own, one says nothing.
const std::string kPlane = R"({"hottel": 1, "dimension": 2,
  "materials": {"wall": {"emission": 1}, "leaf": {"reflectivity": 0.5, "two_sided": true}}, "edges": [
  {"name": "screen", "points": [[1, 1], [3, 2]], "material": "leaf"},
  {"name": "shelf", "points": [[0, 2], [1, 2]], "material": "leaf", "back": "wall"}], "polylines": [
  {"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "wall"}]})";
const std::string kSpace = R"({"hottel": 1, "dimension": 3,
  "materials": {"wall": {"emission": 1}, "leaf": {"reflectivity": 0.5, "two_sided": true}}, "polygons": [
  {"name": "screen", "points": [[1,1,1],[3,1,1],[3,2,1]], "material": "leaf"},
  {"name": "shelf", "points": [[1,1,2],[3,1,2],[3,2,2]], "material": "leaf", "back": "wall"},
  {"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "wall"},
  {"name": "roof", "points": [[0,0,3],[0,4,3],[4,4,3],[4,0,3]], "material": "wall"}]})";

// The same with backs on every surface.
std::string said_each(std::string scene) {
  replace_all(scene, ", \"two_sided\": true", "");
  replace_all(scene, "\"material\": \"leaf\"}", "\"material\": \"leaf\", \"back\": \"leaf\"}");
  return scene;
}

TEST(TwoSided, IsShortForABackOnEachSurface) {
  const Workplace place;
  for (const std::string& scene : {kPlane, kSpace}) {
    place.write("short.json", scene);
    place.write("long.json", said_each(scene));
    const Outcome a = place.run("hottel factors short.json --quiet"), b = place.run("hottel factors long.json --quiet");
    EXPECT_EQ(a.code, 0) << a.err;
    EXPECT_EQ(a.out, b.out);
    EXPECT_THAT(a.out, AllOf(HasSubstr("screen:back,"), HasSubstr("shelf:back,")));
    ASSERT_EQ(place.run("hottel solve short.json -o s --no-illumination --quiet").code, 0);
    ASSERT_EQ(place.run("hottel solve long.json -o l --no-illumination --quiet").code, 0);
    EXPECT_EQ(place.read("s/radiosity.csv"), place.read("l/radiosity.csv"));
  }
}

TEST(TwoSided, IsKeptByConvert) {
  const Workplace place;
  for (const std::string& scene : {kPlane, kSpace}) {
    place.write("scene.json", scene);
    ASSERT_EQ(place.run("hottel convert scene.json once.json; hottel convert once.json twice.json").code, 0);
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
    EXPECT_THAT(place.read("once.json"), AllOf(HasSubstr("\"leaf\": {\"reflectivity\": 0.5, \"two_sided\": true}"),
                                               HasSubstr("\"material\": \"leaf\", \"back\": \"leaf\""),
                                               HasSubstr("\"material\": \"leaf\", \"back\": \"wall\"")));
    EXPECT_EQ(place.run("hottel factors once.json --quiet").out, place.run("hottel factors scene.json --quiet").out);
  }
}

TEST(TwoSided, StoresTakeItForWhatItIs) {
  const Workplace place;
  for (const std::string& scene : {kPlane, kSpace}) {
    place.write("short.json", scene);
    place.write("long.json", said_each(scene));
    ASSERT_EQ(place.run("hottel factors short.json --store s -o a.csv").code, 0);
    EXPECT_THAT(place.run("hottel factors long.json --store s --json -o b.csv").out, HasSubstr("\"computed\": 0"));
    EXPECT_EQ(place.read("a.csv"), place.read("b.csv"));
    ASSERT_EQ(place.run("sed -i 's/, \"two_sided\": true//' short.json; rm -f b.csv").code, 0);
    EXPECT_THAT(place.run("hottel factors short.json --store s --json -o b.csv").out,
                Not(HasSubstr("\"computed\": 0")));
  }
}

// A patch has the back that it says, and takes its part of the front of what it lies on alone.
TEST(TwoSided, PatchesHaveTheBacksThatTheySay) {
  const Workplace place;
  for (const std::string& scene : {kPlane, kSpace}) {
    std::string with = scene;
    replace_all(with, R"(2]], "material": "leaf", "back": "wall"})",
                scene == kPlane ? R"(2]], "material": "leaf", "back": "wall"},
      {"name": "pane", "points": [[0.25, 2], [0.5, 2]], "material": "leaf", "on": "shelf"})"
                                : R"(2]], "material": "leaf", "back": "wall"},
      {"name": "pane", "points": [[2,1,2],[2.5,1,2],[2.5,1.25,2]], "material": "leaf", "on": "shelf"})");
    ASSERT_NE(with, scene);
    place.write("scene.json", with);
    const Outcome rows = place.run("hottel factors scene.json --quiet");
    EXPECT_EQ(rows.code, 0) << rows.err;
    EXPECT_THAT(rows.out, AllOf(HasSubstr("\npane,"), HasSubstr("\nscreen:back,"), Not(HasSubstr("\npane:back,"))));
    ASSERT_EQ(place.run("hottel convert scene.json once.json").code, 0);
    EXPECT_THAT(place.read("once.json"), HasSubstr("\"two_sided\": true"));
    EXPECT_EQ(place.run("hottel factors once.json --quiet").out, rows.out);
  }
}

TEST(TwoSided, IsTrueOrFalse) {
  const Workplace place;
  std::string scene = kPlane;
  replace_all(scene, "\"two_sided\": true", "\"two_sided\": 1");
  place.write("scene.json", scene);
  const Outcome outcome = place.run("hottel check scene.json");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("scene.json:2: material 'leaf': two_sided"));
}

TEST(TwoSided, TheCheckNamesItWhereBacksAreBlack) {
  const Workplace place;
  for (const std::string& scene : {kPlane, kSpace}) {
    std::string without = scene;
    replace_all(without, ", \"two_sided\": true", "");
    place.write("scene.json", without);
    EXPECT_THAT(place.run("hottel check scene.json").out, HasSubstr("or its material \"two_sided\": true"));
  }
}

// Two squares that look up, in groups, and one in none.
constexpr const char* kMesh =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 3 0 1\nv 3 1 1\nv 2 1 1\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n"
    "f 9 10 11 12\ng low\nusemtl m\nf 1 2 3 4\ng high\nf 5 6 7 8\n";

std::string meshes(const std::string& members, const std::string& of_m = "") {
  return R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5)" + of_m +
         R"(}, "n": {"emission": 1}}, "mesh": {"file": "sheets.obj", "name": "top", "material": "m")" + members + "}}";
}

TEST(TwoSided, BacksOfMeshesAreByGroup) {
  const Workplace place;
  place.write("sheets.obj", kMesh);
  const auto converted = [&](const std::string& scene) {
    place.write("scene.json", scene);
    const Outcome outcome = place.run("hottel convert scene.json out.json --quiet");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return place.read("out.json");
  };
  const auto has = [](const char* group, const char* back) {
    const std::string name = std::string("\"name\": \"") + group + "[[]0[]]\"";
    return ::testing::ContainsRegex(
        name + ".*" + (back == nullptr ? "\"material\": \"m\"[^b]*}" : "\"back\": \"" + std::string(back) + "\""));
  };
  EXPECT_THAT(converted(meshes("")), Not(HasSubstr("\"back\"")));
  EXPECT_THAT(converted(meshes(R"(, "backs": {"low": "n"})")),
              AllOf(HasSubstr("\"back\": \"n\""), has("low", "n"), has("high", nullptr)));
  EXPECT_THAT(converted(meshes(R"(, "back": "m", "backs": {"low": "n", "top": "n"})")),
              AllOf(has("low", "n"), has("high", "m"), has("top", "n")));
  EXPECT_THAT(converted(meshes(R"(, "backs": {"low": "n"})", ", \"two_sided\": true")),
              AllOf(has("low", "n"), has("high", "m"), has("top", "m")));
}

TEST(TwoSided, BacksOfWhatIsNotThereAreRefused) {
  const Workplace place;
  place.write("sheets.obj", kMesh);
  const auto refused = [&](const std::string& members) {
    place.write("scene.json", meshes(members));
    const Outcome outcome = place.run("hottel convert scene.json out.json");
    EXPECT_EQ(outcome.code, 3);
    return outcome.err;
  };
  EXPECT_THAT(refused(R"(, "backs": {"lou": "n"})"),
              AllOf(HasSubstr("scene.json:1: mesh 'top': backs: "), HasSubstr("has no group 'lou'"),
                    HasSubstr("did you mean 'low'")));
  EXPECT_THAT(refused(R"(, "backs": {"wall": "n"})"), HasSubstr("its groups are 'low', 'high', 'top'"));
  EXPECT_THAT(refused(R"(, "backs": {"low": "x"})"), HasSubstr("the back of 'low' 'x' is not defined"));
  EXPECT_THAT(refused(R"(, "backs": ["low"])"), HasSubstr("mesh 'top': backs"));
}

}  // namespace
}  // namespace hottel::two_sided_test

#include "io/scene/space/vs3_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "io/scene/scene_json.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"

namespace hottel::vs3_writer_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

Scene3 scene_of(const std::string& polygons, const std::string& materials = R"("m": {"reflectivity": "1/4"})") {
  return parse_scene_3(
      "{\"hottel\": 1, \"dimension\": 3, \"materials\": {" + materials + "},\n\"polygons\": [" + polygons + "]}",
      "scene.json");
}

TEST(Vs3Writer, WritesSquaresAndTrianglesWithTheirVerticesOnce) {
  const Scene3 scene = scene_of(
      R"({"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
         {"name": "roof", "points": [[0,0,0],[1,0,0],["1/2","1/4","0.1"]], "material": "m"})");
  const WrittenVs3Deck3 deck = write_vs3_3(scene, false);
  EXPECT_EQ(deck.text,
            "C encl=0\nF 3\n!  #   x y z\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0.5 0.25 0.1\n"
            "!  #   v1 v2 v3 v4   base cmb   emit   name\n"
            "S 1  1 2 3 4   0 0   0.75   floor\nS 2  1 2 5 0   0 0   0.75   roof\nEnd\n");
  EXPECT_THAT(deck.notes, ElementsAre(StartsWith("black backs are not in the deck")));
}

TEST(Vs3Writer, WhatItWritesIsReadBackExactly) {
  const Vs3Scene3 first = parse_vs3_3(
      "T a b\nC encl=1\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 .1\nV 6 1 0 .1\nV 7 1 1 .1\n"
      "S 1 1 2 3 0 0 0 .9 a\nS 2 7 6 5 0 0 0 .3 b\nS 3 1 3 4 0 0 1 .9 c\nO 4 1 2 6 5\n",
      "first.vs3");
  const WrittenVs3Deck3 deck = write_vs3_3(first.scene, true);
  const Vs3Scene3 again = parse_vs3_3(deck.text, "again.vs3");
  EXPECT_EQ(again.scene->polygons, first.scene->polygons);
  EXPECT_EQ(again.scene->groups, first.scene->groups);
  EXPECT_EQ(again.scene->materials, first.scene->materials);
  EXPECT_EQ(again.scene->about, "a b");
  EXPECT_TRUE(again.scene->closed);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(again.scene->surfaces[s].name, first.scene->surfaces[s].name);
    EXPECT_EQ(again.scene->surfaces[s].is_obstruction, s == 3);
  }
  EXPECT_EQ(write_vs3_3(again.scene, true).text, deck.text);
}

TEST(Vs3Writer, CutsWhatHasMoreThanFourCornersAndCombinesItAgain) {
  const Scene3 scene =
      scene_of(R"({"name": "house", "points": [[0,0,0],[1,0,0],[2,0,0],[2,1,0],[1,2,0],[0,1,0]], "material": "m"})");
  const WrittenVs3Deck3 deck = write_vs3_3(scene, false);
  // The point in the middle of a side is no corner: five are left, three triangles.
  EXPECT_THAT(deck.text, HasSubstr("S 1  1 2 3 0   0 0   0.75   house\nS 2  1 3 4 0   0 1   0.75   house.2\n"
                                   "S 3  1 4 5 0   0 1   0.75   house.3\n"));
  EXPECT_THAT(deck.notes, IsSupersetOf({StartsWith("'house': cut into pieces")}));
}

TEST(Vs3Writer, WhatFillsTheHolesOfAPolygonIsItsSubsurface) {
  const std::string text =
      "C encl=0\nF 3\n!  #   x y z\nV 1 0 0 0\nV 2 4 0 0\nV 3 4 4 0\nV 4 0 4 0\nV 5 1 1 0\nV 6 2 1 0\nV 7 2 2 0\n"
      "V 8 3 3 0\nV 9 3 2 0\nV 10 1.5 1 0\nV 11 1.5 1.5 0\n"
      "!  #   v1 v2 v3 v4   base cmb   emit   name\n"
      "S 1  1 2 3 4   0 0   0.9   floor\nS 2  5 6 7 0   1 0   0.5   rug\nN 3  8 9 7 0   1 0   0.5   leg\n"
      "S 4  10 6 11 0   2 0   0.5   spot\nEnd\n";
  const WrittenVs3Deck3 deck = write_vs3_3(parse_vs3_3(text, "a.vs3").scene, false);
  EXPECT_EQ(deck.text, text);
  EXPECT_THAT(deck.notes, ElementsAre(StartsWith("black backs are not in the deck")));
}

TEST(Vs3Writer, AMaskIsAnMRecord) {
  Scene3 scene = parse_vs3_3(
                     "F 3\nV 1 0 0 0\nV 2 4 0 0\nV 3 4 4 0\nV 4 0 4 0\nV 5 1 1 0\nV 6 2 1 0\nV 7 2 2 0\n"
                     "S 1 1 2 3 4 0 0 .5 floor\nM 2 5 7 6 0 1 0 .25 foot\n",
                     "deck.vs3")
                     .scene;
  const WrittenVs3Deck3 deck = write_vs3_3(scene, true);
  EXPECT_THAT(deck.text, HasSubstr("M 2  5 6 7 0   1 0   0.25   foot\n"));
  EXPECT_THAT(deck.notes, ElementsAre(HasSubstr("black backs are not in the deck")));
  EXPECT_EQ(parse_vs3_3(deck.text, "again.vs3").scene->masks, scene.masks);
  // Of a base that has more corners than a record there is none.
  scene.polygons[0].points.insert(scene.polygons[0].points.begin() + 1, {2, -1, 0});
  try {
    write_vs3_3(scene, true);
    ADD_FAILURE() << "was written";
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(), "'foot' masks 'floor', which is no single record before it: a deck cannot say that");
  }
}

TEST(Vs3Writer, APolygonWithAHoleThatNothingFillsIsCut) {
  const char* const kFloor =
      R"({"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "holes": [[[1,1,0],[2,1,0],[2,2,0]]], "material": "m"})";
  const WrittenVs3Deck3 deck = write_vs3_3(scene_of(kFloor), false);
  EXPECT_THAT(deck.notes, IsSupersetOf({StartsWith("'floor': cut into pieces")}));
  Rational area;
  const Vs3Scene3 again = parse_vs3_3(deck.text, "a.vs3");
  for (const Polygon3& piece : again.scene->polygons) area += doubled_area(piece).z;
  EXPECT_EQ(area, 31);
  // A front that looks the other way is no subsurface.
  const WrittenVs3Deck3 turned = write_vs3_3(
      scene_of(std::string(kFloor) + R"(, {"name": "rug", "points": [[2,2,0],[2,1,0],[1,1,0]], "material": "m"})"),
      false);
  EXPECT_THAT(turned.notes, IsSupersetOf({StartsWith("'floor': cut into pieces")}));
}

TEST(Vs3Writer, TellsWhatLosesAreaToOthersButNotOfThinWalls) {
  const std::string floor = R"({"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "m"})";
  const std::string tile = R"(, {"name": "tile", "points": [[3,3,0],[5,3,0],[5,5,0],[3,5,0]], "material": "m"})";
  const std::string under = R"(, {"name": "under", "points": [[0,0,0],[0,4,0],[4,4,0],[4,0,0]], "material": "m"})";
  EXPECT_THAT(write_vs3_3(scene_of(floor + tile), false).notes,
              IsSupersetOf({StartsWith("'tile': whole in the deck, though parts")}));
  EXPECT_THAT(write_vs3_3(scene_of(floor + under), false).notes,
              ElementsAre(StartsWith("black backs are not in the deck")));
}

TEST(Vs3Writer, BacksWithAMaterialAreSurfacesOfTheirOwn) {
  const Scene3 scene = scene_of(
      R"({"name": "fin", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m", "back": "b"},
         {"name": "lid", "points": [[0,0,1],[1,0,1],[1,1,1]], "obstruction": true},
         {"name": "floor of it", "points": [[0,0,-1],[1,0,-1],[1,1,-1]], "material": "b"})",
      R"("m": {"reflectivity": 0.2}, "b": {"reflectivity": [0.1, 0.2, 0.6], "emission": 1})");
  const WrittenVs3Deck3 deck = write_vs3_3(scene, false);
  EXPECT_THAT(deck.text, HasSubstr("S 1  1 2 3 4   0 0   0.8   fin\nS 2  1 4 3 2   0 0   0.7   fin-back\n"
                                   "S 3  5 6 7 0   0 0   0.7   floor_of_it\nO 4  8 9 10 0\nEnd\n"));
  EXPECT_THAT(deck.notes, IsSupersetOf({StartsWith("materials that are not gray have the mean"),
                                        StartsWith("1 back with a material is a surface NAME-back"),
                                        StartsWith("a deck does not say what surfaces and the sky emit"),
                                        StartsWith("1 names have '_'")}));
}

TEST(Vs3Writer, CombinesGroupsWhereItIsAskedTo) {
  const Scene3 scene = scene_of(
      R"({"name": "a", "group": "walls", "points": [[0,0,0],[1,0,0],[1,1,0]], "material": "m"},
         {"name": "b", "points": [[0,0,1],[1,0,1],[1,1,1]], "material": "m"},
         {"name": "c", "group": "walls", "points": [[0,0,2],[1,0,2],[1,1,2]], "material": "m"})");
  EXPECT_THAT(write_vs3_3(scene, true).text, HasSubstr("0 0   0.75   walls\nS 2  4 5 6 0   0 0   0.75   b\n"
                                                       "S 3  7 8 9 0   0 1   0.75   c\n"));
  const WrittenVs3Deck3 apart = write_vs3_3(scene, false);
  EXPECT_THAT(apart.text, HasSubstr("0 0   0.75   a\n"));
  EXPECT_THAT(apart.notes, IsSupersetOf({StartsWith("groups are not combined")}));
}

TEST(Vs3Writer, RoundsWhatIsNoShortDecimalAndSaysSo) {
  const Scene3 scene =
      scene_of(R"({"name": "a", "points": [[0,0,"1/3"],[1,0,"1/3"],["2/7",1,"1/3"]], "material": "m"})",
               R"("m": {"reflectivity": "1/3"})");
  const WrittenVs3Deck3 deck = write_vs3_3(scene, false);
  EXPECT_THAT(deck.text, HasSubstr("V 3 0.2857142857142857 1 0.3333333333333333\n"));
  EXPECT_THAT(deck.text, HasSubstr(" 0.6666666666666666 "));
  EXPECT_THAT(deck.notes, IsSupersetOf({StartsWith("2 coordinates are no short decimals"),
                                        StartsWith("emittances that are no short decimals")}));
}

}  // namespace
}  // namespace hottel::vs3_writer_test

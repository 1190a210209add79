#include "io/scene/space/vs3_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/space/arrangement/solids.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/vs3_deck.h"
#include "kernel/support/failure.h"
#include "tests/refusal.h"

namespace hottel::vs3_reader_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

Vs3Scene3 read(const std::string& text) { return parse_vs3_3(text, "in/room.vs3"); }

std::string refusal(const std::string& text) {
  return refusal_by([&] { read(text); });
}

std::string points_text(const std::vector<Point3>& points) {
  std::string text;
  for (const Point3& p : points)
    text += (text.empty() ? "" : " ") + to_string(p.x) + "," + to_string(p.y) + "," + to_string(p.z);
  return text;
}

// "name: x,y,z x,y,z ..." for each surface, holes between bars.
std::vector<std::string> lines(const Scene3& scene) {
  std::vector<std::string> result;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    std::string line = scene.surfaces[s].name + ": " + points_text(scene.polygons[s].points);
    for (const std::vector<Point3>& hole : scene.polygons[s].holes) line += " | " + points_text(hole);
    result.push_back(line);
  }
  return result;
}

// The unit square at z = 0, and around its middle; that at z = 1.
const std::string kSquares =
    "F 3\n"
    "V 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\n"
    "V 5 .25 .25 0\nV 6 .5 .25 0\nV 7 .5 .5 0\nV 8 .25 .5 0\n"
    "V 9 0 0 1\nV 10 1 0 1\nV 11 1 1 1\nV 12 0 1 1\n";

TEST(Vs3Reader, ReadsVerticesAndSurfacesExactly) {
  const Scene3 scene = read(
                           "T two squares\nF 3\n"
                           "V 1 0.1 1e-3 -.5\nV 2 1. 0 0\nV 3 1 1 1.e0\n"
                           "S 1 1 2 3 0 0 0 0.90 a\n")
                           .scene;
  EXPECT_EQ(scene.about, "two squares");
  EXPECT_EQ(scene.file, "in/room.vs3");
  EXPECT_THAT(lines(scene), ElementsAre("a: 1/10,1/1000,-1/2 1,0,0 1,1,1"));
  EXPECT_EQ(scene.surfaces[0].line, 6);
  EXPECT_FALSE(scene.closed);
}

TEST(Vs3Reader, ReflectsOneMinusTheEmittanceExactlyOneMaterialAnEmittance) {
  const Vs3Scene3 read_deck = read(kSquares +
                                   "S 1 1 2 3 4 0 0 0.9 a\nS 2 12 11 10 9 0 0 .90 b\n"
                                   "S 3 9 10 11 12 0 0 0.1 c\n");
  const Scene3& scene = read_deck.scene;
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "emittance 0.9");
  EXPECT_EQ(scene.materials[0].reflectivity.value[0], Rational(1, 10));
  EXPECT_TRUE(scene.materials[0].emission.is_zero());
  EXPECT_EQ(scene.surfaces[1].material, 0u);
  EXPECT_EQ(scene.materials[scene.surfaces[2].material].reflectivity.value[2], Rational(9, 10));
  EXPECT_EQ(scene.surfaces[0].back, std::nullopt);
  EXPECT_THAT(read_deck.notes, IsEmpty());
}

TEST(Vs3Reader, TakesEmittancesAsWrittenAndSaysSoOnce) {
  const Vs3Scene3 deck = read(kSquares + "S 1 1 2 3 4 0 0 0 mirror\nS 2 12 11 10 9 0 0 1 black\n");
  EXPECT_EQ(deck.scene->materials[0].reflectivity.value[0], 1);
  EXPECT_EQ(deck.scene->materials[1].reflectivity.value[0], 0);
  ASSERT_EQ(deck.notes.size(), 1u);
  EXPECT_THAT(deck.notes[0], StartsWith("emittances are as written; View3D takes 0.001"));
  EXPECT_THAT(read(kSquares + "S 1 1 2 3 4 0 0 .001 a\nS 2 12 11 10 9 0 0 .999 b\n").notes, IsEmpty());
}

TEST(Vs3Reader, ReadsCommentsSeparatorsAndLettersAsView3dDoes) {
  const std::vector<std::string> expected{"a: 0,0,0 1,0,0 1,1,0"};
  EXPECT_EQ(lines(read("! a comment\r\n/ another\r\n\r\nf 3 form\r\nv\t1,0,0,0\r\nVertex 2  1 0 0 ! corner\r\n"
                       " v 3 1 1 0 and more\r\ns 1 1 2 3 0 0 0 .5 a said of it\r\nend of data\r\nS 2 nonsense")
                      .scene),
            expected);
  EXPECT_EQ(lines(read("F 3\rV 1 0 0 0\rV 2 1 0 0\rV 3 1 1 0\rS 1 1 2 3 0 0 0 .5 a\r* S 2\rS").scene), expected);
  // Without F the form is 3.
  EXPECT_EQ(lines(read("V 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nS 1 1 2 3 0 0 0 .5 a").scene), expected);
}

TEST(Vs3Reader, NamesThatRepeatHaveTheirNumbers) {
  const std::vector<std::string> squares =
      lines(read(kSquares + "S 1 1 2 3 4 0 0 .5 wall\nS 2 12 11 10 9 0 0 .5 wall\nO 3 5 6 10 9\n").scene);
  EXPECT_THAT(squares, ElementsAre(StartsWith("wall~1: "), StartsWith("wall~2: "), StartsWith("O~3: ")));
  EXPECT_THAT(refusal(kSquares + "S 1 1 2 3 4 0 0 .5 sky\n"),
              StartsWith("in/room.vs3:14: surface 1: the name 'sky' is kept for the sky"));
  EXPECT_THAT(refusal(kSquares + "S 1 1 2 3 4 0 0 .5 a#1\n"), StartsWith("in/room.vs3:14: surface 1: the name 'a#1'"));
}

TEST(Vs3Reader, CutsSubsurfacesOutOfTheirBases) {
  const Scene3 scene = read(kSquares + "S 1 1 2 3 4 0 0 .5 wall\nS 2 5 6 7 8 1 0 .9 window\n").scene;
  EXPECT_THAT(lines(scene), ElementsAre("wall: 0,0,0 1,0,0 1,1,0 0,1,0 | 1/4,1/4,0 1/2,1/4,0 1/2,1/2,0 1/4,1/2,0",
                                        "window: 1/4,1/4,0 1/2,1/4,0 1/2,1/2,0 1/4,1/2,0"));
  EXPECT_EQ(scene.groups.size(), 2u);
}

TEST(Vs3Reader, SubsurfacesMayHaveSubsurfacesAndObstructionsToo) {
  const std::string deck = kSquares + "V 13 .25 .25 0\nV 14 .375 .25 0\nV 15 .375 .5 0\n";
  EXPECT_THAT(
      lines(read(deck + "S 1 1 2 3 4 0 0 .5 wall\nS 2 5 6 7 8 1 0 .9 window\nS 3 13 14 15 0 2 0 .1 pane\n").scene),
      ElementsAre(HasSubstr(" | "), HasSubstr("window: 1/4,1/4,0 1/2,1/4,0 1/2,1/2,0 1/4,1/2,0 | 1/4,1/4,0 "),
                  "pane: 1/4,1/4,0 3/8,1/4,0 3/8,1/2,0"));
  const Scene3 scene = read(kSquares + "S 1 5 6 7 8 2 0 .5 lamp\nO 2 1 2 3 4\n").scene;
  EXPECT_THAT(lines(scene), ElementsAre(StartsWith("lamp: "), HasSubstr("O~2: 0,0,0 1,0,0 1,1,0 0,1,0 | ")));
  EXPECT_TRUE(scene.surfaces[1].is_obstruction);
}

TEST(Vs3Reader, OfABaseThatIsCoveredWhollyNothingIsLeft) {
  const Vs3Scene3 deck = read(kSquares + "S 1 1 2 3 4 0 0 .5 wall\nS 2 1 2 3 0 1 0 .9 a\nS 3 1 3 4 0 1 0 .1 b\n");
  EXPECT_THAT(lines(deck.scene), ElementsAre("a: 0,0,0 1,0,0 1,1,0", "b: 0,0,0 1,1,0 0,1,0"));
  EXPECT_THAT(deck.notes, ElementsAre("subsurfaces cover 'wall' wholly: of these there is no row"));
  EXPECT_EQ(deck.scene->groups.size(), 2u);
}

TEST(Vs3Reader, NullsTakeAreaFromTheirBaseAndStayOpaque) {
  const Scene3 scene = read(kSquares + "S 1 1 2 3 4 0 0 .5 floor\nN 2 8 7 6 5 1 0 .5 under\n").scene;
  EXPECT_THAT(lines(scene), ElementsAre("floor: 0,0,0 1,0,0 1,1,0 0,1,0 | 1/4,1/2,0 1/2,1/2,0 1/2,1/4,0 1/4,1/4,0",
                                        "under: 1/4,1/2,0 1/2,1/2,0 1/2,1/4,0 1/4,1/4,0"));
  EXPECT_TRUE(scene.surfaces[1].is_obstruction);
  EXPECT_EQ(scene.surfaces[1].material_of(false), std::nullopt);
  EXPECT_EQ(refusal(kSquares + "S 1 1 2 3 4 0 0 .5 floor\nN 2 5 6 7 8 1 0 .5 under\n"),
            "in/room.vs3:15: surface 2 'under' faces the same way as its base, surface 1 'floor'; N and M face it");
  EXPECT_EQ(refusal(kSquares + "S 1 1 2 3 4 0 0 .5 floor\nN 2 8 7 6 5 0 0 .5 under\n"),
            "in/room.vs3:15: surface 2 'under' has no base");
}

TEST(Vs3Reader, MasksLieOnTheirBaseWhichStaysWhole) {
  const Scene3 scene = read(kSquares + "S 1 1 2 3 4 0 0 .5 floor\nM 2 8 7 6 5 1 0 .3 bottom\n").scene;
  EXPECT_THAT(lines(scene),
              ElementsAre("floor: 0,0,0 1,0,0 1,1,0 0,1,0", "bottom: 1/4,1/2,0 1/2,1/2,0 1/2,1/4,0 1/4,1/4,0"));
  EXPECT_EQ(scene.masks, (std::vector<Mask3>{{1, 0}}));
  EXPECT_FALSE(scene.surfaces[1].is_obstruction);
  EXPECT_EQ(scene.materials[scene.surfaces[1].material].reflectivity.value[0], Rational(7, 10));
  // They are kept in scene files.
  const Scene3 again = parse_scene_3(write_scene_3(scene), "again.json");
  EXPECT_EQ(again.masks, scene.masks);
  EXPECT_EQ(again.polygons, scene.polygons);
}

TEST(Vs3Reader, MasksOfSubsurfacesAreInTheHoleOfTheBase) {
  const Scene3 scene =
      read(kSquares + "S 1 1 2 3 4 0 0 .5 wall\nS 2 5 6 7 8 1 0 .9 window\nM 3 8 7 6 5 2 0 .3 shutter\n").scene;
  EXPECT_THAT(lines(scene)[0], HasSubstr(" | "));
  EXPECT_EQ(scene.masks, (std::vector<Mask3>{{2, 1}}));
}

TEST(Vs3Reader, RefusesMasksThatLieOnNoneOrOnSeveral) {
  const std::string floor = kSquares + "S 1 1 2 3 4 0 0 .5 floor\n";
  EXPECT_EQ(refusal(floor + "M 2 5 6 7 8 1 0 .5 bottom\n"),
            "in/room.vs3:15: surface 2 'bottom' faces the same way as its base, surface 1 'floor'; N and M face it");
  EXPECT_EQ(refusal(floor + "M 2 8 7 6 5 0 0 .5 bottom\n"), "in/room.vs3:15: surface 2 'bottom' has no base");
  EXPECT_EQ(refusal(floor + "M 2 12 11 10 9 1 0 .5 bottom\n"),
            "in/room.vs3:15: surface 2 'bottom' is not in the plane of its base, surface 1 'floor': it lies 1 off");
  EXPECT_EQ(refusal(floor + "M 2 8 7 6 5 1 1 .5 bottom\n"),
            "in/room.vs3:15: surface 2 'bottom' is combined with another: only S records are");
  EXPECT_EQ(refusal(floor + "M 2 8 7 6 5 3 0 .5 bottom\nO 3 1 2 3 4\n"),
            "in/room.vs3:15: surface 2 'bottom' has the base obstruction 3, which is no S record");
  EXPECT_EQ(refusal(floor + "M 2 8 7 6 5 1 0 .5 bottom\nM 3 5 6 7 0 2 0 .5 other\n"),
            "in/room.vs3:16: surface 3 'other' has the base surface 2 'bottom', which is no S record");
  const std::string both = ": both lie on surface 1 'floor', and one of them is a mask";
  EXPECT_EQ(refusal(floor + "M 2 8 7 6 5 1 0 .5 bottom\nM 3 5 8 7 0 1 0 .5 other\n"),
            "in/room.vs3:16: surface 3 'other' shares an area with surface 2 'bottom'" + both);
  EXPECT_EQ(refusal(floor + "S 2 5 6 7 8 1 0 .5 mat\nM 3 5 8 7 0 1 0 .5 other\n"),
            "in/room.vs3:16: surface 3 'other' shares an area with surface 2 'mat'" + both);
}

TEST(Vs3Reader, ObstructionsHaveNoMaterial) {
  const Scene3 scene = read(kSquares + "S 1 1 2 3 4 0 0 .5 floor\nO 2 9 10 11 12 and this is not read\n").scene;
  EXPECT_THAT(lines(scene), Contains("O~2: 0,0,1 1,0,1 1,1,1 0,1,1"));
  EXPECT_FALSE(scene.surfaces[0].is_obstruction);
  EXPECT_TRUE(scene.surfaces[1].is_obstruction);
  EXPECT_EQ(scene.materials.size(), 1u);
  // They are kept in scene files.
  const Scene3 again = parse_scene_3(write_scene_3(scene), "again.json");
  EXPECT_EQ(again.polygons, scene.polygons);
  EXPECT_TRUE(again.surfaces[1].is_obstruction);
}

TEST(Vs3Reader, WhatIsCombinedIsAGroup) {
  const Vs3Scene3 deck = read(kSquares + "S 1 1 2 3 0 0 0 .5 a\nS 2 12 11 10 9 0 0 .5 b\nS 3 1 3 4 0 0 1 .5 c\n");
  ASSERT_EQ(deck.scene->groups.size(), 2u);
  EXPECT_EQ(deck.scene->groups[0].name, "a");
  EXPECT_EQ(deck.scene->surfaces[2].group, 0u);
  EXPECT_THAT(deck.notes, IsEmpty());
  EXPECT_THAT(read(kSquares + "S 1 1 2 3 0 0 0 .5 a\nS 2 1 3 4 0 0 1 .6 c\n").notes,
              ElementsAre(StartsWith("surfaces of different emittances are combined")));
  EXPECT_EQ(refusal(kSquares + "S 1 1 2 3 0 0 2 .5 a\nS 2 1 3 4 0 0 0 .5 c\n"),
            "in/room.vs3:14: surface 1 'a' is combined with surface 2, which must stand before it");
  EXPECT_EQ(refusal(kSquares + "S 1 1 2 3 0 0 0 .5 a\nS 2 1 3 4 0 0 1 .5 b\nS 3 9 10 11 12 0 2 .5 c\n"),
            "in/room.vs3:16: surface 3 'c' is combined with surface 2 'b', which is combined with another itself");
}

TEST(Vs3Reader, ControlsPromiseAClosedSceneOrAreSaidNotToBeObeyed) {
  const std::string surface = kSquares + "S 1 1 2 3 4 0 0 .5 a\n";
  const Vs3Scene3 deck =
      read("C encl=1 list=2 eps=1.e-5, maxu = 8 MAXO 8 mino=0 emit=1 EPS=1e-4 out=1 ! row=1\n" + surface);
  EXPECT_TRUE(deck.scene->closed);
  EXPECT_TRUE(deck.output.wants_script_f);
  EXPECT_THAT(deck.notes, ElementsAre(StartsWith("eps, maxu, MAXO, mino: read, not obeyed"),
                                      StartsWith("encl=1 promises that the scene is closed")));
  EXPECT_FALSE(read("C encl=0 emit=0\n" + surface).scene->closed);
  EXPECT_FALSE(read("C encl=0 emit=0\n" + surface).output.wants_script_f);
  EXPECT_THAT(read("C encl=0 emit=0\n" + surface).notes, IsEmpty());
  EXPECT_EQ(refusal("C enclosure=1\n" + surface), "in/room.vs3:1: the control 'enclosure' is not known");
  EXPECT_EQ(refusal("C eps=1e-4 encl\n" + surface), "in/room.vs3:1: the control 'encl' has no value");
  EXPECT_THAT(refusal("C encl=yes\n" + surface), StartsWith("in/room.vs3:1: control encl is no whole number: 'yes'"));
  EXPECT_THAT(refusal("C eps=small\n" + surface), StartsWith("in/room.vs3:1: control eps is not a number"));
}

TEST(Vs3Reader, RowAndColumnAreSurfacesOfTheScene) {
  const std::string surfaces =
      kSquares + "S 1 1 2 3 4 0 0 .5 low\nN 2 8 7 6 5 1 0 .5 under\nS 3 12 11 10 9 0 0 .5 high\n";
  const DeckOutput3 all = read(surfaces).output;
  EXPECT_FALSE(all.row || all.column || all.out || all.list != 0);
  const DeckOutput3 some = read("C row=1 out=0 list=1\nC ROW=3, col = 1 out=1 list=0\n" + surfaces).output;
  EXPECT_EQ(some.row, 2u);
  EXPECT_EQ(some.column, 0u);
  EXPECT_EQ(some.out, 1u);
  EXPECT_EQ(some.list, 0u);
  EXPECT_EQ(read("C row=0 col=0\n" + surfaces).output.row, std::nullopt);
  EXPECT_EQ(refusal("T t\nC row=4\n" + surfaces), "in/room.vs3:2: row=4: the deck has 3 surfaces");
  EXPECT_EQ(refusal("C row=2\n" + surfaces),
            "in/room.vs3:1: row=2: surface 2 'under' has no row: only those of S and M records are there");
  EXPECT_EQ(refusal("C col=1\n" + surfaces), "in/room.vs3:1: col=1 is set without row=: a column belongs to a row");
  EXPECT_EQ(refusal("C out=3\n" + surfaces),
            "in/room.vs3:1: control out is 3: there are 0, text, 1, binary, and 2, a sparse list");
  EXPECT_THAT(refusal("C row=-1\n" + surfaces), StartsWith("in/room.vs3:1: control row is no whole number: '-1'"));
  EXPECT_EQ(refusal("C row=1\n" + kSquares + "S 1 1 2 3 4 0 0 .5 wall\nS 2 1 2 3 0 1 0 .9 a\nS 3 1 3 4 0 1 0 .1 b\n"),
            "in/room.vs3:1: row=1: surface 1 'wall' has no row: subsurfaces cover it wholly");
}

// The room of View3D's example of this form: its corners are whole numbers.
TEST(Vs3Reader, ReadsTheFormOfPlanesExactlyWhereAnglesAreQuarters) {
  const Scene3 scene = read(
                           "T L\nF  3a\n!  #  s base cmb emit  name\n"
                           "S  1  R   0   0  0.90  srf-1\n  3. 0. 0.    0  90    3. 3.\n"
                           "S  2  R   0   0  0.90  srf-2 west\n  3. 1. 0.  270  90    1. 3.\n"
                           "S  3  Q   0   0  0.90  srf-7\n  3. 0. 3.    0  180 \n  2. 0.   3. 0.   3. 1.   2. 1.\n"
                           "S  4  t   0   0  0.90  srf-8\n  0. 0. 0.\n -180   0 ! flat\n  0. 0.   1. 0.\n\n  1. 1.\n"
                           "O  5  r\n 1 1 1  450  0  1 1\nEnd\n")
                           .scene;
  EXPECT_THAT(lines(scene), ElementsAre("srf-1: 3,0,3 3,0,0 0,0,0 0,0,3", "srf-2: 3,1,3 3,1,0 3,0,0 3,0,3",
                                        "srf-7: 1,0,3 0,0,3 0,1,3 1,1,3", "srf-8: 0,0,0 1,0,0 1,1,0",
                                        "O~5: 0,1,1 1,1,1 1,2,1 0,2,1"));
}

TEST(Vs3Reader, OtherAnglesHaveRationalSinesSoThatQuadrilateralsStayPlane) {
  const Vs3Scene3 deck = read("F 3a\nS 1 R 0 0 .5 a\n 0 0 0 30 60.5 2 3\n");
  EXPECT_THAT(deck.notes, ElementsAre(HasSubstr("no multiples of 90 degrees")));
  const std::vector<Point3>& p = deck.scene->polygons[0].points;
  EXPECT_EQ(dot(p[2] - p[1], p[2] - p[1]), 4);
  EXPECT_EQ(dot(p[0] - p[1], p[0] - p[1]), 9);
  EXPECT_EQ(dot(p[0] - p[1], p[2] - p[1]), 0);
  // The normal (sin 30 sin 60.5, cos 30 sin 60.5, cos 60.5), times the area.
  const Vector3 normal = doubled_area(deck.scene->polygons[0]);
  EXPECT_NEAR(to_double(normal.x), 12 * 0.5 * 0.87035569593989971, 1e-14);
  EXPECT_NEAR(to_double(normal.y), 12 * 0.8660254037844386 * 0.87035569593989971, 1e-14);
  EXPECT_NEAR(to_double(normal.z), 12 * 0.49242356010346718, 1e-14);
}

// As patches are, by planarity.h.
TEST(Vs3Reader, PutsSubsurfacesIntoThePlaneOfTheirBaseExactly) {
  const std::string deck = kSquares + "V 13 .25 .25 1e-16\nV 14 1.0000000000000002 0 1e-16\nS 1 1 2 3 4 0 0 .5 wall\n";
  EXPECT_THAT(lines(read(deck + "S 2 13 6 7 0 1 0 .5 window\n").scene),
              ElementsAre("wall: 0,0,0 1,0,0 1,1,0 0,1,0 | 1/4,1/4,0 1/2,1/4,0 1/2,1/2,0",
                          "window: 1/4,1/4,0 1/2,1/4,0 1/2,1/2,0"));
  EXPECT_THAT(lines(read(deck + "S 2 13 14 7 0 1 0 .5 window\n").scene)[1], "window: 1/4,1/4,0 1,0,0 1/2,1/2,0");
  const Scene3 mask = read(deck + "M 2 7 6 13 0 1 0 .5 foot\n").scene;
  EXPECT_THAT(lines(mask)[1], "foot: 1/2,1/2,0 1/2,1/4,0 1/4,1/4,0");
}

// A base closes with its subsurface only, which is a group of its own.
TEST(Vs3Reader, WhatIsCombinedClosesWithItsSubsurfaces) {
  const std::string deck =
      "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 0 1 0\nV 4 0 0 1\nV 5 .25 0 .25\nV 6 .5 0 .25\nV 7 .25 0 .5\n"
      "S 1 1 3 2 0 0 0 .5 body\nS 2 1 2 4 0 0 1 .5 south\nS 3 1 4 3 0 0 1 .5 west\nS 4 2 3 4 0 0 1 .5 slope\n"
      "S 5 5 6 7 0 2 0 .2 window\n";
  const Scene3 scene = read(deck).scene;
  ASSERT_EQ(scene.groups.size(), 2u);
  for (const Group& group : scene.groups) EXPECT_EQ(group.body, "body");
  const Solids3 solids(scene);
  ASSERT_NE(solids.mesh_of(0), nullptr);
  EXPECT_EQ(solids.mesh_of(0)->kind, ClosedMesh3::Kind::kSolid);
  EXPECT_EQ(solids.mesh_of(1), solids.mesh_of(0));
}

TEST(Vs3Reader, RefusesSubsurfacesThatAreNone) {
  const std::string deck = kSquares + "V 13 .25 .25 .1\nV 14 2 0 0\nS 1 1 2 3 4 0 0 .5 wall\n";
  EXPECT_EQ(refusal(deck + "S 2 13 6 7 0 1 0 .5 window\n"),
            "in/room.vs3:17: surface 2 'window' is not in the plane of its base, surface 1 'wall': it lies 0.1 off");
  EXPECT_EQ(refusal(deck + "S 2 5 14 7 0 1 0 .5 window\n"),
            "in/room.vs3:17: surface 2 'window' is not within its base, surface 1 'wall'");
  EXPECT_EQ(refusal(deck + "S 2 8 7 6 5 1 0 .5 window\n"),
            "in/room.vs3:17: surface 2 'window' faces the other way than its base, surface 1 'wall'");
  EXPECT_EQ(refusal(deck + "S 2 5 6 7 8 9 0 .5 window\n"),
            "in/room.vs3:17: surface 2 'window' has the base 9, which is not there");
  EXPECT_EQ(refusal(deck + "S 2 5 6 7 8 2 0 .5 window\n"),
            "in/room.vs3:17: surface 2 'window' has the base surface 2 'window', which must stand before it");
}

TEST(Vs3Reader, RefusesWhatItCannotReadWithFileAndLine) {
  const auto after = [](const std::string& line) { return refusal(kSquares + line + "\n"); };
  EXPECT_EQ(after("S 2 1 2 3 4 0 0 .5 a"), "in/room.vs3:14: surface '2' is out of sequence: 1 comes next");
  EXPECT_EQ(after("V 14 0 0 0"), "in/room.vs3:14: vertex 14 is out of sequence: 13 comes next");
  EXPECT_EQ(after("V 13 0 0"), "in/room.vs3:14: vertex 13: z is missing: the line ends");
  EXPECT_EQ(after("S 1 1 2 3"), "in/room.vs3:14: surface 1: v4 is missing: the line ends");
  EXPECT_EQ(after("S 1 1 2 0 3 0 0 .5 a"),
            "in/room.vs3:14: surface 1: v3: the vertex 0 is none of the 12 that stand before it");
  EXPECT_EQ(after("S 1 1 2 13 4 0 0 .5 a"),
            "in/room.vs3:14: surface 1: v3: the vertex 13 is none of the 12 that stand before it");
  EXPECT_EQ(after("S 1 1 2 -3 4 0 0 .5 a"), "in/room.vs3:14: surface 1: v3 is no whole number: '-3'");
  EXPECT_EQ(after("S 1 1 02 3 4 0 0 .5 a"), "in/room.vs3:14: surface 1: v2 begins with 0: '02'");
  EXPECT_EQ(after("S 1 1 2 3 4 0 0 .5"), "in/room.vs3:14: surface 1: its name is missing: the line ends");
  EXPECT_EQ(after("S 1 1 2 3 4 0 0 1.5 a"), "in/room.vs3:14: surface 1: the emittance 1.5 is not from 0 to 1");
  EXPECT_THAT(after("S 1 1 2 3 4 0 0 x a"), StartsWith("in/room.vs3:14: surface 1: emit is not a number: 'x'"));
  EXPECT_EQ(after("S 1 1 2 3 4 0 0 .5 a\nO 2 9 10 11 12\nS 3 5 6 7 8 1 0 .5 b"),
            "in/room.vs3:16: surface 3 stands after an obstruction: obstructions come last");
  EXPECT_EQ(after("S 1 1 3 2 4 0 0 .5 a").find("in/room.vs3:14: surface 1 'a' "), 0u);
  EXPECT_EQ(after("S 1 1 2 11 4 0 0 .5 a").find("in/room.vs3:14: surface 1 'a' is not plane"), 0u);
  EXPECT_EQ(after("X 1 2 3"), "in/room.vs3:14: X, a transformation of coordinates, is not read");
  EXPECT_EQ(after("Q 1"), "in/room.vs3:14: the letter 'Q' is not known");
  EXPECT_EQ(after("F 3a"), "in/room.vs3:14: F stands after vertices or surfaces");
  EXPECT_EQ(after(std::string("S 1 \0", 5)), "in/room.vs3:14: the line has a NUL byte: this is no text");
  EXPECT_EQ(refusal("F 2\n"), "in/room.vs3:1: the form '2' is not read: decks in space have the form 3 or 3a");
  EXPECT_EQ(refusal("F 3a\nV 1 0 0 0\n"), "in/room.vs3:2: V belongs to the form F 3; this deck has the form F 3a");
  EXPECT_EQ(refusal("F 3a\nS 1 Z 0 0 .5 a\n"), "in/room.vs3:2: surface 1: the shape 'Z' is not known");
  EXPECT_EQ(refusal("F 3a\nS 1 R 0 0 .5 a\n0 0 0 0 0 1\nEnd\n"),
            "in/room.vs3:4: surface 1: height is not a number: 'End'");
  EXPECT_EQ(refusal("F 3a\nS 1 R 0 0 .5 a\n0 0 0 0 0 1\n"),
            "in/room.vs3:3: surface 1: height is missing: the deck ends");
  EXPECT_THAT(refusal("T only a title\n"), HasSubstr("the deck has no surfaces"));
  EXPECT_THAT(refusal(""), HasSubstr("the deck has no surfaces"));
  EXPECT_EQ(refusal("\xEF\xBB\xBFT a\n"), "in/room.vs3:1: the file begins with a byte order mark");
}

TEST(Vs3Reader, KnowsDecksByTheirEnding) {
  for (const char* name : {"a.vs3", "b/A.VS3", "a.Vs3"}) EXPECT_TRUE(is_vs3(name)) << name;
  for (const char* name : {"vs3", "a.vs2", "a.vs3.txt", ".vs3x"}) EXPECT_FALSE(is_vs3(name)) << name;
}

}  // namespace
}  // namespace hottel::vs3_reader_test

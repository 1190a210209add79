// Overlaps in space settled by claims, and what solids cover, on the smallest scenes.
#include "geometry/space/arrangement/arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "tests/geometry/space/box_scene.h"
#include "tests/refusal.h"

namespace hottel::arrangement_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Cover = Piece3::Cover;

Rational area_of(const Polygon3& polygon) {
  const Vector3 n = doubled_area(polygon);
  return (abs(n.x) + abs(n.y) + abs(n.z)) / 2;  // of polygons parallel to the axes
}

// What a face has that no solid covers, and what of it is covered.
struct Areas {
  Rational free, covered;
  friend bool operator==(const Areas&, const Areas&) = default;
};

Areas areas_of(const Arrangement3& arrangement, const Face& face) {
  Areas areas;
  for (const PieceSide3& place : arrangement.sides(face)) {
    const Piece3& piece = arrangement.pieces()[place.piece];
    const Piece3::Side& side = piece.side(place.is_back);
    Rational free = side.cover == Cover::kFree ? area_of(piece.polygon) : Rational(0);
    for (const Polygon3& polygon : side.free) free += area_of(polygon);
    areas.free += free;
    areas.covered += area_of(piece.polygon) - free;
  }
  return areas;
}

Areas front(const Scene3& scene, std::uint32_t surface) { return areas_of(Arrangement3(scene), {surface, false}); }
Areas back(const Scene3& scene, std::uint32_t surface) { return areas_of(Arrangement3(scene), {surface, true}); }

std::string refusal(const Scene3& scene) {
  return refusal_by([&] { Arrangement3{scene}; });
}

// S(i, j) by names.
double measure(const Scene3& scene, const std::string& from, const std::string& to) {
  const ExchangeMatrix matrix = exact_exchange(prepare(scene), {.tolerance = 1e-12});
  return matrix.factor(from, to).value * matrix.elements()[*matrix.find(from)].area.value;
}

TEST(Arrangement3, OfPolygonsThatOnlyTouchIsPlain) {
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {2, 2, 2}, true);
  scene.polygon("screen", {{{1, 0, 0}, {1, 2, 0}, {1, 2, 1}, {1, 0, 1}}}, 0, 0);
  scene.polygon("pierced", {{{0, 1, 1}, {2, 1, 1}, {2, 1, 2}}});
  const Arrangement3 arrangement(scene);
  EXPECT_TRUE(arrangement.is_plain());
  ASSERT_EQ(arrangement.pieces().size(), scene.polygons.size());
  for (std::uint32_t s = 0; s < scene.polygons.size(); ++s) {
    EXPECT_EQ(arrangement.pieces()[s].polygon, scene.polygons[s]);
    EXPECT_TRUE(arrangement.pieces()[s].is_whole);
    EXPECT_THAT(arrangement.pieces_on(s), ElementsAre(s));
    EXPECT_EQ(arrangement.owner(s, true), (Face{s, true}));
  }
  EXPECT_EQ(arrangement.polygons(), scene.polygons);
}

TEST(Arrangement3, PiecesShareNoAreaAndCoverWhatThePolygonsCover) {
  BoxScene3 scene;
  scene.polygon("a", level(0, 0, 2, 2, 0));
  scene.polygon("b", level(1, 1, 3, 3, 0));
  scene.polygon("c", turned(level(1, 0, 2, 4, 0)));
  const Arrangement3 arrangement(scene);
  EXPECT_FALSE(arrangement.is_plain());
  Rational sum;
  for (std::uint32_t p = 0; p < arrangement.pieces().size(); ++p) {
    EXPECT_TRUE(is_convex(arrangement.pieces()[p].polygon));
    sum += area_of(arrangement.pieces()[p].polygon);
    if (p > 0) {
      EXPECT_GE(arrangement.pieces()[p].surface, arrangement.pieces()[p - 1].surface);
    }
  }
  EXPECT_EQ(sum, 4 + 4 + 4 - 1 - 2 - 2 + 1);
}

TEST(Arrangement3, ASideWithoutAClaimIsTheBlackBackOfTheFirstListed) {
  BoxScene3 scene;
  const std::uint32_t a = scene.polygon("a", level(0, 0, 2, 1, 0)), b = scene.polygon("b", level(1, 0, 3, 1, 0));
  EXPECT_EQ(back(scene, a), (Areas{2, 0}));
  EXPECT_EQ(back(scene, b), (Areas{1, 0}));
}

TEST(Arrangement3, ASideWithOneClaimIsThatFace) {
  BoxScene3 scene;
  const std::uint32_t a = scene.polygon("a", level(0, 0, 2, 1, 0)),
                      b = scene.polygon("b", turned(level(1, 0, 3, 1, 0)));
  for (const std::uint32_t s : {a, b}) EXPECT_EQ(front(scene, s), (Areas{2, 0}));
  for (const std::uint32_t s : {a, b}) EXPECT_EQ(back(scene, s), (Areas{1, 0}));
  // A thin wall, given as a -> b and b -> a, is one with a material on each side.
  BoxScene3 wall, two;
  wall.polygon("wall", level(0, 0, 1, 1, 0), 0, 1);
  two.polygon("wall", level(0, 0, 1, 1, 0), 0);
  two.polygon("other", turned(level(0, 0, 1, 1, 0)), 1);
  for (BoxScene3* s : {&wall, &two}) {
    s->polygon("above", turned(level(0, 0, 1, 1, 1)));
    s->polygon("below", level(0, 0, 1, 1, -2));
  }
  EXPECT_EQ(measure(wall, "wall", "above"), measure(two, "wall", "above"));
  EXPECT_EQ(measure(wall, "wall:back", "below"), measure(two, "other", "below"));
}

TEST(Arrangement3, ASideWithEqualClaimsIsTheFirstListed) {
  BoxScene3 scene;
  scene.materials.push_back(scene.materials[0]);
  scene.materials.back().name = "like white";
  const std::uint32_t a = scene.polygon("a", level(0, 0, 2, 1, 0)), b = scene.polygon("b", level(1, 0, 3, 1, 0), 2),
                      c = scene.polygon("c", turned(level(0, 0, 3, 1, 0)), 1, 0);
  EXPECT_EQ(front(scene, a), (Areas{2, 0}));
  EXPECT_EQ(front(scene, b), (Areas{1, 0}));
  EXPECT_EQ(back(scene, c), (Areas{0, 0}));
  EXPECT_EQ(front(scene, c), (Areas{3, 0}));
  // One with nothing left has no row.
  const ExchangeMatrix matrix = exact_exchange(prepare(scene));
  EXPECT_FALSE(matrix.has_row(*matrix.find("c:back")));
  EXPECT_EQ(matrix.elements()[*matrix.find("c:back")].area.value, 0);
}

TEST(Arrangement3, ASideWithDifferentClaimsIsRefusedWithBothNamesAndTheSide) {
  BoxScene3 scene;
  scene.polygon("a", level(0, 0, 2, 1, 0), 0);
  scene.polygon("b", level(1, 0, 3, 1, 0), 1);
  EXPECT_THAT(refusal(scene), StartsWith("boxes.json:2: 'a' (front) and 'b' (front) claim the same side with different "
                                         "materials: they overlap around ("));
  BoxScene3 backs;
  backs.polygon("a", level(0, 0, 2, 1, 0), 0, 0);
  backs.polygon("b", turned(level(1, 0, 3, 1, 0)), 1);
  EXPECT_THAT(refusal(backs), HasSubstr("'a' (back) and 'b' (front) claim the same side"));
  BoxScene3 both;
  both.polygon("a", level(0, 0, 2, 1, 0), 0, 1);
  both.polygon("b", turned(level(1, 0, 3, 1, 0)), 1, 0);
  EXPECT_EQ(refusal(both), "");
  // Those that only touch claim nothing of each other.
  BoxScene3 apart;
  apart.polygon("a", level(0, 0, 1, 1, 0), 0);
  apart.polygon("b", level(1, 0, 3, 1, 0), 1);
  EXPECT_EQ(refusal(apart), "");
}

// A box on the floor of a room, listed before or after it.
BoxScene3 box_in_a_room(bool is_box_first, const std::array<Rational, 3>& low = {1, 1, 0},
                        const std::array<Rational, 3>& high = {2, 2, 1}, std::uint32_t material = 1) {
  BoxScene3 scene;
  if (is_box_first) scene.box("box", low, high, false, material);
  scene.box("room", {0, 0, 0}, {4, 4, 4}, true);
  if (!is_box_first) scene.box("box", low, high, false, material);
  return scene;
}

TEST(Arrangement3, ABoxOnTheFloorAndTheFloorUnderItExchangeNothing) {
  for (const bool is_box_first : {false, true}) {
    const BoxScene3 scene = box_in_a_room(is_box_first);
    const std::uint32_t floor = *scene.find("room bottom"), bottom = *scene.find("box bottom");
    EXPECT_EQ(front(scene, floor).free, 15);
    EXPECT_EQ(front(scene, bottom).free, 0);
    // The silent front leaves the other side of the floor to the floor.
    EXPECT_EQ(back(scene, floor), (Areas{16, 0}));
    const ExchangeMatrix matrix = exact_exchange(prepare(scene));
    EXPECT_FALSE(matrix.has_row(*matrix.find("box bottom")));
    EXPECT_EQ(matrix.elements()[*matrix.find("room bottom")].area.value, 15);
    EXPECT_EQ(matrix.factor("room bottom", "sky").value, 0);
  }
}

TEST(Arrangement3, ABoxOnTheFloorIsTheBoxWithoutABottom) {
  const BoxScene3 whole = box_in_a_room(false);
  BoxScene3 open;
  open.box("room", {0, 0, 0}, {4, 4, 4}, true);
  const std::uint32_t bottom = open.box("box", {1, 1, 0}, {2, 2, 1}, false, 1);
  open.surfaces.erase(open.surfaces.begin() + bottom);
  open.polygons.erase(open.polygons.begin() + bottom);
  const ExchangeMatrix a = exact_exchange(prepare(whole), {.tolerance = 1e-12}),
                       b = exact_exchange(prepare(open), {.tolerance = 1e-12});
  EXPECT_EQ(b.elements()[*b.find("room bottom")].area.value, 16);
  for (const char* to : {"box south", "box north", "box west", "box east", "room top", "room east"})
    EXPECT_NEAR(a.factor("room bottom", to).value, b.factor("room bottom", to).value * 16 / 15, 1e-12) << to;
  // What is covered of the floor sees the black backs of a box without a bottom.
  double lost = 0;
  for (const char* to : {"box top:back", "box south:back", "box north:back", "box west:back", "box east:back"})
    lost += b.factor("room bottom", to).value;
  EXPECT_NEAR(lost, 1.0 / 16, 1e-12);
}

TEST(Arrangement3, TheFrontUnderAFaceThatLooksIntoTheSolidIsSilent) {
  // A shelf lies on a box: it keeps its own underside where it stands out, and its upper side all over.
  for (const bool is_shelf_first : {false, true}) {
    BoxScene3 scene;
    if (!is_shelf_first) scene.box("box", {0, 0, 0}, {2, 2, 1}, false, 1);
    const std::uint32_t shelf = scene.polygon("shelf", level(1, 0, 3, 2, 1), 0, 0);
    if (is_shelf_first) scene.box("box", {0, 0, 0}, {2, 2, 1}, false, 1);
    EXPECT_EQ(refusal(scene), "");
    EXPECT_EQ(front(scene, shelf), (Areas{4, 0}));
    EXPECT_EQ(back(scene, shelf).free, 2);
    EXPECT_EQ(front(scene, *scene.find("box top")).free, 2);
  }
  // A shelf without a material below does not look into the box: both claim the upper side.
  BoxScene3 rug;
  rug.box("box", {0, 0, 0}, {2, 2, 1}, false, 1);
  rug.polygon("rug", level(0, 0, 1, 1, 1), 0);
  EXPECT_THAT(refusal(rug), AllOf(HasSubstr("'box top' (front)"), HasSubstr("'rug' (front)")));
}

TEST(Arrangement3, OfTwoBoxesSideBySideBothTouchingFrontsAreCovered) {
  BoxScene3 scene;
  scene.box("a", {0, 0, 0}, {1, 1, 1}, false, 0);
  scene.box("b", {1, 0, 0}, {2, 2, 1}, false, 1);
  EXPECT_EQ(front(scene, *scene.find("a east")).free, 0);
  EXPECT_EQ(front(scene, *scene.find("b west")).free, 1);
}

TEST(Arrangement3, OfStackedBoxesWhatTouchesIsCovered) {
  BoxScene3 scene;
  scene.box("low", {0, 0, 0}, {2, 2, 1}, false, 0);
  scene.box("high", {1, 1, 1}, {3, 2, 2}, false, 1);
  EXPECT_EQ(front(scene, *scene.find("low top")).free, 3);
  EXPECT_EQ(front(scene, *scene.find("high bottom")).free, 1);
}

TEST(Arrangement3, WhatIsWithinAnotherSolidIsCovered) {
  BoxScene3 scene;
  scene.box("a", {0, 0, 0}, {2, 2, 2});
  scene.box("b", {1, 1, 1}, {3, 3, 3});
  for (const char* name : {"a top", "a north", "a east", "b bottom", "b south", "b west"}) {
    EXPECT_EQ(front(scene, *scene.find(name)), (Areas{3, 1})) << name;
    EXPECT_EQ(back(scene, *scene.find(name)).free, 0) << name;
  }
  const Arrangement3 arrangement(scene);
  // Each stays one piece, of which what is free is told.
  for (const Piece3& piece : arrangement.pieces()) EXPECT_TRUE(piece.is_whole);
  EXPECT_EQ(arrangement.pieces()[*scene.find("a top")].side(false).cover, Cover::kPartly);
  EXPECT_EQ(arrangement.pieces()[*scene.find("a bottom")].side(false).cover, Cover::kFree);
  EXPECT_EQ(arrangement.pieces()[*scene.find("a bottom")].side(true).cover, Cover::kCovered);
}

TEST(Arrangement3, APolygonThatPiercesASolidKeepsWhatStandsOut) {
  BoxScene3 scene;
  scene.box("box", {0, 0, 0}, {2, 2, 2});
  const std::uint32_t sheet = scene.polygon("sheet", level(1, 0, 4, 1, 1), 0, 1);
  EXPECT_EQ(front(scene, sheet), (Areas{2, 1}));
  EXPECT_EQ(back(scene, sheet), (Areas{2, 1}));
  EXPECT_EQ(front(scene, *scene.find("box east")), (Areas{4, 0}));
}

TEST(Arrangement3, WhatIsCoveredOfTwoFacesDoesNotSeeEachOtherWithinTheSolid) {
  // A pillar from floor to ceiling, drawn with both of its ends.
  const BoxScene3 scene = box_in_a_room(false, {1, 1, 0}, {2, 2, 4});
  const ExchangeMatrix matrix = exact_exchange(prepare(scene), {.tolerance = 1e-12});
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
    EXPECT_NEAR(sum, matrix.has_row(i) ? 1 : 0, 1e-12) << matrix.name(i);
  }
  // The floor cut by hand around a pillar without ends.
  BoxScene3 open;
  const std::uint32_t first = open.box("room", {0, 0, 0}, {4, 4, 4}, true);
  const std::uint32_t pillar = open.box("box", {1, 1, 0}, {2, 2, 4}, false, 1);
  open.polygons[first + kBottom].holes.push_back(level(1, 1, 2, 2, 0).points);
  open.polygons[first + kTop].holes.push_back(level(1, 1, 2, 2, 4).points);
  for (int side = 0; side < 2; ++side) {
    open.surfaces.erase(open.surfaces.begin() + pillar);
    open.polygons.erase(open.polygons.begin() + pillar);
  }
  for (const char* to : {"room top", "room west", "room east", "box east"})
    EXPECT_NEAR(matrix.factor("room bottom", to).value,
                exact_exchange(prepare(open), {.tolerance = 1e-12}).factor("room bottom", to).value, 1e-12)
        << to;
}

TEST(Arrangement3, AConvexPolygonThatLosesNothingIsOnePiece) {
  BoxScene3 scene = box_in_a_room(true);
  scene.polygon("apart", level(0, 0, 3, 1, 2), 0, 1);
  const Arrangement3 arrangement(scene);
  const std::uint32_t apart = *scene.find("apart");
  ASSERT_EQ(arrangement.sides({apart, false}).size(), 1u);
  const Piece3& piece = arrangement.pieces()[arrangement.sides({apart, false})[0].piece];
  EXPECT_TRUE(piece.is_whole);
  EXPECT_EQ(piece.polygon, scene.polygons[apart]);
  // The floor is one piece too, of which a part is covered.
  ASSERT_EQ(arrangement.sides({*scene.find("room bottom"), false}).size(), 1u);
}

TEST(Arrangement3, PolygonsThatAreNotConvexAreConvexPieces) {
  BoxScene3 scene;
  const std::uint32_t corner =
      scene.polygon("corner", {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}}, 0, 1);
  Polygon3 window = level(0, 0, 3, 3, 1);
  window.holes.push_back(level(1, 1, 2, 2, 1).points);
  const std::uint32_t frame = scene.polygon("frame", turned(window));
  const Arrangement3 arrangement(scene);
  EXPECT_FALSE(arrangement.is_plain());
  EXPECT_EQ(areas_of(arrangement, {corner, false}), (Areas{3, 0}));
  EXPECT_EQ(areas_of(arrangement, {corner, true}), (Areas{3, 0}));
  EXPECT_EQ(areas_of(arrangement, {frame, false}), (Areas{8, 0}));
  for (const Piece3& piece : arrangement.pieces()) {
    EXPECT_TRUE(is_convex(piece.polygon));
    EXPECT_GT(dot(doubled_area(piece.polygon), doubled_area(scene.polygons[piece.surface])), 0);
  }
  EXPECT_EQ(arrangement.pieces_on(frame).size(), arrangement.sides({frame, false}).size());
}

TEST(Arrangement3, IsExactWhateverTheCoordinates) {
  // The floor and the box differ by a third of 2^-80: the box stands, floats, or sinks.
  const Rational least = Rational(1, 3) / (Rational(1) << 80);
  const Rational height = (Rational(1) << 60) + Rational(1, 7);
  for (const int step : {-1, 0, 1}) {
    BoxScene3 scene;
    scene.polygon("floor", level(0, 0, 4, 4, height));
    scene.box("box", {1, 1, height + step * least}, {2, 2, height + 1});
    EXPECT_EQ(front(scene, 0).free, step == 1 ? 16 : 15) << step;
    EXPECT_EQ(front(scene, *scene.find("box bottom")).free, step == 0 ? 0 : 1) << step;
  }
}

TEST(Arrangement3, ARoomInABuildingIsFree) {
  BoxScene3 scene;
  scene.box("building", {-1, -1, -1}, {5, 5, 5}, false, 1);
  scene.box("room", {0, 0, 0}, {4, 4, 4}, true);
  scene.box("box", {1, 1, 0}, {2, 2, 1});
  EXPECT_EQ(front(scene, *scene.find("room bottom")).free, 15);
  EXPECT_EQ(front(scene, *scene.find("box top")).free, 1);
  EXPECT_EQ(front(scene, *scene.find("building bottom")).free, 36);  // from outside
  EXPECT_EQ(back(scene, *scene.find("room top")).free, 0);           // within the walls
  // One that sticks out of the building is no room of it.
  BoxScene3 out;
  out.box("building", {0, 0, 0}, {2, 2, 2});
  out.box("room", {1, 0, 0}, {3, 2, 2}, true);
  EXPECT_EQ(front(out, *out.find("room east")).free, 4);
  EXPECT_EQ(front(out, *out.find("room top")).free, 2);
}

TEST(Arrangement3, ABoxInsideOutCoversNothing) {
  const BoxScene3 scene = [] {
    BoxScene3 s;
    s.box("room", {0, 0, 0}, {4, 4, 4}, true);
    s.box("turned", {1, 1, 1}, {2, 2, 2}, true, 1);
    return s;
  }();
  const Arrangement3 arrangement(scene);
  EXPECT_TRUE(arrangement.is_plain());
  EXPECT_GT(measure(scene, "turned west", "turned east"), 0);
}

TEST(Arrangement3, WhatIsSaidToBeOpenCoversNothing) {
  BoxScene3 scene = box_in_a_room(false);
  scene.groups.back().behind = Behind::kOpen;
  // The fronts of the bottom and of the back of the floor are on one side: the bottom claims it.
  EXPECT_EQ(front(scene, *scene.find("box bottom")), (Areas{1, 0}));
  EXPECT_EQ(front(scene, *scene.find("room bottom")), (Areas{16, 0}));
  EXPECT_EQ(back(scene, *scene.find("room bottom")), (Areas{15, 0}));
}

TEST(Arrangement3, OfAnEmptySceneHasNoPieces) {
  const Arrangement3 arrangement{Scene3()};
  EXPECT_TRUE(arrangement.pieces().empty());
  EXPECT_TRUE(arrangement.is_plain());
}

}  // namespace
}  // namespace hottel::arrangement_test

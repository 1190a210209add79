// What bodies hide at once, and what is never first: each on a small scene, with what is exchanged there.
#include "geometry/space/hiding/hiders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "tests/geometry/space/box_faces.h"

namespace hottel::hiders_test {
namespace {

using box_faces::box;
using box_faces::operator+;
using box_faces::Points;
using box_faces::polygons_of;

Rational ratio(long p, long q) { return Rational(p) / q; }
Rational two_to_minus(int k) { return scaled_by_power_of_two(Rational(1), -k); }

enum Face : std::uint32_t { kBottom, kTop, kSouth, kNorth, kWest, kEast };

// A box without a bottom: the numbers of its faces are one less.
std::vector<Points> open_box(const Point3& a, const Point3& b) {
  std::vector<Points> faces = box(a, b);
  faces.erase(faces.begin());
  return faces;
}

// Across x at a place, facing +x, or -x where it is turned.
Points wall(const Rational& x, const Rational& y0, const Rational& y1, const Rational& z0, const Rational& z1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}
// At a height, facing up.
Points level(const Rational& z, const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}
Points turned(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

class Scene {
 public:
  explicit Scene(const std::vector<Points>& polygons)
      : occluders_(polygons_of(polygons)), hiders_(occluders_), measurer_(occluders_) {}

  Patch3 patch(std::uint32_t surface, bool is_back = false) const {
    Patch3 patch = whole_patch(occluders_, surface);
    if (is_back) std::reverse(patch.corners.begin(), patch.corners.end());
    return patch;
  }
  bool hide(const Patch3& i, const Patch3& j) const { return hiders_.hide(hiders_.placed(i), hiders_.placed(j)); }
  bool hide(std::uint32_t i, std::uint32_t j) const { return hide(patch(i), patch(j)); }
  bool is_never_first(const Patch3& i, std::uint32_t surface) const {
    return hiders_.is_never_first(hiders_.placed(i), surface);
  }
  bool is_never_first(std::uint32_t i, std::uint32_t surface) const { return is_never_first(patch(i), surface); }

  // In the unit of doubles; both with and without what is hidden at once, which are the same.
  double measure(const Patch3& i, const Patch3& j) const {
    PairRequest3 request;
    request.tolerance = 1e-12;
    request.effort = Effort3::kUsual;  // so that what is wrong is told soon
    const PairResult3 told = measurer_.measure(i, j, request);
    request.asks_hiders = false;
    const PairResult3 walked = measurer_.measure(i, j, request);
    EXPECT_EQ(told.problem, "");
    EXPECT_EQ(told.measure == 0, walked.measure == 0);
    EXPECT_EQ(told.is_whole, walked.is_whole);
    EXPECT_NEAR(told.measure, walked.measure, told.error + walked.error + 1e-14 * walked.measure);
    return told.measure;
  }
  double measure(std::uint32_t i, std::uint32_t j) const { return measure(patch(i), patch(j)); }

  const Occluders3& occluders() const { return occluders_; }
  const Hiders3& hiders() const { return hiders_; }
  const PairIntegrator3& measurer() const { return measurer_; }

 private:
  Occluders3 occluders_;
  Hiders3 hiders_;
  PairIntegrator3 measurer_;
};

// Two walls that face each other, at x = -2 and 4, and what stands between, with numbers from 2 on.
std::vector<Points> street(const Rational& low, const Rational& high, const std::vector<Points>& between) {
  return std::vector<Points>{wall(-2, ratio(1, 2), ratio(3, 2), low, high),
                             turned(wall(4, ratio(1, 2), ratio(3, 2), low, high))} +
         between;
}

// (1)
TEST(Hiders3, ABoxHidesWhatIsBehindIt) {
  const Scene scene(street(ratio(1, 2), 1, box({0, 0, 0}, {2, 2, 2})));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_TRUE(scene.hide(1, 0));
  EXPECT_EQ(scene.measure(0, 1), 0);
  EXPECT_FALSE(scene.hide(0, 2 + kWest));
  EXPECT_TRUE(scene.hide(scene.patch(0), scene.patch(2 + kEast)));
  EXPECT_TRUE(scene.is_never_first(0, 1));
  EXPECT_TRUE(scene.is_never_first(0, 2 + kEast));
  EXPECT_FALSE(scene.is_never_first(0, 2 + kWest));
}

// What is seen past a box in part is not hidden, but each half beside it may be.
TEST(Hiders3, HalvesAreHiddenByDifferentBodies) {
  const Scene scene({wall(-2, 0, 4, 0, 1), turned(wall(4, 0, 4, 0, 1)), wall(0, -4, 2, -1, 2), wall(1, 2, 8, -1, 2),
                     wall(2, -4, ratio(5, 2), -1, 2)});
  EXPECT_TRUE(scene.hide(0, 1));
  const Scene ajar(
      {wall(-2, 0, 4, 0, 1), turned(wall(4, 0, 4, 0, 1)), wall(0, -4, ratio(7, 4), -1, 2), wall(1, 2, 8, -1, 2)});
  EXPECT_FALSE(ajar.hide(0, 1));
  EXPECT_GT(ajar.measure(0, 1), 0);
}

// The plane of the lid bounds nothing where both patches are on its inner side.
TEST(Hiders3, LinesAlongTheGroundAreHiddenByAnOpenBox) {
  const Scene scene(street(0, 1, open_box({0, 0, 0}, {2, 2, 2})));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_EQ(scene.measure(0, 1), 0);
}

// Both are below: the condition on the lid.
TEST(Hiders3, LinesPassBelowAnOpenBox) {
  for (const auto& between : {open_box({0, 0, 1}, {2, 2, 2}), box({0, 0, 1}, {2, 2, 2})}) {
    const Scene scene(street(0, ratio(1, 2), between));
    EXPECT_FALSE(scene.hide(0, 1));
    EXPECT_GT(scene.measure(0, 1), 0);
    EXPECT_FALSE(scene.is_never_first(0, 1));
  }
}

// One is partly below.
TEST(Hiders3, SomeLinesPassBelowAnOpenBox) {
  const Scene scene(street(ratio(1, 4), ratio(3, 2), open_box({0, 0, 1}, {2, 2, 2})));
  EXPECT_FALSE(scene.hide(0, 1));
  EXPECT_GT(scene.measure(0, 1), 0);
}

// From below on one side to above on the other: in through a wall, out through the open bottom.
TEST(Hiders3, LinesThatComeInThroughASurfaceAndGoOutThroughTheLidAreHidden) {
  const Scene scene({turned(level(0, ratio(3, 4), ratio(5, 4), ratio(3, 4), ratio(5, 4))),
                     level(4, ratio(3, 4), ratio(5, 4), ratio(3, 4), ratio(5, 4))});
  const std::vector<Points> patches{level(0, ratio(3, 4), ratio(5, 4), ratio(3, 4), ratio(5, 4)),
                                    turned(level(4, ratio(3, 4), ratio(5, 4), ratio(3, 4), ratio(5, 4)))};
  const Scene with_box(patches + open_box({0, 0, 1}, {2, 2, 2}));
  EXPECT_TRUE(with_box.hide(0, 1));
  EXPECT_EQ(with_box.measure(0, 1), 0);
  EXPECT_EQ(scene.measure(0, 1), 0);  // they look away from each other
  EXPECT_TRUE(scene.hide(0, 1));
}

// In through the lid, to what is in the box: each must be outside.
TEST(Hiders3, WhatIsInAnOpenBoxIsSeenFromBelow) {
  const std::vector<Points> below{level(0, ratio(1, 2), ratio(3, 2), ratio(1, 2), ratio(3, 2))};
  const Scene scene(below + open_box({0, 0, 1}, {2, 2, 3}) +
                    std::vector<Points>{turned(level(2, ratio(3, 4), 1, ratio(3, 4), 1))});
  const std::uint32_t in_the_box = 6, roof = kTop;  // the bottom is left out, below stands before
  EXPECT_FALSE(scene.hide(0, in_the_box));
  EXPECT_GT(scene.measure(0, in_the_box), 0);
  EXPECT_FALSE(scene.hide(scene.patch(0), scene.patch(roof, true)));
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(roof, true)), 0);
  for (std::uint32_t s = 1; s < 7; ++s) EXPECT_FALSE(scene.is_never_first(0, s)) << s;
}

// Neither is outside: a room.
TEST(Hiders3, InnerSidesOfABoxSeeEachOther) {
  for (const bool is_open : {false, true}) {
    const Scene scene(is_open ? open_box({0, 0, 0}, {2, 2, 2}) : box({0, 0, 0}, {2, 2, 2}));
    const auto n = static_cast<std::uint32_t>(scene.occluders().size());
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        if (i == j) continue;
        EXPECT_FALSE(scene.hide(scene.patch(i, true), scene.patch(j, true))) << i << ' ' << j;
        EXPECT_FALSE(scene.is_never_first(scene.patch(i, true), j)) << i << ' ' << j;
        EXPECT_GT(scene.measure(scene.patch(i, true), scene.patch(j, true)), 0);
      }
  }
}

// One touches the plane, the other is on it: outside is strictly beyond somewhere.
TEST(Hiders3, WhatStandsInABoxSeesItsInnerSides) {
  const Scene scene(box({0, 0, 0}, {4, 4, 4}) + std::vector<Points>{wall(2, 1, 3, 0, 3)});
  EXPECT_FALSE(scene.hide(scene.patch(6), scene.patch(kEast, true)));
  EXPECT_GT(scene.measure(scene.patch(6), scene.patch(kEast, true)), 0);
  for (std::uint32_t s = 0; s < 6; ++s) EXPECT_EQ(scene.is_never_first(6, s), s == kWest) << s;  // which is behind it
}

// At once: a patch that looks into a body sees nothing outside.
TEST(Hiders3, AnInnerSideSeesNothingOutsideThePlanesOfItsBody) {
  for (const bool is_open : {false, true}) {
    const std::vector<Points> outside{turned(wall(5, -9, 9, 0, 9)), level(0, 3, 9, -9, 9)};
    const Scene scene(outside + (is_open ? open_box({0, 0, 0}, {2, 2, 2}) : box({0, 0, 0}, {2, 2, 2})));
    const std::uint32_t west = 2 + kWest - (is_open ? 1 : 0);
    EXPECT_TRUE(scene.hide(scene.patch(west, true), scene.patch(0)));
    EXPECT_TRUE(scene.hide(scene.patch(west, true), scene.patch(1)));
    EXPECT_EQ(scene.measure(scene.patch(west, true), scene.patch(0)), 0);
    EXPECT_FALSE(scene.hide(scene.patch(west + 1), scene.patch(0)));  // the outer side of the east
    EXPECT_GT(scene.measure(scene.patch(west + 1), scene.patch(0)), 0);
  }
}

// The same where one is below the lid: it is seen through it.
TEST(Hiders3, AnInnerSideSeesWhatIsBelowItsLid) {
  const Scene scene(std::vector<Points>{turned(wall(5, -9, 9, 0, 1))} + open_box({0, 0, 1}, {2, 2, 3}));
  const std::uint32_t west = kWest;
  EXPECT_FALSE(scene.hide(scene.patch(west, true), scene.patch(0)));
  EXPECT_GT(scene.measure(scene.patch(west, true), scene.patch(0)), 0);
}

// In the plane of the lid, under the box.
TEST(Hiders3, GroundUnderAnOpenBoxSeesTheBoxFromInsideAlone) {
  const Scene scene(std::vector<Points>{level(0, ratio(1, 2), 1, ratio(1, 2), 1), turned(wall(5, -9, 9, 0, 9)),
                                        wall(5, -9, 9, -9, 0)} +
                    open_box({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_EQ(scene.measure(0, 1), 0);
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(3, true)), 0);
  for (std::uint32_t s = 3; s < 8; ++s) EXPECT_FALSE(scene.is_never_first(0, s)) << s;
  // Its back looks down.
  EXPECT_FALSE(scene.hide(scene.patch(0, true), scene.patch(2, true)));
  EXPECT_GT(scene.measure(scene.patch(0, true), scene.patch(2, true)), 0);
}

// Ground that is not cut: a part of it is under the box.
TEST(Hiders3, UncutGroundSeesAnOpenBoxFromInsideAndFromOutside) {
  const Scene scene(std::vector<Points>{level(0, -4, 6, -4, 6), turned(wall(6, -4, 6, 0, 1))} +
                    open_box({0, 0, 0}, {2, 2, 2}));
  for (std::uint32_t s = 1; s < 7; ++s) EXPECT_FALSE(scene.is_never_first(0, s)) << s;
  EXPECT_GT(scene.measure(0, 1), 0);
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(2, true)), 0);  // the roof from below
  EXPECT_EQ(scene.measure(0, 2), 0);                                  // from above
}

// Lines from the plane of the lid, upward, are within it whatever the other one is.
TEST(Hiders3, GroundBesideAnOpenBoxDoesNotSeeWhatIsBehindIt) {
  const Scene scene(
      std::vector<Points>{level(0, -3, -2, ratio(1, 2), 1), turned(wall(4, ratio(1, 2), 1, -1, ratio(1, 2)))} +
      open_box({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_EQ(scene.measure(0, 1), 0);
  // From below the ground it is seen.
  EXPECT_FALSE(scene.hide(scene.patch(0, true), scene.patch(1)));
  EXPECT_GT(scene.measure(scene.patch(0, true), scene.patch(1)), 0);
}

// By the plane of one patch: what is behind it does not count.
TEST(Hiders3, OnlyWhatFacesEachOtherMustBeHidden) {
  // A long wall along x passes the plane of the first one: the part behind it is beside the box, in sight of it.
  const Scene scene(std::vector<Points>{wall(-1, ratio(1, 2), ratio(3, 2), ratio(1, 2), ratio(3, 2)),
                                        Points{{-9, 3, 0}, {-9, 3, 2}, {-1, 3, 2}, {-1, 3, 0}}} +
                    box({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_EQ(scene.measure(0, 1), 0);
  const Scene through(std::vector<Points>{wall(-1, ratio(1, 2), ratio(3, 2), ratio(1, 2), ratio(3, 2)),
                                          turned(wall(4, ratio(1, 2), ratio(3, 2), ratio(1, 2), ratio(3, 2))),
                                          Points{{-9, 9, 0}, {9, 9, 0}, {9, 9, 2}, {-9, 9, 2}}} +
                      box({0, 0, -9}, {2, 20, 9}));
  EXPECT_TRUE(through.hide(0, 1));
}

// Margins: places that doubles do not tell from the surface are not in the body.
TEST(Hiders3, LinesJustAboveARoofAreFree) {
  for (const int digits : {20, 30, 36, 44}) {
    const Scene scene(street(2, 2 + two_to_minus(digits), box({0, 0, 0}, {2, 2, 2})));
    EXPECT_FALSE(scene.hide(0, 1)) << digits;
    EXPECT_FALSE(scene.is_never_first(0, 1)) << digits;
  }
  const Scene scene(street(2, 2 + two_to_minus(36), box({0, 0, 0}, {2, 2, 2})));
  EXPECT_GT(scene.measure(0, 1), 0);
}
TEST(Hiders3, PatchesThatLookOverARoofByNearlyNothingAreNotHidden) {
  for (const int digits : {20, 30, 36, 44, 100}) {
    const Scene scene(street(1, 2 + two_to_minus(digits), box({0, 0, 0}, {2, 2, 2})));
    EXPECT_FALSE(scene.hide(0, 1)) << digits;
    EXPECT_FALSE(scene.is_never_first(0, 1)) << digits;
    const Scene below(street(ratio(1, 2) - two_to_minus(digits), 1, open_box({0, 0, ratio(1, 2)}, {2, 2, 2})));
    EXPECT_FALSE(below.hide(0, 1)) << digits;
    EXPECT_FALSE(below.is_never_first(0, 1)) << digits;
  }
}
TEST(Hiders3, LinesJustBelowARoofAreHiddenWhetherOrNotItIsProven) {
  for (const int digits : {20, 30, 36, 44}) {
    const Scene scene(street(2 - two_to_minus(digits), 2, box({0, 0, 0}, {2, 2, 2})));
    EXPECT_EQ(scene.measure(0, 1), 0) << digits;
  }
}

// Bodies side by side: lines in the plane between them are hidden by neither.
TEST(Hiders3, BodiesThatTouchLetNothingThrough) {
  std::vector<Points> boxes = box({0, 0, 0}, {2, 1, 2});
  boxes.erase(boxes.begin() + kNorth);
  const Scene scene(street(ratio(1, 2), ratio(3, 2), boxes + box({0, 1, 0}, {2, 2, 2})));
  EXPECT_EQ(scene.measure(0, 1), 0);
}
TEST(Hiders3, AGapBetweenBodiesLetsThrough) {
  for (const int digits : {8, 30, 36, 40}) {
    const Scene scene(
        street(ratio(1, 2), ratio(3, 2), box({0, 0, 0}, {2, 1, 2}) + box({0, 1 + two_to_minus(digits), 0}, {2, 2, 2})));
    EXPECT_FALSE(scene.hide(0, 1)) << digits;
  }
}

// A flat surface: one before it, one behind.
TEST(Hiders3, ASurfaceOfNoBodyHides) {
  const Scene scene(street(0, 1, {wall(1, 0, 2, -1, 2)}));
  EXPECT_TRUE(scene.hide(0, 1));
  EXPECT_TRUE(scene.is_never_first(0, 1));
  EXPECT_FALSE(scene.is_never_first(0, 2));
  const Scene beside(street(0, 1, {wall(1, 0, 2, ratio(1, 2), 2)}));
  EXPECT_FALSE(beside.hide(0, 1));
  const Scene behind(street(0, 1, {wall(5, 0, 2, -1, 2)}));
  EXPECT_FALSE(behind.hide(0, 1));
}
TEST(Hiders3, ASurfaceThatEndsAtTheLineDoesNotHide) {
  for (const int digits : {20, 36, 44}) {
    const Scene scene(street(0, 1, {wall(1, 0, 2, -1, 1 - two_to_minus(digits))}));
    EXPECT_FALSE(scene.hide(0, 1)) << digits;
  }
}

// (2): faces turned away are met from within their body.
TEST(Hiders3, FacesTurnedAwayAreNeverFirst) {
  // Above and west of a box: the east is turned away, and so are south and north.
  const Scene scene(std::vector<Points>{turned(level(9, -3, -2, ratio(1, 2), 1))} + box({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(scene.is_never_first(0, 1 + kEast));
  EXPECT_TRUE(scene.is_never_first(0, 1 + kBottom));
  EXPECT_TRUE(scene.is_never_first(0, 1 + kSouth));
  EXPECT_TRUE(scene.is_never_first(0, 1 + kNorth));
  EXPECT_FALSE(scene.is_never_first(0, 1 + kTop));
  EXPECT_FALSE(scene.is_never_first(0, 1 + kWest));
}
TEST(Hiders3, AFaceIsNotTurnedAwayFromWhatIsPartlyBeforeIt) {
  const Scene scene(std::vector<Points>{turned(level(9, 1, 3, ratio(1, 2), 1))} + box({0, 0, 0}, {2, 2, 2}));
  EXPECT_FALSE(scene.is_never_first(0, 1 + kEast));
  EXPECT_GT(scene.measure(0, 1 + kEast), 0);
  const Scene in_its_plane(std::vector<Points>{turned(level(9, 1, 2, ratio(1, 2), 1))} + box({0, 0, 0}, {2, 2, 2}));
  EXPECT_TRUE(in_its_plane.is_never_first(0, 1 + kEast));
}

// Inside, all faces are behind their planes.
TEST(Hiders3, FacesAreFirstFromWithinTheirBody) {
  const Scene scene(std::vector<Points>{level(1, ratio(1, 2), 1, ratio(1, 2), 1)} + box({0, 0, 0}, {2, 2, 2}));
  for (const bool is_back : {false, true})
    for (std::uint32_t s = 1; s < 7; ++s)
      EXPECT_EQ(scene.is_never_first(scene.patch(0, is_back), s), s == 1 + (is_back ? kTop : kBottom)) << s;
}
// Or partly within it: a patch that pierces it.
TEST(Hiders3, FacesAreFirstFromWhatPiercesTheirBody) {
  const Scene scene(std::vector<Points>{level(1, -1, 1, ratio(1, 2), 1)} + box({0, 0, 0}, {2, 2, 2}));
  EXPECT_FALSE(scene.is_never_first(0, 1 + kEast));
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(1 + kEast, true)), 0);
}

// Below and beside a box without a bottom: its faces are met from within, through the bottom.
TEST(Hiders3, FacesOfAnOpenBoxAreFirstThroughItsLid) {
  const Scene scene(std::vector<Points>{level(0, -1, -ratio(1, 2), ratio(1, 2), 1)} + open_box({0, 0, 1}, {2, 2, 3}));
  EXPECT_FALSE(scene.is_never_first(0, kEast));
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(kEast, true)), 0);
  const Scene closed(std::vector<Points>{level(0, -1, -ratio(1, 2), ratio(1, 2), 1)} + box({0, 0, 1}, {2, 2, 3}));
  EXPECT_TRUE(closed.is_never_first(0, 1 + kEast));
}

// The planes of a body meet nobody below its lid.
TEST(Hiders3, WhatIsBelowALidIsNotHiddenByWhatIsAboveIt) {
  // From the west, below a box without a bottom, up to a sheet in the plane of its lid, whose front looks up.
  const Scene scene(
      std::vector<Points>{wall(-1, ratio(1, 2), 1, 0, ratio(1, 4)), level(1, ratio(1, 2), 1, ratio(1, 2), 1)} +
      open_box({0, 0, 1}, {2, 2, 3}));
  EXPECT_FALSE(scene.is_never_first(0, 1));
  EXPECT_GT(scene.measure(scene.patch(0), scene.patch(1, true)), 0);
}

// Lines end on both sides of a surface that is asked for: not on its front alone.
TEST(Hiders3, AFaceThatLooksIntoItsBodyIsMetFromOutside) {
  std::vector<Points> inward = box({0, 0, 0}, {2, 2, 2});
  for (Points& face : inward) face = turned(face);
  const Scene scene(std::vector<Points>{Points{{-2, -2, ratio(1, 2)}, {-2, -2, 1}, {5, -1, 1}, {5, -1, ratio(1, 2)}}} +
                    inward);
  for (const bool is_back : {false, true}) {
    const bool faces_it = scene.measure(scene.patch(0, is_back), scene.patch(1 + kSouth, true)) > 0;
    if (!faces_it) continue;
    EXPECT_FALSE(scene.is_never_first(scene.patch(0, is_back), 1 + kWest));
    EXPECT_GT(scene.measure(scene.patch(0, is_back), scene.patch(1 + kWest, true)), 0);
  }
}

// (2): what is left out for the first patch is not left out for the second one as well.
TEST(Hiders3, WhatHidesFromBothSidesIsNotLeftOutForBoth) {
  // Two sheets between: from the left the right one is never first, and the other way round.
  const Scene scene(street(0, 1, {wall(0, 0, 2, -1, 2), wall(2, 0, 2, -1, 2)}));
  EXPECT_TRUE(scene.is_never_first(0, 3));
  EXPECT_FALSE(scene.is_never_first(0, 2));
  EXPECT_TRUE(scene.is_never_first(1, 2));
  EXPECT_FALSE(scene.is_never_first(1, 3));
  EXPECT_EQ(scene.measure(0, 1), 0);
  EXPECT_EQ(scene.measure(1, 0), 0);
}

// (2): silhouettes of which one surface is left out are walked.
TEST(Hiders3, WhatIsSeenPastABoxIsTheSameWithoutItsFacesTurnedAway) {
  for (const bool is_open : {false, true})
    for (const long shift : {0, 1, 2}) {
      const std::vector<Points> between =
          is_open ? open_box({0, shift, 0}, {2, shift + 2, 1}) : box({0, shift, 0}, {2, shift + 2, 1});
      const Scene scene(street(0, 2, between));
      EXPECT_GT(scene.measure(0, 1), 0);
      EXPECT_GT(scene.measure(1, 0), 0);
      EXPECT_NEAR(scene.measure(0, 1), scene.measure(1, 0), 1e-12);
    }
}
// Boxes on each other, so that left-out faces touch faces that stay, along parts of edges.
TEST(Hiders3, WhatIsSeenPastAStackOfBoxesIsTheSameWithoutItsFacesTurnedAway) {
  for (const Rational& shift : {Rational(0), ratio(1, 4), ratio(1, 2)}) {
    const Scene scene(street(0, 3,
                             box({0, 0, 0}, {2, 2, 1}) + open_box({shift, shift, 1}, {1 + shift, 1 + shift, 2}) +
                                 open_box({shift, 2, 0}, {2, 3, ratio(1, 2)})));
    EXPECT_GT(scene.measure(0, 1), 0);
    EXPECT_NEAR(scene.measure(0, 1), scene.measure(1, 0), 1e-12);
  }
}

// What is told of a pair is of its number, in a row, alone, and with details.
TEST(PairRow3, HasTheBitsOfThePairAloneAndWithDetails) {
  const Scene scene(street(0, 3,
                           box({0, 0, 0}, {2, 1, 1}) + open_box({ratio(1, 3), ratio(1, 7), 1}, {1, ratio(3, 5), 2}) +
                               open_box({-1, ratio(5, 7), 0}, {ratio(1, 3), 2, ratio(4, 3)}) +
                               box({ratio(7, 3), ratio(1, 5), 0}, {3, ratio(12, 7), ratio(9, 4)})));
  for (std::uint32_t from = 0; from < scene.occluders().size(); ++from) {
    const Patch3 i = scene.patch(from);
    PairRow3 row(scene.measurer(), i);
    for (std::uint32_t s = 0; s < scene.occluders().size(); ++s)
      for (const bool is_back : {false, true}) {
        if (s == i.surface) continue;
        const Patch3 j = scene.patch(s, is_back);
        PairDetails3 details;
        const PairResult3 in_row = row.measure(j), alone = scene.measurer().measure(i, j),
                          told = scene.measurer().measure(i, j, {}, &details);
        for (const PairResult3& other : {alone, told}) {
          EXPECT_EQ(other.measure, in_row.measure);
          EXPECT_EQ(other.error, in_row.error);
          EXPECT_EQ(other.bounds.lower, in_row.bounds.lower);
          EXPECT_EQ(other.bounds.upper, in_row.bounds.upper);
          EXPECT_EQ(other.is_whole, in_row.is_whole);
        }
        EXPECT_EQ(details.stretches.empty(),
                  in_row.measure == 0 || told.sight != PairVisibility3::kMixed || in_row.is_whole);
      }
  }
}

// Behind the patch nothing is met.
TEST(Hiders3, WhatIsBehindAPatchIsNeverFirst) {
  const Scene scene({level(0, 0, 1, 0, 1), level(-1, 0, 1, 0, 1), level(1, 0, 1, 0, 1)});
  EXPECT_TRUE(scene.is_never_first(0, 1));
  EXPECT_FALSE(scene.is_never_first(0, 2));
}

// The sky is beyond everything.
TEST(Hiders3, AnInnerSideSeesNoSky) {
  const Scene scene(box({0, 0, 0}, {2, 2, 2}));
  const IntegerVector a{-9, -9, 9}, b{9, -9, 9}, c{9, 9, 9}, d{-9, 9, 9};
  Patch3 sky{Patch3::kSky, {d, c, b, a}, 1};
  EXPECT_TRUE(scene.hide(scene.patch(kBottom, true), sky));
  EXPECT_TRUE(scene.hide(sky, scene.patch(kBottom, true)));
  EXPECT_FALSE(scene.hide(scene.patch(kTop), sky));
  EXPECT_TRUE(scene.is_never_first(sky, kBottom));
  EXPECT_FALSE(scene.is_never_first(sky, kTop));
}

// Degenerate: numbers beyond doubles prove nothing.
TEST(Hiders3, NumbersBeyondDoublesProveNothing) {
  const Scene scene(street(ratio(1, 2), 1, box({0, 0, 0}, {2, 2, 2})));
  Patch3 patch = scene.patch(0);
  const Integer huge = Integer(1) << 3000;
  for (IntegerVector& corner : patch.corners) corner = multiple(huge, corner);
  patch.weight = huge;
  EXPECT_FALSE(scene.hiders().placed(patch).is_told);
  EXPECT_FALSE(scene.hide(patch, scene.patch(1)));
  EXPECT_FALSE(scene.is_never_first(patch, 1));
}

TEST(FirstMet3, TheSurfaceOfThePatchIsNotLeftOut) {
  const Scene scene(box({0, 0, 0}, {2, 2, 2}));
  FirstMet3 first_met(scene.hiders(), scene.patch(kTop), scene.occluders().size());
  EXPECT_FALSE(first_met.is_never_first(kTop));
  EXPECT_TRUE(first_met.is_never_first(kBottom));
  EXPECT_TRUE(first_met.is_never_first(kBottom));
}

}  // namespace
}  // namespace hottel::hiders_test

// Where what is dragged in space comes to lie.
#include "viewer/edit/space/snapping.h"

#include <gtest/gtest.h>

#include "tests/viewer/edit/space/edited_scenes.h"

namespace hottel::snapping_test {
namespace {

using testing_edits::furnished;
using To = Snap3::To;

class Snapped : public testing::Test {
 protected:
  // The tent is dragged by a corner.
  Snapped() {
    std::vector<bool> is_moved(scene.surfaces.size());
    is_moved[*scene.find("tent[0]")] = is_moved[*scene.find("tent[1]")] = true;
    snapper.emplace(scene, is_moved);
  }
  Snap3 at(const Direction3& place, const Point3& from, std::optional<int> axis = {}) const {
    Pointer3 pointer{.eye = {2, 0.25, 1.5}, .pixel = 0.002};
    pointer.at = pointer.seen(place);
    Freedom3 freedom(from);
    if (axis) freedom.hold_on_axis(*axis);
    return snapper->at(pointer, freedom);
  }

  const Scene3 scene = furnished();
  std::optional<Snapper3> snapper;
};

const Point3 kTop{Rational(16, 5), Rational(16, 5), 1};

// (1)
TEST_F(Snapped, CornersWin) {
  const Snap3 snap = at({1.505, 3, 1.495}, kTop);
  EXPECT_EQ(snap.to, To::kVertex);
  EXPECT_EQ(snap.at, (Point3{Rational(3, 2), 3, Rational(3, 2)}));
  EXPECT_NE(at({1, 2, 0.01}, kTop).to, To::kVertex) << "a corner behind the box";
}

TEST_F(Snapped, WhatIsHeldOnAnAxisComesLevelWithACorner) {
  EXPECT_EQ(at({1.5, 3, 1.5}, kTop, 2).at, (Point3{Rational(16, 5), Rational(16, 5), Rational(3, 2)}));
}

// (2)
TEST_F(Snapped, SidesAreMetExactly) {
  const Snap3 snap = at({1.5003, 3, 0.9123}, kTop);
  EXPECT_EQ(snap.to, To::kEdge);
  EXPECT_EQ(snap.at.x, Rational(3, 2));
  EXPECT_EQ(snap.at.y, 3);
  EXPECT_NEAR(to_double(snap.at.z), 0.9123, 0.01);
  EXPECT_LT(snap.at.z.get_den(), 10001);
}

// (3)
TEST_F(Snapped, PolygonsAreMetInTheirPlanes) {
  const Snap3 snap = at({3.7, 3.995, 2.6}, {Rational(37, 10), Rational(399, 100), Rational(1, 2)});
  EXPECT_EQ(snap.to, To::kPlane);
  EXPECT_EQ(snap.at.y, 4);
}

// (4)
TEST_F(Snapped, ElsePlacesAreShortDecimals) {
  const Snap3 snap = at({2.7123456, 2, 1.2123456}, {Rational(5, 2), 2, 1});
  EXPECT_EQ(snap.to, To::kDecimals);
  EXPECT_EQ(snap.at.y, 2) << "what does not change stays";
  EXPECT_LE(snap.at.x.get_den(), 10000);
  EXPECT_NEAR(to_double(snap.at.x), 2.7123456, 0.005);
}

}  // namespace
}  // namespace hottel::snapping_test

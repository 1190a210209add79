// What an eye sees of boxes, as shells.
#include "geometry/space/visibility/view_shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernel/support/parallel.h"

namespace hottel::view_shells_test {
namespace {

// The faces of a box from (0, 0, 0) to (1, 1, 1), fronts outside.
std::vector<Polygon3> box() {
  return {{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
          {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}},
          {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}}, {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}}};
}

struct Seen {
  DefaultFloatingPoint environment;
  Occluders3 occluders;
  EyePlanes3 planes;
  ViewCones3 cones;
  ViewShells3 shells;

  Seen(const std::vector<Polygon3>& polygons, const Point3& eye)
      : occluders(polygons), planes(occluders, eye, false), cones(planes), shells(planes, cones) {}
};

TEST(ViewShells3, TheNearSidesOfABoxAreOneAndTheFarOnesBuried) {
  const Seen corner(box(), {2, 3, 4});
  ASSERT_EQ(corner.shells.shell_of(0), corner.shells.shell_of(3));
  ASSERT_EQ(corner.shells.shell_of(0), corner.shells.shell_of(4));
  const ViewShell3& shell = corner.shells[corner.shells.shell_of(0)];
  EXPECT_EQ(shell.polygons.size(), 3u);
  EXPECT_EQ(shell.cone.corners.size(), 7u);
  EXPECT_EQ(shell.cone.sides.size(), 6u);
  EXPECT_TRUE(shell.is_round);
  for (const std::size_t near : {0, 3, 4}) EXPECT_FALSE(corner.shells.is_buried(near));
  for (const std::size_t far : {1, 2, 5}) EXPECT_TRUE(corner.shells.is_buried(far));
}

TEST(ViewShells3, APolygonWhosePlaneTheEyeIsInIsInNone) {
  const Seen edge(box(), {1, Rational(1) / 2, 4});
  EXPECT_EQ(edge.planes.facing(3), 0);
  EXPECT_EQ(edge.shells[edge.shells.shell_of(0)].polygons.size(), 1u);
  EXPECT_TRUE(edge.shells.is_buried(1));
}

TEST(ViewShells3, FromWithinNothingIsJoinedNorBuried) {
  const Seen inside(box(), {Rational(1) / 3, Rational(1) / 5, Rational(1) / 7});
  EXPECT_EQ(inside.shells.size(), 6u);
  for (std::size_t s = 0; s < 6; ++s) EXPECT_FALSE(inside.shells.is_buried(s));
}

// Two of three near sides: seen together they are not convex.
TEST(ViewShells3, WhatIsNotConvexIsNotJoined) {
  std::vector<Polygon3> polygons = box();
  polygons.erase(polygons.begin());
  const Seen open(polygons, {2, 3, 4});
  for (std::size_t s = 0; s < polygons.size(); ++s) EXPECT_EQ(open.shells[open.shells.shell_of(s)].polygons.size(), 1u);
  // The two far sides that are seen past the missing top are not behind one of the near ones as a whole.
  EXPECT_FALSE(open.shells.is_buried(1));
  EXPECT_FALSE(open.shells.is_buried(4));
}

TEST(ViewShells3, ConesAreAroundWhatTheyHide) {
  const Seen seen(box(), {2, 3, 4});
  const ViewShell3& shell = seen.shells[seen.shells.shell_of(0)];
  ViewCone3 behind = shell.around;
  behind.sine = 0.01;
  behind.cosine = 0.99995;
  EXPECT_FALSE(hides_all(shell, behind));
  behind.nearest = 2 * shell.around.farthest;
  behind.farthest = 3 * shell.around.farthest;
  EXPECT_TRUE(hides_all(shell, behind));
  behind.x = -behind.x;
  EXPECT_FALSE(hides_all(shell, behind));
}

}  // namespace
}  // namespace hottel::view_shells_test

#include "geometry/space/stretches/stretch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/space/stretches/surface_stretches.h"

namespace hottel::stretch_test {
namespace {

using testing::ElementsAre;

WeightedPoint3 on_x(long numerator, long weight = 1) { return {{numerator, 0, 0}, weight}; }

LinePart3 part(long from, long to, std::uint32_t surface, bool is_inside = false, long weight = 1) {
  return {on_x(from, weight), on_x(to, weight), {surface, true}, is_inside};
}

std::vector<std::uint32_t> surfaces_of(const AtomicStretch3& stretch) {
  std::vector<std::uint32_t> result;
  for (const StretchFace3& face : stretch.faces) result.push_back(face.surface);
  return result;
}

// Normals of surfaces that all contain the x axis: of different planes.
std::vector<IntegerVector> fan(std::size_t count) {
  std::vector<IntegerVector> normals;
  for (std::size_t k = 0; k < count; ++k) normals.push_back({0, 1, static_cast<long>(k)});
  return normals;
}

// Property "once": parts of one line are cut at each other's ends.
TEST(AtomicStretches3, PartsOfOneLineAreCutAtEachOthersEnds) {
  const auto stretches = atomic_stretches({part(0, 6, 0), part(2, 4, 1), part(4, 6, 2)}, true, fan(3));
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_THAT(surfaces_of(stretches[0]), ElementsAre(0));
  EXPECT_THAT(surfaces_of(stretches[1]), ElementsAre(0, 1));
  EXPECT_THAT(surfaces_of(stretches[2]), ElementsAre(0, 2));
  EXPECT_EQ(stretches[1].stretch.from, (IntegerVector{2, 0, 0}));
  EXPECT_EQ(stretches[1].stretch.way, (IntegerVector{2, 0, 0}));
}

TEST(AtomicStretches3, OppositePartsAreSeenAlongOneStretch) {
  const auto stretches = atomic_stretches({part(0, 3, 0), part(3, 0, 1)}, true, fan(2));
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_NE(stretches[0].faces[0].is_forward, stretches[0].faces[1].is_forward);
}

// Property (1): ends are fractions, and lines that nearly coincide are two.
TEST(AtomicStretches3, FractionsAreExact) {
  EXPECT_EQ(atomic_stretches({part(1, 2, 0, false, 3), part(2, 4, 1, false, 6)}, true, fan(2)).size(), 1u);
  LinePart3 near = part(0, 3, 1);
  near.to.numerator.y = 1;
  near.to = {{near.to.numerator.x << 80, 1, 0}, Integer(1) << 80};
  EXPECT_EQ(atomic_stretches({part(0, 3, 0), near}, true, fan(2)).size(), 2u);
}

// Property (2).
TEST(AtomicStretches3, WhatRunsThroughASurfaceIsLeftOut) {
  EXPECT_TRUE(atomic_stretches({part(0, 3, 0), part(-1, 5, 1, true)}, false, fan(2)).empty());
  EXPECT_EQ(atomic_stretches({part(0, 3, 0), part(-1, 2, 1, true)}, false, fan(2)).size(), 1u);
}

TEST(AtomicStretches3, SurfacesOfOnePlaneThatContinueEachOtherLeaveNothing) {
  const std::vector<IntegerVector> alike{{0, 0, 1}, {0, 0, 1}}, opposite{{0, 0, 1}, {0, 0, -1}};
  // Two fronts up, on both sides of the line: the edge runs forward along one, backward along the other.
  EXPECT_TRUE(atomic_stretches({part(0, 3, 0), part(3, 0, 1)}, false, alike).empty());
  EXPECT_TRUE(atomic_stretches({part(0, 3, 0), part(0, 3, 1)}, false, opposite).empty());
  // On the same side they are two sides of a sheet.
  EXPECT_EQ(atomic_stretches({part(0, 3, 0), part(3, 0, 1)}, false, opposite).size(), 1u);
}

struct Scene {
  Occluders3 occluders;
  SurfaceBoxes3 boxes;
  SurfaceStretches3 stretches;
  explicit Scene(const std::vector<Polygon3>& polygons)
      : occluders(polygons), boxes(occluders), stretches(occluders, boxes) {}
};

Polygon3 triangle(const Point3& a, const Point3& b, const Point3& c) { return {{a, b, c}}; }

// A triangle that stands on the floor, and one that pierces it; both have a part in front of its front.
TEST(SurfaceStretches3, FeetAreWhereOthersStandOrPierce) {
  const Scene scene({{{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}},
                     triangle({1, 1, 0}, {3, 1, 0}, {2, 1, 2}),
                     triangle({5, 5, -2}, {5, 7, -2}, {5, 6, 2}),
                     triangle({1, 4, 0}, {3, 4, 0}, {2, 4, -2})});
  const auto front = scene.stretches.grounds(0, false), back = scene.stretches.grounds(0, true);
  ASSERT_EQ(front.size(), 2u);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(front[0].faces.size(), 1u);
}

TEST(SurfaceStretches3, ABoxHasEveryEdgeOnceWithBothItsFaces) {
  const Point3 p[8] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
  const Scene scene({{{p[0], p[3], p[2], p[1]}},
                     {{p[4], p[5], p[6], p[7]}},
                     {{p[0], p[1], p[5], p[4]}},
                     {{p[1], p[2], p[6], p[5]}},
                     {{p[2], p[3], p[7], p[6]}},
                     {{p[3], p[0], p[4], p[7]}}});
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < 6; ++s) {
    EXPECT_EQ(scene.stretches.outlines_of(s).size(), 4u);
    for (const std::uint32_t number : scene.stretches.outlines_of(s)) {
      EXPECT_EQ(scene.stretches.outline(number).faces.size(), 2u);
      ++count;
    }
  }
  EXPECT_EQ(count, 24u);
}

// Four quarters of a square: the lines between them are no edges.
TEST(SurfaceStretches3, SeamsOfAFlatWallAreNoEdges) {
  const auto quarter = [](long x, long y) {
    return Polygon3{{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}};
  };
  const Scene scene({quarter(0, 0), quarter(1, 0), quarter(0, 1), quarter(1, 1)});
  for (std::uint32_t s = 0; s < 4; ++s) EXPECT_EQ(scene.stretches.outlines_of(s).size(), 2u);
}

}  // namespace
}  // namespace hottel::stretch_test

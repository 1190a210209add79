// Segments of a plane, the triangles between them, and convex pieces of regions.
#include "geometry/space/scene/plane_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hottel::plane_triangulation_test {
namespace {

using Loop = std::vector<FlatPoint3>;

Loop square(const Rational& u0, const Rational& v0, const Rational& u1, const Rational& v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

Rational doubled_area_of(const Loop& loop) {
  Rational sum;
  for (std::size_t k = 2; k < loop.size(); ++k) sum += doubled_area(loop[0], loop[k - 1], loop[k]);
  return sum;
}

std::vector<FlatSegment3> sides_of(const FlatRegion3& region) {
  std::vector<FlatSegment3> sides;
  region.append_sides(sides);
  return sides;
}

bool is_convex_loop(const Loop& loop) {
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (doubled_area(loop[k], loop[(k + 1) % loop.size()], loop[(k + 2) % loop.size()]) <= 0) return false;
  return true;
}

// Convex pieces of a region have its area, and each lies in it.
void expect_pieces_of(const FlatRegion3& region, const Rational& doubled) {
  Rational sum;
  for (const Loop& piece : convex_pieces(region)) {
    EXPECT_TRUE(is_convex_loop(piece));
    sum += doubled_area_of(piece);
    FlatPoint3 centre;
    for (const FlatPoint3& p : piece) centre = {centre.u + p.u, centre.v + p.v};
    const auto n = static_cast<long>(piece.size());
    EXPECT_TRUE(region.contains({centre.u / n, centre.v / n}));
    for (const FlatPoint3& p : piece)
      EXPECT_TRUE(std::any_of(region.loops().begin(), region.loops().end(),
                              [&](const Loop& loop) { return std::count(loop.begin(), loop.end(), p) > 0; }));
  }
  EXPECT_EQ(sum, doubled);
}

TEST(PlaneTriangulation3, KeepsTheEndsInTheirOrderAndPutsCrossingsAfterThem) {
  const PlaneTriangulation3 t({{FlatPoint3{0, 0}, {4, 4}}, {FlatPoint3{0, 4}, {4, 0}}, {FlatPoint3{0, 0}, {0, 4}}});
  EXPECT_EQ(t.given_points(), 4u);
  ASSERT_EQ(t.points().size(), 5u);
  EXPECT_EQ(t.points()[0], (FlatPoint3{0, 0}));
  EXPECT_EQ(t.points()[1], (FlatPoint3{4, 4}));
  EXPECT_EQ(t.points()[2], (FlatPoint3{0, 4}));
  EXPECT_EQ(t.points()[3], (FlatPoint3{4, 0}));
  EXPECT_EQ(t.points()[4], (FlatPoint3{2, 2}));
}

TEST(PlaneTriangulation3, CoversTheHullWithTrianglesThatShareNoArea) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<FlatSegment3> segments;
    while (segments.size() < 6) {
      const long a = static_cast<long>(random() % 6), b = static_cast<long>(random() % 6);
      const long c = static_cast<long>(random() % 6), d = static_cast<long>(random() % 6);
      if (a != c || b != d) segments.push_back({FlatPoint3{a, b}, FlatPoint3{c, d}});
    }
    for (const FlatSegment3& side : sides_of(FlatRegion3({square(-1, -1, 6, 6)}))) segments.push_back(side);
    const PlaneTriangulation3 t(segments);
    Rational sum;
    for (std::uint32_t k = 0; k < t.triangles().size(); ++k) {
      EXPECT_GT(t.doubled_area_of(k), 0);
      EXPECT_EQ(t.doubled_area_of(k), doubled_area_of(t.corners_of(k)));
      sum += t.doubled_area_of(k);
      const auto& triangle = t.triangles()[k];
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t beyond = triangle.neighbours[side];
        if (beyond == PlaneTriangulation3::kNone) continue;
        const auto& other = t.triangles()[beyond];
        const auto place = std::find(other.neighbours.begin(), other.neighbours.end(), k) - other.neighbours.begin();
        ASSERT_LT(place, 3);
        EXPECT_EQ(other.is_border[static_cast<std::size_t>(place)], triangle.is_border[side]);
      }
      // A side that is no border lies on no segment; one that is does.
      for (std::size_t side = 0; side < 3; ++side) {
        const FlatPoint3 &p = t.points()[triangle.corners[(side + 1) % 3]],
                         &q = t.points()[triangle.corners[(side + 2) % 3]];
        const FlatPoint3 middle{(p.u + q.u) / 2, (p.v + q.v) / 2};
        const bool is_on = std::any_of(segments.begin(), segments.end(), [&](const FlatSegment3& s) {
          return doubled_area(s[0], s[1], middle) == 0 && doubled_area(s[0], s[1], p) == 0 &&
                 (middle.u - s[0].u) * (middle.u - s[1].u) + (middle.v - s[0].v) * (middle.v - s[1].v) <= 0;
        });
        EXPECT_EQ(triangle.is_border[side], is_on);
      }
    }
    EXPECT_EQ(sum, 2 * 49);
  }
}

TEST(PlaneTriangulation3, OfOneLineHasNoTriangles) {
  EXPECT_TRUE(PlaneTriangulation3({{FlatPoint3{0, 0}, {1, 1}}, {FlatPoint3{2, 2}, {3, 3}}}).triangles().empty());
  EXPECT_TRUE(PlaneTriangulation3({}).triangles().empty());
}

TEST(PlaneTriangulation3, CrossingsAreExact) {
  const Rational third = Rational(1) / 3;
  const PlaneTriangulation3 t({{FlatPoint3{0, 0}, {1, third}}, {FlatPoint3{0, third}, {1, 0}}});
  EXPECT_EQ(t.points().back(), (FlatPoint3{Rational(1) / 2, Rational(1) / 6}));
}

TEST(ConvexPieces, CoverARegionWithItsOwnCornersAlone) {
  expect_pieces_of(FlatRegion3({square(0, 0, 2, 2)}), 8);
  expect_pieces_of(FlatRegion3({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}), 6);
  expect_pieces_of(FlatRegion3({square(0, 0, 3, 3), square(1, 1, 2, 2)}), 16);
  // A hole that touches the outline, in either sense.
  expect_pieces_of(FlatRegion3({square(0, 0, 4, 4), {{0, 0}, {2, 3}, {2, 2}}}), 32 - 2);
  EXPECT_EQ(convex_pieces(FlatRegion3({square(0, 0, 2, 2)})).size(), 1u);
}

TEST(ConvexPieces, OfSomeTrianglesAreThoseAndNoMore) {
  std::vector<FlatSegment3> segments = sides_of(FlatRegion3({square(0, 0, 2, 2)}));
  segments.push_back({FlatPoint3{1, 0}, {1, 2}});
  const PlaneTriangulation3 t(segments);
  std::vector<char> is_left;
  for (std::uint32_t k = 0; k < t.triangles().size(); ++k) is_left.push_back(t.centre(k).u < 1 ? 1 : 0);
  const std::vector<Loop> pieces = convex_pieces(t, is_left);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(doubled_area_of(pieces[0]), 4);
  EXPECT_EQ(pieces[0].size(), 4u);
  const FlatRegion3 region = region_of(t, is_left);
  ASSERT_EQ(region.loops().size(), 1u);
  EXPECT_EQ(doubled_area_of(region.loops()[0]), 4);
}

TEST(RegionOf, HasTheInsideOnTheLeftOfHolesToo) {
  const FlatRegion3 frame({square(0, 0, 3, 3), square(1, 1, 2, 2)});
  const PlaneTriangulation3 t(sides_of(frame));
  std::vector<char> is_in;
  for (std::uint32_t k = 0; k < t.triangles().size(); ++k) is_in.push_back(frame.contains(t.centre(k)) ? 1 : 0);
  Rational sum;
  const FlatRegion3 region = region_of(t, is_in);
  EXPECT_EQ(region.loops().size(), 2u);
  for (const Loop& loop : region.loops()) sum += doubled_area_of(loop);
  EXPECT_EQ(sum, 16);
}

}  // namespace
}  // namespace hottel::plane_triangulation_test

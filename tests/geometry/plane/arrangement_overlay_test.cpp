// The numbered properties of overlay(), against rationals and the pairs of all pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/point_index.h"
#include "kernel/rational.h"
#include "tests/geometry/plane/vertex_literal.h"

namespace hottel::arrangement_overlay_test {
namespace {

struct Input {
  PointIndex2 index;
  std::vector<Segment2> segments;

  void add(const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by) {
    if (ax == bx && ay == by) return;
    const VertexId a = index.insert({ax, ay}), b = index.insert({bx, by});
    segments.push_back({a, b});
  }
};

Rational fraction(long p, long q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

// Random segments on a small lattice: crossings, T-junctions, overlaps, repetitions both ways.
Input lattice(int n, int size, std::uint64_t seed, const Rational& step, const Rational& offset) {
  Input input;
  std::mt19937_64 random(seed);
  while (input.segments.size() < static_cast<std::size_t>(n)) {
    const auto coordinate = [&]() -> Rational {
      return offset + step * static_cast<long>(random() % static_cast<std::uint64_t>(size));
    };
    const Rational ax = coordinate(), ay = coordinate(), bx = coordinate();
    input.add(ax, ay, bx, random() % 3 == 0 ? ay : coordinate());
  }
  return input;
}

int orientation(const Point2& p, const Point2& q, const Point2& r) {
  const Rational area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return sgn(area);
}

Rational dot(const Point2& o, const Point2& p, const Point2& q) {
  return (p.x - o.x) * (q.x - o.x) + (p.y - o.y) * (q.y - o.y);
}

bool lies_inside(const Point2& p, const Point2& a, const Point2& b) {
  return orientation(a, b, p) == 0 && dot(p, a, b) < 0;
}

Rational extent(const Point2& a, const Point2& b) { return abs(b.x - a.x) + abs(b.y - a.y); }

class OverlayProperties : public testing::TestWithParam<int> {
 protected:
  OverlayProperties() {
    const Rational steps[] = {1, fraction(1, 3), fraction(1, 10), *parse_rational("1e-40"), *parse_rational("1e300")};
    const Rational offsets[] = {0, fraction(1, 7), *parse_rational("0.12345678901234567890123456789012345678901")};
    const int k = GetParam();
    input_ = lattice(10 + k, 4 + k % 5, static_cast<std::uint64_t>(k), steps[k % 5], offsets[k % 3]);
    overlay_ = overlay(input_.index.points(), input_.segments);
    for (const VertexId v : overlay_.vertices.ids())
      points_.push_back(overlay_.vertices.to_scene(overlay_.vertices.exact(v)));
  }

  Input input_;
  Overlay2 overlay_;
  std::vector<Point2> points_;  // in scene coordinates
};

// (1) every input segment is the union of the pieces that name it as a source
TEST_P(OverlayProperties, PiecesMakeUpTheirSources) {
  std::vector<Rational> covered(input_.segments.size(), 0);
  for (std::size_t piece = 0; piece < overlay_.pieces.size(); ++piece) {
    const auto sources = overlay_.sources(piece);
    ASSERT_FALSE(sources.empty());
    EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end()));
    EXPECT_EQ(std::set<std::uint32_t>(sources.begin(), sources.end()).size(), sources.size());
    const Point2 &a = points_[overlay_.pieces[piece].a.index()], &b = points_[overlay_.pieces[piece].b.index()];
    for (const std::uint32_t s : sources) {
      const Point2 &from = points_[input_.segments[s].a.index()], &to = points_[input_.segments[s].b.index()];
      for (const Point2* end : {&a, &b}) EXPECT_TRUE(*end == from || *end == to || lies_inside(*end, from, to));
      covered[s] += extent(a, b);
    }
  }
  for (std::size_t s = 0; s < input_.segments.size(); ++s)
    EXPECT_EQ(covered[s], extent(points_[input_.segments[s].a.index()], points_[input_.segments[s].b.index()]));
}

// (2) two pieces meet in common end points only; every vertex on a piece is one of its ends
TEST_P(OverlayProperties, PiecesMeetInCommonEndsOnly) {
  const auto& pieces = overlay_.pieces;
  for (std::size_t s = 0; s < pieces.size(); ++s) {
    const Point2 &a = points_[pieces[s].a.index()], &b = points_[pieces[s].b.index()];
    for (const Point2& p : points_) EXPECT_FALSE(lies_inside(p, a, b));
    for (std::size_t t = 0; t < s; ++t) {
      const Point2 &c = points_[pieces[t].a.index()], &d = points_[pieces[t].b.index()];
      EXPECT_FALSE(orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0);
      EXPECT_NE(std::minmax(pieces[s].a, pieces[s].b), std::minmax(pieces[t].a, pieces[t].b));
    }
  }
  // Vertices are distinct, and each is the end of a piece.
  std::set<std::pair<Rational, Rational>> distinct;
  for (const Point2& p : points_) EXPECT_TRUE(distinct.insert({p.x, p.y}).second);
  std::set<VertexId> used;
  for (const Segment2& piece : pieces) used.insert({piece.a, piece.b});
  EXPECT_EQ(used.size(), points_.size());
}

// (3) the first points are the input points, in their order
TEST_P(OverlayProperties, InputPointsComeFirst) {
  ASSERT_LE(input_.index.points().size(), points_.size());
  for (std::size_t k = 0; k < input_.index.points().size(); ++k) EXPECT_EQ(points_[k], input_.index.points()[k]);
}

// (4) a piece that has one source points the same way as it
TEST_P(OverlayProperties, PiecesPointTheWayOfTheirSource) {
  for (std::size_t piece = 0; piece < overlay_.pieces.size(); ++piece) {
    const auto sources = overlay_.sources(piece);
    if (sources.size() != 1) continue;
    const Segment2& source = input_.segments[sources.front()];
    const Point2 &a = points_[overlay_.pieces[piece].a.index()], &b = points_[overlay_.pieces[piece].b.index()];
    const Point2 &from = points_[source.a.index()], &to = points_[source.b.index()];
    EXPECT_GT((b.x - a.x) * (to.x - from.x) + (b.y - a.y) * (to.y - from.y), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Lattices, OverlayProperties, testing::Range(0, 40));

TEST(Overlay2, PassesDisjointSegmentsThrough) {
  Input input;
  input.add(0, 0, 1, 0);
  input.add(1, 0, 1, 1);
  input.add(5, 5, 6, 6);
  const Overlay2 result = overlay(input.index.points(), input.segments);
  ASSERT_EQ(result.pieces.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(result.pieces[k].a, input.segments[k].a);
    EXPECT_EQ(result.pieces[k].b, input.segments[k].b);
    EXPECT_EQ(result.sources(k).size(), 1u);
  }
}

TEST(Overlay2, CutsACrossingAtItsRationalPoint) {
  Input input;
  input.add(0, 0, 3, 1);
  input.add(0, 1, 2, 0);
  const Overlay2 result = overlay(input.index.points(), input.segments);
  EXPECT_EQ(result.pieces.size(), 4u);
  ASSERT_EQ(result.vertices.size(), 5u);
  EXPECT_EQ(result.vertices.to_scene(result.vertices.exact(4_v)), (Point2{fraction(6, 5), fraction(2, 5)}));
}

// A shear by 10^-digits changes no incidence, whatever the size of the numbers that it takes.
TEST(Overlay2, IsTheSameOfNumbersOfAnyLength) {
  const Input plain = lattice(14, 5, 3, 1, 0);
  const Overlay2 expected = overlay(plain.index.points(), plain.segments);
  for (int digits = 4; digits <= 420; digits += digits < 90 || digits > 130 ? 13 : 1) {
    Rational slant(1, Integer("1" + std::string(static_cast<std::size_t>(digits), '0')));
    const auto sheared = [&slant](const Point2& p) { return Point2{p.x + p.y * slant, p.y}; };
    std::vector<Point2> points;
    for (const Point2& p : plain.index.points()) points.push_back(sheared(p));
    const Overlay2 result = overlay(points, plain.segments);
    ASSERT_EQ(result.pieces.size(), expected.pieces.size()) << digits;
    for (std::size_t k = 0; k < result.pieces.size(); ++k) {
      const auto at = [](const Overlay2& o, VertexId v) { return o.vertices.to_scene(o.vertices.exact(v)); };
      EXPECT_EQ(at(result, result.pieces[k].a), sheared(at(expected, expected.pieces[k].a))) << digits;
      EXPECT_EQ(at(result, result.pieces[k].b), sheared(at(expected, expected.pieces[k].b))) << digits;
      const auto sources = result.sources(k), same = expected.sources(k);
      EXPECT_TRUE(std::equal(sources.begin(), sources.end(), same.begin(), same.end())) << digits;
    }
  }
}

TEST(Overlay2, HoldsNothing) {
  const Overlay2 result = overlay({}, {});
  EXPECT_TRUE(result.pieces.empty());
  EXPECT_EQ(result.vertices.size(), 0u);
}

}  // namespace
}  // namespace hottel::arrangement_overlay_test

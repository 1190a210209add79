// Many segments at one place: on top of each other, along one line, at one vertex. Against the pairs of all.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/arrangement/entangled.h"
#include "geometry/plane/arrangement/line_overlaps.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/visibility/visible_lines.h"
#include "kernel/rational.h"
#include "tests/geometry/plane/vertex_literal.h"

namespace hottel::arrangement_many_test {
namespace {

struct Input {
  PointIndex2 index;
  std::vector<Segment2> segments;

  void add(long ax, long ay, long bx, long by) {
    if (ax == bx && ay == by) return;
    const VertexId a = index.insert({ax, ay}), b = index.insert({bx, by});
    segments.push_back({a, b});
  }
  const std::vector<Point2>& points() const { return index.points(); }
  Vertices2 vertices() const { return Vertices2(points(), points().size()); }
};

// Spokes from every corner of a small square, and some segments across, on a lattice where much coincides.
Input fans(int spokes, int across, std::uint64_t seed) {
  Input input;
  std::mt19937_64 random(seed);
  const auto draw = [&](int size) { return static_cast<long>(random() % static_cast<std::uint64_t>(size)); };
  for (int k = 0; k < spokes; ++k) input.add(draw(2), draw(2), draw(13) - 6, draw(13) - 6);
  for (int k = 0; k < across; ++k) input.add(draw(13) - 6, draw(13) - 6, draw(13) - 6, draw(13) - 6);
  std::set<std::pair<VertexId, VertexId>> known;  // each pair of ends once
  std::erase_if(input.segments, [&](const Segment2& s) { return !known.insert(std::minmax(s.a, s.b)).second; });
  return input;
}

bool lies_inside(const Vertices2& v, const Segment2& s, VertexId k) {
  return v.orientation(s.a, s.b, k) == 0 && v.is_between(s.a, s.b, k);
}

// REQUIRES that the segments are not equal.
bool meet_in_more_than_ends(const Vertices2& v, const Segment2& s, const Segment2& t) {
  if (lies_inside(v, s, t.a) || lies_inside(v, s, t.b) || lies_inside(v, t, s.a) || lies_inside(v, t, s.b)) return true;
  return v.orientation(s.a, s.b, t.a) * v.orientation(s.a, s.b, t.b) < 0 &&
         v.orientation(t.a, t.b, s.a) * v.orientation(t.a, t.b, s.b) < 0;
}

TEST(Entangled, AreThoseOfAllPairs) {
  std::size_t some = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Input input = fans(static_cast<int>(1 + seed % 40), static_cast<int>(seed % 5), seed);
    const Vertices2 vertices = input.vertices();
    const auto& segments = input.segments;
    std::vector<char> expected(segments.size(), 0);
    const std::vector<char> cover = entangled_neighbours(vertices, segments);
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (!meet_in_more_than_ends(vertices, segments[i], segments[j])) continue;
        expected[i] = expected[j] = 1;
        EXPECT_TRUE(cover[i] || cover[j]) << "seed " << seed << ": " << i << " and " << j;
      }
    EXPECT_EQ(find_entangled(vertices, segments), expected) << "seed " << seed;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      EXPECT_LE(cover[i], expected[i]) << "seed " << seed << ": " << i;
      ++(expected[i] ? some : none);
    }
  }
  EXPECT_GT(some, 1000u);
  EXPECT_GT(none, 100u);
}

TEST(Entangled, NoneInAFan) {
  Input input;
  for (long k = 0; k < 2000; ++k) input.add(0, 0, 1000, k - 1000);
  for (long k = 0; k < 2000; ++k) input.add(-1000, k - 1000, 0, 0);
  const std::vector<char> entangled = find_entangled(input.vertices(), input.segments);
  EXPECT_EQ(std::count(entangled.begin(), entangled.end(), 1), 0);
}

TEST(Overlay, TakesEqualSegmentsTogether) {
  Input input;
  for (int k = 0; k < 5000; ++k) k % 3 == 0 ? input.add(1, 0, 0, 0) : input.add(0, 0, 1, 0);
  input.add(0, 0, 0, 1);
  const Overlay2 overlaid = overlay(input.points(), input.segments);
  ASSERT_EQ(overlaid.pieces.size(), 2u);
  const auto sources = overlaid.sources(1);
  ASSERT_EQ(sources.size(), 5000u);
  for (std::uint32_t k = 0; k < 5000; ++k) EXPECT_EQ(sources[k], k);
  EXPECT_EQ(overlaid.pieces[1].a, input.segments[0].a);
}

// Each on top of a part of the others, and all of them crossed: every stretch knows all that lie on it.
TEST(Overlay, KnowsAllThatLieOnAStretch) {
  constexpr long kCount = 40;
  Input input;
  for (long k = 0; k < kCount; ++k) input.add(0, 0, 2 * (k + 1), k + 1);              // nested from one end
  for (long k = 0; k < kCount; ++k) input.add(-2 * k - 2, -k - 1, 2 * k + 2, k + 1);  // nested about the middle
  input.add(1, -50, 1, 50);
  const Overlay2 overlaid = overlay(input.points(), input.segments);
  std::vector<std::vector<std::uint32_t>> pieces_of(input.segments.size());
  for (std::uint32_t p = 0; p < overlaid.pieces.size(); ++p) {
    for (const std::uint32_t s : overlaid.sources(p)) pieces_of[s].push_back(p);
    for (std::uint32_t q = 0; q < p; ++q)
      EXPECT_FALSE(meet_in_more_than_ends(overlaid.vertices, overlaid.pieces[p], overlaid.pieces[q]));
    EXPECT_TRUE(std::ranges::is_sorted(overlaid.sources(p)));
  }
  // From (0, 0) to (2 k + 2, k + 1) there are k + 1 steps, the first of which is cut at x = 1.
  for (std::size_t k = 0; k < kCount; ++k) {
    EXPECT_EQ(pieces_of[k].size(), k + 2);
    EXPECT_EQ(pieces_of[kCount + k].size(), 2 * k + 3);
  }
  EXPECT_EQ(pieces_of.back().size(), 2u);
}

TEST(EqualSegments, AreInTheOrderOfTheirFirst) {
  const std::vector<Segment2> segments{{4_v, 5_v}, {1_v, 2_v}, {5_v, 4_v}, {2_v, 1_v}, {0_v, 1_v}, {4_v, 5_v}};
  const EqualSegments2 equal(segments);
  ASSERT_EQ(equal.size(), 3u);
  EXPECT_TRUE(std::ranges::equal(equal.members(0), std::vector<std::uint32_t>{0, 2, 5}));
  EXPECT_TRUE(std::ranges::equal(equal.members(1), std::vector<std::uint32_t>{1, 3}));
  EXPECT_TRUE(std::ranges::equal(equal.members(2), std::vector<std::uint32_t>{4}));
}

// What lies behind a gap, by looking at every piece at its vertex.
void expect_hidden_by_the_nearest(const Vertices2& vertices, VertexId v, const View2& view) {
  const auto& seen = view.seen;
  for_each_gap(vertices, v, view, false, [&](const Gap2& gap) {
    // Strictly left of v -> w, the first piece met when turning counter-clockwise from w; the last one on the right.
    PieceSideId behind_right = kNoPiece, behind_left = kNoPiece;
    const auto at = static_cast<std::size_t>(
        std::find_if(seen.begin(), seen.end(), [&](const auto& s) { return s.vertex == gap.w; }) - seen.begin());
    for (std::size_t turn = 1; turn < seen.size(); ++turn) {
      const auto& s = seen[(at + turn) % seen.size()];
      if (s.left == kNoPiece) continue;
      const int side = vertices.orientation(v, gap.w, s.vertex);
      if (side > 0 && behind_right == kNoPiece) behind_right = s.right;
      if (side < 0) behind_left = s.left;
    }
    if (behind_right != kNoPiece) {
      EXPECT_EQ(gap.behind_right, behind_right);
    }
    if (behind_left != kNoPiece) {
      EXPECT_EQ(gap.behind_left, behind_left);
    }
  });
}

TEST(Gaps, OfManyPiecesTheNearestHidesWhatIsBehind) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Input input = fans(static_cast<int>(1 + seed % 30), 2, seed);
    Overlay2 overlaid = overlay(input.points(), input.segments);
    overlaid.set_total_length();
    const Triangulation2 triangulation(overlaid.vertices, overlaid.pieces);
    View2 view;
    for (const VertexId v : overlaid.vertices.ids()) {
      look_around(overlaid.vertices, triangulation, v, view);
      expect_hidden_by_the_nearest(overlaid.vertices, v, view);
    }
  }
}

// A wheel whose hub has many more neighbours than a rim vertex: every spoke and rim edge becomes a side of triangles.
TEST(Triangulation, TakesEveryPieceOfAWheel) {
  Input input;
  constexpr long kHalf = 300;
  for (long k = -kHalf; k <= kHalf; ++k) {
    input.add(0, 0, k, kHalf * kHalf - k * k + 1);
    if (k > -kHalf) input.add(k - 1, kHalf * kHalf - (k - 1) * (k - 1) + 1, k, kHalf * kHalf - k * k + 1);
  }
  Overlay2 overlaid = overlay(input.points(), input.segments);
  ASSERT_EQ(overlaid.pieces.size(), input.segments.size());
  const Triangulation2 triangulation(overlaid.vertices, overlaid.pieces);
  std::vector<int> met(2 * overlaid.pieces.size(), 0);
  for (const VertexId v : overlaid.vertices.ids())
    for (const StarEntry2& entry : triangulation.star(v))
      if (entry.left != kNoPiece) ++met[entry.left.index()];
  EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(met.size()));
}

}  // namespace
}  // namespace hottel::arrangement_many_test

// The numbered properties of the triangulation on random and degenerate scenes.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "geometry/plane/arrangement/arrangement.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::arrangement_triangulation_test {
namespace {

using namespace testing_scenes;

void check(const Scene2& scene) {
  const Arrangement2 arrangement(scene, Division2(scene.surfaces.size(), 1));
  const Vertices2& vertices = arrangement.vertices();
  const Triangulation2& triangulation = arrangement.triangulation();
  const bool is_line = triangulation.triangle_count() == 0;
  const auto origin = [&](HalfEdgeId h) { return triangulation.origin(h); };
  const auto target = [&](HalfEdgeId h) { return triangulation.target(h); };

  std::map<std::pair<VertexId, VertexId>, PieceSideId> left_of;  // by directed edge, for the pieces
  for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
    const Segment2& piece = arrangement.pieces()[k];
    left_of[{piece.a, piece.b}] = left_side(k);
    left_of[{piece.b, piece.a}] = right_side(k);
  }
  const auto left = [&](VertexId u, VertexId v) {
    const auto place = left_of.find({u, v});
    return place == left_of.end() ? kNoPiece : place->second;
  };

  // (1) triangles are counter-clockwise; their boundary is one convex cycle, so they fill the hull once
  std::set<std::pair<VertexId, VertexId>> edges;
  std::map<VertexId, VertexId> along_hull;
  for (const HalfEdgeId h : triangulation.half_edges()) {
    EXPECT_TRUE(edges.insert({origin(h), target(h)}).second) << "each directed edge once";
    EXPECT_EQ(vertices.orientation(triangulation.corner(h), origin(h), target(h)), 1);
    if (!triangulation.across(h).is_none()) continue;
    EXPECT_TRUE(along_hull.emplace(origin(h), target(h)).second);
    for (const VertexId v : vertices.ids()) EXPECT_GE(vertices.orientation(origin(h), target(h), v), 0);
  }
  if (!is_line) {
    const VertexId first = along_hull.begin()->first;
    std::size_t length = 1;
    for (VertexId v = along_hull.at(first); v != first && length <= along_hull.size(); v = along_hull.at(v)) ++length;
    EXPECT_EQ(length, along_hull.size());
  }

  // (2) twins, what is across, and sides
  for (const HalfEdgeId h : triangulation.half_edges()) {
    const HalfEdgeId across = triangulation.across(h), twin = triangulation.twin(h);
    EXPECT_EQ(across.is_none(), !edges.contains({target(h), origin(h)}));
    if (!across.is_none()) {
      EXPECT_EQ(triangulation.across(across), h);
      EXPECT_EQ(origin(across), target(h));
      EXPECT_EQ(target(across), origin(h));
    }
    const PieceSideId piece = left(origin(h), target(h));
    EXPECT_EQ(triangulation.is_open(h), !twin.is_none());
    EXPECT_EQ(triangulation.is_piece(h), piece != kNoPiece);
    if (triangulation.is_open(h)) {
      EXPECT_EQ(twin, across);
      EXPECT_EQ(piece, kNoPiece) << "nothing stands on the edge";
    } else {
      EXPECT_EQ(triangulation.side(h), piece == kNoPiece ? kSky : piece);
      EXPECT_TRUE(piece != kNoPiece || across.is_none());
    }
    EXPECT_EQ(triangulation.beyond(h), triangulation.is_open(h) ? Beyond2(across) : Beyond2(triangulation.side(h)));
    EXPECT_EQ(triangulation.passage(h).corner, triangulation.corner(h));
    EXPECT_EQ(triangulation.passage(h).on_right, triangulation.beyond(next_half_edge(h)));
    EXPECT_EQ(triangulation.passage(h).on_left, triangulation.beyond(previous_half_edge(h)));
  }
  for (const auto& [ends, side] : left_of)
    EXPECT_TRUE(is_line || edges.contains(ends) || edges.contains({ends.second, ends.first}))
        << "every piece is an edge";

  // (3) stars hold every edge at the vertex, counter-clockwise
  for (const VertexId v : vertices.ids()) {
    const auto star = triangulation.star(v);
    std::set<VertexId> neighbours;
    for (std::size_t k = 0; k < star.size(); ++k) {
      EXPECT_TRUE(neighbours.insert(star[k].neighbour).second);
      EXPECT_EQ(star[k].left, left(v, star[k].neighbour));
      EXPECT_EQ(star[k].right, left(star[k].neighbour, v));
      if (star[k].opposite.is_none()) {
        EXPECT_TRUE(is_line || !edges.contains({star[(k + 1) % star.size()].neighbour, v}) ||
                    !edges.contains({v, star[k].neighbour}));
        continue;
      }
      EXPECT_EQ(triangulation.corner(star[k].opposite), v);
      EXPECT_EQ(origin(star[k].opposite), star[k].neighbour);
      EXPECT_EQ(target(star[k].opposite), star[(k + 1) % star.size()].neighbour);
    }
    for (const auto& [u, w] : edges) {
      EXPECT_TRUE(u != v || neighbours.contains(w));
      EXPECT_TRUE(w != v || neighbours.contains(u));
    }
    for (const auto& [ends, side] : left_of) EXPECT_TRUE(ends.first != v || neighbours.contains(ends.second));
  }
}

class TriangulationOfAScene : public testing::TestWithParam<std::string> {};

TEST_P(TriangulationOfAScene, HasItsProperties) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    check(generated(GetParam(), 30 + 20 * seed, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TriangulationOfAScene,
                         testing::Values("room", "clutter", "lattice", "maze", "comb", "star", "pillars", "plates"),
                         [](const auto& kind) { return kind.param; });

TEST(Triangulation2OfDegenerateScenes, HasItsProperties) {
  check(scene_of({{"one", "0", "0", "1", "2"}}));
  check(scene_of({{"a", "0", "0", "1", "2"}, {"b", "1", "2", "2", "4"}, {"c", "5", "10", "3", "6"}}));
  check(scene_of({{"a", "0", "0", "1", "2"}, {"b", "1", "2", "2", "4"}, {"off", "5", "10", "3", "7"}}));
  check(scene_of({{"a", "-1", "-1", "1", "1"}, {"b", "-1", "1", "1", "-1"}}));
  check(scene_of({{"a", "0", "0", "1", "0"}, {"b", "0", "1e-300", "1", "1e-300"}}));
  check(scene_of({{"a", "0", "0", "1e4000", "0"}, {"b", "0", "1e-4000", "1", "1"}, {"c", "5", "5", "6", "7"}}));
  // Points of one circle, all on a lattice: every choice of diagonals is Delaunay.
  std::vector<Line> lines;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      lines.push_back({"l" + std::to_string(6 * x + y), std::to_string(3 * x), std::to_string(3 * y),
                       std::to_string(3 * x + 1), std::to_string(3 * y)});
  check(scene_of(lines));
}

TEST(Triangulation2OfDegenerateScenes, HasStarsAndNoTrianglesOnOneLine) {
  const Scene2 scene = scene_of({{"a", "0", "0", "1", "2"}, {"b", "1", "2", "2", "4"}, {"c", "3", "6", "5", "10"}});
  const Arrangement2 arrangement(scene, Division2(3, 1));
  EXPECT_EQ(arrangement.triangulation().triangle_count(), 0u);
  std::size_t entries = 0;
  for (const VertexId v : arrangement.vertices().ids()) entries += arrangement.triangulation().star(v).size();
  EXPECT_EQ(entries, 8u) << "five vertices, four neighbours";
}

}  // namespace
}  // namespace hottel::arrangement_triangulation_test

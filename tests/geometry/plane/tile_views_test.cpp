// What the eyes of a tile see together, against what each of them sees alone.
#include "geometry/plane/visibility/tile_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/geometry/plane/vertex_literal.h"

namespace hottel::tile_views_test {
namespace {

using namespace testing_scenes;

bool same(const View2::Seen& a, const View2::Seen& b) {
  return a.vertex == b.vertex && a.behind == b.behind && a.left == b.left && a.right == b.right;
}

class Together {
 public:
  explicit Together(const Scene2& scene)
      : arrangement_(scene, Division2(scene.surfaces.size(), 1)),
        location_(arrangement_.vertices(), arrangement_.triangulation()) {
    low_ = high_ = vertices().exact(0_v);
    for (const VertexId v : vertices().ids()) {
      const Point2 p = vertices().exact(v);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  // Eyes around the scene and in it, in tiles of so many columns and rows.
  void check(std::size_t count, std::size_t columns, std::size_t rows) {
    const auto coordinates = [&](const Rational& low, const Rational& high) {
      std::vector<EyeCoordinate2> result;
      for (std::size_t k = 0; k < count; ++k) {
        const Rational share =
            Rational(4 * static_cast<long>(k) - static_cast<long>(count) / 2) / Rational(3 * static_cast<long>(count));
        result.emplace_back(vertices(), low + (high - low + 1) * share);
      }
      return result;
    };
    const auto x = coordinates(low_.x, high_.x), y = coordinates(low_.y, high_.y);
    for (std::size_t row = 0; row < count; row += rows)
      for (std::size_t column = 0; column < count; column += columns)
        check_tile({vertices(), std::span(x).subspan(column, std::min(columns, count - column)),
                    std::span(y).subspan(row, std::min(rows, count - row))});
  }

  // Eyes whose distance is this share of the scene, about the given vertex.
  void check_about(VertexId v, const Rational& share) {
    const Point2 at = vertices().exact(v);
    const Rational step = (high_.x - low_.x + high_.y - low_.y) * share;
    std::vector<EyeCoordinate2> x, y;
    for (long k = -4; k < 4; ++k) {
      x.emplace_back(vertices(), at.x + step * k);
      y.emplace_back(vertices(), at.y + step * k);
    }
    check_tile({vertices(), x, y});
  }

  std::size_t vertex_count() const { return vertices().size(); }

 private:
  const Vertices2& vertices() const { return arrangement_.vertices(); }

  void check_tile(const EyeTile2& tile) {
    together_.look_around(location_, tile);
    View2 alone;
    for (std::size_t row = 0; row < tile.rows(); ++row)
      for (std::size_t column = 0; column < tile.columns(); ++column) {
        const std::size_t k = EyeTile2::kSide * row + column;
        const Location2 place = location_.look_around(tile.eye(k), alone);
        ASSERT_EQ(together_.location(k).kind, place.kind);
        ASSERT_EQ(together_.location(k).half_edge, place.half_edge);
        ASSERT_EQ(together_.location(k).vertex, place.vertex);
        ASSERT_TRUE(std::equal(together_.view(k).seen.begin(), together_.view(k).seen.end(), alone.seen.begin(),
                               alone.seen.end(), same))
            << "eye " << row << ", " << column;
      }
  }

  Arrangement2 arrangement_;
  PointLocation2 location_;
  Point2 low_, high_;
  inline static TileViews2 together_;  // for one scene after the other
};

class TileViews2OfAScene : public testing::TestWithParam<std::string> {};

TEST_P(TileViews2OfAScene, AreThoseOfTheirEyes) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Together scene(generated(GetParam(), 20 + 60 * seed, seed));
    scene.check(30, 8, 8);
    scene.check(19, 3, 5);
    scene.check(16, 8, 1);
    scene.check(64, 8, 8);
  }
}

TEST_P(TileViews2OfAScene, AreThoseOfEyesNearVertices) {
  Together scene(generated(GetParam(), 30, 5));
  for (const VertexId v : IdRange<VertexId>(std::min<std::size_t>(scene.vertex_count(), 20)))
    for (const char* share : {"1/50", "1e-4", "1e-16", "1e-40"}) scene.check_about(v, *parse_rational(share));
}

INSTANTIATE_TEST_SUITE_P(Kinds, TileViews2OfAScene,
                         testing::Values("room", "clutter", "lattice", "maze", "comb", "star", "pillars", "plates"),
                         [](const auto& kind) { return kind.param; });

TEST(TileViews2OfDegenerateScenes, AreThoseOfTheirEyes) {
  for (const Scene2& scene :
       {scene_of({{"one", "0", "0", "1", "2"}}), scene_of({{"a", "0", "0", "1", "0"}, {"b", "3", "0", "4", "0"}}),
        scene_of({{"a", "-1", "-1", "1", "1"}, {"b", "-1", "1", "1", "-1"}}),
        scene_of({{"a", "0", "0", "1", "0"}, {"b", "0", "1", "1", "1"}, {"c", "7", "7", "8", "5"}}),
        scene_of({{"a", "0", "0", "4", "0"}, {"b", "2", "1", "3", "1"}, {"c", "2", "-1", "5", "1e-30"}})}) {
    Together together(scene);
    for (const std::size_t count : {4, 8, 13, 36}) together.check(count, 8, 8);
    for (const VertexId v : IdRange<VertexId>(together.vertex_count())) together.check_about(v, Rational(1, 16));
  }
}

}  // namespace
}  // namespace hottel::tile_views_test

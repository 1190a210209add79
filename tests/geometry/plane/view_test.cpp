// What is seen from a point, against lines of sight to every vertex in rationals.
#include "geometry/plane/visibility/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/point_location.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::view_test {
namespace {

using namespace testing_scenes;

int orientation(const Point2& p, const Point2& q, const Point2& r) {
  const Rational area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return sgn(area);
}

bool lies_between(const Point2& p, const Point2& a, const Point2& b) {
  const Rational product = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
  return orientation(a, b, p) == 0 && product < 0;
}

// A scene, and what a brute force sees in it.
class Sight {
 public:
  explicit Sight(const Scene2& scene) : arrangement_(scene, Division2(scene.surfaces.size(), 1)) {
    for (const VertexId v : arrangement_.vertices().ids()) points_.push_back(arrangement_.vertices().exact(v));
  }

  const Arrangement2& arrangement() const { return arrangement_; }
  const Point2& point(VertexId v) const { return points_[v.index()]; }

  // Property (1): the open segment from the eye meets no piece and no other vertex, or runs along a piece.
  bool sees(const Point2& eye, VertexId v) const {
    if (points_[v.index()] == eye) return false;
    for (const Point2& p : points_)
      if (lies_between(p, eye, points_[v.index()])) return false;
    return std::none_of(arrangement_.pieces().begin(), arrangement_.pieces().end(), [&](const Segment2& piece) {
      const Point2 &a = points_[piece.a.index()], &b = points_[piece.b.index()];
      return orientation(eye, points_[v.index()], a) * orientation(eye, points_[v.index()], b) < 0 &&
             orientation(a, b, eye) * orientation(a, b, points_[v.index()]) < 0;
    });
  }

  // The side of a piece that a ray from the eye meets first, if it passes no vertex; kSky for none.
  PieceSideId first_met(const Point2& eye, const Point2& direction) const {
    PieceSideId found = kSky;
    Rational nearest = 0;
    for (std::size_t k = 0; k < arrangement_.pieces().size(); ++k) {
      const Point2 &a = points_[arrangement_.pieces()[k].a.index()], &b = points_[arrangement_.pieces()[k].b.index()];
      const Rational ux = b.x - a.x, uy = b.y - a.y;
      const Rational turn = direction.x * uy - direction.y * ux;
      if (turn == 0) continue;
      const Rational t = ((a.x - eye.x) * uy - (a.y - eye.y) * ux) / turn;
      const Rational s = ((a.x - eye.x) * direction.y - (a.y - eye.y) * direction.x) / turn;
      if (t <= 0 || s < 0 || s > 1 || (found != kSky && t >= nearest)) continue;
      nearest = t;
      found = turn > 0 ? left_side(k) : right_side(k);
    }
    return found;
  }

  // Checks a view from a point in integer form.
  void check(const Point2& eye, const View2& view) const {
    std::set<VertexId> seen;
    const std::size_t m = view.seen.size();
    for (const View2::Seen& s : view.seen) EXPECT_TRUE(seen.insert(s.vertex).second) << "no vertex twice";
    for (const VertexId v : IdRange<VertexId>(points_.size()))
      EXPECT_EQ(seen.contains(v), sees(eye, v)) << "vertex " << v.index();
    for (std::size_t k = 0; k < m; ++k) {
      const View2::Seen& s = view.seen[k];
      const Point2 &right = points_[s.vertex.index()], &left = points_[view.seen[(k + 1) % m].vertex.index()];
      // Counter-clockwise; a cone of half a turn or more is looked at just behind its right end.
      const Point2 r{right.x - eye.x, right.y - eye.y}, l{left.x - eye.x, left.y - eye.y};
      const Rational cross = r.x * l.y - r.y * l.x;
      Point2 direction{r.x + l.x, r.y + l.y};
      if (cross <= 0) {
        direction = {-r.y, r.x};
      } else {
        // The middle of the two unit vectors is not rational; any direction strictly inside the cone will do.
        EXPECT_GT(r.x * direction.y - r.y * direction.x, 0);
      }
      EXPECT_EQ(s.behind, first_met(eye, direction)) << "between " << k << " and the next";
      // Along a piece that covers the line of sight.
      PieceSideId on_left = kNoPiece;
      for (std::size_t p = 0; p < arrangement_.pieces().size(); ++p) {
        const Point2 &a = points_[arrangement_.pieces()[p].a.index()], &b = points_[arrangement_.pieces()[p].b.index()];
        if (b == right && (a == eye || lies_between(eye, a, b))) on_left = left_side(p);
        if (a == right && (b == eye || lies_between(eye, a, b))) on_left = right_side(p);
      }
      EXPECT_EQ(s.left, on_left);
      EXPECT_EQ(s.right, on_left == kNoPiece ? kNoPiece : opposite(on_left));
    }
  }

  void check_vertices() const {
    View2 view;
    for (const VertexId v : IdRange<VertexId>(points_.size())) {
      look_around(arrangement_.vertices(), arrangement_.triangulation(), v, view);
      SCOPED_TRACE(fmt::format("from vertex {}", v.index()));
      check(points_[v.index()], view);
    }
  }

  // Eyes inside, outside, on vertices, on pieces and on lines through two vertices.
  void check_free_eyes(int count) const {
    const Vertices2& vertices = arrangement_.vertices();
    const PointLocation2 location(vertices, arrangement_.triangulation());
    std::mt19937_64 random(1);
    View2 view;
    for (int k = 0; k < count; ++k) {
      const Point2 &p = points_[random() % points_.size()], &q = points_[random() % points_.size()],
                   &r = points_[random() % points_.size()];
      const auto share = [&] {
        Rational value(static_cast<long>(random() % 13) - 3, 7);
        value.canonicalize();
        return value;
      };
      const Rational s = share(), t = k % 3 == 0 ? share() : Rational(0);
      const Point2 eye{p.x + s * (q.x - p.x) + t * (r.x - p.x), p.y + s * (q.y - p.y) + t * (r.y - p.y)};
      location.look_around(Eye2(vertices, eye), view);
      SCOPED_TRACE(fmt::format("eye {}, {}", eye.x.get_str(), eye.y.get_str()));
      check(eye, view);
    }
    for (const Segment2& piece : arrangement_.pieces()) {
      const Point2 &a = points_[piece.a.index()], &b = points_[piece.b.index()];
      const Point2 eye{(a.x + 2 * b.x) / 3, (a.y + 2 * b.y) / 3};
      location.look_around(Eye2(vertices, eye), view);
      check(eye, view);
    }
  }

 private:
  Arrangement2 arrangement_;
  std::vector<Point2> points_;  // in integer form
};

class View2OfAScene : public testing::TestWithParam<std::string> {};

TEST_P(View2OfAScene, HoldsWhatEveryVertexSees) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) Sight(generated(GetParam(), 18 + 14 * seed, seed)).check_vertices();
}

TEST_P(View2OfAScene, HoldsWhatAFreeEyeSees) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) Sight(generated(GetParam(), 16 + 10 * seed, seed)).check_free_eyes(60);
}

INSTANTIATE_TEST_SUITE_P(Kinds, View2OfAScene,
                         testing::Values("room", "clutter", "lattice", "maze", "comb", "star", "pillars", "plates"),
                         [](const auto& kind) { return kind.param; });

TEST(View2OfDegenerateScenes, IsRight) {
  for (const Scene2& scene :
       {scene_of({{"one", "0", "0", "1", "2"}}),
        scene_of({{"a", "0", "0", "1", "2"}, {"b", "1", "2", "2", "4"}, {"c", "5", "10", "3", "6"}}),
        scene_of({{"a", "-1", "-1", "1", "1"}, {"b", "-1", "1", "1", "-1"}}),
        scene_of({{"a", "0", "0", "1", "0"}, {"b", "0", "1", "1", "1"}, {"c", "7", "7", "8", "5"}}),
        scene_of({{"a", "0", "0", "4", "0"}, {"b", "2", "1", "3", "1"}, {"c", "2", "-1", "5", "1e-30"}})}) {
    const Sight sight(scene);
    sight.check_vertices();
    sight.check_free_eyes(300);
  }
}

}  // namespace
}  // namespace hottel::view_test

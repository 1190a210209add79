// Every predicate on 256 x 256 adjacent doubles about a degeneracy: right everywhere, where plain doubles are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <span>

#include "geometry/plane/predicates/eye_line.h"
#include "geometry/plane/predicates/eye_tile.h"
#include "geometry/plane/predicates/vertices.h"
#include "kernel/root_sum.h"
#include "tests/geometry/plane/vertex_literal.h"
#include "tests/neighbouring_doubles/grid.h"

namespace hottel::predicates_neighbouring_doubles_test {
namespace {

using namespace neighbouring_doubles;

// With a point that needs 70 bits the vertices take their large form.
enum class Form { kSmall, kLarge };

// All points of a grid as vertices, after the fixed ones.
class Points {
 public:
  Points(const std::vector<Double2>& fixed, const Grid& grid, Form form) : first_(fixed.size()) {
    for (const Double2& p : fixed) exact_.push_back(exact(p));
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) exact_.push_back(exact(grid.at(i, j)));
    if (form == Form::kLarge) exact_.push_back({1 + scaled_by_power_of_two(1, -70), 0});
    vertices_ = Vertices2(exact_, exact_.size());
    EXPECT_EQ(vertices_.is_small(), form == Form::kSmall);
  }

  const Vertices2& vertices() const { return vertices_; }
  const Point2& exact_point(VertexId v) const { return exact_[v.index()]; }
  VertexId id(int i, int j) const { return VertexId(first_ + static_cast<std::size_t>(j * kSide + i)); }

 private:
  std::size_t first_;
  std::vector<Point2> exact_;
  Vertices2 vertices_;
};

// Calls visit(i, j, vertex), and returns for how many it was false.
template <class Visit>
int count_failures(const Points& points, const Visit& visit) {
  int failures = 0;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) failures += !visit(i, j, points.id(i, j));
  return failures;
}

class NeighbouringDoubles : public testing::TestWithParam<Form> {};

TEST(KettnerGrids, PlainDoublesAreWrongAsOftenAsPublished) {
  for (const Grid& grid : kettner_grids()) {
    int wrong = 0;
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        const Double2 p = grid.at(i, j);
        wrong += naive_orientation(p, grid.q, grid.r) != exact_orientation(exact(p), exact(grid.q), exact(grid.r));
      }
    std::printf("grid %s: %d of 4096 orientations wrong in plain doubles\n", grid.name, wrong);
    EXPECT_EQ(wrong, grid.wrong_of_4096) << grid.name;
  }
}

TEST_P(NeighbouringDoubles, OrientationIsRight) {
  for (const Grid& grid : kettner_grids()) {
    const Points points({grid.q, grid.r}, grid, GetParam());
    const Vertices2& v = points.vertices();
    const int naive_failures = count_failures(points, [&](int i, int j, VertexId p) {
      return naive_orientation(grid.at(i, j), grid.q, grid.r) ==
             exact_orientation(points.exact_point(p), points.exact_point(0_v), points.exact_point(1_v));
    });
    EXPECT_GT(naive_failures, 10000) << "of 65536: the grid is where it is hard";
    EXPECT_EQ(count_failures(points,
                             [&](int, int, VertexId p) {
                               const int sign = exact_orientation(points.exact_point(p), points.exact_point(0_v),
                                                                  points.exact_point(1_v));
                               return v.orientation(p, 0_v, 1_v) == sign && v.orientation(0_v, 1_v, p) == sign &&
                                      v.orientation(1_v, p, 0_v) == sign && v.orientation(p, 1_v, 0_v) == -sign &&
                                      v.orientation(0_v, p, 1_v) == -sign && v.orientation(1_v, 0_v, p) == -sign;
                             }),
              0)
        << grid.name;
  }
}

TEST_P(NeighbouringDoubles, OrientationFromAnEyeIsRight) {
  for (const Grid& grid : kettner_grids()) {
    const Points points({grid.q, grid.r}, grid, GetParam());
    const Vertices2& v = points.vertices();
    EXPECT_EQ(count_failures(points,
                             [&](int i, int j, VertexId p) {
                               const Eye2 eye(v, v.from_scene(exact(grid.at(i, j))));
                               const int sign = exact_orientation(points.exact_point(p), points.exact_point(0_v),
                                                                  points.exact_point(1_v));
                               return eye.orientation(0_v, 1_v) == sign && eye.orientation(1_v, 0_v) == -sign &&
                                      eye.direction_sign(0_v, 1_v) == 1 && eye.coincides_with(p) &&
                                      !eye.coincides_with(points.id((i + 1) % kSide, j));
                             }),
              0)
        << grid.name;
  }
}

TEST_P(NeighbouringDoubles, SideOfALineThroughTwoEyesIsRight) {
  for (const Grid& grid : kettner_grids()) {
    const Points points({grid.q, grid.r}, grid, GetParam());
    const Vertices2& v = points.vertices();
    const Eye2 q(v, v.from_scene(exact(grid.q))), r(v, v.from_scene(exact(grid.r)));
    const EyeLine2 forth(q, r), back(r, q);
    EXPECT_EQ(count_failures(points,
                             [&](int i, int j, VertexId p) {
                               const Eye2 eye(v, v.from_scene(exact(grid.at(i, j))));
                               const EyeLine2 from(eye, q), to(q, eye);
                               const int sign = exact_orientation(points.exact_point(p), points.exact_point(0_v),
                                                                  points.exact_point(1_v));
                               return forth.side(p) == sign && back.side(p) == -sign && from.side(1_v) == sign &&
                                      to.side(1_v) == -sign && from.side(p) == 0 && to.side(0_v) == 0;
                             }),
              0)
        << grid.name;
  }
}

TEST_P(NeighbouringDoubles, LeftTurnsSeenFromATileOfEyesAreRight) {
  constexpr int kTile = static_cast<int>(EyeTile2::kSide);
  for (const Grid& grid : kettner_grids()) {
    const Points points({grid.q, grid.r}, grid, GetParam());
    const Vertices2& v = points.vertices();
    std::vector<EyeCoordinate2> x, y;
    for (int k = 0; k < kSide; ++k) {
      const Point2 p = v.from_scene(exact(grid.at(k, k)));
      x.emplace_back(v, p.x);
      y.emplace_back(v, p.y);
    }
    int failures = 0;
    for (std::size_t j = 0; j < kSide; j += kTile)
      for (std::size_t i = 0; i < kSide; i += kTile) {
        const EyeTile2 tile(v, std::span(x).subspan(i, kTile), std::span(y).subspan(j, kTile));
        const EyeTile2::Set left = tile.seeing_left_turn(tile.group(~EyeTile2::Set{0}), 0_v, 1_v);
        const EyeTile2::Set right = tile.seeing_left_turn(tile.group(~EyeTile2::Set{0}), 1_v, 0_v);
        for (std::size_t k = 0; k < kTile * kTile; ++k) {
          const VertexId p = points.id(static_cast<int>(i + k % kTile), static_cast<int>(j + k / kTile));
          const int sign = exact_orientation(points.exact_point(p), points.exact_point(0_v), points.exact_point(1_v));
          failures += static_cast<int>(left >> k & 1) - static_cast<int>(right >> k & 1) != sign;
        }
      }
    EXPECT_EQ(failures, 0) << grid.name;
  }
}

// Between two of 256 adjacent points on a row, a column or the diagonal, every two of them.
TEST_P(NeighbouringDoubles, BetweennessIsRight) {
  const Grid grid{"about a point", {0.5, 0.5}, {}, {}, 0};
  const Points points({}, grid, GetParam());
  const Vertices2& v = points.vertices();
  constexpr int kMiddle = 100;
  const auto on_row = [&](int k) { return points.id(k, kMiddle); };
  const auto on_column = [&](int k) { return points.id(kMiddle, k); };
  const auto on_diagonal = [&](int k) { return points.id(k, k); };
  EXPECT_EQ(count_failures(points,
                           [&](int i, int j, VertexId) {
                             const bool is_between = std::min(i, j) < kMiddle && kMiddle < std::max(i, j);
                             const VertexId middle = points.id(kMiddle, kMiddle);
                             return v.is_between(on_row(i), on_row(j), middle) == is_between &&
                                    v.is_between(on_column(i), on_column(j), middle) == is_between &&
                                    v.is_between(on_diagonal(i), on_diagonal(j), middle) == is_between;
                           }),
            0);
}

TEST_P(NeighbouringDoubles, DirectionIsRight) {
  // Seen from (12, 12), (24, 0) is at a right angle to (1/2, 1/2).
  const Grid grid{"right angle", {0.5, 0.5}, {12, 12}, {24, 0}, 0};
  const Points points({grid.q, grid.r}, grid, GetParam());
  const Vertices2& v = points.vertices();
  const Eye2 eye(v, v.from_scene(exact(grid.q)));
  int naive_failures = 0;
  EXPECT_EQ(count_failures(points,
                           [&](int i, int j, VertexId p) {
                             const int sign = exact_direction(points.exact_point(0_v), points.exact_point(p),
                                                              points.exact_point(1_v));
                             naive_failures += naive_direction(grid.q, grid.at(i, j), grid.r) != sign;
                             return v.direction_sign(0_v, p, 1_v) == sign && v.direction_sign(0_v, 1_v, p) == sign &&
                                    eye.direction_sign(p, 1_v) == sign;
                           }),
            0);
  EXPECT_GT(naive_failures, 5000);
}

TEST_P(NeighbouringDoubles, SideOfCircleIsRight) {
  // A square with a corner in (1/2, 1/2).
  const Grid grid{"square", {0.5, 0.5}, {}, {}, 0};
  const Double2 a{15.5, 0.5}, b{15.5, 15.5}, c{0.5, 15.5};
  const Points points({a, b, c}, grid, GetParam());
  const Vertices2& v = points.vertices();
  int naive_failures = 0;
  EXPECT_EQ(count_failures(points,
                           [&](int i, int j, VertexId p) {
                             const int sign = exact_side_of_circle(points.exact_point(0_v), points.exact_point(1_v),
                                                                   points.exact_point(2_v), points.exact_point(p));
                             naive_failures += naive_side_of_circle(a, b, c, grid.at(i, j)) != sign;
                             return v.side_of_circle(0_v, 1_v, 2_v, p) == sign &&
                                    v.side_of_circle(1_v, 2_v, 0_v, p) == sign;
                           }),
            0);
  EXPECT_GT(naive_failures, 50);
}

TEST_P(NeighbouringDoubles, OrderOfCoordinatesIsRight) {
  const Grid grid{"about a point", {0.5, 0.5}, {next(0.5, 100), next(0.5, 50)}, {}, 0};
  const Points points({grid.q}, grid, GetParam());
  const Vertices2& v = points.vertices();
  EXPECT_EQ(count_failures(points,
                           [&](int i, int j, VertexId p) {
                             const int x = (i > 100) - (i < 100), y = (j > 50) - (j < 50);
                             return v.compare_x(p, 0_v) == x && v.compare_y(p, 0_v) == y &&
                                    v.precedes(p, 0_v) == (x < 0 || (x == 0 && y < 0));
                           }),
            0);
}

INSTANTIATE_TEST_SUITE_P(, NeighbouringDoubles, testing::Values(Form::kSmall, Form::kLarge),
                         [](const auto& test) { return test.param == Form::kSmall ? "small_form" : "large_form"; });

// A detour over q is none iff q lies on the way: |pq| + |qr| - |pr| is 0 iff the three are on one line.
TEST(NeighbouringDoublesOfRoots, TheSignOfADetourIsRight) {
  const Grid& grid = kettner_grids().front();
  const auto add_distance = [](RootSum& sum, int factor, const Point2& a, const Point2& b) {
    const Rational x = a.x - b.x, y = a.y - b.y;
    sum.add(factor, x * x + y * y);
  };
  const Point2 q = exact(grid.q), r = exact(grid.r);
  int failures = 0, none = 0;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const Point2 p = exact(grid.at(i, j));
      RootSum detour;
      add_distance(detour, 1, p, q);
      add_distance(detour, 1, q, r);
      add_distance(detour, -1, p, r);
      const bool is_straight = exact_orientation(p, q, r) == 0;
      none += is_straight;
      failures += detour.sign() != (is_straight ? 0 : 1);
    }
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(none, kSide) << "the diagonal";
}

}  // namespace
}  // namespace hottel::predicates_neighbouring_doubles_test

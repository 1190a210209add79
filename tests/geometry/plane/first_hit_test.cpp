// What a ray meets first, against every piece by itself over rationals.
#include "geometry/plane/visibility/first_hit.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::first_hit_test {
namespace {

using testing_scenes::Line;
using testing_scenes::scene_of;

struct Vector {
  Rational x, y;
};
Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Vector operator-(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }

// A ray in exact numbers, and where it meets the line of a piece: at t + e u, for an infinitesimal shift e to the left.
struct Ray {
  Point2 origin;
  Vector direction, left;
};
struct Meeting {
  Rational t, u;
  PieceSideId side;
  bool operator<(const Meeting& other) const { return t != other.t ? t < other.t : u < other.u; }
};

Ray exact_ray(const Arrangement2& arrangement, const PieceRay2& ray) {
  const Segment2& piece = arrangement.piece(ray.from);
  const Point2 a = arrangement.vertices().exact(piece.a);
  const Vector along = arrangement.vertices().exact(piece.b) - a;
  const Rational s(ray.s), dx(ray.dx), dy(ray.dy);
  return {{a.x + s * along.x, a.y + s * along.y}, {dx, dy}, {-dy, dx}};
}

bool leaves_the_side(const Arrangement2& arrangement, const PieceRay2& ray) {
  const Segment2& piece = arrangement.piece(ray.from);
  const Vector along = arrangement.vertices().exact(piece.b) - arrangement.vertices().exact(piece.a);
  const int turn = sgn(cross(along, {Rational(ray.dx), Rational(ray.dy)}));
  return is_right(ray.from) ? turn < 0 : turn > 0;
}

PieceSideId brute_force(const Arrangement2& arrangement, const PieceRay2& ray) {
  const Ray exact = exact_ray(arrangement, ray);
  std::optional<Meeting> first;
  for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
    if (k == piece_of(ray.from)) continue;
    const Point2 a = arrangement.vertices().exact(arrangement.pieces()[k].a);
    const Point2 b = arrangement.vertices().exact(arrangement.pieces()[k].b);
    const bool a_is_left = cross(exact.direction, a - exact.origin) > 0;
    const bool b_is_left = cross(exact.direction, b - exact.origin) > 0;
    if (a_is_left == b_is_left) continue;
    const Vector along = b - a;
    const Rational slope = cross(exact.direction, along);
    const PieceSideId side = slope < 0 ? right_side(k) : left_side(k);
    const Meeting meeting{cross(a - exact.origin, along) / slope, -cross(exact.left, along) / slope, side};
    if (meeting.t > 0 && (!first || meeting < *first)) first = meeting;
  }
  return first ? first->side : kSky;
}

// Every ray from the middle of every side through every vertex, and some at random.
int compare(const Scene2& scene, std::uint32_t seed) {
  const PreparedScene2 prepared = prepare(scene);
  const Arrangement2& arrangement = prepared.arrangement;
  const Vertices2& vertices = arrangement.vertices();
  const FirstHit2 first_hit(arrangement);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  int compared = 0;
  const auto check = [&](const PieceRay2& ray) {
    if (!leaves_the_side(arrangement, ray)) return;
    EXPECT_EQ(first_hit(ray), brute_force(arrangement, ray)) << ray.from.number() << ' ' << ray.dx << ' ' << ray.dy;
    ++compared;
  };
  for (const PieceSideId from : arrangement.sides()) {
    const auto &a = vertices.approximate(arrangement.piece(from).a),
               &b = vertices.approximate(arrangement.piece(from).b);
    for (const VertexId v : vertices.ids())
      check({from, 0.5, 2 * vertices.approximate(v).x - a.x - b.x, 2 * vertices.approximate(v).y - a.y - b.y});
    for (int k = 0; k < 8; ++k) check({from, 0.5 + unit(random) / 2.5, unit(random), unit(random)});
  }
  return compared;
}

TEST(FirstHit2, IsWhatEveryPieceByItselfSays) {
  // Segments of a small grid: many of them cross, touch and line up.
  std::mt19937 random(1);
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    std::vector<Line> lines;
    for (int k = 0; k < 12; ++k) {
      const auto coordinate = [&] { return std::to_string(random() % 8); };
      Line line{"line " + std::to_string(k), coordinate(), coordinate(), coordinate(), coordinate()};
      line.material = 1;
      if (line.x0 != line.x1 || line.y0 != line.y1) lines.push_back(line);
    }
    compared += compare(scene_of(lines), seed);
  }
  EXPECT_GT(compared, 4'000);
}

TEST(FirstHit2, DoesNotSlipThroughWhereTwoPiecesMeet) {
  // A floor under a roof of two pieces: the ray from the middle of the floor goes through the ridge.
  const PreparedScene2 prepared = prepare(scene_of({{"floor", "-3", "0", "3", "0", 0, 0},
                                                    {"left", "-3", "2", "0", "4", 1, 1},
                                                    {"right", "0", "4", "3", "2", 2, 2}}));
  const FirstHit2 first_hit(prepared.arrangement);
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  for (const PieceSideId side : prepared.arrangement.sides()) {
    const PieceRay2 up{side, 0.5, 0, 1};
    if (!leaves_the_side(prepared.arrangement, up)) continue;
    const std::string from = table.elements()[table.of(up.from)].name;
    if (!from.starts_with("floor")) continue;
    EXPECT_EQ(table.elements()[table.of(first_hit(up))].name, "left");
  }
}

TEST(FirstHit2, MeetsTheSkyInAnOpenScene) {
  const PreparedScene2 prepared = prepare(scene_of({{"alone", "0", "0", "1", "0"}}));
  const FirstHit2 first_hit(prepared.arrangement);
  EXPECT_EQ(first_hit({left_side(0), 0.5, 0.25, 1}), kSky);
  EXPECT_EQ(first_hit({right_side(0), 0.5, 0.25, -1}), kSky);
}

}  // namespace
}  // namespace hottel::first_hit_test

// The critical lines of a scene.
#include "geometry/plane/visibility/critical_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_place.h"
#include "io/scene/scene_json.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel::critical_lines_test {
namespace {

PreparedScene2 generated(const std::string& kind, std::uint64_t n) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  return prepare(generate_2(request));
}

PreparedScene2 scene(const std::string& surfaces) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, )" + surfaces + "}", "test.json"));
}

Rational turn(const Point2& p, const Point2& q, const Point2& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

const CriticalLine2* find(const std::vector<CriticalLine2>& lines, const Point2& p, const Point2& q) {
  for (const CriticalLine2& line : lines)
    if ((line.from == p && line.to == q) || (line.from == q && line.to == p)) return &line;
  return nullptr;
}

TEST(CriticalLines2, EveryCriticalPointOfEveryPairOfFacesIsOnOne) {
  for (const char* kind : {"room", "clutter", "maze", "plates"}) {
    const PreparedScene2 prepared = generated(kind, 16);
    const auto lines = critical_lines(prepared);
    std::size_t points = 0;
    for (std::uint32_t a = 0; a < 2 * prepared.scene.surfaces.size(); ++a)
      for (std::uint32_t b = 0; b <= 2 * prepared.scene.surfaces.size(); ++b) {
        const auto other = b < 2 * prepared.scene.surfaces.size() ? std::optional(Face::of(b)) : std::nullopt;
        for (const CriticalPoint2& c : critical_points(prepared.arrangement, prepared.scene, Face::of(a), other)) {
          EXPECT_NE(find(lines, c.near, c.far), nullptr) << kind;
          ++points;
        }
      }
    EXPECT_GT(points, 20u);
  }
}

TEST(CriticalLines2, CrossNoPieceBetweenTheirEnds) {
  for (const char* kind : {"clutter", "maze", "lattice", "pillars"}) {
    const PreparedScene2 prepared = generated(kind, 30);
    const auto lines = critical_lines(prepared);
    EXPECT_GT(lines.size(), 30u);
    for (const CriticalLine2& line : lines) {
      const Point2 begin = line.behind.end.value_or(line.from), end = line.ahead.end.value_or(line.to);
      for (const Edge2& edge : prepared.scene.edges) {
        const int from = sgn(turn(begin, end, edge.from)), to = sgn(turn(begin, end, edge.to));
        const int first = sgn(turn(edge.from, edge.to, begin)), second = sgn(turn(edge.from, edge.to, end));
        EXPECT_FALSE(from * to < 0 && first * second < 0) << kind;
      }
      for (const LineReach2* reach : {&line.behind, &line.ahead})
        EXPECT_EQ(reach->end.has_value(), reach->left != kSky && reach->right != kSky);
    }
  }
}

TEST(CriticalLines2, ReachAsFarAsEitherSideIsFree) {
  // Two tips on the line y = 1 from opposite sides, in a room.
  const PreparedScene2 prepared = scene(R"("polylines": [
      {"name": "room", "points": [[0,0],[0,2],[9,2],[9,0]], "closed": true, "material": "m"}], "edges": [
      {"name": "low", "points": [[3,0],[3,1]], "material": "m"}, {"name": "high", "points": [[6,2],[6,1]], "material": "m"}])");
  const auto lines = critical_lines(prepared);
  const CriticalLine2* bitangent = find(lines, {3, 1}, {6, 1});
  ASSERT_NE(bitangent, nullptr);
  EXPECT_EQ(bitangent->along, kNoPiece);
  std::vector<Rational> ends{bitangent->behind.end->x, bitangent->ahead.end->x};
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (std::vector<Rational>{0, 9}));
  const CriticalLine2* along = find(lines, {3, 0}, {3, 1});
  ASSERT_NE(along, nullptr);
  EXPECT_NE(along->along, kNoPiece);
  const LineReach2& up = along->from == Point2{3, 0} ? along->ahead : along->behind;
  EXPECT_EQ(*up.end, (Point2{3, 2}));
}

TEST(CriticalLines2, NoneRunsInASolid) {
  const PreparedScene2 prepared = scene(R"("polylines": [
      {"name": "room", "points": [[0,0],[0,9],[9,9],[9,0]], "closed": true, "material": "m"},
      {"name": "box", "points": [[3,3],[6,3],[6,6],[3,6]], "closed": true, "material": "m"}])");
  const auto lines = critical_lines(prepared);
  EXPECT_EQ(find(lines, {3, 3}, {6, 6}), nullptr) << "a diagonal of the box";
  const CriticalLine2* side = find(lines, {3, 3}, {6, 3});
  ASSERT_NE(side, nullptr);
  std::vector<Rational> ends{side->behind.end->x, side->ahead.end->x};
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (std::vector<Rational>{0, 9}));
}

// What an eye sees first in a direction, by every edge, in rationals: the surfaces that are met there, and whether from
// their right side.
struct FirstMet {
  std::vector<std::uint32_t> surfaces;
  std::vector<bool> is_from_right;
};
FirstMet first_met(const Scene2& scene, const Point2& eye, const Point2& through) {
  FirstMet result;
  std::optional<Rational> nearest;
  for (std::uint32_t s = 0; s < scene.edges.size(); ++s) {
    const Edge2& edge = scene.edges[s];
    const Rational a = turn(eye, through, edge.from), b = turn(eye, through, edge.to);
    EXPECT_TRUE(a != 0 && b != 0) << "the eye is not moved little enough to miss all vertices";
    if (sgn(a) == sgn(b)) continue;
    const Rational at =
        turn(edge.from, edge.to, eye) / (turn(edge.from, edge.to, eye) - turn(edge.from, edge.to, through));
    if (at <= 0 || (nearest && *nearest < at)) continue;
    if (!nearest || at < *nearest) result = {};
    nearest = at;
    result.surfaces.push_back(s);
    result.is_from_right.push_back(turn(edge.from, edge.to, eye) < 0);
  }
  return result;
}

TEST(CriticalLines2, SeparateTheFacesThatAreSeenBetweenTheirVertices) {
  std::size_t told = 0, different = 0, in_solids = 0;
  for (const char* kind : {"lattice", "clutter", "maze", "room", "pillars", "star", "boxes"}) {
    const PreparedScene2 prepared = std::string(kind) == "boxes" ? scene(R"("polylines": [
        {"name": "room", "points": [[0,0],[0,9],[9,9],[9,0]], "closed": true, "material": "m"},
        {"name": "box", "points": [[3,3],[6,3],[6,6],[3,6]], "closed": true, "material": "m"},
        {"name": "corner", "points": [[6,6],[8,6],[8,7]], "closed": true, "material": "m"},
        {"name": "turned", "points": [[1,5],[2,6],[1,7],[0,6]], "closed": true, "material": "m"}])")
                                                                 : generated(kind, 40);
    Rational little = 1;
    for (int k = 0; k < 100; ++k) little /= 2;
    for (const CriticalLine2& line : critical_lines(prepared)) {
      const Point2 middle{(line.from.x + line.to.x) / 2, (line.from.y + line.to.y) / 2};
      const auto check = [&](const LineReach2& reach, const Point2& near, const Point2& far) {
        for (const int side : {1, -1}) {
          const PieceSideId seen = side > 0 ? reach.seen_from_left : reach.seen_from_right;
          if (reach.end == near) {
            EXPECT_EQ(seen, kNoPiece);
            continue;
          }
          const Rational dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
          const Point2 eye{near.x + little * (near.x - far.x) - side * little * little * dy,
                           near.y + little * (near.y - far.y) + side * little * little * dx};
          ++told;
          if (place_of(prepared, eye).solid) {
            ++in_solids;
            EXPECT_TRUE(seen != kSky && prepared.arrangement.is_covered(seen)) << kind;
            continue;
          }
          const FirstMet met = first_met(prepared.scene, eye, middle);
          if (seen == kSky) {
            EXPECT_TRUE(met.surfaces.empty()) << kind;
            continue;
          }
          ASSERT_FALSE(prepared.arrangement.is_covered(seen)) << kind;
          const Face face = prepared.arrangement.owner(seen);
          bool is_met = false;
          for (std::size_t k = 0; k < met.surfaces.size(); ++k)
            is_met = is_met || (met.surfaces[k] == face.surface && met.is_from_right[k] == !face.is_back);
          EXPECT_TRUE(is_met) << kind;
        }
        different += reach.seen_from_left != reach.seen_from_right;
      };
      check(line.behind, line.from, line.to);
      check(line.ahead, line.to, line.from);
    }
  }
  EXPECT_GT(told, 2000u);
  EXPECT_GT(different, 500u);
  EXPECT_GE(in_solids, 2u);
}

TEST(CriticalLines2, AreTheSameForAnyNumberOfThreadsAndStopWhenTold) {
  const PreparedScene2 prepared = generated("clutter", 60);
  const auto many = critical_lines(prepared);
  const ThreadLimit one(1);
  const auto few = critical_lines(prepared);
  ASSERT_EQ(many.size(), few.size());
  for (std::size_t k = 0; k < many.size(); ++k) EXPECT_TRUE(many[k].from == few[k].from && many[k].to == few[k].to);
  EXPECT_THROW(critical_lines(prepared, [](double) { throw Interrupted(); }), Interrupted);
}

}  // namespace
}  // namespace hottel::critical_lines_test

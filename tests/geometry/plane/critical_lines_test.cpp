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
#include "io/scene/scene_json.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
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
}  // namespace hottel

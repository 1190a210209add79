// Visibility polygons cut by a circle.
#include "geometry/plane/visibility/range_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::range_polygon_test {
namespace {

using testing::ElementsAre;
using Corner = RoundedPolygon2::Corner;

PreparedScene2 scene(const std::string& surfaces) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, )" + surfaces + "}", "test.json"));
}
PreparedScene2 square() {
  return scene(
      R"("polylines": [{"name": "room", "points": [[-4,-4],[-4,4],[4,4],[4,-4]], "closed": true, "material": "m"}])");
}

RoundedPolygon2 within(const PreparedScene2& prepared, const Point2& eye, const Rational& range) {
  return VisibilityPolygons2(prepared.arrangement).of(eye, {.range = range});
}

// The area by Green's theorem, arcs included.
double area(const Point2& eye, double range, const RoundedPolygon2& polygon) {
  const double x = to_double(eye.x), y = to_double(eye.y);
  double twice = 0;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const Corner &p = polygon.corners[k], &q = polygon.corners[(k + 1) % polygon.corners.size()];
    const double cross = (p.x - x) * (q.y - y) - (p.y - y) * (q.x - x),
                 dot = (p.x - x) * (q.x - x) + (p.y - y) * (q.y - y);
    double turn = std::atan2(cross, dot);
    if (turn < 0) turn += 2 * std::numbers::pi;
    if (polygon.corners.size() == 1) turn = 2 * std::numbers::pi;
    twice += p.after == kRange ? turn * range * range : cross;
  }
  return twice / 2;
}

// The area within the range from the rational polygon, part by part: a slow second way, in doubles.
double area_by_parts(const PreparedScene2& prepared, const Point2& eye, double range) {
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const VisibilityPolygon2 polygon = visibility_polygon(arrangement, location, eye);
  double sum = 0;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k) {
    const auto& part = polygon.parts[k];
    if (part.solid != Solids2::kNone) continue;
    const double whole = angle_fraction(polygon, k, 64).nearest_of_ends().lower * 2 * std::numbers::pi;
    if (part.side == kSky) {
      sum += whole * range * range / 2;
      continue;
    }
    // In thin sectors, each as far as the piece or the circle.
    const double ax = to_double(part.from.x - eye.x), ay = to_double(part.from.y - eye.y);
    const double bx = to_double(part.to.x - eye.x), by = to_double(part.to.y - eye.y);
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, angle = whole * t, c = std::cos(angle), s = std::sin(angle);
      const double length = std::hypot(ax, ay), dx = (ax * c - ay * s) / length, dy = (ax * s + ay * c) / length;
      const double far = (ax * (by - ay) - ay * (bx - ax)) / (dx * (by - ay) - dy * (bx - ax));
      const double r = std::min(far, range);
      sum += r * r / 2 * whole / n;
    }
  }
  return sum;
}

TEST(RangePolygon2, ArcsBeginAndEndWhereSidesCrossTheCircle) {
  const PreparedScene2 room = square();
  const RoundedPolygon2 found = within(room, {0, 0}, 5);  // crosses each wall 3 from its middle: rational
  ASSERT_EQ(found.corners.size(), 8u);
  for (const Corner& corner : found.corners) {
    EXPECT_EQ(std::min(std::fabs(corner.x), std::fabs(corner.y)), 3);
    EXPECT_EQ(std::max(std::fabs(corner.x), std::fabs(corner.y)), 4);
  }
  EXPECT_EQ(std::count_if(found.corners.begin(), found.corners.end(), [](auto& c) { return c.after == kRange; }), 4);
}

TEST(RangePolygon2, ADiscIsOneCornerAndARangeBeyondAllChangesNothing) {
  const PreparedScene2 room = square();
  EXPECT_THAT(within(room, {Rational(1, 2), 0}, 3).corners, ElementsAre(Corner{3.5, 0, kRange}));
  EXPECT_THAT(within(room, {0, 0}, 4).corners, ElementsAre(Corner{4, 0, kRange})) << "walls that are only touched";
  const RoundedPolygon2 all = VisibilityPolygons2(room.arrangement).of({0, 0});
  EXPECT_EQ(within(room, {0, 0}, 100).corners, all.corners);
}

TEST(RangePolygon2, CornersOnTheCircleAreKeptOnce) {
  // The corners (3, 4) and (-3, 4) of the wall are 5 away.
  const PreparedScene2 wall = scene(R"("edges": [{"name": "wall", "points": [[-3,4],[3,4]], "material": "m"}])");
  const RoundedPolygon2 found = within(wall, {0, 0}, 5);
  ASSERT_EQ(found.corners.size(), 2u);
  EXPECT_EQ((std::vector<double>{found.corners[0].x, found.corners[0].y, found.corners[1].x, found.corners[1].y}),
            (std::vector<double>{3, 4, -3, 4}));
  EXPECT_NE(found.corners[0].after, kRange);
  EXPECT_EQ(found.corners[1].after, kRange);
}

TEST(RangePolygon2, IrrationalCornersAreTheNearestDoubles) {
  const PreparedScene2 wall = scene(R"("edges": [{"name": "wall", "points": [[-9,1],[9,1]], "material": "m"}])");
  const RoundedPolygon2 found = within(wall, {0, 0}, 2);
  ASSERT_EQ(found.corners.size(), 2u);
  EXPECT_EQ(found.corners[0].x, std::sqrt(3.0));  // correctly rounded by IEEE 754
  EXPECT_EQ(found.corners[1].x, -std::sqrt(3.0));
  EXPECT_EQ(found.corners[0].y, 1);
}

TEST(RangePolygon2, HasTheAreaOfItsSectors) {
  for (const char* kind : {"room", "clutter", "maze", "plates", "pillars"}) {
    GeneratorRequest2 request;
    request.kind = kind;
    request.n = 40;
    const PreparedScene2 prepared = prepare(generate_2(request));
    const Edge2 &a = prepared.scene.edges[0], &b = prepared.scene.edges[prepared.scene.edges.size() / 2];
    const Point2 eyes[] = {
        {(2 * a.from.x + b.from.x) / 3, (a.from.y + b.to.y) / 2 + Rational(1, 7)}, point_at(a, Rational(1, 3)), a.from};
    for (const Point2& eye : eyes)
      for (const double range : {0.3, 1.0, 2.5, 1000.0}) {
        const RoundedPolygon2 found = within(prepared, eye, Rational(range));
        EXPECT_FALSE(found.sees_sky());
        if (found.corners.empty()) continue;
        const double expected = area_by_parts(prepared, eye, range);
        EXPECT_NEAR(area(eye, range, found), expected, 1e-4 * expected) << kind << " " << range;
        for (std::size_t k = 0; k < found.corners.size(); ++k)
          EXPECT_FALSE(found.corners.size() > 1 && found.corners[k].after == kRange &&
                       found.corners[(k + 1) % found.corners.size()].after == kRange);
      }
  }
}

TEST(RangePolygon2, ARangeIsAboveZeroAndHasNoExactCorners) {
  const PreparedScene2 room = square();
  EXPECT_THROW(within(room, {0, 0}, 0), ContractViolation);
  EXPECT_THROW(VisibilityPolygons2(room.arrangement).of({0, 0}, {.wants_exact = true, .range = Rational(1)}),
               ContractViolation);
}

}  // namespace
}  // namespace hottel::range_polygon_test

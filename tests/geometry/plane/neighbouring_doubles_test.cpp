// Visibility itself on adjacent doubles about a degeneracy: what is seen, and whether light passes.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/segment_visibility.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/neighbouring_doubles/grid.h"
#include "tests/sanitizers.h"

namespace hottel::neighbouring_doubles_test {
namespace {

using namespace neighbouring_doubles;
using namespace testing_scenes;

std::string typed(double value) { return to_string(Rational(value)); }

Line line(const std::string& name, const Double2& a, const Double2& b) {
  return {name, typed(a.x), typed(a.y), typed(b.x), typed(b.y), 1, 1};
}

// Seen from p, the target begins in r, behind the tip q of an occluder that hides all that is right of it.
//
//                         r   target
//                        . ────────
//               q      .
//              . ╲   .        p, q, r next to one line
//            .    ╲
//       p  .       ╲ occluder
TEST(NeighbouringDoublesOfVisibility, TheTargetIsSeenIffItBeginsLeftOfTheTip) {
  for (const Grid& grid : kettner_grids()) {
    const Scene2 scene =
        scene_of({line("occluder", grid.q, {2 * grid.q.x, 0}), line("target", grid.r, {2 * grid.r.x, grid.r.y - 1})});
    const PreparedScene2 prepared = prepare(scene);
    const Arrangement2& arrangement = prepared.arrangement;
    const Vertices2& vertices = arrangement.vertices();
    const PointLocation2 location(vertices, arrangement.triangulation());
    int failures = 0, seen = 0;
    View2 view;
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const Point2 p = exact(grid.at(i, j));
        location.look_around(Eye2(vertices, vertices.from_scene(p)), view);
        const bool sees_target = std::any_of(view.seen.begin(), view.seen.end(), [&](const View2::Seen& s) {
          return s.behind != kSky && arrangement.owner(s.behind).surface == 1;
        });
        seen += sees_target;
        failures += sees_target != (exact_orientation(p, exact(grid.q), exact(grid.r)) > 0);
      }
    EXPECT_EQ(failures, 0) << grid.name;
    EXPECT_GT(seen, 10000) << "on one side of the diagonal";
    EXPECT_LT(seen, kSide * kSide - 10000);
  }
}

// From p on one wall to r on another, past the tip q of an occluder that stands below: seen iff the tip is not above
// the line. Between the walls nothing else stands.
//
//   │            . │ r
//   │      q  .    │
//   │      .       │
//   │   .   ╲      │
//   │ p      ╲     │
TEST(NeighbouringDoublesOfVisibility, PointsOfTwoWallsSeeEachOtherIffTheTipIsNotAboveTheLine) {
  for (const Grid& grid : kettner_grids()) {
    int failures = 0, seen = 0;
    for (int i = 0; i < kSide; ++i) {
      const double x = grid.at(i, 0).x;
      const PreparedScene2 prepared =
          prepare(scene_of({line("p", {x, 0}, {x, 1}), line("occluder", grid.q, {2 * grid.q.x, -1}),
                            line("r", {grid.r.x, 2 * grid.r.y}, {grid.r.x, 0})}));
      const ElementTable2& table = *prepared.elements(Granularity::kFace);
      const Segment2 from = table.runs(0).front(), to = table.runs(4).front();
      const SegmentVisibility2 visibility(prepared.arrangement);
      const RunPoint2 r(prepared.arrangement, to, Rational(1, 2));
      for (int j = 0; j < kSide; ++j) {
        const RunPoint2 p(prepared.arrangement, from, Rational(grid.at(i, j).y));
        const bool sees = visibility.see_each_other(p, r);
        seen += sees;
        failures += sees != (exact_orientation(exact(grid.at(i, j)), exact(grid.q), exact(grid.r)) >= 0);
        failures += sees != visibility.see_each_other(r, p);
      }
    }
    EXPECT_EQ(failures, 0) << grid.name;
    EXPECT_GT(seen, 10000) << "on one side of the diagonal";
    EXPECT_LT(seen, kSide * kSide - 10000);
  }
}

// Light from a to b passes above the tips p and r and below the tip q between them: iff q is left of p, r.
//
//   │        │q      │
//   │                │ b
// a │  p         r
//   │  │         │
TEST(NeighbouringDoublesOfVisibility, LightPassesIffTheMiddleTipIsAboveTheOthers) {
  for (const Grid& grid : kettner_grids()) {
    const double far = 4 * grid.r.x;
    // A scene a point takes time: the others whole above.
    const int step = &grid == &kettner_grids().front() && !kHasAddressSanitizer ? 1 : 8;
    int scenes = 0, failures = 0, passes = 0;
    for (int j = 0; j < kSide; j += step)
      for (int i = 0; i < kSide; i += step) {
        const Double2 p = grid.at(i, j);
        const ExchangeMatrix matrix = exact_exchange(
            prepare(scene_of({line("a", {-10, -20}, {-10, grid.r.x}), line("b", {far, 1.5 * far}, {far, 0}),
                              line("p", p, {p.x, -2 * far}), line("q", grid.q, {grid.q.x, 2 * far}),
                              line("r", grid.r, {grid.r.x, -2 * far})})));
        const bool passed = matrix.factor(matrix.find("a").value(), matrix.find("b").value()).value > 0;
        ++scenes;
        passes += passed;
        failures += passed != (exact_orientation(exact(p), exact(grid.q), exact(grid.r)) < 0);
      }
    EXPECT_EQ(failures, 0) << grid.name;
    EXPECT_GT(passes, scenes / 4) << "on one side of the diagonal";
    EXPECT_LT(passes, scenes * 3 / 4);
  }
}

}  // namespace
}  // namespace hottel::neighbouring_doubles_test

// Solids whose outlines go along one line more than once. Random scenes:
// tests/oracle/plane/solids_against_oracle_test.cpp.
#include <gtest/gtest.h>

#include <utility>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/arrangement/solids.h"
#include "kernel/support/failure.h"
#include "tests/comparison/plane/ownership.h"

namespace hottel::outlines_there_and_back_test {
namespace {

using Points = std::vector<std::pair<int, int>>;
using Edges = std::vector<oracle::InputSegment>;

// Adds a closed polyline of one material.
void add_closed(Edges& edges, const Points& points, int material) {
  const int group = static_cast<int>(edges.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto &a = points[k], &b = points[(k + 1) % points.size()];
    edges.push_back({a.first, a.second, b.first, b.second, material, -1, group});
  }
}

Arrangement2 arrangement_of(const Edges& edges) { return {oracle::to_scene(edges), Division2(edges.size(), 1)}; }

// Found by the storm: an outline goes there and back along the wall of a room in it. The one of its fronts that looks
// into its own solid is a face that lies on the other, which therefore makes no claim: the wall is the room's.
TEST(Solids2, LeaveToARoomTheWallAlongWhichTheirOutlineGoesThereAndBack) {
  Edges edges;
  add_closed(edges, {{0, 2}, {1, 0}, {0, 1}}, 1);
  add_closed(edges, {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 2}}, 0);
  const Arrangement2 arrangement = arrangement_of(edges);
  EXPECT_EQ(oracle::verdict_differs(oracle::to_scene(edges), oracle::split(edges)), "");
  std::size_t sides_of_room = 0, covered = 0;
  for (const PieceSideId id : arrangement.sides()) {
    covered += arrangement.is_covered(id);
    sides_of_room += !arrangement.is_covered(id) && arrangement.owner(id).surface < 3;
  }
  EXPECT_EQ(sides_of_room, 3u);
  EXPECT_EQ(covered, 3u) << "of the outline where it goes once, and of the wall";
}

// An outline three times along one of its sides: once its front looks in, so that the two others make no claim.
TEST(Solids2, LeaveNothingOfASideAlongWhichTheirOutlineGoesThreeTimes) {
  Edges edges;
  add_closed(edges, {{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}}, 1);
  const Arrangement2 arrangement = arrangement_of(edges);
  EXPECT_EQ(oracle::verdict_differs(oracle::to_scene(edges), oracle::split(edges)), "");
  for (const PieceSideId id : arrangement.sides()) {
    if (!arrangement.is_covered(id) && arrangement.owner(id).surface < 3) {
      EXPECT_TRUE(arrangement.owner(id).is_back);
    }
  }
}

}  // namespace
}  // namespace hottel::outlines_there_and_back_test

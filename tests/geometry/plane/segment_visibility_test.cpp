#include "geometry/plane/visibility/segment_visibility.h"

#include <gtest/gtest.h>

#include "geometry/plane/arrangement/point_index.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::segment_visibility_test {
namespace {

using testing_scenes::Line;
using testing_scenes::number;
using testing_scenes::room;

// Points of named lines, on their fronts.
class Points {
 public:
  explicit Points(const std::vector<Line>& lines)
      : lines_(lines),
        arrangement_(testing_scenes::scene_of(lines), Division2(lines.size(), 1)),
        visibility_(arrangement_) {
    for (const VertexId v : arrangement_.vertices().ids())
      vertices_.insert(arrangement_.vertices().to_scene(arrangement_.vertices().exact(v)));
  }

  bool see(const std::string& a, const std::string& t, const std::string& b, const std::string& u) {
    const RunPoint2 p = point(a, t), q = point(b, u);
    EXPECT_EQ(visibility_.see_each_other(p, q), visibility_.see_each_other(q, p));
    return visibility_.see_each_other(p, q);
  }

 private:
  RunPoint2 point(const std::string& name, const std::string& t) {
    for (const Line& line : lines_)
      if (line.name == name) {
        const VertexId a = vertices_.insert({number(line.x0), number(line.y0)});
        const VertexId b = vertices_.insert({number(line.x1), number(line.y1)});
        return RunPoint2(arrangement_, {a, b}, number(t));
      }
    throw std::out_of_range(name);
  }

  std::vector<Line> lines_;
  Arrangement2 arrangement_;
  SegmentVisibility2 visibility_;
  PointIndex2 vertices_;
};

// In the room [0,4]^2 the middles of bottom and top are at (2,0) and (2,4).
bool middles_see_each_other(const std::vector<Line>& between) {
  return Points(room("4") + between).see("bottom", "1/2", "top", "1/2");
}

TEST(SegmentVisibility2, IsBlockedByWhatCrosses) {
  EXPECT_TRUE(middles_see_each_other({}));
  EXPECT_FALSE(middles_see_each_other({{"wall", "1", "2", "3", "2"}}));
  EXPECT_TRUE(middles_see_each_other({{"wall", "2.000000000000000001", "2", "3", "2"}}));
}

TEST(SegmentVisibility2, GrazesVerticesOnOneSide) {
  EXPECT_TRUE(middles_see_each_other({{"wall", "2", "2", "3", "2"}}));
  EXPECT_TRUE(middles_see_each_other({{"one", "2", "1", "3", "1"}, {"two", "2", "2", "3", "3"}}));
}

TEST(SegmentVisibility2, IsBlockedByTipsThatTouchItFromBothSides) {
  EXPECT_FALSE(middles_see_each_other({{"one", "1", "2", "2", "2"}, {"two", "2", "2", "3", "2"}}));
  EXPECT_FALSE(middles_see_each_other({{"one", "1", "1", "2", "1"}, {"two", "2", "3", "3", "3"}}));
}

TEST(SegmentVisibility2, SlidesAlongAWall) {
  EXPECT_TRUE(middles_see_each_other({{"wall", "2", "1", "2", "2"}}));
  EXPECT_TRUE(middles_see_each_other({{"wall", "2", "1", "2", "2"}, {"fin", "2", "1.5", "3", "1.5"}}));
  EXPECT_FALSE(middles_see_each_other(
      {{"wall", "2", "1", "2", "2"}, {"fin", "2", "1.5", "3", "1.5"}, {"other", "2", "2", "1", "2"}}));
}

TEST(SegmentVisibility2, LeavesThroughTheFrontOfTheStart) {
  Points points(room("4") + std::vector<Line>{{"shelf", "1", "2", "3", "2"}});  // front below
  EXPECT_TRUE(points.see("shelf", "1/2", "bottom", "1/2"));
  EXPECT_FALSE(points.see("shelf", "1/2", "top", "1/2"));
  EXPECT_FALSE(points.see("bottom", "0", "bottom", "1"));
}

TEST(SegmentVisibility2, LooksFromTheCornersOfARoom) {
  Points points(room("4"));
  EXPECT_TRUE(points.see("bottom", "0", "left", "1"));    // (4,0) and (0,4): moved to the left
  EXPECT_FALSE(points.see("bottom", "0", "top", "0"));    // moved, it ends on left or begins on right
  EXPECT_FALSE(points.see("bottom", "0", "right", "0"));  // within one line
  EXPECT_FALSE(points.see("bottom", "1", "left", "0"));   // one point
}

// A fin that stands at the middle of the bottom blocks the shift on its side.
TEST(SegmentVisibility2, IsBlockedAtItsEndByWhatStandsThere) {
  EXPECT_TRUE(middles_see_each_other({{"fin", "2", "0", "3", "1"}}));
  EXPECT_FALSE(middles_see_each_other({{"fin", "2", "0", "3", "1"}, {"other", "2", "0", "1", "1"}}));
  EXPECT_FALSE(middles_see_each_other({{"fin", "2", "0", "3", "1"}, {"other", "2", "4", "1", "3"}}));
  EXPECT_TRUE(middles_see_each_other({{"fin", "2", "0", "3", "1"}, {"other", "2", "4", "3", "3"}}));
}

// The segment between the ends of two edges is the hull of the scene: what is outside is free.
TEST(SegmentVisibility2, MayPassOutsideOfEverything) {
  const Line lower{"lower", "2", "0", "0", "0"}, upper{"upper", "0", "4", "2", "4"};
  EXPECT_TRUE(Points({lower, upper}).see("lower", "1", "upper", "0"));
  EXPECT_TRUE(Points({lower, upper, {"between", "0", "2", "3", "2"}}).see("lower", "1", "upper", "0"));
  EXPECT_FALSE(Points({lower, upper, {"between", "-1", "2", "3", "2"}}).see("lower", "1", "upper", "0"));
}

TEST(SegmentVisibility2, StartsAtContactsInsideARun) {
  Points points(room("4") + std::vector<Line>{{"fin", "1", "0", "1", "1"}, {"other", "3", "0", "3", "1"}});
  EXPECT_TRUE(points.see("bottom", "1/4", "top", "1/2"));   // from (3,0), a fin on one side of the segment to (2,4)
  EXPECT_TRUE(points.see("bottom", "3/4", "top", "1/4"));   // along the fin
  EXPECT_FALSE(points.see("bottom", "3/4", "right", "1"));  // in the line of the bottom
  EXPECT_FALSE(points.see("bottom", "3/4", "right", "7/8"));
}

}  // namespace
}  // namespace hottel::segment_visibility_test

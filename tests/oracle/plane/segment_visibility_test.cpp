// The walk through the triangulation against the moved segments of the oracle: 48,000 pairs of points.
#include "geometry/plane/visibility/segment_visibility.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>

#include "geometry/plane/arrangement/point_index.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/oracle/plane/random_scene.h"
#include "tests/oracle/plane/segment.h"

namespace hottel::oracle::segment_visibility_test {
namespace {

struct Counts {
  int pairs = 0, visible = 0, hidden = 0;
};

class PairsOfPoints {
 public:
  PairsOfPoints(const RandomScene& scene, std::uint64_t seed)
      : edges_(scene.edges),
        scene_(to_scene(scene.edges)),
        arrangement_(scene_, Division2(scene.edges.size(), 1)),
        visibility_(arrangement_),
        random_(seed) {
    for (const VertexId v : arrangement_.vertices().ids())
      vertices_.insert(arrangement_.vertices().to_scene(arrangement_.vertices().exact(v)));
  }

  void compare(Counts& counts) {
    const EdgePoint p = draw(), q = draw();
    const bool expected = hottel::oracle::see_each_other(edges_, p, q);
    const RunPoint2 from = run_point(p), to = run_point(q);
    ASSERT_EQ(visibility_.see_each_other(from, to), expected) << text(p) << " and " << text(q);
    ASSERT_EQ(visibility_.see_each_other(to, from), expected) << text(q) << " and " << text(p);
    ++counts.pairs;
    ++(expected ? counts.visible : counts.hidden);
  }

 private:
  EdgePoint draw() {
    static const mpq_class kPlaces[] = {0, mpq_class(1, 4), mpq_class(1, 3), mpq_class(1, 2), mpq_class(3, 4), 1};
    return {edges_[random_() % edges_.size()], kPlaces[random_() % 6], random_() % 2 == 0};
  }
  RunPoint2 run_point(const EdgePoint& point) {
    const VertexId a = vertices_.insert({point.edge.ax, point.edge.ay});
    const VertexId b = vertices_.insert({point.edge.bx, point.edge.by});
    return point.looks_left ? RunPoint2(arrangement_, {b, a}, 1 - point.t) : RunPoint2(arrangement_, {a, b}, point.t);
  }
  static std::string text(const EdgePoint& point) {
    return fmt::format("({},{})-({},{}) at {} {}", point.edge.ax.get_str(), point.edge.ay.get_str(),
                       point.edge.bx.get_str(), point.edge.by.get_str(), point.t.get_str(),
                       point.looks_left ? "left" : "right");
  }

  const std::vector<InputSegment>& edges_;
  Scene2 scene_;
  Arrangement2 arrangement_;
  SegmentVisibility2 visibility_;
  PointIndex2 vertices_;
  std::mt19937_64 random_;
};

TEST(SegmentVisibility2, AgreesWithMovedSegmentsOnRandomScenes) {
  for (const bool lattice : {true, false}) {
    Counts counts;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const RandomScene scene = random_scene(seed, 4 + static_cast<int>(seed % 29), lattice);
      PairsOfPoints pairs(scene, seed);
      for (int k = 0; k < 400; ++k) {
        pairs.compare(counts);
        if (testing::Test::HasFatalFailure()) FAIL() << "scene " << seed << (lattice ? " on a lattice" : "");
      }
    }
    EXPECT_GT(counts.visible, counts.pairs / 50);
    EXPECT_GT(counts.hidden, counts.pairs / 10);
    fmt::print("{} pairs of points, {} visible\n", counts.pairs, counts.visible);
  }
}

}  // namespace
}  // namespace hottel::oracle::segment_visibility_test

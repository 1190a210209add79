// Point sets on which plain doubles get orientations wrong: Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples
// of robustness problems in geometric computations (2008). scenes/degenerate/kettner_*.json has occluders that end in
// them.
#include <gtest/gtest.h>

#include <array>

#include "tests/neighbouring_doubles/grid.h"

namespace hottel::kettner_points_test {
namespace {

using namespace neighbouring_doubles;

using Triple = std::array<std::size_t, 3>;  // numbers of points, from 1

struct PointSet {
  const char* name;
  std::vector<Double2> points;
  int wrong_triples;                          // with at least one choice of the pivot, in plain doubles
  std::vector<std::pair<Triple, int>> signs;  // some exact orientations
};

const std::vector<PointSet>& point_sets() {
  static const std::vector<PointSet> sets{{"page 13",
                                           {{0.10000000000000001, 0.10000000000000001},
                                            {0.20000000000000001, 0.20000000000000004},
                                            {0.79999999999999993, 0.80000000000000004},
                                            {1.267650600228229e30, 1.2676506002282291e30}},
                                           4,
                                           {{{1, 2, 3}, -1}, {{1, 2, 4}, -1}, {{1, 3, 4}, -1}, {{2, 3, 4}, -1}}},
                                          {"A1",
                                           {{7.3000000000000194, 7.3000000000000167},
                                            {24.000000000000068, 24.000000000000071},
                                            {24.00000000000005, 24.000000000000053},
                                            {0.50000000000001621, 0.50000000000001243}},
                                           2,
                                           {{{1, 2, 4}, 1}, {{1, 3, 4}, 1}}},
                                          {"A2",
                                           {{27.643564356435643, -21.881188118811881},
                                            {83.366336633663366, 15.544554455445542},
                                            {4, 4},
                                            {73.415841584158414, 8.8613861386138595}},
                                           1,
                                           {{{1, 2, 4}, 1}}},
                                          {"B1",
                                           {{200, 49.200000000000003},
                                            {100, 49.600000000000001},
                                            {-233.33333333333334, 50.93333333333333},
                                            {166.66666666666669, 49.333333333333336}},
                                           3,
                                           {}},
                                          {"B2",
                                           {{0.50000000000001243, 0.50000000000000189},
                                            {0.50000000000001243, 0.50000000000000333},
                                            {24.00000000000005, 24.000000000000053},
                                            {24.000000000000068, 24.000000000000071},
                                            {17.300000000000001, 17.300000000000001}},
                                           8,
                                           {}}};
  return sets;
}

TEST(KettnerPoints, OrientationsAreRightWherePlainDoublesAreNot) {
  for (const PointSet& set : point_sets()) {
    std::vector<Point2> points;
    for (const Double2& p : set.points) points.push_back(exact(p));
    const Vertices2 vertices(points, points.size());
    int wrong_triples = 0;
    for (const VertexId k : vertices.ids())
      for (const VertexId j : IdRange<VertexId>(k.index()))
        for (const VertexId i : IdRange<VertexId>(j.index())) {
          const int sign = exact_orientation(points[i.index()], points[j.index()], points[k.index()]);
          const auto naive = [&](VertexId p, VertexId q, VertexId r) {
            return naive_orientation(set.points[p.index()], set.points[q.index()], set.points[r.index()]);
          };
          wrong_triples += naive(i, j, k) != sign || naive(j, k, i) != sign || naive(k, i, j) != sign;
          for (const auto& [p, q, r] : {std::tuple(i, j, k), std::tuple(j, k, i), std::tuple(k, i, j)}) {
            EXPECT_EQ(vertices.orientation(p, q, r), sign) << set.name;
            EXPECT_EQ(vertices.orientation(p, r, q), -sign) << set.name;
          }
        }
    EXPECT_EQ(wrong_triples, set.wrong_triples) << set.name;
    for (const auto& [triple, sign] : set.signs)
      EXPECT_EQ(vertices.orientation(VertexId(triple[0] - 1), VertexId(triple[1] - 1), VertexId(triple[2] - 1)), sign)
          << set.name;
  }
}

}  // namespace
}  // namespace hottel::kettner_points_test

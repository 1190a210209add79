// The elements of polygons: their corners, their order, and that together they are the polygon.
#include "geometry/space/scene/division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel::division_test {
namespace {

using Corners = std::vector<IntegerVector>;

const Corners kSquare{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}};
const Corners kTriangle{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}};
// Sides of four lengths, none parallel to another.
const Corners kQuad{{0, 0, 0}, {7, 1, 0}, {5, 6, 0}, {1, 4, 0}};
// A triangle listed with a point in the middle of its first side.
const Corners kQuadWithAStraightCorner{{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {0, 6, 0}};
// A pentagon listed with its first point in the middle of a side.
const Corners kPentagon{{3, 0, 0}, {6, 0, 0}, {8, 4, 0}, {4, 7, 0}, {-1, 5, 0}, {0, 0, 0}};

Corners in_plane(const Corners& flat) {  // of the plane x + 2 y + 3 z = 0, whichever way
  Corners result;
  for (const IntegerVector& p : flat) result.push_back({2 * p.x + 3 * p.y, -p.x, -p.y});
  return result;
}

IntegerVector doubled_area_of(const Corners& corners) {
  IntegerVector sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const IntegerVector turn = cross(difference(corners[k], corners[0]), difference(corners[k + 1], corners[0]));
    sum = {sum.x + turn.x, sum.y + turn.y, sum.z + turn.z};
  }
  return sum;
}

Polygon3 polygon_of(const Corners& corners) {
  Polygon3 polygon;
  for (const IntegerVector& p : corners) polygon.points.push_back({p.x, p.y, p.z});
  return polygon;
}

// In units of 1 / weight.
std::vector<Corners> elements(const PolygonDivision3& division) {
  std::vector<Corners> result;
  for (std::uint64_t k = 0; k < division.count(); ++k) result.push_back(division.corners(k));
  return result;
}

class EveryDivision : public testing::TestWithParam<std::tuple<Corners, std::uint32_t>> {
 protected:
  Corners polygon() const { return in_plane(std::get<0>(GetParam())); }
  std::uint32_t n() const { return std::get<1>(GetParam()); }
};

TEST_P(EveryDivision, SharesThePolygonOut) {
  const PolygonDivision3 division(polygon(), n());
  EXPECT_EQ(division.count(), element_count(polygon_of(polygon()), n()));
  const IntegerVector whole = doubled_area_of(polygon());
  const Integer weight = division.weight(), unit = weight * weight;
  IntegerVector sum;
  for (const Corners& element : elements(division)) {
    const IntegerVector area = doubled_area_of(element);
    EXPECT_GT(dot(area, whole), 0);  // fronts on one side
    EXPECT_TRUE(is_zero(cross(area, whole)));
    sum = {sum.x + area.x, sum.y + area.y, sum.z + area.z};
  }
  EXPECT_EQ(sum, (IntegerVector{whole.x * unit, whole.y * unit, whole.z * unit}));
}

TEST_P(EveryDivision, HasConvexElementsWithoutStraightCornersWithinThePolygon) {
  const Corners outline = polygon();
  const IntegerVector normal = doubled_area_of(outline);
  const PolygonDivision3 division(outline, n());
  for (const Corners& element : elements(division))
    for (std::size_t k = 0; k < element.size(); ++k) {
      const IntegerVector& at = element[k];
      const IntegerVector& next = element[(k + 1) % element.size()];
      EXPECT_GT(determinant_sign(normal, difference(next, at), difference(element[(k + 2) % element.size()], next)), 0);
      for (std::size_t s = 0; s < outline.size(); ++s) {
        const IntegerVector &a = outline[s], &b = outline[(s + 1) % outline.size()];
        const Integer& w = division.weight();
        const IntegerVector from{w * a.x, w * a.y, w * a.z};
        EXPECT_GE(determinant_sign(normal, difference(b, a), difference(at, from)), 0);
      }
    }
}

TEST_P(EveryDivision, HasElementsThatShareNoArea) {
  // The middle of an element is in no other one: elements are convex, and their areas add up.
  const Corners outline = polygon();
  const IntegerVector normal = doubled_area_of(outline);
  const std::vector<Corners> all = elements(PolygonDivision3(outline, n()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    IntegerVector middle;  // times the number of corners
    for (const IntegerVector& c : all[i]) middle = {middle.x + c.x, middle.y + c.y, middle.z + c.z};
    const Integer m = static_cast<unsigned long>(all[i].size());
    for (std::size_t j = 0; j < all.size(); ++j) {
      bool is_inside = true;
      for (std::size_t k = 0; k < all[j].size(); ++k) {
        const IntegerVector &a = all[j][k], &b = all[j][(k + 1) % all[j].size()];
        const IntegerVector from{m * a.x, m * a.y, m * a.z};
        is_inside = is_inside && determinant_sign(normal, difference(b, a), difference(middle, from)) > 0;
      }
      EXPECT_EQ(is_inside, i == j) << i << " " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryDivision,
                         testing::Combine(testing::Values(kSquare, kTriangle, kQuad, kQuadWithAStraightCorner,
                                                          kPentagon),
                                          testing::Values(1u, 2u, 3u, 5u)));

TEST(PolygonDivision3, RowsOfAQuadRunAlongItsFirstSide) {
  const PolygonDivision3 division(kSquare, 3);
  EXPECT_EQ(division.weight(), 3);  // of a parallelogram; corners are 3 times the points
  EXPECT_EQ(division.corners(0), (Corners{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}));
  EXPECT_EQ(division.corners(1), (Corners{{6, 0, 0}, {12, 0, 0}, {12, 6, 0}, {6, 6, 0}}));
  EXPECT_EQ(division.corners(3), (Corners{{0, 6, 0}, {6, 6, 0}, {6, 12, 0}, {0, 12, 0}}));
  EXPECT_EQ(division.corners(8), (Corners{{12, 12, 0}, {18, 12, 0}, {18, 18, 0}, {12, 18, 0}}));
}

TEST(PolygonDivision3, PartsOfTheSidesOfAQuadAreEqual) {
  const PolygonDivision3 division(kQuad, 2);
  EXPECT_EQ(division.weight(), 4);
  EXPECT_EQ(division.corners(0), (Corners{{0, 0, 0}, {14, 2, 0}, {13, 11, 0}, {2, 8, 0}}));
  EXPECT_EQ(division.corners(3), (Corners{{13, 11, 0}, {24, 14, 0}, {20, 24, 0}, {12, 20, 0}}));
}

TEST(PolygonDivision3, RowsOfATriangleGoUpAndDown) {
  const PolygonDivision3 division(kTriangle, 3);
  const std::vector<Corners> all = elements(division);
  ASSERT_EQ(all.size(), 9u);
  EXPECT_EQ(all[0], (Corners{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}));     // up
  EXPECT_EQ(all[1], (Corners{{6, 0, 0}, {6, 6, 0}, {0, 6, 0}}));     // down
  EXPECT_EQ(all[2], (Corners{{6, 0, 0}, {12, 0, 0}, {6, 6, 0}}));    // up
  EXPECT_EQ(all[4], (Corners{{12, 0, 0}, {18, 0, 0}, {12, 6, 0}}));  // the end of the first row
  EXPECT_EQ(all[5], (Corners{{0, 6, 0}, {6, 6, 0}, {0, 12, 0}}));    // the second
  EXPECT_EQ(all[8], (Corners{{0, 12, 0}, {6, 12, 0}, {0, 18, 0}}));  // the last corner
  for (const Corners& element : all) {
    // All are similar: the same area, and sides parallel to those of the triangle.
    const IntegerVector area = doubled_area_of(element);
    EXPECT_EQ(area, (IntegerVector{0, 0, 36}));
  }
}

TEST(PolygonDivision3, OfMorePointsTheTrianglesOfAFanComeInOrder) {
  const PolygonDivision3 division(kPentagon, 2);
  ASSERT_EQ(division.count(), 12u);  // five corners, three triangles, four elements each
  const PolygonDivision3 first({kPentagon[1], kPentagon[2], kPentagon[3]}, 2);
  const PolygonDivision3 last({kPentagon[1], kPentagon[4], kPentagon[5]}, 2);
  for (std::uint64_t k = 0; k < 4; ++k) {
    EXPECT_EQ(division.corners(k), first.corners(k));
    EXPECT_EQ(division.corners(8 + k), last.corners(k));
  }
}

TEST(PolygonDivision3, ByOneIsThePolygonWithoutStraightCorners) {
  EXPECT_EQ(PolygonDivision3(kQuadWithAStraightCorner, 1).corners(0), (Corners{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}));
  EXPECT_EQ(PolygonDivision3(kPentagon, 1).corners(0).size(), 5u);
  EXPECT_EQ(PolygonDivision3(kPentagon, 1).count(), 1u);
}

TEST(PolygonDivision3, AQuadThatIsATriangleHasOneElementOfThreeCorners) {
  const std::vector<Corners> all = elements(PolygonDivision3(kQuadWithAStraightCorner, 2));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Corners& c) { return c.size() == 3; }), 1);
  EXPECT_EQ(all[1].size(), 3u);  // at its second point
}

TEST(PolygonDivision3, RowsAreFoundInLargeTriangles) {
  const std::uint64_t n = 1'000'000;
  const PolygonDivision3 division(kTriangle, n);
  ASSERT_EQ(division.count(), n * n);
  for (const std::uint64_t j : {std::uint64_t{0}, std::uint64_t{1}, n / 3, n - 2, n - 1}) {
    const std::uint64_t first = 2 * n * j - j * j;
    EXPECT_EQ(division.corners(first)[0], (IntegerVector{0, Integer(6 * j), 0}));
    if (j > 0) {
      EXPECT_EQ(division.corners(first - 1)[1], (IntegerVector{Integer(6 * (n - j + 1)), Integer(6 * (j - 1)), 0}));
    }
  }
}

Scene3 scene_of(const std::vector<Corners>& polygons) {
  Scene3 scene;
  scene.materials.push_back({"m", {}, {}});
  for (const Corners& corners : polygons) {
    const std::string name = "p" + std::to_string(scene.surfaces.size());
    scene.groups.emplace_back(name);
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.surfaces.size());
    scene.add(std::move(surface), polygon_of(corners));
  }
  return scene;
}

TEST(DivideByLength, TakesTheLeastNumberForTheLongestSide) {
  Scene3 scene = scene_of({kSquare, kTriangle, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}});
  EXPECT_FALSE(divide_by_length(scene, 2, 1000));
  EXPECT_EQ(scene.surfaces[0].elements, 3u);  // 6 / 2, exactly
  EXPECT_EQ(scene.surfaces[1].elements, 5u);  // 6 sqrt(2) / 2
  EXPECT_EQ(scene.surfaces[2].elements, 1u);
  EXPECT_FALSE(divide_by_length(scene, Rational(1999) / 1000, 1000));
  EXPECT_EQ(scene.surfaces[0].elements, 4u);
  EXPECT_EQ(divide_by_length(scene, Rational(1) / 100, 700), std::optional<std::uint32_t>(1));
  EXPECT_EQ(scene.surfaces[0].elements, 600u);
  EXPECT_EQ(scene.surfaces[1].elements, 5u);
  EXPECT_THROW(divide_by_length(scene, 0, 1), ContractViolation);
}

TEST(DivideByLength, JoinsSidesWithAPointInTheMiddleOfPolygonsOfMoreThanFour) {
  Scene3 scene = scene_of({{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}});
  EXPECT_FALSE(divide_by_length(scene, 2, 1000));
  EXPECT_EQ(scene.surfaces[0].elements, 2u);
}

TEST(DivideInto, SetsAllSurfaces) {
  Scene3 scene = scene_of({kSquare, kTriangle});
  divide_into(scene, 7);
  EXPECT_EQ(scene.surfaces[1].elements, 7u);
  EXPECT_THROW(divide_into(scene, 0), ContractViolation);
}

// (6)
TEST_P(EveryDivision, NodesOfOneDepthAreTheElementsByAsManyTimesTwo) {
  for (const int depth : {1, 2, 3}) {
    const std::uint32_t many = n() << depth;
    const PolygonDivision3 roots(polygon(), n(), HasTrees3::kYes), equal(polygon(), many);
    const Integer tree_weight = roots.weight(depth), weight = equal.weight();
    const auto canonical = [](Corners corners, const Integer& scale) {  // where it begins plays no part
      for (IntegerVector& p : corners) p = {p.x * scale, p.y * scale, p.z * scale};
      const auto less = [](const IntegerVector& a, const IntegerVector& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
      };
      std::rotate(corners.begin(), std::ranges::min_element(corners, less), corners.end());
      return corners;
    };
    std::vector<Corners> nodes, parts;
    for (const TreeNode& node : uniform_leaves(static_cast<std::uint32_t>(roots.count()), 4, depth))
      nodes.push_back(canonical(roots.corners(node.part, node.path), weight));
    for (const Corners& part : elements(equal)) parts.push_back(canonical(part, tree_weight));
    const auto is_less = [](const Corners& a, const Corners& b) {
      return std::ranges::lexicographical_compare(a, b, [](const IntegerVector& p, const IntegerVector& q) {
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
      });
    };
    std::ranges::sort(nodes, is_less);
    std::ranges::sort(parts, is_less);
    EXPECT_EQ(nodes.size(), parts.size());
    EXPECT_TRUE(nodes == parts) << "depth " << depth;
  }
}

// (6)
TEST(PolygonDivision3, ChildrenHaveTheCornersOfTheirParentByTheirDigits) {
  const PolygonDivision3 quad(kQuad, 1, HasTrees3::kYes), triangle(kTriangle, 1, HasTrees3::kYes);
  for (int digit = 0; digit < 4; ++digit) {
    const Corners child = quad.corners(0, TreePath().child(digit));
    const IntegerVector& corner = kQuad[static_cast<std::size_t>(digit)];
    const Integer w = quad.weight(1);
    EXPECT_EQ(child[static_cast<std::size_t>(digit)], (IntegerVector{w * corner.x, w * corner.y, w * corner.z}));
  }
  for (int digit = 0; digit < 3; ++digit) {
    const Corners child = triangle.corners(0, TreePath().child(digit));
    const IntegerVector& corner = kTriangle[static_cast<std::size_t>(digit)];
    EXPECT_EQ(child[static_cast<std::size_t>(digit)], (IntegerVector{2 * corner.x, 2 * corner.y, 2 * corner.z}));
  }
  EXPECT_EQ(triangle.corners(0, TreePath().child(3)), (Corners{{6, 6, 0}, {0, 6, 0}, {6, 0, 0}}));
}

}  // namespace
}  // namespace hottel::division_test

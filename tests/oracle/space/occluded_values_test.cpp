// Pairs whose factors are known: tables of rectangles with something between, contacts by name, and the 140 pairs of
// occluded.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/comparison/space/pair_scene.h"
#include "tests/oracle/space/pair_quadrature.h"
#include "tests/oracle/space/random_polygons.h"
#include "tests/oracle/space/space_scenes.h"

namespace hottel::oracle::occluded_values_test {
namespace {

constexpr double kTolerance = 1e-12;
// Aligned unit squares at distance 1, and perpendicular ones with a common side (Howell C-11, C-14).
constexpr double kParallel = 0.1998248956983873830416, kPerpendicular = 0.2000437760754031542396;

PairRequest3 request() {
  PairRequest3 result;
  result.tolerance = kTolerance;
  return result;
}

SpacePolygon floor_square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}; }
SpacePolygon ceiling_square() { return {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}; }
SpacePolygon wall_square() { return {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}; }

std::vector<SpaceCase> cases_of_the_file() {
  return read_space_cases(std::string(HOTTEL_SOURCE_DIR) + "/tests/oracle/space/occluded.json");
}

// F from polygon 0 to polygon 1: forward, from j to i, along edges even where the pair is clear, and with another
// origin.
void expect_factor(const std::vector<SpacePolygon>& polygons, double factor, const std::string& name) {
  const PairScene3 scene(polygons);
  const Patch3 i = scene.patch(0), j = scene.patch(1);
  const double area = scene.area(i);
  const auto expect = [&](const PairRequest3& how, const char* what) {
    const PairResult3 m = scene.measure(i, j, how);
    EXPECT_EQ(m.problem, "") << name << ", " << what;
    EXPECT_NEAR(m.measure / area, factor, kTolerance) << name << ", " << what;
    EXPECT_LE(m.bounds.lower, factor * area * (1 + 1e-15)) << name << ", " << what;
    EXPECT_GE(m.bounds.upper, factor * area * (1 - 1e-15)) << name << ", " << what;
  };
  PairRequest3 reversed = request(), along_edges = request(), shifted = request();
  reversed.is_reversed = true;
  along_edges.always_along_edges = true;
  shifted.origin_shift[0] = 0.75;
  shifted.origin_shift[1] = -2;
  shifted.origin_shift[2] = 1.25;
  expect(request(), "forward");
  expect(reversed, "from j to i");
  expect(along_edges, "along edges");
  expect(shifted, "origin moved");
}

TEST(OccludedValues, AreThoseOfTheFile) {
  const std::vector<SpaceCase> cases = cases_of_the_file();
  ASSERT_EQ(cases.size(), 140u);
  for (const auto& [name, polygons, value] : cases) expect_factor(polygons, value, name);
}

// What is proven of a pair holds the value, of which the file has all digits that doubles have, and is as narrow as
// asked.
void expect_enclosed(const std::vector<SpacePolygon>& polygons, double factor, const std::string& name) {
  const PairScene3 scene(polygons);
  const Patch3 i = scene.patch(0), j = scene.patch(1);
  const double area = scene.area(i), value = factor * area, ulps = 4e-16 * area;
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    PairRequest3 how;
    how.tolerance = tolerance;
    how.proves = true;
    const PairResult3 m = scene.measure(i, j, how);
    EXPECT_LE(m.bounds.lower, value + ulps) << name;
    EXPECT_GE(m.bounds.upper, value - ulps) << name;
    EXPECT_LE(m.bounds.width(), tolerance * std::min(area, scene.area(j))) << name;
    EXPECT_TRUE(m.bounds.contains(m.measure)) << name;
  }
}

TEST(OccludedValues, AreEnclosed) {
  for (const auto& [name, polygons, value] : cases_of_the_file()) expect_enclosed(polygons, value, name);
  const mpq_class h(1, 2);
  expect_enclosed({floor_square(), ceiling_square(), {{0, 0, h}, {h, 0, h}, {h, h, h}, {0, h, h}}}, kParallel * 3 / 4,
                  "obstructed_squares_corner");
}

TEST(OccludedValues, SquaresWithAQuarterSquareHalfWay) {
  expect_factor({floor_square(),
                 ceiling_square(),
                 {{0, 0, mpq_class(1) / 2},
                  {mpq_class(1) / 2, 0, mpq_class(1) / 2},
                  {mpq_class(1) / 2, mpq_class(1) / 2, mpq_class(1) / 2},
                  {0, mpq_class(1) / 2, mpq_class(1) / 2}}},
                kParallel * 3 / 4, "obstructed_squares_corner");
}

// Each of the four quarters of a screen half-way hides as much.
TEST(OccludedValues, QuartersOfAScreenHideEqualParts) {
  std::vector<SpacePolygon> polygons{floor_square(), ceiling_square()};
  const mpq_class h(1, 2);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 1), std::pair(1, 0), std::pair(0, 1)}) {
    const mpq_class u = x * h, v = y * h;
    polygons.push_back({{u, v, h}, {u + h, v, h}, {u + h, v + h, h}, {u, v + h, h}});
    expect_factor(polygons, kParallel * static_cast<double>(6 - polygons.size()) / 4, "quarters");
  }
  const PairScene3 scene(polygons);
  EXPECT_EQ(scene.measure(scene.patch(0), scene.patch(1)).measure, 0);
}

// What edges.md 1.3 lists beyond those: held against quadrature.
struct Contact {
  const char* name;
  std::vector<SpacePolygon> polygons;
};

void PrintTo(const Contact& contact, std::ostream* out) { *out << contact.name; }

std::vector<SpacePolygon> with_box(std::vector<SpacePolygon> polygons, const SpacePoint& low, const SpacePoint& high) {
  for (SpacePolygon& face : box(low, high))
    if (low.z != 0 || std::any_of(face.begin(), face.end(), [](const SpacePoint& p) { return p.z != 0; }))
      polygons.push_back(std::move(face));
  return polygons;
}

const SpacePolygon kFloor{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const SpacePolygon kCeiling{{0, 0, 4}, {0, 4, 4}, {4, 4, 4}, {4, 0, 4}};
const SpacePolygon kWall{{0, 0, 0}, {0, 4, 0}, {0, 4, 4}, {0, 0, 4}};

// Everything of the degeneracy rules, one scene each, the pair first.
std::vector<Contact> contacts() {
  return {
      {"one_square_between", {kFloor, kCeiling, {{1, 1, 2}, {3, 1, 2}, {3, 3, 2}, {1, 3, 2}}}},
      {"a_box_floats", with_box({kFloor, kCeiling}, {1, 1, 1}, {2, 3, 3})},
      {"a_box_stands_without_bottom", with_box({kFloor, kCeiling}, {1, 1, 0}, {2, 3, 2})},
      {"boxes_stacked", with_box(with_box({kFloor, kCeiling}, {1, 1, 0}, {3, 3, 1}), {1, 1, 1}, {2, 3, 2})},
      {"a_wall_stands", {kFloor, kCeiling, {{2, 1, 0}, {2, 3, 0}, {2, 3, 3}, {2, 1, 3}}}},
      {"a_wall_leans_on_a_side_of_i", {kFloor, kCeiling, {{0, 0, 0}, {0, 4, 0}, {2, 4, 3}, {2, 0, 3}}}},
      {"a_triangle_pierces_i", {kFloor, kCeiling, {{1, 1, -1}, {3, 2, 3}, {2, 3, 2}}}},
      {"a_triangle_pierces_j", {kFloor, kCeiling, {{1, 1, 5}, {3, 2, 1}, {2, 3, 2}}}},
      {"a_triangle_pierces_both", {kFloor, kCeiling, {{1, 1, -1}, {3, 2, 5}, {2, 3, 2}}}},
      {"two_skew_triangles", {kFloor, kCeiling, {{0, 1, 1}, {4, 2, 2}, {1, 4, 1}}, {{0, 3, 3}, {4, 0, 3}, {4, 4, 2}}}},
      {"triangles_pierce_each_other",
       {kFloor, kCeiling, {{0, 1, 1}, {4, 2, 3}, {1, 4, 1}}, {{0, 3, 3}, {4, 0, 1}, {3, 4, 2}}}},
      {"two_faces_share_an_edge",
       {kFloor, kCeiling, {{1, 1, 1}, {3, 1, 1}, {2, 3, 3}}, {{3, 1, 1}, {1, 1, 1}, {2, 0, 3}}}},
      {"coplanar_neighbours",
       {kFloor, kCeiling, {{1, 1, 2}, {3, 1, 2}, {2, 3, 3}}, {{3, 1, 2}, {1, 1, 2}, {2, -1, 1}}}},
      {"edges_in_line_overlap",
       {kFloor, kCeiling, {{0, 1, 2}, {2, 1, 2}, {1, 3, 2}}, {{1, 1, 2}, {3, 1, 2}, {2, 0, 3}}}},
      {"a_t_junction",
       {kFloor,
        kCeiling,
        {{0, 2, 2}, {4, 2, 2}, {2, 4, 2}},
        {{0, 2, 2}, {2, 2, 2}, {1, 0, 2}},
        {{2, 2, 2}, {4, 2, 2}, {3, 0, 2}}}},
      {"a_foot_crosses_a_straddling_face",
       {kFloor, kCeiling, {{1, 2, 0}, {3, 2, 0}, {2, 2, 3}}, {{2, 1, -1}, {2, 3, -1}, {2, 2, 3}}}},
      {"a_foot_lies_in_a_straddling_face",
       {kFloor, kCeiling, {{1, 2, 0}, {3, 2, 0}, {2, 3, 3}}, {{0, 2, -1}, {4, 2, -1}, {2, 2, 2}}}},
      {"an_edge_runs_through_a_face",
       {kFloor, kCeiling, {{1, 1, 2}, {3, 1, 2}, {3, 3, 2}, {1, 3, 2}}, {{1, 2, 2}, {3, 2, 2}, {2, 2, 3}}}},
      {"a_side_of_i_runs_through_a_face", {kFloor, kCeiling, {{0, 1, -1}, {0, 3, -1}, {0, 2, 3}}}},
      {"a_face_stands_on_the_outline_of_i", {kFloor, kCeiling, {{0, 1, 0}, {0, 3, 0}, {1, 2, 3}}}},
      {"a_corner_touches_i", {kFloor, kCeiling, {{2, 2, 0}, {3, 1, 2}, {1, 3, 3}}}},
      {"corners_touch", {kFloor, kCeiling, {{2, 2, 2}, {3, 0, 1}, {4, 3, 2}}, {{2, 2, 2}, {0, 1, 3}, {1, 3, 2}}}},
      {"a_double_sheet", {kFloor, kWall, {{1, 1, 1}, {3, 1, 0}, {1, 3, 2}}}},
      {"i_and_j_touch_and_a_wall_stands_in_the_corner", {kFloor, kWall, {{0, 2, 0}, {2, 2, 0}, {0, 2, 3}}}},
      {"a_face_lies_along_the_common_side", {kFloor, kWall, {{0, 1, 0}, {0, 3, 0}, {2, 2, 2}}}},
      {"a_face_pierces_the_common_side", {kFloor, kWall, {{-1, 1, 1}, {1, 2, -1}, {2, 3, 2}}}},
      {"j_stands_on_i", {kFloor, {{1, 0, 0}, {1, 4, 0}, {1, 4, 3}, {1, 0, 3}}, {{2, 1, 0}, {2, 3, 1}, {3, 2, 2}}}},
      {"j_pierces_i", {kFloor, {{1, 0, -1}, {1, 4, -1}, {1, 4, 3}, {1, 0, 3}}, {{1, 1, 0}, {2, 3, 1}, {3, 2, 2}}}},
      {"j_pierces_i_in_part", {kFloor, {{1, 1, -1}, {1, 3, -1}, {2, 2, 3}}, {{2, 1, 0}, {3, 3, 0}, {2, 2, 2}}}},
      {"i_and_j_touch_in_a_corner", {kFloor, {{0, 0, 0}, {-2, 4, 3}, {0, 0, 4}}, {{1, 0, 1}, {0, 2, 1}, {1, 1, 2}}}},
      {"i_crosses_the_plane_of_j",
       {kFloor, {{2, 1, 1}, {2, 3, 1}, {2, 3, 4}, {2, 1, 4}}, {{3, 1, 0}, {3, 3, 2}, {4, 2, 1}}}},
  };
}

class Contacts : public testing::TestWithParam<Contact> {};

TEST_P(Contacts, HaveTheMeasureOfQuadrature) {
  constexpr double kAsked = 2e-8;
  const std::vector<SpacePolygon>& polygons = GetParam().polygons;
  const FlatPair pair = first_pair(polygons);
  const QuadratureResult there = exchange_by_quadrature(pair, kAsked, 400'000);
  const QuadratureResult back = exchange_by_quadrature(pair.reversed(), kAsked, 400'000);
  const QuadratureResult& better = there.error < back.error ? there : back;
  const PairScene3 scene(polygons);
  const Patch3 i = scene.patch(0), j = scene.patch(1);
  const PairResult3 m = scene.measure(i, j, request());
  const double slack = 10 * better.error + 1e-9;
  EXPECT_NEAR(m.measure, better.measure, slack);
  EXPECT_NEAR(there.measure, back.measure, 10 * (there.error + back.error) + 1e-9);
  EXPECT_LT(slack, 1e-4 * std::min(area(pair.i), area(pair.j)));
  EXPECT_GT(m.measure, 0);
  expect_factor(polygons, m.measure / scene.area(i), GetParam().name);
}

// Polygons listed the other way round, and their backs taken.
TEST_P(Contacts, AreTheSameForBacks) {
  std::vector<SpacePolygon> reversed = GetParam().polygons;
  for (SpacePolygon& polygon : reversed) std::reverse(polygon.begin(), polygon.end());
  const PairScene3 scene(GetParam().polygons), turned(reversed);
  const PairResult3 front = scene.measure(scene.patch(0), scene.patch(1), request());
  const PairResult3 back = turned.measure(turned.patch(0, true), turned.patch(1, true), request());
  EXPECT_EQ(back.problem, "");
  EXPECT_NEAR(back.measure, front.measure, 2 * kTolerance * scene.area(scene.patch(0)));
}

INSTANTIATE_TEST_SUITE_P(ByName, Contacts, testing::ValuesIn(contacts()),
                         [](const auto& contact) { return std::string(contact.param.name); });

// A third way of saying how much is left: a box that stands takes its floor away; what is under it sees nothing
// outside.
TEST(OccludedValues, AFloorUnderABoxSeesNothingOutside) {
  std::vector<SpacePolygon> polygons = with_box({kFloor, kCeiling}, {0, 0, 0}, {4, 4, 2});
  const PairScene3 scene(polygons);
  EXPECT_EQ(scene.measure(scene.patch(0), scene.patch(1)).measure, 0);
}

// Sheets in the plane of a pair or behind it, or that only touch the lines between, hide nothing: it is said so.
TEST(OccludedValues, WhatOnlyTouchesHidesNothing) {
  const std::vector<SpacePolygon> sheets{
      {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}},                // in the plane of the floor, outside
      {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}},               // below, at a side
      {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}},     // a side of the room between
      {{1, 1, 0}, {1, 1, 1}, {2, 2, 1}, {2, 2, 0}},     // touches it along an edge
      {{1, 1, mpq_class(1) / 2}, {2, 1, 0}, {2, 2, 1}}  // in a point
  };
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    const std::vector<SpacePolygon> polygons{floor_square(), ceiling_square(), sheets[k]};
    const PairScene3 scene(polygons);
    PairRequest3 along_edges = request();
    along_edges.always_along_edges = true;
    EXPECT_TRUE(scene.measure(scene.patch(0), scene.patch(1)).is_whole) << k;
    EXPECT_TRUE(scene.measure(scene.patch(0), scene.patch(1), along_edges).is_whole) << k;
    expect_factor(polygons, kParallel, "touching sheet " + std::to_string(k));
  }
  expect_factor({floor_square(), wall_square(), {{0, 0, 0}, {0, 1, 0}, {-1, 0, 1}}}, kPerpendicular, "behind both");
}

// What lies right on a face, or fills a room from wall to wall, hides all of it: 0 exactly.
TEST(OccludedValues, WhatCoversHidesAll) {
  const std::vector<SpacePolygon> screen{{{-1, -1, 2}, {5, -1, 2}, {5, 5, 2}, {-1, 5, 2}}};
  const std::vector<SpacePolygon> halves{{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}}, {{0, 0, 2}, {4, 4, 2}, {0, 4, 2}}};
  const std::vector<SpacePolygon> tent{{{0, 0, 0}, {4, 0, 0}, {2, 2, 3}},
                                       {{4, 0, 0}, {4, 4, 0}, {2, 2, 3}},
                                       {{4, 4, 0}, {0, 4, 0}, {2, 2, 3}},
                                       {{0, 4, 0}, {0, 0, 0}, {2, 2, 3}}};
  for (const std::vector<SpacePolygon>& cover : {screen, halves, tent}) {
    std::vector<SpacePolygon> polygons{kFloor, kCeiling};
    polygons.insert(polygons.end(), cover.begin(), cover.end());
    const PairScene3 scene(polygons);
    for (const bool is_reversed : {false, true}) {
      PairRequest3 how = request();
      how.is_reversed = is_reversed;
      const PairResult3 m = scene.measure(scene.patch(0), scene.patch(1), how);
      EXPECT_EQ(m.measure, 0);
      EXPECT_EQ(m.bounds.upper, 0);
      EXPECT_FALSE(m.is_whole);
      EXPECT_EQ(m.problem, "");
    }
  }
}

// A cube in a larger one: what the walls see of it is its area over theirs.
TEST(OccludedValues, ACubeInACubeTakesItsShare) {
  for (const SpacePoint& at : {SpacePoint{1, 1, 1}, SpacePoint{mpq_class(1) / 2, 1, mpq_class(3) / 2}}) {
    std::vector<SpacePolygon> polygons = room_of_walls({0, 0, 0}, {4, 4, 4}, 1);
    for (SpacePolygon& face : box(at, {at.x + 2, at.y + 2, at.z + 2})) polygons.push_back(std::move(face));
    const PairScene3 scene(polygons);
    double inner = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < 12; ++j) {
        if (j == i) continue;
        const PairResult3 m = scene.measure(scene.patch(i), scene.patch(j), request());
        EXPECT_EQ(m.problem, "");
        row += m.measure;
        if (j >= 6) inner += m.measure;
      }
      EXPECT_NEAR(row, 16, 16e-12);
    }
    EXPECT_NEAR(inner / 96, 0.25, kTolerance);
  }
}

}  // namespace
}  // namespace hottel::oracle::occluded_values_test

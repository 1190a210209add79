// Contacts in space: every screen between a pair of squares and every two of them at once, boxes beside, on and in each
// other and the floor, polygons that coincide, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/refusal.h"

namespace hottel::contact_table_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Coordinates as text, so that fractions stay what they are.
std::string polygon(const std::string& name, const std::string& points, const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "points": )" + points + R"(, "material": "m")" + more + "}";
}
Scene3 scene_of(const std::vector<std::string>& polygons) {
  std::string list;
  for (const std::string& p : polygons) list += (list.empty() ? "" : ",\n") + p;
  return parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}, "n": {"reflectivity": 0.25}},
          "polygons": [)" +
          list + "]}",
      "scene.json");
}

double row_sum(const ExchangeMatrix& matrix, std::uint32_t i) {
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
  return sum;
}
void expect_closed_rows(const ExchangeMatrix& matrix) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) {
      EXPECT_NEAR(row_sum(matrix, i), 1, 1e-9) << matrix.name(i);
    }
}
double area_of(const ExchangeMatrix& matrix, const std::string& face) {
  return matrix.elements()[matrix.find(face).value()].area.value;
}

// ---- Screens between two squares ------------------------------------------------------------------------------------
//
// Unit squares face each other at distance 1. A line between them meets the plane in the middle once, and each quarter
// of the unit square there is met by as much: so what is left is told by the quarters that are covered.
//
//      z = 1   ┌─────────┐ ceiling
//              │         │              2 │ 3
//      1/2     │─ ─ ─ ─ ─│  screens     ──┼──      quarters, seen from above
//              │         │              0 │ 1
//      z = 0   └─────────┘ floor
constexpr double kOpposite = 0.1998248956983873830415993;

struct Screen {
  const char* contact;
  const char* points;
  unsigned quarters;  // one bit each
};
constexpr Screen kScreens[] = {
    {"none", "[[2,0,0.5],[3,0,0.5],[3,1,0.5],[2,1,0.5]]", 0},
    {"a vertex touches a side", "[[1,0.5,0.5],[2,0,0.5],[2,1,0.5]]", 0},
    {"a vertex touches an edge of the pair", "[[1,1,0.5],[2,1,0.5],[2,2,0.5]]", 0},
    {"an edge touches a side", "[[1,0,0.5],[2,0,0.5],[2,1,0.5],[1,1,0.5]]", 0},
    {"an edge lies along an edge of the pair", "[[1,1,0],[2,2,0],[2,2,1],[1,1,1]]", 0},
    {"a face lies along a side", "[[1,0.25,0.25],[1,0.75,0.25],[1,0.75,0.75],[1,0.25,0.75]]", 0},
    {"a face continues the floor", "[[1,0,0],[2,0,0],[2,1,0],[1,1,0]]", 0},
    {"crosses a side", "[[0.5,0,0.5],[2,0,0.5],[2,1,0.5],[0.5,1,0.5]]", 0b1010},
    {"crosses an edge of the pair", "[[0.5,0.5,0.5],[0.5,2,0.5],[2,2,0.5],[2,0.5,0.5]]", 0b1000},
    {"half covers", "[[0,0,0.5],[0.5,0,0.5],[0.5,1,0.5],[0,1,0.5]]", 0b0101},
    {"covers a quarter", "[[0,0,0.5],[0,0.5,0.5],[0.5,0.5,0.5],[0.5,0,0.5]]", 0b0001},
    {"covers three quarters", "[[0,0,0.5],[1,0,0.5],[1,0.5,0.5],[0.5,0.5,0.5],[0.5,1,0.5],[0,1,0.5]]", 0b0111},
    {"covers", "[[0,0,0.5],[1,0,0.5],[1,1,0.5],[0,1,0.5]]", 0b1111},
    {"covers more", "[[-1,-1,0.5],[-1,2,0.5],[2,2,0.5],[2,-1,0.5]]", 0b1111},
};

double floor_to_ceiling(const std::vector<std::string>& between) {
  std::vector<std::string> polygons{polygon("floor", "[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]"),
                                    polygon("ceiling", "[[0,0,1],[0,1,1],[1,1,1],[1,0,1]]")};
  polygons.insert(polygons.end(), between.begin(), between.end());
  const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(polygons)));
  expect_closed_rows(matrix);
  return matrix.factor("floor", "ceiling").value;
}

TEST(ContactTable3, EveryScreenHidesItsQuarters) {
  for (const Screen& screen : kScreens) {
    const double factor = floor_to_ceiling({polygon("screen", screen.points)});
    EXPECT_NEAR(factor, kOpposite * (4 - std::popcount(screen.quarters)) / 4, 1e-12) << screen.contact;
    EXPECT_EQ(factor == 0, screen.quarters == 0b1111) << screen.contact;
  }
}

// Most of them overlap in the plane that they have in common: the first listed has what both have.
TEST(ContactTable3, EveryTwoScreensHideTheQuartersOfBoth) {
  for (const Screen& first : kScreens)
    for (const Screen& second : kScreens) {
      const double factor = floor_to_ceiling({polygon("first", first.points), polygon("second", second.points)});
      const unsigned quarters = first.quarters | second.quarters;
      EXPECT_NEAR(factor, kOpposite * (4 - std::popcount(quarters)) / 4, 1e-12)
          << first.contact << ", " << second.contact;
      EXPECT_EQ(factor == 0, quarters == 0b1111) << first.contact << ", " << second.contact;
    }
}

// Parallel rectangles a by b, straight opposite each other at distance 1 (Howell C-11).
double aligned(double a, double b) {
  const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return 2 / (std::acos(-1.0) * a * b) *
         (std::log(p * q / std::sqrt(1 + a * a + b * b)) + a * q * std::atan(a / q) + b * p * std::atan(b / p) -
          a * std::atan(a) - b * std::atan(b));
}

TEST(ContactTable3, PartitionsThatPierceEachOtherLeaveFourCells) {
  const std::string along = polygon("along", "[[0.5,0,0],[0.5,1,0],[0.5,1,1],[0.5,0,1]]");
  const std::string across = polygon("across", "[[0,0.5,0],[1,0.5,0],[1,0.5,1],[0,0.5,1]]");
  EXPECT_NEAR(aligned(1, 1), kOpposite, 1e-15);
  EXPECT_NEAR(floor_to_ceiling({along}), aligned(0.5, 1), 1e-12);
  EXPECT_NEAR(floor_to_ceiling({along, across}), aligned(0.5, 0.5), 1e-12);
}

// ---- Polygons that coincide -----------------------------------------------------------------------------------------

TEST(ContactTable3, ACopyOwnsNothing) {
  const std::string points = "[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]";
  const PreparedScene3 twice = prepare(scene_of({polygon("one", points), polygon("two", points)}));
  EXPECT_EQ(twice.arrangement().pieces().size(), 1u);
  EXPECT_EQ(twice.arrangement().owner(0, false), (Face{0, false}));
  EXPECT_EQ(twice.arrangement().owner(0, true), (Face{0, true}));
  EXPECT_EQ(twice.arrangement().pieces_on(1).size(), 1u) << "it lies there all the same";
  const ExchangeMatrix matrix = exact_exchange(twice);
  EXPECT_FALSE(matrix.has_row(*matrix.find("two")));
  EXPECT_EQ(area_of(matrix, "two"), 0);
}

TEST(ContactTable3, APolygonThereAndBackHasTwoFronts) {
  const PreparedScene3 thin = prepare(scene_of({polygon("there", "[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]"),
                                                polygon("back again", "[[0,0,0],[0,1,0],[1,1,0],[1,0,0]]")}));
  ASSERT_EQ(thin.arrangement().pieces().size(), 1u);
  EXPECT_EQ(thin.arrangement().owner(0, false), (Face{0, false}));
  EXPECT_EQ(thin.arrangement().owner(0, true), (Face{1, false}));
  const ExchangeMatrix matrix = exact_exchange(thin);
  EXPECT_EQ(matrix.factor("there", "sky").value, 1);
  EXPECT_EQ(matrix.factor("back again", "sky").value, 1);
}

// Two squares of one plane: apart, with a corner, an edge or a part of an edge in common, overlapping, one in the
// other.
TEST(ContactTable3, SquaresOfOnePlaneKeepWhatTheFirstDoesNotHave) {
  struct Case {
    const char* second;
    std::size_t pieces;
    double left;
  };
  constexpr Case kCases[] = {{"[[5,0,0],[7,0,0],[7,2,0],[5,2,0]]", 2, 4}, {"[[2,2,0],[4,2,0],[4,4,0],[2,4,0]]", 2, 4},
                             {"[[2,0,0],[4,0,0],[4,2,0],[2,2,0]]", 2, 4}, {"[[2,1,0],[4,1,0],[4,3,0],[2,3,0]]", 2, 4},
                             {"[[1,0,0],[3,0,0],[3,2,0],[1,2,0]]", 2, 2}, {"[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]", 1, 0},
                             {"[[0,0,0],[0,2,0],[2,2,0],[2,0,0]]", 1, 4}};
  for (const Case& c : kCases) {
    const PreparedScene3 scene =
        prepare(scene_of({polygon("first", "[[0,0,0],[2,0,0],[2,2,0],[0,2,0]]"), polygon("second", c.second)}));
    EXPECT_EQ(scene.arrangement().pieces().size(), c.pieces) << c.second;
    const ExchangeMatrix matrix = exact_exchange(scene);
    EXPECT_EQ(area_of(matrix, "first"), 4) << c.second;
    EXPECT_EQ(area_of(matrix, "second"), c.left) << c.second;
    EXPECT_EQ(matrix.factor("first", "second").value, 0) << c.second;
    expect_closed_rows(matrix);
  }
}

TEST(ContactTable3, DifferentMaterialsOnOneSideAreRefused) {
  const auto prepare_with = [](const std::string& second) {
    return refusal_by([&] { prepare(scene_of({polygon("first", "[[0,0,0],[2,0,0],[2,2,0],[0,2,0]]"), second})); });
  };
  const auto other = [](const std::string& points) {
    return R"({"name": "second", "points": )" + points + R"(, "material": "n"})";
  };
  EXPECT_THAT(prepare_with(other("[[1,1,0],[3,1,0],[3,3,0],[1,3,0]]")),
              AllOf(HasSubstr("'first' (front)"), HasSubstr("'second' (front)")));
  EXPECT_EQ(prepare_with(other("[[1,1,0],[1,3,0],[3,3,0],[3,1,0]]")), "") << "their fronts are on different sides";
  EXPECT_EQ(prepare_with(other("[[2,1,0],[4,1,0],[4,3,0],[2,3,0]]")), "") << "they have an edge in common, no area";
}

TEST(ContactTable3, WhatIsNoPolygonIsRefusedByName) {
  const auto read = [](const std::string& points, const std::string& more = "") {
    return refusal_by([&] { validate(scene_of({polygon("bad", points, more)})); });
  };
  EXPECT_EQ(read("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]"), "");
  for (const std::string points : {"[[0,0,0],[1,0,0]]",                    // two points
                                   "[[0,0,0],[1,0,0],[2,0,0]]",            // on one line
                                   "[[0,0,0],[1,0,0],[1,0,0],[0,1,0]]",    // a point twice
                                   "[[0,0,0],[1,0,0],[1,1,0.5],[0,1,0]]",  // not plane
                                   "[[0,0,0],[1,1,0],[1,0,0],[0,1,0]]",    // crosses itself
                                   "[[0,0,0],[2,0,0],[1,0,0],[1,1,0]]"})   // goes back
    EXPECT_THAT(read(points), HasSubstr("'bad'")) << points;
  const std::string square = "[[0,0,0],[4,0,0],[4,4,0],[0,4,0]]";
  EXPECT_EQ(read(square, R"(, "holes": [[[1,1,0],[2,1,0],[2,2,0]]])"), "");
  EXPECT_EQ(read(square, R"(, "holes": [[[0,0,0],[2,1,0],[2,2,0]]])"), "") << "it may touch the outline";
  for (const std::string holes : {"[[[1,1,1],[2,1,1],[2,2,1]]]",                            // off the plane
                                  "[[[3,3,0],[5,3,0],[5,5,0]]]",                            // sticks out
                                  "[[[1,1,0],[3,1,0],[3,3,0]],[[1,1,0],[3,1,0],[3,3,0]]]",  // two that overlap
                                  "[[[1,1,0],[2,1,0]]]"})
    EXPECT_THAT(read(square, R"(, "holes": )" + holes), HasSubstr("'bad'")) << holes;
}

// ---- Two boxes and a floor ------------------------------------------------------------------------------------------

// Coordinates are halves: cells of side 1/2 are free, or solid.
struct Box {
  std::string name;
  std::array<int, 3> low, high;  // in halves

  bool holds(const std::array<int, 3>& cell) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (cell[a] < low[a] || cell[a] >= high[a]) return false;
    return true;
  }
};

struct Side {
  std::string name, points;
  std::size_t axis;
  bool is_high;
  int level;
};

std::string halves(const std::array<int, 3>& p) {
  std::string text;
  for (const int value : p) text += (text.empty() ? "[\"" : ",\"") + std::to_string(value) + "/2\"";
  return text + "]";
}

// The rectangle of a plane, its front to the upper or the lower side.
std::string rectangle(std::size_t axis, int level, std::array<int, 3> low, std::array<int, 3> high, bool is_up) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  low[axis] = high[axis] = level;
  std::array<int, 3> second = low, fourth = low;
  second[u] = high[u];
  fourth[v] = high[v];
  if (!is_up) std::swap(second, fourth);
  return "[" + halves(low) + "," + halves(second) + "," + halves(high) + "," + halves(fourth) + "]";
}

std::vector<Side> sides_of(const Box& box, bool is_outward = true) {
  std::vector<Side> sides;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool is_high : {false, true}) {
      const int level = is_high ? box.high[axis] : box.low[axis];
      sides.push_back({box.name + " " + "xyz"[axis] + (is_high ? "1" : "0"),
                       rectangle(axis, level, box.low, box.high, is_high == is_outward), axis, is_high, level});
    }
  return sides;
}

std::vector<std::string> polygons_of(const Box& box, const std::string& group, bool is_outward = true) {
  std::vector<std::string> polygons;
  for (const Side& side : sides_of(box, is_outward))
    polygons.push_back(polygon(side.name, side.points, group.empty() ? "" : R"(, "group": ")" + group + "\""));
  return polygons;
}

constexpr int kFrom = -2, kTo = 8;  // of the floor, in halves
std::string uncut_floor() { return polygon("floor", rectangle(2, 0, {kFrom, kFrom, 0}, {kTo, kTo, 0}, true)); }

// The squares of side 1/2 that faces have, by the name of the face: what is not covered, each square the first
// listed's.
std::map<std::string, std::vector<std::string>> squares_of(const std::vector<Box>& boxes) {
  const auto is_solid = [&](const std::array<int, 3>& cell) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.holds(cell); });
  };
  std::map<std::string, std::vector<std::string>> squares;
  std::map<std::string, std::string> taken;  // by square
  const auto look = [&](const std::string& name, std::size_t axis, int level, bool is_up, const Box& frame) {
    std::array<int, 3> cell = frame.low;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (cell[u] = frame.low[u]; cell[u] < frame.high[u]; ++cell[u])
      for (cell[v] = frame.low[v]; cell[v] < frame.high[v]; ++cell[v]) {
        cell[axis] = is_up ? level : level - 1;
        const bool is_silent = axis == 2 && level == 0 && !is_up;  // it lies on the floor, which looks into it
        if (is_silent || is_solid(cell)) continue;
        std::array<int, 3> corner = cell;
        for (int& value : corner) ++value;
        const std::string square = rectangle(axis, level, cell, corner, is_up);
        if (taken.emplace(square, name).second) squares[name].push_back(square);
      }
  };
  look("floor", 2, 0, true, {"", {kFrom, kFrom, 0}, {kTo, kTo, 0}});
  for (const Box& box : boxes)
    for (const Side& side : sides_of(box)) look(side.name, side.axis, side.level, side.is_high, box);
  return squares;
}

// How far the second box is off the first one, which is 2 by 2 by 2 halves, along each axis: apart, touching, crossing,
// flush on one side, on both.
constexpr int kApart = 3, kTouching = 2, kCrossing = 1, kFlush = 0;
constexpr int kOffsets[] = {kApart, kTouching, kCrossing, kFlush};
constexpr int kHeights[] = {kApart, kTouching, kCrossing, kFlush, -1};  // at -1 it is let into the floor

std::vector<Box> boxes_at(int dx, int dy, int dz) {
  return {{"a", {0, 0, 0}, {2, 2, 2}}, {"b", {dx, dy, dz}, {dx + 2, dy + 2, dz + 2}}};
}
Scene3 boxes_on_floor(const std::vector<Box>& boxes, bool is_one_group) {
  std::vector<std::string> polygons{uncut_floor()};
  for (const Box& box : boxes)
    for (const std::string& p : polygons_of(box, is_one_group ? "all" : box.name)) polygons.push_back(p);
  return scene_of(polygons);
}

template <class Use>
void for_each_place_of_two_boxes(const Use& use) {
  for (const int dx : kOffsets)
    for (const int dy : kOffsets)
      for (const int dz : kHeights) {
        SCOPED_TRACE(testing::Message() << "offset " << dx << ", " << dy << ", " << dz << " halves");
        use(boxes_at(dx, dy, dz));
      }
}

// Whether two boxes share a volume.
bool overlap(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a.high[axis] <= b.low[axis] || b.high[axis] <= a.low[axis]) return false;
  return true;
}

void expect_areas(const std::vector<Box>& boxes, const PreparedScene3& scene) {
  auto squares = squares_of(boxes);
  const ElementTable3& table = *scene.elements(Granularity::kFace);
  for (const Element& element : table.elements())
    if (element.material) {
      EXPECT_EQ(element.area.value, 0.25 * static_cast<double>(squares[element.name].size())) << element.name;
    }
}

TEST(TwoBoxesOnAFloor3, FacesHaveTheSquaresThatNoSolidCovers) {
  for_each_place_of_two_boxes([](const std::vector<Box>& boxes) {
    const PreparedScene3 scene = prepare(boxes_on_floor(boxes, false));
    for (const ClosedMesh3& mesh : scene.arrangement().solids().meshes())
      EXPECT_EQ(mesh.kind, ClosedMesh3::Kind::kSolid);
    expect_areas(boxes, scene);
  });
}

// Turned by a matrix of thirds no plane is along an axis, and areas stay what they are.
Scene3 turned(Scene3 scene) {
  for (Polygon3& polygon : scene.polygons)
    for (Point3& p : polygon.points) {
      const Rational x = (2 * p.x - 2 * p.y + p.z) / 3, y = (p.x + 2 * p.y + 2 * p.z) / 3,
                     z = (-2 * p.x - p.y + 2 * p.z) / 3;
      p = {x, y, z};
    }
  return scene;
}

TEST(TwoBoxesOnAFloor3, HaveTheSameAreasTurned) {
  for_each_place_of_two_boxes(
      [](const std::vector<Box>& boxes) { expect_areas(boxes, prepare(turned(boxes_on_floor(boxes, false)))); });
}

TEST(TwoBoxesOnAFloor3, HaveTheSameFactorsTurned) {
  for (const int dz : kHeights) {
    const Scene3 scene = boxes_on_floor(boxes_at(kCrossing, kTouching, dz), false);
    const ExchangeMatrix straight = exact_exchange(prepare(scene)), other = exact_exchange(prepare(turned(scene)));
    ASSERT_EQ(straight.entry_count(), other.entry_count()) << dz;
    for (std::uint32_t i = 0; i < straight.size(); ++i)
      for (std::size_t k = 0; k < straight.row(i).size(); ++k) {
        EXPECT_EQ(straight.row(i)[k].to, other.row(i)[k].to);
        EXPECT_NEAR(straight.row(i)[k].factor.value, other.row(i)[k].factor.value, 1e-11) << straight.name(i);
        EXPECT_NEAR(straight.row(i)[k].visibility, other.row(i)[k].visibility, 1e-11) << straight.name(i);
      }
  }
}

// Winding numbers of two that touch are 0 and 1 everywhere, and 2 where they overlap.
TEST(TwoBoxesOnAFloor3, AreOneSolidAsOneGroupWhereTheyDoNotOverlap) {
  for_each_place_of_two_boxes([](const std::vector<Box>& boxes) {
    const PreparedScene3 scene = prepare(boxes_on_floor(boxes, true));
    ASSERT_EQ(scene.arrangement().solids().meshes().size(), 1u);
    const bool is_tangled = overlap(boxes[0], boxes[1]);
    EXPECT_EQ(scene.arrangement().solids().meshes()[0].kind,
              is_tangled ? ClosedMesh3::Kind::kTangled : ClosedMesh3::Kind::kSolid);
    if (!is_tangled) expect_areas(boxes, scene);
  });
}

TEST(TwoBoxesOnAFloor3, FloorsThatLoseNothingElseStayOnePiece) {
  const PreparedScene3 scene = prepare(boxes_on_floor(boxes_at(kApart, 0, 0), false));
  const Arrangement3& arrangement = scene.arrangement();
  ASSERT_EQ(arrangement.pieces_on(0).size(), 1u);
  const Piece3& floor = arrangement.pieces()[arrangement.pieces_on(0)[0]];
  EXPECT_TRUE(floor.is_whole);
  EXPECT_EQ(floor.sides[0].cover, Piece3::Cover::kPartly);
  EXPECT_EQ(floor.sides[1].cover, Piece3::Cover::kFree);
  EXPECT_EQ(floor.sides[1].owner, (Face{0, true})) << "the bottom of a box makes no claim beneath the floor";
  EXPECT_FALSE(arrangement.is_plain());
}

TEST(TwoBoxesOnAFloor3, RowsClose) {
  for_each_place_of_two_boxes(
      [](const std::vector<Box>& boxes) { expect_closed_rows(exact_exchange(prepare(boxes_on_floor(boxes, false)))); });
}

// Each face is replaced by a group of the rectangles that it has: nothing overlaps any more, and nothing is covered.
TEST(TwoBoxesOnAFloor3, HaveTheFactorsOfTheSceneThatIsCutByHand) {
  const std::array<int, 3> places[] = {{kApart, kFlush, kFlush},       {kTouching, kCrossing, kFlush},
                                       {kTouching, kTouching, kFlush}, {kCrossing, kCrossing, kTouching},
                                       {kCrossing, kFlush, kCrossing}, {kFlush, kFlush, kFlush}};
  for (const auto& [dx, dy, dz] : places) {
    SCOPED_TRACE(testing::Message() << "offset " << dx << ", " << dy << ", " << dz << " halves");
    const std::vector<Box> boxes = boxes_at(dx, dy, dz);
    const ExchangeMatrix whole = exact_exchange(prepare(boxes_on_floor(boxes, false)));
    std::vector<std::string> cut;
    const auto squares = squares_of(boxes);
    for (const auto& [name, list] : squares) {
      for (std::size_t k = 0; k < list.size(); ++k)
        cut.push_back(polygon(name + "." + std::to_string(k), list[k], R"(, "group": ")" + name + "\""));
    }
    const ExchangeMatrix parts = exact_exchange(prepare(scene_of(cut)), {.granularity = Granularity::kGroup});
    for (const auto& [from, list] : squares)
      for (const auto& [to, other] : squares)
        EXPECT_NEAR(whole.factor(from, to).value, parts.factor(from, to).value, 1e-8) << from << " to " << to;
  }
}

// Two sheets go through each other within a box: what it covers of both sees each other there, and does not count.
TEST(TwoSheetsInABox3, HaveTheFactorsOfSheetsWithHoles) {
  const auto sheets_with = [](const std::string& hole, const std::string& other_hole) {
    const std::string back = R"(, "back": "m")";
    const auto holes = [](const std::string& points) { return points.empty() ? "" : R"(, "holes": [)" + points + "]"; };
    std::vector<std::string> polygons{
        polygon("sheet", "[[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]]", back + holes(hole)),
        polygon("blade", "[[0,-1,-1],[0,1,-1],[0,1,1],[0,-1,1]]", back + holes(other_hole))};
    for (const std::string& side : polygons_of({"core", {-1, -1, -1}, {1, 1, 1}}, "core")) polygons.push_back(side);
    return prepare(scene_of(polygons));
  };
  const PreparedScene3 uncut = sheets_with("", "");
  ASSERT_EQ(uncut.arrangement().pieces().size(), 8u);
  for (const std::uint32_t sheet : {0u, 1u})
    for (const Piece3::Side& side : uncut.arrangement().pieces()[sheet].sides)
      EXPECT_EQ(side.cover, Piece3::Cover::kPartly);
  const ExchangeMatrix whole = exact_exchange(uncut);
  const ExchangeMatrix holed = exact_exchange(sheets_with("[[-0.5,-0.5,0],[0.5,-0.5,0],[0.5,0.5,0],[-0.5,0.5,0]]",
                                                          "[[0,-0.5,-0.5],[0,0.5,-0.5],[0,0.5,0.5],[0,-0.5,0.5]]"));
  ASSERT_EQ(whole.entry_count(), holed.entry_count());
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole.elements()[i].area, holed.elements()[i].area) << whole.name(i);
    for (std::size_t k = 0; k < whole.row(i).size(); ++k) {
      EXPECT_EQ(whole.row(i)[k].to, holed.row(i)[k].to);
      EXPECT_NEAR(whole.row(i)[k].factor.value, holed.row(i)[k].factor.value, 1e-12) << whole.name(i);
      EXPECT_NEAR(whole.row(i)[k].visibility, holed.row(i)[k].visibility, 1e-12) << whole.name(i);
    }
  }
}

// The bottom of a box claims nothing beneath the shelf that it stands on, whatever its material.
TEST(BoxOnAShelf3, LeavesTheShelfItsUnderside) {
  std::vector<std::string> polygons{polygon("shelf", "[[-1,-1,0],[2,-1,0],[2,2,0],[-1,2,0]]", R"(, "back": "n")")};
  for (const std::string& side : polygons_of({"box", {0, 0, 0}, {2, 2, 2}}, "box")) polygons.push_back(side);
  const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(polygons)));
  EXPECT_EQ(area_of(matrix, "shelf"), 8);
  EXPECT_EQ(area_of(matrix, "shelf:back"), 9);
  EXPECT_EQ(area_of(matrix, "box z0"), 0);
  EXPECT_EQ(matrix.factor("shelf:back", "sky").value, 1);
}

// A crate in a corner of a room in a building: the room is free, the walls of the building are not.
TEST(RoomInABuilding3, IsFree) {
  std::vector<std::string> polygons;
  for (const auto& [box, is_outward] :
       {std::pair(Box{"building", {0, 0, 0}, {8, 8, 8}}, true), std::pair(Box{"room", {1, 1, 1}, {7, 7, 7}}, false),
        std::pair(Box{"crate", {1, 1, 1}, {3, 3, 3}}, true)})
    for (const std::string& side : polygons_of(box, box.name, is_outward)) polygons.push_back(side);
  const PreparedScene3 scene = prepare(scene_of(polygons));
  const Solids3& solids = scene.arrangement().solids();
  EXPECT_TRUE(solids.around({Rational(1, 4), 1, 1}).has_value()) << "in the wall";
  EXPECT_FALSE(solids.around({3, 3, 3}).has_value()) << "in the room";
  EXPECT_TRUE(solids.around({1, 1, 1}).has_value()) << "in the crate";
  EXPECT_FALSE(solids.around({1, 1, Rational(3, 2)}).has_value()) << "on the crate";
  const ExchangeMatrix matrix = exact_exchange(scene);
  EXPECT_EQ(area_of(matrix, "room z0"), 8);
  EXPECT_EQ(area_of(matrix, "crate z0"), 0);
  EXPECT_EQ(area_of(matrix, "crate z1"), 1);
  EXPECT_EQ(matrix.factor("building z0", "sky").value, 1);
  EXPECT_EQ(matrix.factor("crate z1", "sky").value, 0);
  expect_closed_rows(matrix);
}

// ---- One box on a floor, drawn in other ways ------------------------------------------------------------------------

const Box kBox{"box", {2, 2, 0}, {4, 4, 2}};  // a unit cube on the floor of 25

TEST(BoxOnAFloor3, CoversTheFloorWithABottom) {
  std::vector<std::string> polygons = polygons_of(kBox, "box");
  polygons.insert(polygons.begin(), uncut_floor());
  const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(polygons)));
  EXPECT_EQ(area_of(matrix, "floor"), 24);
  EXPECT_EQ(area_of(matrix, "box z0"), 0);
  EXPECT_FALSE(matrix.has_row(*matrix.find("box z0")));
  for (const std::string side : {"box x0", "box x1", "box y0", "box y1", "box z1"})
    EXPECT_EQ(matrix.factor("floor", side + ":back").value, 0) << side;
  EXPECT_NEAR(matrix.factor("box z1", "sky").value, 1, 1e-12);
  expect_closed_rows(matrix);
}

TEST(BoxOnAFloor3, IsAHollowShellWithoutABottomOrAGroup) {
  for (const bool has_bottom : {false, true}) {
    std::vector<std::string> polygons{uncut_floor()};
    for (const Side& side : sides_of(kBox))
      if (side.name != "box z0" || has_bottom)
        polygons.push_back(polygon(side.name, side.points, has_bottom ? "" : R"(, "group": "box")"));
    const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(polygons)));
    EXPECT_EQ(area_of(matrix, "floor"), 25);
    // One of 25 parts of the floor sees the inside of a cube, and nothing else.
    EXPECT_NEAR(matrix.factor("floor", "box z1:back").value, kOpposite / 25, 1e-12);
    for (const std::string side : {"box x0", "box x1", "box y0", "box y1"})
      EXPECT_NEAR(matrix.factor("floor", side + ":back").value, (1 - kOpposite) / 100, 1e-12) << side;
    expect_closed_rows(matrix);
  }
}

// The side facing west in pieces, with a corner inside an edge of another: closed all the same. With a crack it is not.
TEST(BoxOnAFloor3, IsClosedWithTVerticesAndOpenWithACrack) {
  const auto with_west = [](const std::vector<std::string>& west) {
    std::vector<std::string> polygons{uncut_floor()};
    for (const Side& side : sides_of(kBox))
      if (side.name != "box x0") polygons.push_back(polygon(side.name, side.points, R"(, "group": "box")"));
    int k = 0;
    for (const std::string& points : west)
      polygons.push_back(polygon("west" + std::to_string(k++), points, R"(, "group": "box")"));
    return prepare(scene_of(polygons));
  };
  const std::string low = "[[1,1,0],[1,1,1/2],[1,2,1/2],[1,2,0]]", left = "[[1,1,1/2],[1,1,1],[1,4/3,1],[1,4/3,1/2]]",
                    right = "[[1,4/3,1/2],[1,4/3,1],[1,2,1],[1,2,1/2]]",
                    cracked = "[[1,1.3334,1/2],[1,1.3334,1],[1,2,1],[1,2,1/2]]";
  const auto quoted = [](std::string text) {
    for (const std::string fraction : {"1/2", "4/3"})
      for (std::size_t at = 0; (at = text.find(fraction, at)) != std::string::npos; at += fraction.size() + 2)
        text.replace(at, fraction.size(), '"' + fraction + '"');
    return text;
  };
  const PreparedScene3 closed = with_west({quoted(low), quoted(left), quoted(right)});
  ASSERT_EQ(closed.arrangement().solids().meshes().size(), 1u);
  EXPECT_EQ(closed.arrangement().solids().meshes()[0].kind, ClosedMesh3::Kind::kSolid);
  const ExchangeMatrix whole = exact_exchange(closed);
  EXPECT_EQ(area_of(whole, "floor"), 24);
  expect_closed_rows(whole);
  const PreparedScene3 open = with_west({quoted(low), quoted(left), quoted(cracked)});
  EXPECT_TRUE(open.arrangement().solids().is_empty());
  const ExchangeMatrix matrix = exact_exchange(open);
  EXPECT_EQ(area_of(matrix, "floor"), 25);
  EXPECT_GT(matrix.factor("floor", "box z1:back").value, 0);
  expect_closed_rows(matrix);
}

TEST(BoxOnAFloor3, InsideOutIsARoomAndCoversNothing) {
  std::vector<std::string> polygons = polygons_of(kBox, "box", false);
  polygons.insert(polygons.begin(), uncut_floor());
  const PreparedScene3 scene = prepare(scene_of(polygons));
  ASSERT_EQ(scene.arrangement().solids().meshes().size(), 1u);
  EXPECT_EQ(scene.arrangement().solids().meshes()[0].kind, ClosedMesh3::Kind::kRoom);
  const ExchangeMatrix matrix = exact_exchange(scene);
  EXPECT_EQ(area_of(matrix, "floor"), 25)
      << "listed first, it has what its claim and that of the bottom have in common";
  EXPECT_NEAR(matrix.factor("floor", "box z1").value, kOpposite / 25, 1e-12);
  EXPECT_NEAR(matrix.factor("box z1", "floor").value, kOpposite, 1e-12);
  EXPECT_NEAR(matrix.factor("box x0", "box x1").value, kOpposite, 1e-12);
  expect_closed_rows(matrix);
}

// One polygon of a cube that is listed the wrong way round shows the others its black back, and itself the sky.
TEST(BoxOnAFloor3, AnUpsideDownPolygonIsSeenInTheRows) {
  std::vector<std::string> polygons;
  for (const Side& side : sides_of(kBox, false))
    polygons.push_back(side.name == "box z1" ? polygon(side.name, sides_of(kBox)[5].points)
                                             : polygon(side.name, side.points));
  const ExchangeMatrix matrix = exact_exchange(prepare(scene_of(polygons)));
  EXPECT_NEAR(matrix.factor("box z0", "box z1:back").value, kOpposite, 1e-12);
  EXPECT_EQ(matrix.factor("box z0", "box z1").value, 0);
  EXPECT_EQ(matrix.factor("box z1", "sky").value, 1);
  expect_closed_rows(matrix);
}

}  // namespace
}  // namespace hottel::contact_table_test

// What is solid, which sides it covers, and who owns the others.
#include "geometry/plane/arrangement/solids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::solids_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// A scene with materials "a" and "b" from its edges and polylines.
Scene2 scene(const std::string& edges, const std::string& polylines) {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2,
    "materials": {"a": {"reflectivity": 0.5}, "b": {"reflectivity": 0.25, "emission": 1}},
    "edges": [)" + edges + R"(], "polylines": [)" +
                           polylines + "]}",
                       "test.json");
}

std::string polyline(const std::string& name, const std::string& points, const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": "a", "closed": true)" + more + "}";
}
std::string edge(const std::string& name, const std::string& points, const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": "a")" + more + "}";
}

const std::string kRoom = polyline("room", "[0,0],[0,8],[8,8],[8,0]");
const std::string kBoxOnFloor = polyline("box", "[2,0],[4,0],[4,2],[2,2]");

// The names of all faces that have an area, in the order of the contract.
std::vector<std::string> faces(const Scene2& scene) {
  const PreparedScene2 prepared = prepare(scene);
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  std::vector<std::string> names;
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (!table.runs(label).empty()) names.push_back(table.elements()[label].name);
  return names;
}

// Half the area of triangles in solid cells, in scene units: what is solid within the hull of the scene.
Rational solid_area(const Scene2& scene) {
  const Arrangement2 arrangement(scene, Division2(scene.surfaces.size(), 1));
  const Triangulation2& triangulation = arrangement.triangulation();
  const FreeRegions2 regions(triangulation, arrangement.side_count());
  const Vertices2& vertices = arrangement.vertices();
  Rational area = 0;
  for (const PieceSideId side : arrangement.sides()) {
    if (!arrangement.is_covered(side)) continue;
    // Green's theorem: the cell lies on the left of the piece, or on its right.
    const Segment2& piece = arrangement.piece(side);
    const Point2 p = vertices.to_scene(vertices.exact(piece.a)), q = vertices.to_scene(vertices.exact(piece.b));
    const Rational twice = p.x * q.y - q.x * p.y;
    area += is_right(side) ? Rational(-twice) : twice;
  }
  return area / 2;
}

std::string refusal(const Scene2& scene) {
  try {
    prepare(scene);
  } catch (const InputError& error) {
    std::string text = error.what();
    for (const std::string& hint : error.hints()) text += "\n" + hint;
    return text;
  }
  return "accepted";
}

TEST(Solids2, AreClosedPolylinesWithFrontsOutward) {
  EXPECT_EQ(solid_area(scene("", kRoom)), 0);
  EXPECT_EQ(solid_area(scene("", kBoxOnFloor)), 4);
  EXPECT_EQ(solid_area(scene("", kRoom + "," + kBoxOnFloor)), 4);
  // With a material on its back, or open, a polyline is a shell.
  EXPECT_EQ(solid_area(scene("", polyline("box", "[2,0],[4,0],[4,2],[2,2]", R"(, "back": "b")"))), 0);
  EXPECT_EQ(solid_area(scene("", R"({"name": "u", "points": [[2,2],[2,0],[4,0],[4,2]], "material": "a"})")), 0);
  // The first point given again closes it as well; single edges are no polyline.
  EXPECT_EQ(solid_area(scene("", R"({"points": [[2,0],[4,0],[4,2],[2,0]], "material": "a"})")), 2);
  EXPECT_EQ(
      solid_area(scene(edge("e", "[2,0],[4,0]") + "," + edge("f", "[4,0],[3,2]") + "," + edge("g", "[3,2],[2,0]"), "")),
      0);
}

TEST(Solids2, AskForAWindingNumberOfZeroOrOneEverywhere) {
  // Touches itself in a point, retraces itself to a second square: solid.
  EXPECT_EQ(solid_area(scene("", polyline("s", "[0,0],[2,0],[2,2],[4,2],[4,4],[2,4],[2,2],[0,2]"))), 8);
  EXPECT_EQ(
      solid_area(scene("", polyline("s", "[0,0],[2,0],[2,1],[4,1],[4,0],[6,0],[6,2],[4,2],[4,1],[2,1],[2,2],[0,2]"))),
      8);
  // A ring cut open: solid but for its hole.
  EXPECT_EQ(solid_area(scene("", polyline("s", "[0,0],[6,0],[6,6],[0,6],[0,2],[2,2],[2,4],[4,4],[4,2],[0,2]"))), 32);
  // A figure of eight and one that goes around twice.
  EXPECT_EQ(solid_area(scene("", polyline("s", "[0,0],[2,2],[2,0],[0,2]"))), 0);
  EXPECT_EQ(solid_area(scene("", polyline("s", "[0,0],[4,0],[4,4],[0,4],[0,1],[3,1],[3,3],[0,3]"))), 0);
  // Out and back: nothing inside.
  EXPECT_EQ(solid_area(scene("", polyline("s", "[0,0],[2,0]"))), 0);
}

TEST(Solids2, LeaveOutRoomsThatLieInThem) {
  const std::string building = polyline("building", "[-1,-1],[9,-1],[9,9],[-1,9]");
  EXPECT_EQ(solid_area(scene("", building + "," + kRoom)), 100 - 64);
  EXPECT_EQ(solid_area(scene("", kRoom + "," + building)), 100 - 64);
  // Furniture in the room is solid again, and a closet in it is not.
  EXPECT_EQ(solid_area(scene("", building + "," + kRoom + "," + kBoxOnFloor)), 100 - 64 + 4);
  EXPECT_EQ(solid_area(scene(
                "", building + "," + kRoom + "," + kBoxOnFloor + "," + polyline("closet", "[2,0],[2,1],[3,1],[3,0]"))),
            100 - 64 + 3);
  // A thin wall all around; a room that only reaches into the building.
  EXPECT_EQ(solid_area(scene("", polyline("out", "[0,0],[8,0],[8,8],[0,8]") + "," + kRoom)), 0);
  EXPECT_EQ(solid_area(scene("", polyline("building", "[4,-1],[9,-1],[9,9],[4,9]") + "," + kRoom)), 50);
}

TEST(Solids2, AreAUnion) {
  const std::string low = polyline("low", "[0,0],[3,0],[3,3],[0,3]"),
                    high = polyline("high", "[2,2],[5,2],[5,5],[2,5]");
  EXPECT_EQ(solid_area(scene("", low + "," + high)), 17);
  EXPECT_EQ(solid_area(scene("", low + "," + polyline("in", "[1,1],[2,1],[2,2],[1,2]"))), 9);
}

TEST(Solids2, BehindSolidFillsWhatBlackBacksBound) {
  const std::string three = R"({"name": "box", "points": [[4,0],[4,2],[2,2],[2,0]], "material": "a")";
  EXPECT_EQ(solid_area(scene("", kRoom + "," + three + "}")), 0);
  EXPECT_EQ(solid_area(scene("", kRoom + "," + three + R"(, "behind": "solid"})")), 4);
  // A wall across the room: what is behind it.
  EXPECT_EQ(solid_area(scene(edge("partition", "[3,0],[3,8]", R"(, "behind": "solid")"), kRoom)), 24);
  // What makes itself solid says so at no cost.
  EXPECT_EQ(solid_area(scene("", polyline("box", "[2,0],[4,0],[4,2],[2,2]", R"(, "behind": "solid")"))), 4);
  // A shelf in the box divides its inside; both parts are behind backs of the box.
  EXPECT_EQ(solid_area(scene(edge("shelf", "[2,1],[4,1]"), kRoom + "," + three + R"(, "behind": "solid"})")), 4);
}

TEST(Solids2, BehindOpenTakesBackWhatIsItsOwn) {
  EXPECT_EQ(solid_area(scene("", polyline("box", "[2,0],[4,0],[4,2],[2,2]", R"(, "behind": "open")"))), 0);
  // What others make solid stays.
  EXPECT_EQ(solid_area(scene("", polyline("box", "[2,0],[4,0],[4,2],[2,2]", R"(, "behind": "open")") + "," +
                                     polyline("more", "[2,0],[3,0],[3,2],[2,2]"))),
            2);
}

TEST(Solids2, RefuseBehindThatBoundsNothing) {
  const auto three = [](const char* points) {
    return R"({"name": "box", "points": [)" + std::string(points) + R"(], "material": "a", "behind": "solid"})";
  };
  EXPECT_THAT(refusal(scene("", kRoom + "," + three("[4,0],[4,2],[2,2],[2,0.25]"))),
              AllOf(HasSubstr("'box'"), HasSubstr("(2, 0.25), 0.25 from 'room[3]'")));
  EXPECT_THAT(refusal(scene(edge("free", "[2,2],[4,2]", R"(, "behind": "solid")"), kRoom)), HasSubstr("own fronts"));
  EXPECT_THAT(refusal(scene(edge("free", "[2,2],[4,2]", R"(, "behind": "solid", "back": "a")"), kRoom)),
              HasSubstr("every back of it has a material"));
  EXPECT_THAT(refusal(scene("", polyline("box", "[2,0],[4,0],[4,2],[2,2]", R"(, "behind": "open")") + "," +
                                    polyline("same", "[2,0],[4,0],[4,2],[2,2]", R"(, "behind": "solid")"))),
              AllOf(HasSubstr("'same'"), HasSubstr("'box'")));
}

TEST(Solids2, CoverTheFloorUnderABoxAndItsBottom) {
  EXPECT_THAT(faces(scene("", kRoom + "," + kBoxOnFloor)),
              ElementsAre("room[0]", "room[0]:back", "room[1]", "room[1]:back", "room[2]", "room[2]:back", "room[3]",
                          "room[3]:back", "box[1]", "box[2]", "box[3]"));
  // The same whichever is listed first, and with another material.
  EXPECT_THAT(faces(scene("", R"({"name": "box", "points": [[2,0],[4,0],[4,2],[2,2]], "material": "b", "closed": true})"
                              "," +
                                  kRoom)),
              ElementsAre("box[1]", "box[2]", "box[3]", "room[0]", "room[0]:back", "room[1]", "room[1]:back", "room[2]",
                          "room[2]:back", "room[3]", "room[3]:back"));
}

TEST(Solids2, LeaveAShelfItsUnderside) {
  // A box on a shelf that hangs in the open: below the box the shelf's back is seen, not the bottom of the box.
  const std::string shelf = edge("shelf", "[6,3],[1,3]", R"(, "back": "b")");
  const std::string box = polyline("box", "[2,3],[4,3],[4,5],[2,5]");
  const PreparedScene2 prepared = prepare(scene(shelf, box));
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  EXPECT_EQ(table.elements()[0].area.value, 3);  // shelf
  EXPECT_EQ(table.elements()[1].area.value, 5);  // shelf:back
  EXPECT_TRUE(table.runs(2).empty());            // box[0]
  // Without a material on its back the shelf is black there.
  EXPECT_THAT(faces(scene(edge("shelf", "[6,3],[1,3]"), box)),
              ElementsAre("shelf", "shelf:back", "box[1]", "box[2]", "box[3]"));
  // A shelf whose black back lies on the box makes no claim on the other side: the bottom of the box is seen there.
  EXPECT_THAT(faces(scene(edge("shelf", "[1,3],[6,3]"), box)),
              ElementsAre("shelf", "shelf:back", "box[1]", "box[2]", "box[3]"));
}

TEST(Solids2, CoverBothFrontsWhereBoxesTouch) {
  const std::string left = polyline("left", "[0,0],[2,0],[2,2],[0,2]"),
                    right = polyline("right", "[2,0],[4,0],[4,3],[2,3]");
  const PreparedScene2 prepared = prepare(scene("", left + "," + right));
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const auto area = [&](const std::string& name) {
    for (const Element& element : table.elements())
      if (element.name == name) return element.area.value;
    return -1.0;
  };
  EXPECT_EQ(area("left[1]"), 0);
  EXPECT_EQ(area("right[3]"), 1);
  EXPECT_EQ(area("left[1]:back"), 0);
}

TEST(Solids2, KeepTheFrontOfABuildingWhereFurnitureTouchesItsWallFromInside) {
  // The room's wall and the building's are one line; the cupboard in the room stands against it.
  const std::string building = polyline("building", "[0,0],[8,0],[8,8],[0,8]"),
                    room = polyline("room", "[0,1],[0,7],[7,7],[7,1]");
  const std::string cupboard = polyline("cupboard", "[0,2],[1,2],[1,4],[0,4]");
  const PreparedScene2 prepared = prepare(scene("", building + "," + room + "," + cupboard));
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  for (const Element& element : table.elements()) {
    if (element.name == "building[3]") {
      EXPECT_EQ(element.area.value, 8);
    }
    if (element.name == "room[0]") {
      EXPECT_EQ(element.area.value, 4);
    }
  }
  EXPECT_EQ(solid_area(scene("", building + "," + room + "," + cupboard)), 64 - 42 + 2);
}

TEST(Solids2, ClosedScenesStayClosed) {
  const char* const boxes[] = {
      "[2,0],[4,0],[4,2],[2,2]",  // on the floor
      "[0,3],[2,3],[2,5],[0,5]",  // against a wall
      "[0,0],[2,0],[2,2],[0,2]",  // in a corner
      "[3,0],[4,0],[4,8],[3,8]",  // from floor to ceiling
      "[0,0],[8,0],[8,1],[0,1]",  // covers the whole floor
      "[7,3],[9,3],[9,5],[7,5]",  // through the wall
  };
  for (const char* box : boxes) {
    const PreparedScene2 prepared = prepare(scene("", kRoom + "," + polyline("box", box)));
    const ExchangeMatrix matrix = exact_exchange(prepared);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      const Element& element = matrix.elements()[i];
      if (!matrix.has_row(i) || element.name.starts_with("box")) continue;
      EXPECT_EQ(matrix.factor(i, matrix.sky()).value, 0) << box << ' ' << element.name;
    }
  }
}

}  // namespace
}  // namespace hottel::solids_test

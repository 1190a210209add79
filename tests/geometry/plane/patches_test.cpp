// Patches of the plane: edges that lie on others and take their part of them.
#include "geometry/plane/scene/patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/plane/check/contact_findings.h"
#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/check/near_misses.h"
#include "geometry/plane/check/repair.h"
#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene_builder.h"
#include "io/scene/scene_json.h"
#include "solver/plane/simulation/simulation.h"
#include "tests/refusal.h"

namespace hottel::patches_2_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene2 scene_of(const std::string& edges, const std::string& polylines) {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2,
    "materials": {"a": {"reflectivity": 0.5}, "b": {"reflectivity": 0.25}, "c": {"reflectivity": 0.75}},
    "edges": [)" + edges + R"(], "polylines": [)" +
                           polylines + "]}",
                       "scene.json");
}

std::string edge(const std::string& name, const std::string& points, const std::string& more = "",
                 const std::string& material = "b") {
  return "{\"name\": \"" + name + "\", \"points\": [" + points + "], \"material\": \"" + material + "\"" + more + "}";
}
std::string on(const std::string& base) { return ", \"on\": \"" + base + "\""; }

std::string room(const std::string& more = "") {
  return edge("room", "[0,0],[0,3],[4,3],[4,0]", ", \"closed\": true" + more, "a");
}

// "NAME length^2" of all faces that have an area.
std::vector<std::string> faces(const Scene2& scene) {
  const PreparedScene2 prepared = prepare(scene);
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  std::vector<std::string> names;
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (!table.runs(label).empty()) names.push_back(table.elements()[label].name);
  return names;
}

std::string refusal(const std::string& edges, const std::string& polylines = room()) {
  return refusal_by([&] { prepare(scene_of(edges, polylines)); });
}

ExchangeMatrix factors(const Scene2& scene, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepare(scene, granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo),
                        {.granularity = granularity});
}

RootSum exchange(const Scene2& scene, const std::string& from, const std::vector<std::string>& to) {
  const PreparedScene2 prepared = prepare(scene);
  RootSum sum;
  for (const std::string& name : to) sum += exact_pair(prepared, face_of(scene, from), face_of(scene, name)).exchange;
  return sum;
}

TEST(Patches2, TakeTheirPartWhateverTheMaterials) {
  const Scene2 scene = scene_of(edge("window", "[0,1],[0,2]", on("room")), room());
  EXPECT_THAT(faces(scene), ElementsAre("window", "room[0]", "room[0]:back", "room[1]", "room[1]:back", "room[2]",
                                        "room[2]:back", "room[3]", "room[3]:back"));
  const ExchangeMatrix matrix = factors(scene);
  EXPECT_EQ(matrix.elements()[*matrix.find("window")].area.value, 1);
  EXPECT_EQ(matrix.elements()[*matrix.find("room[0]")].area.value, 2);
}

// The sum over the patch and what is left is what the whole wall had: exactly.
TEST(Patches2, OfTheMaterialOfTheBaseAddUpToIt) {
  const Scene2 whole = scene_of("", room()),
               parted = scene_of(edge("patch", "[0,1],[0,2]", on("room[0]"), "a"), room());
  for (const std::string other : {"room[1]", "room[2]", "room[3]"})
    EXPECT_EQ((exchange(whole, other, {"room[0]"}) - exchange(parted, other, {"room[0]", "patch"})).to_string(), "0")
        << other;
}

// A window on a wall is the wall cut by hand: every pair, as sums of square roots.
TEST(Patches2, AreTheSceneWithTheBaseCutByHand) {
  const std::string walls = edge("wall", "[0,0],[0,3]", R"(, "back": "c")", "a") + "," +
                            edge("table", "[1,1],[2,3/2]", R"(, "back": "b")", "a") + "," +
                            edge("far", "[4,3],[4,0]", "", "c");
  std::string text = walls;
  text.replace(text.find("[2,3/2]"), 7, R"([2,"3/2"])");
  const Scene2 patched = scene_of(text + "," + edge("window", "[0,1],[0,2]", on("wall")), "");
  std::string cut = text;
  cut.replace(0, text.find("},") + 2,
              edge("low", "[0,0],[0,1]", R"(, "back": "c")", "a") + "," +
                  edge("window", "[0,1],[0,2]", R"(, "back": "c")") + "," +
                  edge("high", "[0,2],[0,3]", R"(, "back": "c")", "a") + ",");
  const Scene2 by_hand = scene_of(cut, "");
  for (const std::string other : {"table", "table:back", "far", "far:back"}) {
    EXPECT_EQ((exchange(patched, other, {"window"}) - exchange(by_hand, other, {"window"})).to_string(), "0") << other;
    EXPECT_EQ((exchange(patched, other, {"wall"}) - exchange(by_hand, other, {"low", "high"})).to_string(), "0")
        << other;
    EXPECT_EQ(
        (exchange(patched, other, {"wall:back"}) - exchange(by_hand, other, {"low:back", "window:back", "high:back"}))
            .to_string(),
        "0")
        << other;
  }
}

TEST(Patches2, HaveABackOnlyWithAMaterial) {
  const std::string wall = edge("wall", "[0,0],[0,3]", R"(, "back": "c")", "a");
  EXPECT_THAT(faces(scene_of(wall + "," + edge("p", "[0,1],[0,2]", on("wall")), "")),
              ElementsAre("wall", "wall:back", "p"));
  EXPECT_THAT(faces(scene_of(wall + "," + edge("p", "[0,1],[0,2]", on("wall") + R"(, "back": "a")"), "")),
              ElementsAre("wall", "wall:back", "p", "p:back"));
  // The black back of a base stays that of the base, wherever the patch is listed.
  EXPECT_THAT(faces(scene_of(edge("p", "[0,0],[0,3]", on("wall")) + "," + edge("wall", "[0,0],[0,3]", "", "a"), "")),
              ElementsAre("p", "wall:back"));
}

TEST(Patches2, LieOnBacksToo) {
  const std::string wall = edge("wall", "[0,0],[0,3]", R"(, "back": "c")", "a");
  EXPECT_THAT(faces(scene_of(wall + "," + edge("p", "[0,3],[0,0]", on("wall:back")), "")), ElementsAre("wall", "p"));
  EXPECT_THAT(refusal(wall + "," + edge("p", "[0,1],[0,2]", on("wall:back")), ""),
              AllOf(HasSubstr("scene.json:"), HasSubstr("'p' looks the other way than the back of 'wall'")));
}

TEST(Patches2, OfAChainTheInnermostWins) {
  const std::string chain =
      edge("pane", "[0,1.25],[0,1.5]", on("window"), "c") + "," + edge("window", "[0,1],[0,2]", on("room"));
  const ExchangeMatrix matrix = factors(scene_of(chain, room()));
  const auto area = [&](const char* name) { return matrix.elements()[*matrix.find(name)].area.value; };
  EXPECT_EQ(area("pane"), 0.25);
  EXPECT_EQ(area("window"), 0.75);
  EXPECT_EQ(area("room[0]"), 2);
}

TEST(Patches2, DoNotLieOnThemselves) {
  EXPECT_THAT(refusal(edge("a1", "[0,1],[0,2]", on("b1")) + "," + edge("b1", "[0,1],[0,2]", on("a1"))),
              HasSubstr("'a1' lies on 'b1', which lies on 'a1'"));
  EXPECT_THAT(refusal(edge("a1", "[0,1],[0,2]", on("a1"))), HasSubstr("'a1' lies on itself"));
  EXPECT_THAT(refusal(edge("a1", "[0,1],[0,2]", on("rooms"))),
              HasSubstr("'a1' lies on 'rooms', but there is no surface or group of that name"));
}

TEST(Patches2, ThatOverlapNeedOneMaterial) {
  const std::string first = edge("p", "[0,1],[0,2]", on("room"));
  EXPECT_THAT(refusal(first + "," + edge("q", "[0,1.5],[0,2.5]", on("room"), "c")),
              HasSubstr("'p' (front) and 'q' (front) claim the same side with different materials"));
  EXPECT_EQ(refusal(first + "," + edge("q", "[0,1.5],[0,2.5]", on("room"))), "");
}

TEST(Patches2, MaySpanPiecesOfAPolyline) {
  const std::string bent = edge("wall", "[0,0],[0,1],[0,2],[1,2]", "", "a");
  const Scene2 scene = scene_of(edge("p", "[0,0.5],[0,1.5]", on("wall")), bent);
  const ExchangeMatrix matrix = factors(scene);
  EXPECT_EQ(matrix.elements()[*matrix.find("wall[0]")].area.value, 0.5);
  EXPECT_EQ(matrix.elements()[*matrix.find("wall[1]")].area.value, 0.5);
  EXPECT_THAT(refusal(edge("p", "[0,0.5],[0,1.5]", on("wall[0]")), bent),
              AllOf(HasSubstr("'p' leaves 'wall[0]'"), HasSubstr("along (0, 1) to (0, 1.5)")));
}

TEST(Patches2, MayBePolylinesThatRunAroundCorners) {
  const Scene2 scene = scene_of("", room() + "," + edge("dado", "[0,2],[0,3],[1,3]", on("room")));
  EXPECT_THAT(faces(scene), testing::IsSupersetOf({"dado[0]", "dado[1]"}));
}

TEST(Patches2, ThatCoverABaseLeaveItNoRows) {
  EXPECT_THAT(faces(scene_of(edge("p", "[0,0],[0,3]", on("room")), room())),
              ElementsAre("p", "room[0]:back", "room[1]", "room[1]:back", "room[2]", "room[2]:back", "room[3]",
                          "room[3]:back"));
}

TEST(Patches2, LeaveElementsTheirNumbers) {
  const Scene2 scene = scene_of(edge("p", "[0,1],[0,2]", on("room")), room(R"(, "elements": 3)"));
  const ExchangeMatrix matrix = factors(scene, Granularity::kElement);
  for (const auto& [name, has_row] : {std::pair{"room[0]#0", true}, {"room[0]#1", false}, {"room[0]#2", true}})
    EXPECT_EQ(matrix.has_row(*matrix.find(name)), has_row) << name;
}

TEST(Patches2, AreCoveredBySolids) {
  const std::string box =
      R"({"name": "box", "points": [[0,0],[1,0],[1,1.5],[0,1.5]], "closed": true, "material": "a"})";
  const ExchangeMatrix matrix = factors(scene_of(edge("p", "[0,1],[0,2]", on("room")), room() + "," + box));
  EXPECT_EQ(matrix.elements()[*matrix.find("p")].area.value, 0.5);
  EXPECT_EQ(matrix.elements()[*matrix.find("room[0]")].area.value, 1);
}

// A window on a box stands on the solid as the box does, and closes none.
TEST(Patches2, OnSolidsCloseNothing) {
  const std::string box = R"({"name": "box", "points": [[1,1],[2,1],[2,2],[1,2]], "closed": true, "material": "a"})";
  const std::string lining =
      R"({"name": "lining", "points": [[1,1],[2,1],[2,2],[1,2]], "closed": true, "material": "b")";
  const Scene2 scene = scene_of("", room() + "," + box + "," + lining + on("box") + "}");
  const PreparedScene2 prepared = prepare(scene);
  EXPECT_FALSE(prepared.arrangement.solids().is_empty());
  EXPECT_THAT(faces(scene), testing::IsSupersetOf({"lining[0]", "lining[1]", "lining[2]", "lining[3]"}));
}

// What a back of a patch on a solid looks at is covered, and so is what a patch on the back of it looks at.
TEST(Patches2, WithBacksOnSolidsAreCoveredInside) {
  const std::string box = edge("box", "[0,0],[3,0],[3,3],[0,3]", ", \"closed\": true", "a");
  const auto with = [&](const std::string& points, const std::string& more) {
    return faces(scene_of(edge("win", points, more), box));
  };
  EXPECT_THAT(with("[0,2],[0,1]", R"(, "back": "c", "on": "box[3]")"),
              ElementsAre("win", "box[0]", "box[1]", "box[2]", "box[3]"));
  EXPECT_THAT(with("[0,1],[0,2]", R"(, "on": "box[3]:back")"), ElementsAre("box[0]", "box[1]", "box[2]", "box[3]"));
  EXPECT_THAT(with("[0,1],[0,2]", R"(, "back": "c", "on": "box[3]:back")"),
              ElementsAre("win:back", "box[0]", "box[1]", "box[2]", "box[3]"));
}

// The back of a patch on a patch without one is that of the wall below.
TEST(Patches2, OnPatchesHaveBacksOfTheirOwn) {
  const Scene2 scene =
      scene_of(edge("wall", "[0,0],[0,10]", R"(, "back": "a")", "a") + "," + edge("win", "[0,2],[0,8]", on("wall")) +
                   "," + edge("pane", "[0,3],[0,5]", R"(, "back": "c", "on": "win")", "c"),
               "");
  const ExchangeMatrix matrix = factors(scene);
  for (const auto& [name, length] : {std::pair("wall", 4), {"wall:back", 8}, {"win", 4}, {"pane", 2}, {"pane:back", 2}})
    EXPECT_EQ(matrix.elements()[*matrix.find(name)].area.value, length) << name;
  EXPECT_FALSE(matrix.find("win:back") && matrix.has_row(*matrix.find("win:back")));
}

TEST(Patches2, AreNotBesideBehind) {
  EXPECT_THAT(refusal(edge("p", "[0,1],[0,2]", on("room") + R"(, "behind": "solid")")),
              HasSubstr("edge 'p' lies on another surface (\"on\"): it makes nothing solid"));
}

TEST(Patches2, AreToldWhereTheyAreNot) {
  EXPECT_THAT(refusal(edge("p", "[0.01,1],[0,2]", on("room"))),
              AllOf(HasSubstr("'p' does not lie on 'room'"), HasSubstr("(0.01, 1) is 0.01 off its line")));
  EXPECT_THAT(refusal(edge("p", "[0,2],[0,1]", on("room"))), HasSubstr("'p' looks the other way than 'room'"));
  EXPECT_THAT(refusal(edge("p", "[0,2],[0,4]", on("room"))), HasSubstr("along (0, 3) to (0, 4)"));
  EXPECT_THAT(refusal(edge("p", "[0,4],[0,5]", on("room"))), HasSubstr("it runs beside it"));
}

// As typed to four digits: on the line of a slanting wall, and at its end, but for rounding.
TEST(Patches2, AreProjectedWithinTheDigits) {
  const std::string wall = edge("wall", "[0,0],[3,1]", "", "a");
  const Scene2 scene = scene_of(wall + "," + edge("p", "[1.5,0.5],[3.0001,1.0001]", on("wall")) + "," +
                                    edge("q", "[0.1,0.0333],[1.1,0.3667]", on("wall")),
                                "");
  EXPECT_EQ(scene.edges[1].to, scene.edges[0].to);
  for (const std::uint32_t s : {1u, 2u})
    for (const Point2& end : {scene.edges[s].from, scene.edges[s].to})
      EXPECT_EQ(doubled_area(scene.edges[0].from, scene.edges[0].to, end), 0);
  EXPECT_EQ(scene.edges[1].from, (Point2{Rational(3, 2), Rational(1, 2)})) << "what lies there stays";
  EXPECT_TRUE(parse_scene_2(write_scene_2(scene), "scene.json")->edges == scene.edges);
}

// Off by three units as a long base may be, but far for what is itself one unit long. A narrow window is not.
TEST(Patches2, AreNotProjectedFromFarForTheirSize) {
  const std::string road = edge("road", "[0,0],[40000,0]", "", "a");
  EXPECT_THAT(refusal(road + "," + edge("p", "[5,3],[6,3]", on("road")), ""), HasSubstr("(5, 3) is 3 off its line"));
  EXPECT_EQ(refusal(road + "," + edge("p", "[5,3],[306,3]", on("road")), ""), "");
  EXPECT_EQ(
      refusal(edge("wall", "[0,0],[3,1]", "", "a") + "," + edge("slit", "[0.1,0.0333],[0.15,0.05]", on("wall")), ""),
      "");
}

TEST(Patches2, GoRoundACornerWithinTheDigits) {
  const Scene2 scene = scene_of("", edge("wall", "[0,0],[3,1],[4,4]", "", "a") + "," +
                                        edge("p", "[2.1,0.70001],[3.00002,0.99999],[3.50001,2.5]", on("wall")));
  EXPECT_EQ(scene.edges[2].to, scene.edges[0].to);
  EXPECT_EQ(scene.edges[3].from, scene.edges[0].to);
}

TEST(Patches2, AreMadeInCodeToo) {
  SceneBuilder2 builder;
  builder.add_material("m").add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "m", {.closed = true});
  builder.add_edge("window", {0, 1}, {0, 2}, "m", {.on = "room"});
  EXPECT_THAT(faces(builder.build()), testing::Contains("window"));
  builder.add_edge("astray", {1, 1}, {1, 2}, "m", {.on = "room"});
  EXPECT_THAT(refusal_by([&] { builder.build(); }), HasSubstr("'astray'"));
}

TEST(Patches2, GiveWayNowhereToWhatIsAsked) {
  const Scene2 scene = scene_of(edge("p", "[0,1],[0,2]", on("room")), room());
  const PreparedScene2 prepared = prepare(scene);
  EXPECT_NO_THROW(require_free_at(prepared, face_of(scene, "room[0]"), Rational(1, 6)));
  try {
    require_free_at(prepared, face_of(scene, "room[0]"), Rational(1, 2));
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the front of 'room[0]' gives way to the patch 'p'"));
  }
}

TEST(Patches2, AreNoContacts) {
  const Scene2 scene = scene_of(edge("p", "[0,0.001],[0,2]", on("room")) + "," + edge("q", "[0,2],[0,3]", on("room")) +
                                    "," + edge("r", "[0,2],[0,3]", on("q"), "c"),
                                room());
  EXPECT_THAT(find_near_misses(scene), IsEmpty());
  const Findings2 findings = contact_findings(scene, find_contacts(scene));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_THAT(findings[0].message, HasSubstr("nothing is left of the front of 'q' beside the patch on it, 'r'"));
}

// A room listed wall by wall and the wrong way round, its window too, with a screen in it.
TEST(Patches2, AreReversedWithWhatTheyLieOn) {
  const Scene2 scene =
      scene_of(edge("p", "[0,2],[0,1]", on("west")) + "," + edge("west", "[0,3],[0,0]", "", "a") + "," +
                   edge("north", "[4,3],[0,3]", "", "a") + "," + edge("east", "[4,0],[4,3]", "", "a") + "," +
                   edge("south", "[0,0],[4,0]", "", "a") + "," + edge("screen", "[1,1],[2,2]", R"(, "back": "c")"),
               "");
  Repair2 repair = unrepaired(scene);
  reverse_inside_out(repair);
  for (std::uint32_t s = 0; s < 5; ++s)
    EXPECT_TRUE(repair.scene.edges[s] == (Edge2{scene.edges[s].to, scene.edges[s].from})) << scene.surfaces[s].name;
  EXPECT_EQ(refusal_by([&] { validate(repair.scene); }), "");
}

TEST(Patches2, StayWhereGapsAreClosed) {
  const Scene2 scene = scene_of(edge("p", "[0,1],[0,2]", on("wall")) + "," + edge("wall", "[0,0],[0,3]", "", "a") +
                                    "," + edge("top", "[0.001,3],[4,3]", "", "a"),
                                "");
  const Repair2 repair = close_gaps(scene, Rational(1, 100));
  EXPECT_TRUE(repair.scene.edges[0] == scene.edges[0] && repair.scene.edges[1] == scene.edges[1]);
  EXPECT_EQ(repair.scene.edges[2].from, scene.edges[1].to);
}

}  // namespace
}  // namespace hottel::patches_2_test

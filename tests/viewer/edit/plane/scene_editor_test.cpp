// One scene under a hand.
#include "viewer/edit/plane/scene_editor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::scene_editor_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// small_room(): the screen is 0, the room 1..4, the step 5, 6, the table 7..10.
constexpr std::uint32_t kScreen = 0, kRoom = 1, kTable = 7;

Pointer2 at(double x, double y) { return {.place = {x, y}, .reach = 0.1, .decimals = 2}; }

std::size_t steps_back(SceneEditor2& editor) {
  std::size_t steps = 0;
  while (editor.history().can_undo()) {
    editor.undo();
    ++steps;
  }
  return steps;
}

void drag(SceneEditor2& editor, const Pointer2& from, std::initializer_list<Place2> places) {
  ASSERT_TRUE(editor.press(from));
  for (const Place2& place : places) {
    Pointer2 pointer = from;
    pointer.place = place;
    editor.drag(pointer);
  }
  editor.release();
}

std::vector<std::string> selected_names(const SceneEditor2& editor) {
  std::vector<std::string> names;
  for (const std::uint32_t s : editor.selected()) names.push_back(editor.scene()->surfaces[s].name);
  return names;
}

// (1)
TEST(SceneEditor2, EveryEditIsOneStepAndUndoneAsOne) {
  SceneEditor2 editor(small_room());
  const auto start = editor.scene();
  const auto is_one_step = [&](const char* what, const auto& edit) {
    SCOPED_TRACE(what);
    editor.select({kTable, kTable + 1});
    const auto before = editor.scene();
    const std::uint64_t version = editor.version();
    edit();
    EXPECT_NE(editor.scene(), before);
    EXPECT_GT(editor.version(), version);
    EXPECT_NE(editor.undo(), "");
    EXPECT_EQ(editor.scene(), before);
    EXPECT_FALSE(editor.history().is_changed());
    EXPECT_NE(editor.redo(), "");
    EXPECT_NE(editor.scene(), before);
    editor.undo();
  };
  is_one_step("move", [&] { EXPECT_NE(editor.move_by(1, 0), ""); });
  is_one_step("move to", [&] { EXPECT_NE(editor.move_to({3, 1}), ""); });
  is_one_step("turn", [&] { EXPECT_NE(editor.rotate(15, 3), ""); });
  is_one_step("copy", [&] { EXPECT_NE(editor.duplicate(1, 1), ""); });
  is_one_step("delete", [&] { EXPECT_NE(editor.erase(), ""); });
  is_one_step("reverse", [&] { EXPECT_NE(editor.reverse(), ""); });
  is_one_step("line", [&] { EXPECT_NE(editor.add_line({{0, 1}, {1, 1}, {1, 0}}, false, 0), ""); });
  is_one_step("lamp", [&] { EXPECT_NE(editor.add_lamp({1, 1}, Rational(1) / 10), ""); });
  is_one_step("material", [&] {
    EXPECT_EQ(editor.change_material({kRoom, false}, false, [](Material& m) { m.emission = Spectrum::scalar(1); }),
              "white");
  });
  is_one_step("own material", [&] {
    EXPECT_EQ(editor.change_material({kRoom, false}, true, [](Material& m) { m.emission = Spectrum::scalar(1); }),
              "white copy");
  });
  is_one_step("drag", [&] { drag(editor, at(2.5, 1), {{2.5, 1.1}, {2.6, 1.2}, {2.7, 1.3}, {2.8, 1.4}}); });
  EXPECT_EQ(editor.scene(), start);
}

// (1)
TEST(SceneEditor2, WhatChangesNothingIsNoStep) {
  SceneEditor2 editor(small_room());
  const auto start = editor.scene();
  EXPECT_EQ(editor.undo(), "");
  EXPECT_EQ(editor.redo(), "");
  EXPECT_EQ(editor.move_by(1, 1), "");  // nothing is selected
  EXPECT_EQ(editor.move_to({1, 1}), "");
  EXPECT_EQ(editor.rotate(90, 2), "");
  EXPECT_EQ(editor.duplicate(1, 1), "");
  EXPECT_EQ(editor.erase(), "");
  EXPECT_EQ(editor.reverse(), "");
  EXPECT_EQ(editor.add_line({{1, 1}}, false, 0), "");
  EXPECT_EQ(editor.change_material({kRoom, true}, false, [](Material& m) { m.reflectivity = {}; }), "");  // it has none
  EXPECT_EQ(editor.change_material({kRoom, false}, false, [](Material&) {}), "");
  editor.select({kScreen});
  EXPECT_EQ(editor.move_by(0, 0), "");
  EXPECT_EQ(editor.move_to({1, 1}), "");             // there it is
  drag(editor, at(1, 1.5), {});                      // a click
  drag(editor, at(1, 1.5), {{1.5, 1.5}, {1, 1.5}});  // there and back
  editor.press(at(1, 1.5));
  editor.drag(at(2, 2));
  editor.cancel();
  EXPECT_FALSE(editor.press(at(-5, -5)));
  editor.drag(at(2, 2));
  editor.release();
  EXPECT_EQ(editor.scene(), start);
  EXPECT_FALSE(editor.history().can_undo());
  EXPECT_FALSE(editor.history().is_changed());
}

// (1)
TEST(SceneEditor2, NothingElseIsDoneDuringADrag) {
  SceneEditor2 editor(small_room());
  ASSERT_TRUE(editor.press(at(2.5, 1)));
  editor.drag(at(2.5, 1.4));
  ASSERT_TRUE(editor.is_dragging());
  const auto shown = editor.scene();
  EXPECT_EQ(editor.move_by(1, 1), "");
  EXPECT_EQ(editor.rotate(90, 2), "");
  EXPECT_EQ(editor.duplicate(1, 1), "");
  EXPECT_EQ(editor.erase(), "");
  EXPECT_EQ(editor.reverse(), "");
  EXPECT_EQ(editor.add_line({{1, 1}, {2, 2}}, false, 0), "");
  EXPECT_EQ(editor.add_lamp({1, 1}, 1), "");
  EXPECT_EQ(editor.change_material({kRoom, false}, false, [](Material& m) { m.reflectivity = {}; }), "");
  EXPECT_EQ(editor.redo(), "");
  EXPECT_EQ(editor.scene(), shown);
  EXPECT_EQ(editor.undo(), "drag dropped");
  EXPECT_EQ(difference(*editor.scene(), small_room()), "");
}

// (2)
TEST(SceneEditor2, AVertexTakesAlongWhatLiesThere) {
  SceneEditor2 editor(small_room());
  drag(editor, at(2, 1), {{2.2, 0.8}, {1.5, 0.7}});
  const Point2 place{Rational(3) / 2, Rational(7) / 10};
  EXPECT_EQ(editor.scene()->edges[kTable].from, place);
  EXPECT_EQ(editor.scene()->edges[kTable + 3].to, place);
  EXPECT_EQ(editor.selected_vertex(), place);
  EXPECT_THAT(editor.selected(), IsEmpty());
  Scene2 expected = small_room();
  expected.edges[kTable].from = expected.edges[kTable + 3].to = place;
  EXPECT_EQ(difference(*editor.scene(), expected), "");
  EXPECT_EQ(editor.move_by(Rational(1) / 10, 0), "moved a vertex");
  EXPECT_EQ(editor.selected_vertex(), (Point2{Rational(8) / 5, Rational(7) / 10}));
  EXPECT_EQ(steps_back(editor), 2u);
}

// (2)
TEST(SceneEditor2, AloneAVertexIsOneEnd) {
  SceneEditor2 editor(small_room());
  Pointer2 pointer = at(2.02, 1);  // nearer to the lower edge of the table
  pointer.alone = true;
  drag(editor, pointer, {{2.5, 0.5}});
  int moved = 0;
  const Scene2 before = small_room();
  for (const std::uint32_t s : {kTable, kTable + 3}) {
    const auto found = std::ranges::find(editor.scene()->surfaces, before.surfaces[s].name, &Surface::name);
    moved += found == editor.scene()->surfaces.end() ||
                     !(editor.scene()->edges[static_cast<std::size_t>(found - editor.scene()->surfaces.begin())] ==
                       before.edges[s])
                 ? 1
                 : 0;
  }
  EXPECT_EQ(moved, 1);
}

// (2): the end of one edge that touches the middle of another one, which is nearer.
TEST(SceneEditor2, AloneAVertexIsAnEndThatLiesThere) {
  const Scene2 touching = move_end(small_room(), kScreen, false, {1, 0});
  SceneEditor2 editor(touching);
  Pointer2 pointer = at(1.04, 0.01);
  pointer.alone = true;
  ASSERT_NE(editor.pick(pointer).surface, kScreen);
  drag(editor, pointer, {{1.54, 0.51}});
  EXPECT_EQ(difference(*editor.scene(), move_end(touching, kScreen, false, {Rational(3) / 2, Rational(1) / 2})), "");
}

// (3)
TEST(SceneEditor2, AnEdgeTakesAlongTheEndsOfItsNeighbours) {
  SceneEditor2 editor(small_room());
  drag(editor, at(2.5, 1), {{2.5, 0.75}});  // the lower edge of the table
  Scene2 expected = small_room();
  const Rational low = Rational(3) / 4;
  expected.edges[kTable] = {{2, low}, {3, low}};
  expected.edges[kTable + 1].from = {3, low};
  expected.edges[kTable + 3].to = {2, low};
  EXPECT_EQ(difference(*editor.scene(), expected), "");
  EXPECT_THAT(selected_names(editor), ElementsAre("table[0]"));
}

// The table pushed against the screen, which then shares its left edge's ends.
Scene2 room_with_touching_table() {
  Scene2 scene = small_room();
  return move_end(move_end(scene, kScreen, false, {2, 1}), kScreen, true, {2, 2});
}

// (3)
TEST(SceneEditor2, AWholeGroupPartsFromWhatItTouches) {
  for (const Place2& hold : {Place2{2.5, 1.0}, Place2{3, 1}, Place2{3, 2}}) {
    SceneEditor2 editor(room_with_touching_table());
    editor.select({kTable});
    editor.select_groups();
    ASSERT_EQ(editor.selected().size(), 4u);
    drag(editor, at(hold[0], hold[1]), {{hold[0] + 0.25, hold[1]}});
    Scene2 expected = room_with_touching_table();
    for (std::uint32_t s = kTable; s < kTable + 4; ++s)
      for (Point2* end : {&expected.edges[s].from, &expected.edges[s].to}) end->x += Rational(1) / 4;
    EXPECT_EQ(difference(*editor.scene(), expected), "") << hold[0];  // the screen stays
    EXPECT_EQ(editor.selected().size(), 4u);
  }
  // Three edges of the table are no whole group: the screen goes with them.
  SceneEditor2 editor(room_with_touching_table());
  editor.select({kTable, kTable + 1, kTable + 2});
  EXPECT_NE(editor.move_by(Rational(1) / 4, 0), "");
  EXPECT_EQ(editor.scene()->edges[kScreen], (Edge2{{Rational(9) / 4, 1}, {Rational(9) / 4, 2}}));
}

// (3)
TEST(SceneEditor2, AloneAnEdgePartsFromItsNeighbours) {
  SceneEditor2 editor(small_room());
  Pointer2 pointer = at(2.5, 1);
  pointer.alone = true;
  drag(editor, pointer, {{2.5, 0.75}});
  const auto& scene = *editor.scene();
  ASSERT_EQ(editor.selected().size(), 1u);
  EXPECT_EQ(scene.edges[editor.selected()[0]], (Edge2{{2, Rational(3) / 4}, {3, Rational(3) / 4}}));
  int there = 0;
  for (const Edge2& edge : scene.edges) there += edge == Edge2{{3, 1}, {3, 2}} || edge == Edge2{{2, 2}, {2, 1}} ? 1 : 0;
  EXPECT_EQ(there, 2);
}

// (4)
TEST(SceneEditor2, WhatIsDraggedComesToLieOnASnappedPlace) {
  std::mt19937_64 random(9);
  const auto draw = [&](double most) { return static_cast<double>(random() % 1000) / 1000 * most; };
  for (int k = 0; k < 300; ++k) {
    SceneEditor2 editor(small_room());
    const Scene2 before = *editor.scene();
    const Place2 hold{2 + draw(1), 1 + draw(0.08)};  // at the lower edge of the table
    Pointer2 pointer = at(hold[0], hold[1]);
    pointer.alone = random() % 2 == 0;
    ASSERT_TRUE(editor.press(pointer));
    const Pick2 found = editor.pick(pointer);
    const Edge2 edge = before.edges[*found.surface];
    const bool is_vertex = found.vertex.has_value();
    const Point2 anchor = is_vertex ? *found.vertex : found.is_last ? edge.to : edge.from;
    pointer.place = {draw(4), draw(3)};
    editor.drag(pointer);
    // In the order of the editor: rounding decides where two decimals are equally near.
    const Place2 target{pointer.place[0] + (to_double(anchor.x) - hold[0]),
                        pointer.place[1] + (to_double(anchor.y) - hold[1])};
    std::vector<std::uint32_t> moved;
    if (pointer.alone) {
      moved = {*found.surface};
    } else {
      for (std::uint32_t s = 0; s < before.edges.size(); ++s)
        for (const Point2& end : {before.edges[s].from, before.edges[s].to})
          if (end == anchor || (!is_vertex && (end == edge.from || end == edge.to))) moved.push_back(s);
    }
    if (is_vertex && pointer.alone) continue;  // which of two ends: above
    const Point2 expected = snapped(before, target, {.decimals = 2, .reach = 0.1, .moved = moved}).at;
    bool is_there = false;
    for (const Edge2& now : editor.scene()->edges) is_there = is_there || now.from == expected || now.to == expected;
    EXPECT_TRUE(is_there) << k << " " << to_double(expected.x) << " " << to_double(expected.y);
    if (is_vertex) {
      EXPECT_EQ(editor.selected_vertex(), expected);
    }
  }
}

// (4): the way does not matter, only where it ends.
TEST(SceneEditor2, ADragIsOfTheSceneInWhichItBegan) {
  SceneEditor2 there(small_room()), straight(small_room());
  drag(there, at(2, 1), {{0.2, 2.9}, {3.9, 0.6}, {1, 1.5}, {1.2, 0.4}});
  drag(straight, at(2, 1), {{1.2, 0.4}});
  EXPECT_EQ(difference(*there.scene(), *straight.scene()), "");
}

// (5)
TEST(SceneEditor2, TheSelectionIsKeptByNames) {
  SceneEditor2 editor(small_room());
  editor.select({kTable + 1, kTable + 2});
  const auto names = selected_names(editor);
  editor.move_by(Rational(1) / 10, 0);
  EXPECT_EQ(selected_names(editor), names);
  editor.undo();
  EXPECT_EQ(selected_names(editor), names);
  editor.redo();
  EXPECT_EQ(selected_names(editor), names);
  editor.add_lamp({1, Rational(1) / 2}, Rational(1) / 10);  // the lamp is selected now
  EXPECT_THAT(selected_names(editor), testing::Each(testing::StartsWith("lamp 1")));
  editor.undo();
  EXPECT_THAT(editor.selected(), IsEmpty());  // what was added is gone
  editor.select({kScreen, kTable});
  editor.erase();
  EXPECT_THAT(editor.selected(), IsEmpty());
  editor.undo();
  for (const std::uint32_t s : editor.selected()) EXPECT_LT(s, editor.scene()->surfaces.size());
}

// (5): counted anew, as after a polyline has fallen apart.
TEST(SceneEditor2, TheSelectionOutlivesAnotherOrder) {
  SceneEditor2 editor(small_room());
  editor.select({kTable + 1});  // one side of the table by itself: its polyline falls apart
  Pointer2 pointer = at(3, 1.5);
  pointer.alone = true;
  drag(editor, pointer, {{3.5, 1.5}});
  EXPECT_THAT(selected_names(editor), ElementsAre("table[1]"));
  EXPECT_EQ(editor.scene()->edges[editor.selected()[0]].from.x, Rational(7) / 2);
  EXPECT_NE(editor.selected()[0], kTable + 1);
  editor.undo();
  EXPECT_THAT(selected_names(editor), ElementsAre("table[1]"));
  EXPECT_THAT(editor.selected(), ElementsAre(kTable + 1));
}

// (6)
TEST(SceneEditor2, AnInvalidSceneIsShownAndMended) {
  SceneEditor2 editor(small_room());
  drag(editor, at(1, 1), {{1, 2}});  // the screen has no length now
  EXPECT_EQ(editor.scene()->edges[kScreen].from, editor.scene()->edges[kScreen].to);
  EXPECT_THROW(validate(*editor.scene()), std::runtime_error);
  EXPECT_TRUE(editor.history().is_changed());
  Pointer2 pointer = at(1, 2);
  pointer.alone = true;
  drag(editor, pointer, {{1, 1}});
  EXPECT_NO_THROW(validate(*editor.scene()));
  editor.undo();
  editor.undo();
  EXPECT_EQ(difference(*editor.scene(), small_room()), "");
}

TEST(SceneEditor2, ClicksSelect) {
  SceneEditor2 editor(small_room());
  drag(editor, at(2.5, 1), {});
  EXPECT_THAT(editor.selected(), ElementsAre(kTable));
  Pointer2 adds = at(1, 1.5);
  adds.adds = true;
  drag(editor, adds, {});
  EXPECT_THAT(editor.selected(), ElementsAre(kScreen, kTable));
  drag(editor, adds, {});
  EXPECT_THAT(editor.selected(), ElementsAre(kTable));
  Pointer2 whole = at(2, 3);
  whole.is_whole = true;
  drag(editor, whole, {});
  EXPECT_THAT(editor.selected(), ElementsAre(1, 2, 3, 4));
  whole.adds = true;
  whole.place = {2.5, 1};
  drag(editor, whole, {});
  EXPECT_EQ(editor.selected().size(), 8u);
  drag(editor, whole, {});
  EXPECT_THAT(editor.selected(), ElementsAre(1, 2, 3, 4));
  editor.select_in({1.9, 0.9}, {3.1, 2.1}, false);
  EXPECT_THAT(editor.selected(), ElementsAre(7, 8, 9, 10));
  editor.select_in({1.1, 2.1}, {0.9, 0.9}, true);
  EXPECT_THAT(editor.selected(), ElementsAre(0, 7, 8, 9, 10));
  editor.select_all();
  EXPECT_EQ(editor.selected().size(), small_room().surfaces.size());
  editor.select_none();
  EXPECT_THAT(editor.selected(), IsEmpty());
}

// What else changes the scene while a button is down takes what was held out of the hand.
TEST(SceneEditor2, NothingIsHeldOnceSomethingElseHasChangedTheScene) {
  for (int what = 0; what < 4; ++what) {
    SceneEditor2 editor(small_room());
    editor.add_lamp({1, Rational(1) / 2}, Rational(1) / 10);
    if (what == 1) editor.undo();
    Pointer2 pointer = at(2.5, 1);
    pointer.alone = true;
    editor.select({kTable, kTable + 1});
    ASSERT_TRUE(editor.press(pointer));
    if (what == 0) editor.undo();
    if (what == 1) editor.redo();
    if (what == 2) {
      EXPECT_NE(editor.erase(), "");
    }
    if (what == 3) {
      Scene2 one = small_room();
      editor.replace(erase_surfaces(one, std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    }
    const auto scene = editor.scene();
    pointer.place = {3, 3};
    editor.drag(pointer);
    editor.release();
    EXPECT_EQ(editor.scene(), scene) << what;
    EXPECT_FALSE(editor.is_dragging());
  }
}

TEST(SceneEditor2, AnotherSceneHasNoHistory) {
  SceneEditor2 editor(small_room());
  editor.select({kTable});
  editor.move_by(1, 0);
  const std::uint64_t version = editor.version();
  editor.replace(small_room());
  EXPECT_GT(editor.version(), version);
  EXPECT_FALSE(editor.history().is_changed());
  EXPECT_FALSE(editor.history().can_undo());
  EXPECT_THAT(editor.selected(), IsEmpty());
  EXPECT_EQ(editor.pick(at(2.5, 1)).surface, kTable);
}

// Hands at random: whatever they do, all that is told of the editor is of its scene.
TEST(SceneEditor2, HandsAtRandomLeaveItConsistent) {
  std::mt19937_64 random(2026);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  SceneEditor2 editor(small_room());
  for (int k = 0; k < 4000; ++k) {
    if (editor.scene()->surfaces.size() > 60 || editor.scene()->surfaces.size() < 4) editor.replace(small_room());
    Pointer2 pointer = at(static_cast<double>(below(500)) / 100 - 0.5, static_cast<double>(below(400)) / 100 - 0.5);
    pointer.adds = below(5) == 0;
    pointer.alone = below(3) == 0;
    pointer.is_whole = below(4) == 0;
    switch (below(14)) {
      case 0:
        editor.press(pointer);
        break;
      case 1:
      case 2:
      case 3:
        editor.drag(pointer);
        break;
      case 4:
        editor.release();
        break;
      case 5:
        editor.cancel();
        break;
      case 6:
        editor.undo();
        break;
      case 7:
        editor.redo();
        break;
      case 8:
        editor.duplicate(Rational(1) / 4, 0);
        break;
      case 9:
        editor.erase();
        break;
      case 10:
        editor.reverse();
        break;
      case 11:
        below(2) == 0 ? editor.select_groups() : editor.select_none();
        break;
      case 12:
        editor.rotate(static_cast<long>(below(8)) * 45, 3);
        break;
      default:
        editor.move_by(Rational(static_cast<long>(below(9))) / 10, 0);
        break;
    }
    for (const std::uint32_t s : editor.selected()) ASSERT_LT(s, editor.scene()->surfaces.size()) << k;
    ASSERT_TRUE(std::ranges::is_sorted(editor.selected()));
    const Pick2 found = editor.pick(pointer);
    if (found.surface) {
      ASSERT_LT(*found.surface, editor.scene()->surfaces.size());
    }
  }
}

}  // namespace
}  // namespace hottel::scene_editor_test

// Lights of the plane under a hand.
#include "viewer/edit/plane/light_handles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/scene/scene_json.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/plane/scene_editor.h"

namespace hottel::light_handles_test {
namespace {

constexpr double kReach = 0.1, kArm = 0.5;

// A room with a spot that shines to the right, and a bulb that walks.
Scene2 lit_room() {
  SceneBuilder2 builder;
  builder.add_material("white", {.reflectivity = "0.7"});
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  Scene2 scene = builder.build();
  Light spot{.name = "spot", .type = LightType::kSpot, .focus = 30, .power = {}};
  spot.power = Spectrum::scalar(3);
  scene.add_light(spot, {.position = {1, 1}, .direction = {2, 0}, .path = {}});
  Light bulb{.name = "bulb", .power = {}};
  bulb.power = Spectrum::scalar(1);
  scene.add_light(bulb, {.position = {2, 1}, .path = LightPath2{.points = {{2, 1}, {3, 1}}, .seconds = 4}});
  return scene;
}

Pointer2 at(double x, double y) { return {.place = {x, y}, .reach = kReach, .arm = kArm, .decimals = 2}; }

void drag(SceneEditor2& editor, const Pointer2& from, const Pointer2& to) {
  ASSERT_TRUE(editor.press(from));
  editor.drag(to);
  editor.release();
}

TEST(LightHandles2, AreWhereTheAxisAndTheBordersOfTheBeamPass) {
  const LightShape2 shape = light_shape(lit_room(), 0, kArm);
  EXPECT_TRUE(shape.is_spot);
  EXPECT_NEAR(shape.axis[0], 1.5, 1e-12);
  EXPECT_NEAR(shape.left[1], 1 + 0.5 * std::sin(M_PI / 6), 1e-12);
  EXPECT_NEAR(shape.right[1], 1 - 0.5 * std::sin(M_PI / 6), 1e-12);
  EXPECT_FALSE(light_shape(lit_room(), 1, kArm).is_spot);
}

TEST(LightHandles2, ArePickedNearestFirst) {
  const Scene2 scene = lit_room();
  const auto hold = [](std::uint32_t light, LightPart part) { return std::optional(LightHold{light, part}); };
  EXPECT_EQ(pick_light(scene, {1.02, 1}, kReach, kArm), hold(0, LightPart::kPlace));
  EXPECT_EQ(pick_light(scene, {1.5, 1}, kReach, kArm), hold(0, LightPart::kAxis));
  EXPECT_EQ(pick_light(scene, {1.43, 1.25}, kReach, kArm), hold(0, LightPart::kLeft));
  EXPECT_EQ(pick_light(scene, {1.43, 0.75}, kReach, kArm), hold(0, LightPart::kRight));
  EXPECT_EQ(pick_light(scene, {2, 0.95}, kReach, kArm), hold(1, LightPart::kPlace));
  EXPECT_EQ(pick_light(scene, {1.75, 1.5}, kReach, kArm), std::nullopt);
  EXPECT_EQ(pick_light(scene, {2, 1}, kReach, 1.0), hold(1, LightPart::kPlace));  // before the other one's axis
}

// (1)
TEST(LightHandles2, ASunHasNoneAndTurns) {
  Scene2 scene = lit_room();
  scene.lights[1].type = LightType::kSun;
  scene.light_places[1] = {.position = {2, Rational(19, 20)}, .direction = {0, -1}};
  EXPECT_EQ(pick_light(scene, {2, 0.95}, kReach, kArm), std::nullopt);
  EXPECT_EQ(turn_light(scene, 1, 90).light_places[1].direction, (Point2{1, 0}));
}

TEST(LightHandles2, TakeThePathAlong) {
  SceneEditor2 editor(lit_room());
  drag(editor, at(2.01, 1), at(2.51, 1.25));
  const LightPlace2& place = editor.scene()->light_places[1];
  EXPECT_EQ(place.position, (Point2{Rational(5, 2), Rational(5, 4)}));
  EXPECT_EQ(place.path->points.back(), (Point2{Rational(7, 2), Rational(5, 4)}));
}

// (2)
TEST(LightHandles2, TurnTheAxisExactlyToThePlace) {
  const Scene2 scene = lit_room();
  EXPECT_EQ(drag_light(scene, {0, LightPart::kAxis}, {1.254, 0.75}, 2).light_places[0].direction,
            (Point2{Rational(1, 4), Rational(-1, 4)}));
  EXPECT_EQ(drag_light(scene, {0, LightPart::kAxis}, {1.001, 1}, 2).light_places, scene.light_places);
}

// (3)
TEST(LightHandles2, FocusInWholeDegrees) {
  Scene2 scene = lit_room();
  const auto focus = [&](const Place2& to) { return drag_light(scene, {0, LightPart::kLeft}, to, 4).lights[0].focus; };
  EXPECT_EQ(focus({1.5, 1.5}), 45);
  EXPECT_EQ(focus({1.5, 0.5}), 45);
  EXPECT_EQ(focus({0.5, 1}), 180);
  EXPECT_EQ(focus({1.5, 1.001}), 1);
  scene.lights[0].falloff = 1;
  EXPECT_EQ(focus({0.5, 1}), 90);
}

// (4)
TEST(LightHandles2, TurnByQuartersExactly) {
  Scene2 scene = lit_room();
  scene.light_places[0].direction = {Rational(1, 3), Rational(1, 7)};
  EXPECT_EQ(turn_light(scene, 0, 90).light_places[0].direction, (Point2{Rational(-1, 7), Rational(1, 3)}));
  const Point2 turned = turn_light(scene, 0, 15).light_places[0].direction;
  EXPECT_NEAR(std::atan2(to_double(turned.y), to_double(turned.x)), std::atan2(3, 7) + M_PI / 12, 1e-5);
  EXPECT_EQ(Rational(turned.x * 1000000).get_den(), 1);
  EXPECT_EQ(turn_light(scene, 1, 15).light_places, scene.light_places);
}

// SceneEditor2 (1), (5) and (7).
TEST(SceneEditor2Lights, EveryEditIsOneStepAndSelectsTheLight) {
  SceneEditor2 editor(lit_room());
  const auto is_one_step = [&](const char* what, const auto& edit) {
    SCOPED_TRACE(what);
    ASSERT_TRUE(editor.press(at(1, 1)));
    editor.release();
    EXPECT_EQ(editor.selected_light(), 0u);
    const auto before = editor.scene();
    edit();
    EXPECT_NE(editor.scene(), before);
    EXPECT_NE(editor.undo(), "");
    EXPECT_EQ(editor.scene(), before);
    EXPECT_FALSE(editor.history().can_undo());
  };
  is_one_step("drag", [&] { drag(editor, at(1, 1), at(1.2, 1.1)); });
  is_one_step("axis", [&] { drag(editor, at(1.5, 1), at(1.5, 1.5)); });
  is_one_step("border", [&] { drag(editor, at(1.43, 1.25), at(1.3, 1.4)); });
  is_one_step("nudge", [&] { EXPECT_EQ(editor.move_by(Rational(1, 10), 0), "moved spot"); });
  is_one_step("place", [&] { EXPECT_EQ(editor.move_to({1, Rational(6, 5)}), "moved spot"); });
  is_one_step("turn", [&] { EXPECT_EQ(editor.rotate(15, 2), "turned spot"); });
  is_one_step("copy", [&] {
    EXPECT_EQ(editor.duplicate(Rational(1, 4), 0), "copied spot copy");
    EXPECT_EQ(editor.selected_light(), 2u);
  });
  is_one_step("delete", [&] {
    EXPECT_EQ(editor.erase(), "deleted spot");
    EXPECT_FALSE(editor.selected_light());
  });
  is_one_step("add", [&] { EXPECT_EQ(editor.add_light({2, Rational(1, 2)}), "added light 1"); });
  is_one_step("change", [&] { EXPECT_EQ(editor.change_light(0, editor.scene()->lights[0], 30), "changed spot"); });
}

TEST(SceneEditor2Lights, ALightIsTouchedBeforeAnEdgeAndEitherIsSelected) {
  Scene2 scene = lit_room();
  const Point2& corner = scene.edges[1].from;
  scene.light_places[0].position = {corner.x + Rational(1, 20), corner.y + Rational(1, 20)};
  const Place2 there = to_doubles(corner);
  SceneEditor2 editor(scene);
  editor.select({1, 2});
  ASSERT_TRUE(editor.press(at(there[0], there[1])));
  editor.release();
  EXPECT_EQ(editor.selected_light(), 0u);
  EXPECT_TRUE(editor.selected().empty());
  editor.select({1});
  EXPECT_FALSE(editor.selected_light());
}

TEST(SceneEditor2Lights, WhatChangesNothingIsNoStep) {
  SceneEditor2 editor(lit_room());
  drag(editor, at(1.01, 1), at(1.011, 1));
  EXPECT_EQ(editor.change_light(0, editor.scene()->lights[0], {}), "");
  EXPECT_FALSE(editor.history().can_undo());
}

// What is saved is what is seen.
TEST(SceneEditor2Lights, AreReadAgainAsTheyAreWritten) {
  SceneEditor2 editor(lit_room());
  editor.add_light({Rational(1, 2), Rational(3, 2)});
  ASSERT_TRUE(editor.press(at(1, 1)));
  editor.release();
  editor.rotate(15, 2);
  const Scene2 read = parse_scene_2(write_scene_2(*editor.scene()), "room.json");
  EXPECT_EQ(read.light_places, editor.scene()->light_places);
  ASSERT_EQ(read.lights.size(), 3u);
  EXPECT_EQ(read.lights[2].name, "light 1");
}

}  // namespace
}  // namespace hottel::light_handles_test

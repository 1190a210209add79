// The lights of a scene in space, edited.
#include "viewer/edit/space/scene_editor.h"

#include <gtest/gtest.h>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "viewer/edit/space/light_region.h"

namespace hottel::scene_editor_test {
namespace {

// A floor, a wall behind it, a spot above the floor and a bulb.
constexpr const char* kStage = R"({"hottel": 1, "dimension": 3, "about": "a stage",
  "materials": {"white": {"reflectivity": 0.5}, "red": {"reflectivity": [0.5, 0.1, 0.1]}},
  "polygons": [
    {"name": "floor", "points": [[-2,0,-1],[2,0,-1],[2,4,-1],[-2,4,-1]], "material": "white"},
    {"name": "wall", "points": [[-2,4,-1],[2,4,-1],[2,4,2],[-2,4,2]], "material": "red"}],
  "lights": [
    {"type": "spot", "name": "spot", "position": [0, 2, 0], "direction": [1, 0, 0], "focus": 30, "power": 3},
    {"type": "point", "name": "bulb", "position": [-1, 2, 0], "power": [1, 1, 2]}],
  "expect": []})";

std::string may_be(const Scene3& scene, std::uint32_t light, const Point3* before) {
  const Solids3 solids(scene);
  return light_refusal(scene, light, solids, before);
}

SceneEditor3 editor() { return {parse_scene_3(kStage, "stage.json"), may_be}; }

Pointer3 at(const Direction3& place) {
  Pointer3 pointer{.pixel = 0.01, .reach = 9, .arm = 50};
  pointer.at = pointer.seen(place);
  return pointer;
}

void drag(SceneEditor3& editor, const Direction3& from, const Direction3& to) {
  ASSERT_TRUE(editor.press(at(from)));
  editor.drag(at(to));
  editor.release();
}

// (1)
TEST(SceneEditor3, EveryEditIsOneStepAndSelectsTheLight) {
  SceneEditor3 editor = scene_editor_test::editor();
  const auto is_one_step = [&](const char* what, const auto& edit) {
    SCOPED_TRACE(what);
    editor.select_light(0);
    const auto before = editor.scene();
    edit();
    EXPECT_NE(editor.scene(), before);
    EXPECT_EQ(editor.refusal(), "");
    EXPECT_NE(editor.undo(), "");
    EXPECT_EQ(editor.scene(), before);
    EXPECT_FALSE(editor.history().can_undo());
    EXPECT_NE(editor.redo(), "");
    EXPECT_NE(editor.undo(), "");
  };
  is_one_step("drag", [&] { drag(editor, {0, 2, 0}, {0.2, 2, 0.1}); });
  is_one_step("axis", [&] { drag(editor, {1, 2, 0}, {0.6, 2, 0.6}); });
  is_one_step("border", [&] { drag(editor, {0.866, 2, 0.5}, {0.5, 2, 0.8}); });
  is_one_step("place", [&] { EXPECT_EQ(editor.move_to({1, Rational(6, 5), 0}), "moved spot"); });
  is_one_step("turn", [&] { EXPECT_EQ(editor.rotate(15), "turned spot"); });
  is_one_step("copy", [&] {
    EXPECT_EQ(editor.duplicate({Rational(1, 4), 0, 0}), "copied spot copy");
    EXPECT_EQ(editor.selected_light(), 2u);
  });
  is_one_step("delete", [&] {
    EXPECT_EQ(editor.erase(), "deleted spot");
    EXPECT_FALSE(editor.selected_light());
  });
  is_one_step("add", [&] { EXPECT_EQ(editor.add_light({1, 1, 1}), "added light 1"); });
  is_one_step("change", [&] {
    EXPECT_EQ(editor.change_light(0, editor.scene()->lights[0], {0, 0, 30}), "changed spot");
  });
  is_one_step("material", [&] {
    std::vector<Material> materials = editor.scene()->materials;
    materials[0].reflectivity = Spectrum::scalar(Rational(1, 4));
    EXPECT_EQ(editor.change_materials(materials, "change white"), "change white");
  });
}

TEST(SceneEditor3, WhatChangesNothingIsNoStep) {
  SceneEditor3 editor = scene_editor_test::editor();
  drag(editor, {0, 2, 0}, {0.001, 2, 0});
  EXPECT_EQ(editor.change_light(0, editor.scene()->lights[0], {}), "");
  EXPECT_EQ(editor.change_materials(editor.scene()->materials, "change"), "");
  EXPECT_EQ(editor.move_to({0, 2, 0}), "");
  EXPECT_FALSE(editor.press(at({0, 2, 1.5})));
  editor.drag(at({0, 2, 0}));
  editor.release();
  EXPECT_FALSE(editor.history().can_undo());
}

TEST(SceneEditor3, ADragThatIsDroppedChangesNothing) {
  SceneEditor3 editor = scene_editor_test::editor();
  const auto before = editor.scene();
  for (const bool by_undo : {false, true}) {
    ASSERT_TRUE(editor.press(at({0, 2, 0})));
    editor.drag(at({0.5, 2, 0}));
    EXPECT_NE(editor.scene(), before);
    EXPECT_EQ(editor.rotate(15), "");
    if (by_undo)
      EXPECT_EQ(editor.undo(), "drag dropped");
    else
      editor.cancel();
    EXPECT_EQ(editor.scene(), before);
    editor.drag(at({0.5, 2, 0}));  // nothing is held
    EXPECT_EQ(editor.scene(), before);
  }
}

// (2)
TEST(SceneEditor3, LightsStayWhereTheyWereAndItIsSaidWhy) {
  SceneEditor3 editor = scene_editor_test::editor();
  ASSERT_TRUE(editor.press(at({0, 2, 0})));
  editor.drag(at({0, 2, -0.5}));
  const auto good = editor.scene();
  editor.drag(at({0, 2, -1}));
  EXPECT_EQ(editor.refusal(), "spot lies on the surface 'floor'; a light has to be beside it");
  EXPECT_EQ(editor.scene(), good);
  editor.drag(at({0, 2, -1.5}));  // beyond, in the open
  EXPECT_EQ(editor.refusal(), "");
  editor.drag(at({0, 2, -1}));
  editor.release();
  EXPECT_EQ(editor.scene()->light_places[0].position, (Point3{0, 2, Rational(-3, 2)}));
  const auto before = editor.scene();
  EXPECT_EQ(editor.move_to({1, 4, 0}), "");
  EXPECT_NE(editor.refusal(), "");
  EXPECT_EQ(editor.add_light({1, 4, 0}), "");
  EXPECT_NE(editor.refusal(), "");
  EXPECT_EQ(editor.duplicate({0, 0, Rational(1, 2)}), "");
  EXPECT_NE(editor.refusal(), "");
  EXPECT_EQ(editor.scene(), before);
}

// (3)
TEST(SceneEditor3, KeepsTheSelectionByItsName) {
  SceneEditor3 editor = scene_editor_test::editor();
  editor.select_light(0);
  editor.erase();
  editor.select_light(0);
  editor.undo();
  EXPECT_EQ(editor.selected_light(), 1u);  // the bulb
  editor.redo();
  EXPECT_EQ(editor.selected_light(), 0u);
  editor.undo();
  editor.select_light(0);
  editor.redo();
  EXPECT_FALSE(editor.selected_light());
}

// What is saved is what is seen.
TEST(SceneEditor3, WhatIsEditedIsReadAgainAsItIsWritten) {
  SceneEditor3 editor = scene_editor_test::editor();
  drag(editor, {0, 2, 0}, {0.333, 2, 0.1});
  drag(editor, {1.333, 2, 0.1}, {0.7, 2, 0.6});
  editor.change_light(1, editor.scene()->lights[1], {0, 0, 30});
  editor.add_light({Rational(1, 3), 1, 1});
  const Scene3& now = *editor.scene();
  const Scene3 read = parse_scene_3(write_scene_3(now), "stage.json");
  EXPECT_EQ(read.light_places[0], now.light_places[0]);
  EXPECT_EQ(read.light_places[2], now.light_places[2]);
  EXPECT_EQ(read.lights.size(), 3u);
  EXPECT_EQ(read.about, "a stage");
  EXPECT_EQ(read.polygons, now.polygons);
  EXPECT_EQ(read.materials.size(), now.materials.size());
}

}  // namespace
}  // namespace hottel::scene_editor_test

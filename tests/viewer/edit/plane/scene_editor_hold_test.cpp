// A button that is held while keys change the scene.
#include <gmock/gmock.h>

#include "io/scene/scene_json.h"
#include "viewer/edit/plane/scene_editor.h"

namespace hottel::scene_editor_hold_test {
namespace {

constexpr const char* kScene = R"({
  "hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1}},
  "edges": [{"name": "a", "points": [[0, 0], [1, 0]], "material": "m"}]
})";

TEST(SceneEditorHold2, WhatWasUndoneIsNotDragged) {
  SceneEditor2 editor(parse_scene_2(kScene, "scene.json"));
  editor.add_lamp({5, 5}, 1);
  ASSERT_TRUE(editor.press({.place = {6, 6}, .reach = 0.1, .alone = true}));
  editor.undo();
  editor.drag({.place = {7, 7}, .reach = 0.1});
  EXPECT_FALSE(editor.is_dragging());
  editor.release();
  EXPECT_EQ(editor.scene()->edges.size(), 1u);
  EXPECT_FALSE(editor.history().is_changed());
}

TEST(SceneEditorHold2, WhatWasReadAgainIsNotDragged) {
  SceneEditor2 editor(parse_scene_2(kScene, "scene.json"));
  editor.add_lamp({5, 5}, 1);
  ASSERT_TRUE(editor.press({.place = {6, 6}, .reach = 0.1, .alone = true}));
  editor.drag({.place = {7, 7}, .reach = 0.1});
  EXPECT_TRUE(editor.is_dragging());
  editor.replace(parse_scene_2(kScene, "scene.json"));
  editor.drag({.place = {8, 8}, .reach = 0.1});
  EXPECT_FALSE(editor.is_dragging());
  EXPECT_EQ(editor.scene()->edges.size(), 1u);
}

}  // namespace
}  // namespace hottel::scene_editor_hold_test

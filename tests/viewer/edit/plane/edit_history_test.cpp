#include "viewer/edit/edit_history.h"

#include <gtest/gtest.h>

#include "kernel/support/failure.h"
#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::edit_history_test {
namespace {

using EditHistory2 = EditHistory<Scene2>;

// A scene that is told from others by its text.
Scene2 scene_about(const std::string& about) {
  Scene2 scene;
  scene.about = about;
  return scene;
}

TEST(EditHistory2, UndoAndRedoBringBackTheVerySameScene) {
  EditHistory2 history(scene_about("0"));
  std::vector<EditHistory2::ScenePointer> scenes{history.scene()};
  for (const char* step : {"1", "2", "3"}) {
    history.set(scene_about(step), step);
    scenes.push_back(history.scene());
  }
  for (std::size_t k = 3; k > 0; --k) {
    EXPECT_EQ(history.scene(), scenes[k]);
    EXPECT_EQ(history.what_undo(), std::to_string(k));
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.what_redo(), std::to_string(k));
  }
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(history.what_undo(), "");
  for (std::size_t k = 1; k <= 3; ++k) {
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(history.scene(), scenes[k]);
  }
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.what_redo(), "");
}

TEST(EditHistory2, ANewStepForgetsThoseThatWereUndone) {
  EditHistory2 history(scene_about("0"));
  history.set(scene_about("1"), "one");
  history.undo();
  history.set(scene_about("2"), "two");
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.what_undo(), "two");
  history.undo();
  EXPECT_EQ(history.scene()->about, "0");
}

TEST(EditHistory2, ADragIsOneStep) {
  EditHistory2 history(scene_about("0"));
  history.begin("drag");
  for (const char* about : {"a", "b", "c"}) {
    history.preview(scene_about(about));
    EXPECT_EQ(history.scene()->about, about);
    EXPECT_EQ(history.scene_before_drag()->about, "0");
    EXPECT_TRUE(history.is_changed());
  }
  const EditHistory2::ScenePointer last = history.scene();
  history.commit();
  EXPECT_EQ(history.scene(), last);
  EXPECT_EQ(history.what_undo(), "drag");
  history.undo();
  EXPECT_EQ(history.scene()->about, "0");
  EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory2, CancelAndUndoOfADragLeaveNoStep) {
  EditHistory2 history(scene_about("0"));
  history.set(scene_about("1"), "one");
  history.undo();
  for (const bool by_undo : {false, true}) {
    history.begin("drag");
    history.preview(scene_about("a"));
    EXPECT_EQ(history.what_undo(), "drag");
    EXPECT_FALSE(history.redo());
    if (by_undo)
      EXPECT_TRUE(history.undo());
    else
      history.cancel();
    EXPECT_EQ(history.scene()->about, "0");
    EXPECT_FALSE(history.is_dragging());
    EXPECT_FALSE(history.can_undo());
    EXPECT_TRUE(history.can_redo());
  }
  history.begin("nothing");
  history.commit();
  EXPECT_FALSE(history.can_undo());
  EXPECT_TRUE(history.can_redo());
}

TEST(EditHistory2, IsUnchangedWhereItWasSaved) {
  EditHistory2 history(scene_about("0"));
  EXPECT_FALSE(history.is_changed());
  history.set(scene_about("1"), "one");
  EXPECT_TRUE(history.is_changed());
  history.undo();
  EXPECT_FALSE(history.is_changed());
  history.redo();
  history.mark_saved();
  EXPECT_FALSE(history.is_changed());
  history.undo();
  EXPECT_TRUE(history.is_changed());
  history.redo();
  EXPECT_FALSE(history.is_changed());
}

TEST(EditHistory2, ForgetsTheOldest) {
  EditHistory2 history(scene_about("0"));
  for (int k = 1; k <= 1000; ++k) history.set(scene_about(std::to_string(k)), "step");
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, EditHistory2::kMostSteps);
  EXPECT_EQ(history.scene()->about, "700");
  EXPECT_EQ(history.what_undo(), "");
  EXPECT_TRUE(history.is_changed());
}

TEST(EditHistory2, KeepsFewerLargeScenesButSome) {
  const auto undo_all = [](std::size_t surfaces) {
    Scene2 scene;
    scene.surfaces.resize(surfaces);
    EditHistory2 history(scene);
    for (int k = 0; k < 60; ++k) history.set(scene, "step");
    std::size_t undone = 0;
    while (history.undo()) ++undone;
    return undone;
  };
  EXPECT_EQ(undo_all(10'000), 39u);  // 40 states
  EXPECT_EQ(undo_all(50'000), EditHistory2::kLeastSteps);
}

TEST(EditHistory2, CountsNoSurfacesOfStepsThatAreForgotten) {
  Scene2 scene;
  scene.surfaces.resize(10'000);
  EditHistory2 history(scene);
  for (int k = 0; k < 25; ++k) history.set(scene, "step");
  for (int k = 0; k < 60; ++k) {
    history.undo();
    history.set(scene, "step");
  }
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, 25u);
}

TEST(EditHistory2, RefusesDragsThatAreNoneOrTwo) {
  EditHistory2 history(scene_about("0"));
  EXPECT_THROW(history.preview({}), ContractViolation);
  EXPECT_THROW(history.commit(), ContractViolation);
  EXPECT_THROW(history.cancel(), ContractViolation);
  history.begin("drag");
  EXPECT_THROW(history.begin("drag"), ContractViolation);
  EXPECT_THROW(history.set({}, "step"), ContractViolation);
  EXPECT_THROW(EditHistory2{EditHistory2::ScenePointer()}, ContractViolation);
}

}  // namespace
}  // namespace hottel::edit_history_test

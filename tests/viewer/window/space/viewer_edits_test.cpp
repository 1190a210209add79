// Polygons in a viewer in space, under a hand.
#include <gmock/gmock.h>

#include <set>

#include "io/results/factor_files.h"
#include "kernel/support/failure.h"
#include "tests/viewer/window/space/hand.h"

namespace hottel::viewer_edits_test {
namespace {

using testing::HasSubstr;
using testing_viewer::Hand;

Point3 first_corner(const Hand& hand, const std::string& name) {
  return hand.viewer->scene()->polygons[hand.viewer->scene()->find(name).value()].points.front();
}

// The files of a new window on the saved scene.
void expect_light_of_a_new_window(Hand& hand) {
  const std::string here = hand.viewer->hashes();
  EXPECT_EQ(here.find(" -"), std::string::npos) << here;
  hand.play("save " + hand.path("copy.json").string());
  RecordingWindow window({64, 48});
  Viewer3 fresh({hand.path("copy.json"), [file = hand.path("copy.json")] { return read_scene_3(file); }}, window,
                FactorsRequest3{}, 1.0);
  fresh.settle(Hand::kPatience);
  EXPECT_EQ(fresh.hashes(), here);
}

TEST(Viewer3Edits, DragWhatIsPickedAndGoAroundElse) {
  Hand hand;
  const auto before = hand.viewer->scene();
  const EyeCamera3 home = hand.viewer->camera();
  hand.play("drag 1.2,1.2,0.2 1.3,1.2,0.2");
  EXPECT_EQ(hand.viewer->scene(), before);
  EXPECT_NE(hand.viewer->camera(), home);
  hand.play("key f\nclick 1.2,1.2,0.2");
  EXPECT_EQ(hand.picked(), "box.a");
  hand.play("drag 1.2,1.2,0.2 1.2,1.1,0.2 shift");
  EXPECT_EQ(hand.viewer->camera(), home);
  EXPECT_EQ(first_corner(hand, "box.a").x, 1);
  EXPECT_LT(first_corner(hand, "box.a").y, Rational(6, 5));
  EXPECT_EQ(first_corner(hand, "box.top").y, first_corner(hand, "box.a").y) << "it stretches";
}

// (8); at rest as LiveScene3 (1) says.
TEST(Viewer3Edits, HaveCoarseLightWhileTheMouseIsDownAndThatOfSolveAtRest) {
  Hand hand;
  hand.play("click 1.2,1.2,0.2\npress 1.2,1.2,0.2 ctrl\nkey x\nmove 1.35,1.2,0.2");
  EXPECT_TRUE(hand.viewer->state().is_coarse);
  EXPECT_TRUE(hand.viewer->state().is_lit());
  EXPECT_EQ(hand.viewer->state().version->model().table().count(), 2 * hand.viewer->scene()->surfaces.size());
  EXPECT_EQ(hand.viewer->hashes(), "factors.csv - radiosity.csv -");
  hand.play("release 1.35,1.2,0.2");
  EXPECT_FALSE(hand.viewer->state().is_coarse);
  EXPECT_GT(first_corner(hand, "box.bottom").x, 1);
  EXPECT_EQ(first_corner(hand, "box.bottom").z, 0);
  expect_light_of_a_new_window(hand);
}

TEST(Viewer3Edits, UndoneHaveTheLightOfBefore) {
  Hand hand;
  const std::string before = hand.viewer->hashes(), written = write_scene_3(*hand.viewer->scene());
  hand.play(
      "pick box\ndrag 1.2,1.2,0.2 1.3,1.2,0.2\ndo turn\npick lamp\ndo copy\ndo delete\ndo reverse\npick rear\ndo "
      "delete");
  EXPECT_NE(hand.viewer->hashes(), before);
  while (hand.viewer->editor().history().can_undo()) hand.play("key ctrl+z");
  EXPECT_EQ(hand.viewer->hashes(), before);
  EXPECT_EQ(write_scene_3(*hand.viewer->scene()), written);
}

TEST(Viewer3Edits, DroppedHaveTheLightOfBefore) {
  Hand hand;
  const std::string before = hand.viewer->hashes();
  const auto scene = hand.viewer->scene();
  hand.play("pick box\npress 1.2,1.2,0.2\nmove 1.3,1.2,0.3\nkey escape\nrelease 1.3,1.2,0.3");
  EXPECT_EQ(hand.viewer->scene(), scene);
  EXPECT_EQ(hand.viewer->hashes(), before);
}

TEST(Viewer3Edits, TypeCoordinates) {
  Hand hand;
  hand.play("pick box\nkey enter\nkey ctrl+u\ntype 1/3, 1, 0\nkey enter");
  EXPECT_EQ(hand.viewer->message(), "moved box");
  EXPECT_EQ(first_corner(hand, "box.bottom"), (Point3{Rational(1, 3), 1, 0}));
  hand.play("do turn by\nkey ctrl+u\ntype y 90\nkey enter");
  EXPECT_EQ(hand.viewer->message(), "turned box");
  hand.play("do turn by\nkey ctrl+u\ntype 90\nkey enter");
  EXPECT_EQ(hand.viewer->prompt()->problem, "an axis and degrees, as z 15");
  hand.play("key escape");
  expect_light_of_a_new_window(hand);
}

// Where y is up.
TEST(Viewer3Edits, TurnAboutTheVerticalOfTheCamera) {
  std::string text = testing_viewer::kRoom;
  text.insert(text.rfind("\"field_of_view\""), "\"up\": [0.1, 1, 0], ");
  text.replace(text.rfind("\"eye\": [0.9, 0.1, 1.1], \"target\": [1, 2, 0.9]"), 45,
               "\"eye\": [0.9, 1.1, 0.1], \"target\": [1, 1, 0.9]");
  Hand hand(text);
  hand.play("pick lamp\ndo turn square");
  std::set<std::string> heights;
  for (const Point3& p : hand.viewer->scene()->polygons[hand.viewer->scene()->find("lamp").value()].points)
    heights.insert(to_string(p.y));
  EXPECT_EQ(heights.size(), 2u) << "it stands upright still, where about z it would lie";
  EXPECT_EQ(first_corner(hand, "lamp").y, Rational(1, 2));
}

TEST(Viewer3Edits, AddBoxesAndRectanglesAtTheMouse) {
  Hand hand;
  hand.play("move 0.5,1.5,0\nkey n\nkey enter");
  EXPECT_EQ(hand.viewer->message(), "added box 1");
  EXPECT_EQ(first_corner(hand, "box 1.bottom").z, 0) << "it stands on what was there";
  hand.play("move 0.6,2,1.5\nkey p\nkey enter");
  EXPECT_EQ(hand.viewer->message(), "added rectangle 1");
  EXPECT_TRUE(hand.viewer->scene()->surfaces.back().on) << "a patch on the wall";
  hand.play("move 0.5,1.5,0\nkey n\nkey ctrl+u\ntype 1,1,1; 1,2,2\nkey enter");
  EXPECT_EQ(hand.viewer->prompt()->problem, "the corners of a box differ in x, y and z");
  hand.play("key escape");
  EXPECT_EQ(hand.viewer->state().problem, "");
  expect_light_of_a_new_window(hand);
}

TEST(Viewer3Edits, SayWhatIsWrongAndKeepTheLastLight) {
  Hand hand;
  hand.play("pick lamp\nkey enter\nkey ctrl+u\ntype 0.5,0.5,2\nkey enter");  // into the plane of the ceiling, facing as
                                                                             // it does
  EXPECT_THAT(hand.viewer->state().problem, HasSubstr("lamp"));
  EXPECT_TRUE(hand.viewer->state().version) << "the last light stays";
  EXPECT_EQ(hand.viewer->hashes(), "factors.csv - radiosity.csv -");
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.viewer->state().problem, "");
}

TEST(Viewer3Edits, KeepSolidsAwayFromTheEye) {
  Hand hand;
  hand.play("pick box\nkey enter\nkey ctrl+u\ntype 0.7,-0.1,0.9\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_EQ(hand.viewer->prompt()->problem, "the eye would be in the solid 'box'");
}

TEST(Viewer3Edits, PickMoreAndWholeGroups) {
  Hand hand;
  hand.play("click 1.2,1.2,0.2\nclick 0.3,2,1 shift");
  EXPECT_EQ(hand.viewer->editor().selected().size(), 2u);
  hand.play("click 0.3,2,1 shift");
  EXPECT_EQ(hand.viewer->editor().selected().size(), 1u);
  hand.play("click 1.2,1.2,0.2 ctrl");
  EXPECT_EQ(hand.viewer->editor().selected().size(), 6u);
  hand.play("key escape\nclick 1.2,1.2,0.2\nkey g");
  EXPECT_EQ(hand.viewer->editor().selected().size(), 6u);
  EXPECT_THROW(hand.play("pick nothing"), std::runtime_error);
}

// What is picked stays so by its name when others before it go.
TEST(Viewer3Edits, KeepWhatIsPickedByItsName) {
  Hand hand;
  hand.play("do look factors\npick box.top\nkey escape\npick floor\ndo delete\npick box.top");
  hand.play("do undo");
  EXPECT_EQ(hand.picked(), "box.top");
  ASSERT_NE(hand.viewer->result(), nullptr);
  EXPECT_THAT(hand.viewer->result()->lines.front(), HasSubstr("box.top"));
}

}  // namespace
}  // namespace hottel::viewer_edits_test

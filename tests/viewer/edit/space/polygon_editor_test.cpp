// Polygons of a scene in space under a hand.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "kernel/support/failure.h"
#include "tests/viewer/edit/space/edited_scenes.h"
#include "viewer/edit/space/scene_editor.h"

namespace hottel::polygon_editor_test {
namespace {

using testing_edits::furnished;

std::string always(const Scene3&, std::uint32_t, const Point3*) { return ""; }

class Edited : public testing::Test {
 protected:
  SceneEditor3 editor{furnished(), always};

  const Scene3& scene() const { return *editor.scene(); }
  const Polygon3& polygon(const std::string& name) const { return scene().polygons[scene().find(name).value()]; }
  void select(const std::string& name) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t s = 0; s < scene().surfaces.size(); ++s)
      if (scene().surfaces[s].name == name || scene().groups[scene().surfaces[s].group].name == name) all.push_back(s);
    editor.select(all);
  }
  Pointer3 at(const Direction3& place) const {
    Pointer3 pointer{.eye = {2, 0.25, 1.5}, .pixel = 0.002};
    pointer.at = pointer.seen(place);
    return pointer;
  }
  bool drag(const Direction3& from, const Direction3& to, const Pointer3& held = {}) {
    Pointer3 hand = at(from);
    hand.alone = held.alone;
    hand.is_whole = held.is_whole;
    hand.along_axis = held.along_axis;
    if (!editor.grab(hand)) return false;
    hand.at = hand.seen(to);
    editor.drag(hand);
    editor.release();
    return true;
  }
};

TEST_F(Edited, HoldsWhatIsSelectedAlone) {
  EXPECT_FALSE(drag({1.5, 1, 0.5}, {1.5, 1, 0.7}));
  select("box.a");
  EXPECT_TRUE(drag({1.5, 1, 0.5}, {1.5, 1, 0.7}));
  EXPECT_FALSE(drag({3.5, 4, 2.5}, {3.5, 4, 2.7})) << "what is beside it";
}

// (1), (4)
TEST_F(Edited, DragsAFaceAndWhatMeetsItStretches) {
  select("box.a");
  const auto before = editor.scene();
  ASSERT_TRUE(drag({1.5, 1, 0.5}, {1.5, 0.8, 0.5}, {.along_axis = true}));
  EXPECT_EQ(editor.refusal(), "");
  EXPECT_NE(editor.scene(), before);
  EXPECT_EQ(polygon("box.a").points[0].z, 0) << "it went along an axis";
  EXPECT_EQ(polygon("box.top").points[0], polygon("box.a").points[3]);
  EXPECT_EQ(editor.undo(), "undone: move box.a");
  EXPECT_EQ(editor.scene(), before);
  EXPECT_FALSE(editor.history().can_undo());
  EXPECT_EQ(editor.redo(), "done again: move box.a");
}

TEST_F(Edited, DragsGroupsByThemselves) {
  select("box");
  ASSERT_TRUE(drag({1.5, 1, 0.5}, {1.9, 1, 0.5}, {.along_axis = true}));
  EXPECT_GT(polygon("box.bottom").points[0].x, 1);
  EXPECT_EQ(polygon("floor").points[0], (Point3{0, 0, 0}));
  select("box.a");
  ASSERT_TRUE(drag({1.9, 1, 0.5}, {1.5, 1, 0.5}, {.is_whole = true}));
  EXPECT_EQ(editor.selected().size(), 6u) << "ctrl takes the group";
}

TEST_F(Edited, KeepsPatchesOnTheirBases) {
  select("picture");
  ASSERT_TRUE(drag({2.25, 4, 1.5}, {2.35, 4, 1.45}));
  EXPECT_EQ(editor.refusal(), "");
  EXPECT_NE(polygon("picture").points[0].x, 2);
  EXPECT_EQ(polygon("picture").points[0].y, 4);
  ASSERT_TRUE(drag({2.35, 4, 1.45}, {3.6, 4, 2.8}));
  EXPECT_NE(editor.refusal(), "") << "beside the window";
}

// (2), (4)
TEST_F(Edited, ACornerThatWouldBendAPolygonStays) {
  select("box.a");
  const auto before = editor.scene();
  ASSERT_TRUE(drag({1, 1, 1}, {0.8, 1, 1.2}));
  EXPECT_NE(editor.refusal(), "");
  EXPECT_EQ(editor.scene(), before);
  EXPECT_FALSE(editor.history().can_undo());
  ASSERT_TRUE(drag({1, 1, 1}, {0.8, 1, 1.2}, {.alone = true})) << "alone it goes in its plane";
  EXPECT_EQ(polygon("box.a").points[3].y, 1);
  EXPECT_NE(polygon("box.a").points[3].x, 1);
  EXPECT_EQ(polygon("box.top").points[0], (Point3{1, 1, 1}));
}

TEST_F(Edited, ACornerOfTrianglesGoesAnywhere) {
  select("tent[0]");
  ASSERT_TRUE(drag({3.2, 3.2, 1}, {3.1, 3.2, 1.2}));
  EXPECT_EQ(editor.refusal(), "");
  EXPECT_EQ(polygon("tent[0]").points[2], polygon("tent[1]").points[2]) << "what meets there goes along";
  EXPECT_EQ(editor.selected_corner(), polygon("tent[0]").points[2]);
}

TEST_F(Edited, SnapsToWhatStands) {
  select("tent");
  ASSERT_TRUE(drag({3.2, 3.2, 0.8}, {1.5, 3, 0.3}));
  std::set<std::string> places;
  for (const char* name : {"tent[0]", "tent[1]"})
    for (const Point3& p : polygon(name).points) places.insert(to_string(p.x) + "," + to_string(p.y));
  EXPECT_EQ(editor.refusal(), "");
}

TEST_F(Edited, GoesToTypedPlaces) {
  select("box");
  EXPECT_EQ(editor.move_to({Rational(5, 3), 1, Rational(1, 10)}), "moved box");
  EXPECT_EQ(polygon("box.bottom").points[0], (Point3{Rational(5, 3), 1, Rational(1, 10)}));
  select("box.top");
  EXPECT_EQ(editor.place_of_selection(), polygon("box.top").points[0]);
  EXPECT_EQ(editor.move_to({Rational(5, 3), 1, 2}), "moved box.top");
  EXPECT_EQ(polygon("box.a").points[2].z, 2);
}

TEST_F(Edited, TurnsCopiesReversesAddsAndDeletes) {
  select("box");
  EXPECT_EQ(editor.rotate(15), "turned box");
  EXPECT_EQ(editor.rotate(20, 0), "turned box");
  EXPECT_EQ(editor.duplicate({Rational(1, 2), 0, 0}), "copied box");
  EXPECT_EQ(scene().surfaces[editor.selected().front()].name, "box.bottom copy");
  EXPECT_EQ(editor.erase(), "deleted box copy");
  EXPECT_TRUE(editor.selected().empty());
  EXPECT_EQ(editor.erase(), "");
  select("frame");
  EXPECT_EQ(editor.reverse(), "reversed frame");
  EXPECT_EQ(editor.add_box({3, 1, 0}, {Rational(7, 2), 2, 1}, 0), "added box 1");
  EXPECT_EQ(editor.selected().size(), 6u);
  EXPECT_EQ(editor.add_box({3, 1, 0}, {3, 2, 1}, 0), "");
  EXPECT_NE(editor.refusal(), "");
  EXPECT_EQ(editor.add_rectangle({3, 1, 0}, {4, 2, 1}, false, 0), "");
  EXPECT_NE(editor.refusal(), "");
  for (int k = 0; k < 6; ++k) EXPECT_NE(editor.undo(), "");
  EXPECT_EQ(write_scene_3(scene()), write_scene_3(furnished()));
}

// (3)
TEST_F(Edited, KeepsTheSelectionByNames) {
  select("picture");
  editor.erase();
  editor.undo();
  select("tent");
  const auto tent = editor.selected();
  select("rear");
  editor.erase();
  editor.undo();
  select("tent");
  EXPECT_EQ(editor.selected(), tent);
  editor.select_light(0);
  EXPECT_TRUE(editor.selected().empty());
  select("tent");
  EXPECT_FALSE(editor.selected_light());
}

TEST(SceneEditor3MayStand, RefusesWhatMayNotBe) {
  SceneEditor3 editor(furnished(), always, [](const Scene3&) { return std::string("not today"); });
  editor.select({editor.scene()->find("tent[0]").value()});
  EXPECT_EQ(editor.move_to({3, 3, 1}), "");
  EXPECT_EQ(editor.refusal(), "not today");
}

// A hand that does anything.
class RandomHand3 {
 public:
  RandomHand3(SceneEditor3& editor, std::uint64_t seed) : editor_(editor), random_(seed) {}

  void edit() {
    if (below(3) == 0 || (editor_.selected().empty() && !editor_.selected_light())) choose();
    switch (below(9)) {
      case 0:
        editor_.move_to(place());
        break;
      case 1:
        editor_.rotate(number() * 10, static_cast<int>(below(3)), static_cast<int>(below(5)));
        break;
      case 2:
        editor_.rotate(90, static_cast<int>(below(3)));
        break;
      case 3:
        if (scene().surfaces.size() < 60) editor_.duplicate({number(), number(), number()});
        break;
      case 4:
        if (scene().surfaces.size() > 12) editor_.erase();
        break;
      case 5:
        editor_.reverse();
        break;
      case 6:
        below(2) == 0
            ? editor_.add_box(place(), place(), material())
            : editor_.add_rectangle({1, number(), number()}, {1, number(), number()}, below(2) == 0, material());
        break;
      default:
        drag();
    }
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  const Scene3& scene() const { return *editor_.scene(); }
  std::uint32_t material() { return static_cast<std::uint32_t>(below(scene().materials.size())); }
  Rational number() { return (Rational(static_cast<long>(below(400))) - 200) / (below(2) != 0 ? 100 : 7); }
  Point3 place() { return {number(), number(), number()}; }

  void choose() {
    if (scene().surfaces.empty()) return;
    editor_.select({static_cast<std::uint32_t>(below(scene().surfaces.size()))});
    if (below(3) == 0) editor_.select_groups();
    if (below(4) == 0) editor_.toggle({static_cast<std::uint32_t>(below(scene().surfaces.size()))});
  }

  // From a corner, or from the middle, of what is selected.
  void drag() {
    if (editor_.selected().empty()) return;
    const Polygon3& held = scene().polygons[editor_.selected()[below(editor_.selected().size())]];
    Pointer3 hand{.eye = {2, -6, 1.5}, .pixel = 0.002};
    hand.alone = below(5) == 0;
    hand.is_whole = below(5) == 0;
    hand.along_axis = below(4) == 0;
    Direction3 at = place_of(held.points[below(held.points.size())]);
    if (below(2) == 0) at = 0.5 * (at + place_of(held.points[below(held.points.size())]));
    if (!(hand.depth(at) > 0)) return;
    hand.at = hand.seen(at);
    if (!editor_.grab(hand)) return;
    if (below(3) == 0) editor_.toggle_axis(static_cast<int>(below(3)));
    for (std::size_t k = 1 + below(3); k > 0; --k) {
      hand.at.x += 0.002 * (static_cast<double>(below(200)) - 100);
      hand.at.y += 0.002 * (static_cast<double>(below(200)) - 100);
      editor_.drag(hand);
    }
    below(6) == 0 ? editor_.cancel() : editor_.release();
  }

  SceneEditor3& editor_;
  std::mt19937_64 random_;
};

// After every edit the scene is one, and is saved as it is seen; undone, all is as it was.
std::size_t edit_and_undo(std::uint64_t edits, std::uint64_t seed) {
  SceneEditor3 editor(furnished(), always);
  RandomHand3 hand(editor, seed);
  std::vector<std::shared_ptr<const Scene3>> scenes{editor.scene()};
  std::vector<std::string> texts{write_scene_3(*editor.scene())};
  for (std::uint64_t k = 0; k < edits; ++k) {
    hand.edit();
    if (editor.scene() == scenes.back()) continue;
    scenes.push_back(editor.scene());
    texts.push_back(write_scene_3(*editor.scene()));
    const Scene3 read = parse_scene_3(texts.back(), "furnished.json");
    EXPECT_EQ(read.polygons, editor.scene()->polygons) << seed << " " << k;
    EXPECT_EQ(read.groups, editor.scene()->groups) << seed << " " << k;
    EXPECT_EQ(write_scene_3(read), texts.back()) << seed << " " << k;
    if (testing::Test::HasFailure()) return 0;
  }
  std::size_t undone = 0;
  for (std::size_t k = scenes.size() - 1; k > 0 && editor.undo() != ""; --k, ++undone) {
    EXPECT_EQ(editor.scene(), scenes[k - 1]);
    EXPECT_EQ(write_scene_3(*editor.scene()), texts[k - 1]);
  }
  EXPECT_EQ(undone, scenes.size() - 1);
  for (std::size_t k = 1; k < scenes.size(); ++k) {
    EXPECT_NE(editor.redo(), "");
    EXPECT_EQ(editor.scene(), scenes[k]);
  }
  return undone;
}

TEST(RandomEdits3, AreSavedAsTheyAreSeenAndUndone) {
  std::size_t made = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    made += edit_and_undo(90, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(made, 1000u);
}

}  // namespace
}  // namespace hottel::polygon_editor_test

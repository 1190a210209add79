// A viewer under a hand: events and scripts in, frames out, without a screen.
#include "viewer/window/plane/viewer.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/moving_lights.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/temporary_folder.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/picture/palette.h"
#include "viewer/window/commands.h"
#include "viewer/window/plane/viewer_script.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/script_player.h"

namespace hottel::viewer_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using EventKind = WindowEvent::Kind;
namespace fs = std::filesystem;

// A viewer with the small room on it, or another scene: the screen is 0, the room 1..4, the step 5, 6, the table 7..10.
class Hand {
 public:
  explicit Hand(const Scene2& scene = small_room()) : window({800, 600}) {
    std::ofstream(file()) << write_scene_2(scene);
    viewer.emplace(file(), window, SimulationRequest2{}, 1.0);
    viewer->settle(kPatience);
  }

  fs::path file() const { return folder / "room.json"; }
  fs::path path(const std::string& name) const { return folder / name; }

  // Does the steps of a script; returns what it prints.
  std::string play(const std::string& script) {
    std::string printed;
    play_script(parse_script(script, "hand.txt"), "hand.txt", *viewer, window,
                {.print = [&printed](const std::string& line) { printed += line + "\n"; }});
    return printed;
  }

  const Scene2& scene() const { return *viewer->editor().scene(); }
  std::string changes() const { return difference(scene(), small_room()); }
  std::vector<std::string> selected() const {
    std::vector<std::string> names;
    for (const std::uint32_t s : viewer->editor().selected()) names.push_back(scene().surfaces[s].name);
    return names;
  }
  std::string question() const { return viewer->prompt() ? viewer->prompt()->question : ""; }
  const ViewRequest2& request() const { return viewer->views().request(); }

  // All that can be asked of the viewer but the frame, in which times are written.
  std::string signature() const {
    std::string text = write_scene_2_or_why() + "|" + viewer->message() + "|" + question() + "|" +
                       (viewer->prompt() ? viewer->prompt()->text : "") + "|" + to_string(request().mode) + "|" +
                       request().method + "|" + std::to_string(static_cast<int>(request().solver)) +
                       std::to_string(request().wants_closed_form) + "|" +
                       std::to_string(static_cast<int>(viewer->views().tone().tone)) + " " +
                       std::to_string(viewer->views().tone().exposure) + (viewer->wants_quit() ? " quits" : "");
    for (const std::string& name : selected()) text += " " + name;
    const Pixel corner = viewer->pixel_of({0, 0});
    const std::string here = folder.path().string();
    for (auto at = text.find(here); at != std::string::npos; at = text.find(here))
      text.replace(at, here.size(), "HERE");
    return text + " " + std::to_string(corner.x) + " " + std::to_string(corner.y);
  }

  static constexpr double kPatience = 300;
  TemporaryFolder folder;
  RecordingWindow window;
  std::optional<Viewer2> viewer;

 private:
  std::string write_scene_2_or_why() const {
    try {
      validate(scene());
      return write_scene_2(scene());
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

// Commands.

// small_room() with a spot between the screen and the table.
Scene2 room_with_a_spot() {
  Scene2 scene = small_room();
  Light spot{.name = "spot", .type = LightType::kSpot, .focus = 30, .power = {}};
  spot.power = Spectrum::scalar(3);
  scene.add_light(spot, {.position = {Rational(3, 2), Rational(3, 2)}, .direction = {0, 1}, .path = {}});
  return scene;
}

TEST(Viewer2, ChangesTheLightUnderTheMouse) {
  Hand hand(room_with_a_spot());
  const auto light = [&]() -> const Light& { return hand.scene().lights[0]; };
  hand.play("move 1.5,1.5\ndo less reflectivity\ndo more emission\ndo colour");
  EXPECT_EQ(light().focus, 24);
  EXPECT_EQ(light().power.value[0], Rational(19, 5));
  hand.play("do spin");
  EXPECT_EQ(hand.scene().light_places[0].rotation, 30);
  hand.play("do spin\nkey i\ntype ; falloff 2; rotation -6\nkey enter");
  EXPECT_EQ(light().falloff, 2);
  EXPECT_EQ(hand.scene().light_places[0].rotation, -6);
  hand.play("drag 1.5,1.5 1.5,1");
  EXPECT_EQ(hand.scene().light_places[0].position, (Point2{Rational(3, 2), 1}));
  hand.play("move 3.5,2.5\ndo light\nkey delete");
  EXPECT_EQ(hand.scene().lights.size(), 1u);
}

TEST(Viewer2, ShowsTheLightOfAMovedLightAsAFreshSolveDoes) {
  Hand hand(room_with_a_spot());
  hand.play("drag 1.5,1.5 1.5,0.5\nkey r");
  const std::string hash = hand.play("hash");
  const fs::path saved = hand.path("saved.json");
  hand.play("save " + saved.string());
  Hand fresh(read_scene_2(saved));
  EXPECT_EQ(fresh.play("hash"), hash);
  EXPECT_NE(Hand(room_with_a_spot()).play("hash"), hash);
}

// (6)
TEST(Viewer2, LightsMoveWithTheirTime) {
  Scene2 turning = room_with_a_spot();
  turning.light_places[0].rotation = 40;
  Hand hand(turning);
  const auto shows = [&hand](const Scene2& scene) {
    return write_scene_2(*hand.viewer->views().state().scene) == write_scene_2(scene);
  };
  const Raster before = hand.viewer->frame();
  hand.play("key tab\npause 0.5");
  EXPECT_TRUE(shows(scene_after(turning, Rational(1, 2))));
  EXPECT_FALSE(hand.viewer->frame() == before);
  EXPECT_EQ(write_scene_2(hand.scene()), write_scene_2(turning)) << "what is edited stands";
  hand.play("move 1.5,1.5\ndo more emission");  // an edit is seen where the light is by now
  EXPECT_TRUE(shows(scene_after(hand.scene(), Rational(1, 2))));
  const fs::path saved = hand.path("saved.json");
  hand.play("save " + saved.string());
  EXPECT_EQ(read_scene_2(saved)->light_places[0].direction, turning.light_places[0].direction);
  hand.play("key tab\nwait");
  EXPECT_TRUE(shows(hand.scene()));
  EXPECT_EQ(hand.viewer->views().state().depth, LiveDepth2::kFull);
  hand.play("key tab\npause 0.25\npress 1.5,1.5\nrelease 1.5,1.5\nwait");
  EXPECT_TRUE(shows(hand.scene())) << "a hand on a light lets all of them stand";
}

TEST(Viewer2, LightsSpinAtOnceAndStandAgainWhereTheyWouldMeetASurface) {
  Hand hand(room_with_a_spot());
  hand.play("key tab");
  EXPECT_EQ(hand.viewer->message(), "no light moves");
  hand.play("move 1.5,1.5\nkey y\npause 1");
  EXPECT_EQ(write_scene_2(*hand.viewer->views().state().scene), write_scene_2(scene_after(hand.scene(), 1)));

  Scene2 leaving = room_with_a_spot();
  leaving.light_places[0].path = {{{Rational(3, 2), Rational(3, 2)}, {Rational(3, 2), Rational(-1, 2)}}, 1, false};
  Hand other(leaving);
  other.play("key tab\npause 0.5");
  ASSERT_EQ(other.viewer->message(), "the lights move");
  other.play("pause 0.25");
  EXPECT_THAT(other.viewer->message(), StartsWith("after 0.75 s: ")) << "it lies on the wall";
  EXPECT_EQ(write_scene_2(*other.viewer->views().state().scene), write_scene_2(leaving));
}

TEST(Viewer2, SaysWhereALightCannotBe) {
  Hand hand(room_with_a_spot());
  hand.play("drag 1.5,1.5 1,1.5");
  EXPECT_THAT(hand.viewer->views().state().problem, HasSubstr("spot"));
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.viewer->views().state().problem, "");
}

// Something is selected, under the mouse, and was changed and undone: so every command has something to do.
constexpr const char* kReady = "click 2.5,1\nkey right\nkey up\nkey ctrl+z\nmove 2.5,1.1\nkey h\nkey h";

TEST(Viewer2, DoesEachCommandByKeyAndByNameAlike) {
  for (const Command& command : commands()) {
    SCOPED_TRACE(std::string(command.name) + ", " + std::string(command.key));
    Hand by_name, by_key;
    by_name.play(kReady);
    by_key.play(kReady);
    ASSERT_EQ(by_name.signature(), by_key.signature());
    const std::string before = by_name.signature();
    by_name.play("do " + std::string(command.name));
    if (!command.key.empty()) by_key.play("key " + std::string(command.key));
    if (!command.key.empty()) {
      EXPECT_EQ(by_name.signature(), by_key.signature());
    }
    // These show nothing that is not there: all is seen, light is shown, and nothing runs that could begin again.
    const std::set<std::string_view> quiet{"look light", "fit", "again", "help"};
    EXPECT_EQ(by_name.signature() == before, quiet.contains(command.name));
  }
}

TEST(Viewer2, SaysWhyACommandDoesNothing) {
  // Nothing is selected, nothing lies under the mouse, nothing was done.
  for (const Command& command : commands()) {
    SCOPED_TRACE(command.name);
    Hand hand;
    const std::string before = hand.signature();
    hand.play("do " + std::string(command.name));
    const std::set<std::string_view> quiet{"look light", "fit", "again", "help", "escape"};
    EXPECT_EQ(hand.signature() == before, quiet.contains(command.name));
    if (command.topic == "edit" && hand.changes().empty() && command.name != "all" && command.name != "escape") {
      EXPECT_NE(hand.viewer->message(), "");
    }
  }
  Hand hand;
  for (const auto& [command, message] :
       std::vector<std::pair<std::string, std::string>>{{"undo", "there is nothing to undo"},
                                                        {"redo", "there is nothing to do again"},
                                                        {"delete", "nothing is selected"},
                                                        {"turn", "nothing is selected"},
                                                        {"left", "nothing is selected"},
                                                        {"coordinates", "select what is to go there first"},
                                                        {"colour", "no edge lies under the mouse"},
                                                        {"copy number", "there is no number to copy"}}) {
    hand.play("do " + command);
    EXPECT_EQ(hand.viewer->message(), message) << command;
  }
  hand.play("click 2,1\ndo delete");
  EXPECT_EQ(hand.viewer->message(), "a vertex is selected: that is for edges");
  hand.play("key escape\nmove 2,3.05");
  for (int k = 0; k < 30; ++k) hand.viewer->command("more reflectivity");
  EXPECT_EQ(hand.viewer->message(), "it goes no further");
  hand.play("press 2.5,1\nmove 2.5,1.3\ndo reverse");
  EXPECT_EQ(hand.viewer->message(), "not while something is dragged");
}

TEST(Viewer2, RefusesOtherNames) {
  Hand hand;
  for (const char* name : {"", "lefty", "sleft", "far", "far away", "look", "look nothing", "own", "own undo", "undo "})
    EXPECT_THROW(hand.viewer->command(name), UsageError) << name;
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, ShowsHelpWithEveryKey) {
  Hand hand;
  const Raster before = hand.viewer->frame();
  hand.play("key h");
  EXPECT_NE(hand.viewer->frame(), before);
  hand.play("key h\nkey h\nkey h");
  EXPECT_FALSE(hand.viewer->prompt());
}

TEST(Viewer2, NudgesByAStepThatIsSeen) {
  Hand hand;
  hand.play("click 2.5,1\nkey right");
  EXPECT_EQ(hand.scene().edges[7], (Edge2{{Rational(21) / 10, 1}, {Rational(31) / 10, 1}}));
  hand.play("key shift+up");
  EXPECT_EQ(hand.scene().edges[7], (Edge2{{Rational(21) / 10, 2}, {Rational(31) / 10, 2}}));
  hand.play("key shift+down\nkey left");
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, TurnsCopiesDeletesAndReverses) {
  Hand hand;
  hand.play("click 2.5,1\nkey g\nkey ctrl+r\nkey ctrl+r\nkey ctrl+r\nkey ctrl+r");
  EXPECT_EQ(hand.selected().size(), 4u);
  EXPECT_EQ(hand.changes(), "");
  hand.play("key r");
  EXPECT_NE(hand.changes(), "");
  hand.play("key ctrl+z\nkey d");
  EXPECT_EQ(hand.scene().surfaces.size(), 15u);
  EXPECT_THAT(hand.selected(), testing::Each(StartsWith("table copy")));
  hand.play("key delete");
  EXPECT_EQ(hand.changes(), "");
  hand.play("click 1,1.5\nkey v");
  EXPECT_EQ(hand.scene().edges[0], (Edge2{{1, 2}, {1, 1}}));
  hand.play("key backspace");
  EXPECT_EQ(hand.scene().surfaces.size(), 10u);
}

TEST(Viewer2, ChangesTheMaterialUnderTheMouse) {
  Hand hand;
  hand.play("move 2,2.95\nkey ]\nkey ]");  // the room is white
  EXPECT_EQ(hand.scene().materials[0].reflectivity, Spectrum::scalar(Rational(4) / 5));
  EXPECT_THAT(hand.viewer->message(), HasSubstr("white: reflectivity 0.8, emission 0"));
  hand.play("key [\nkey '");
  EXPECT_EQ(hand.scene().materials[0].reflectivity, Spectrum::scalar(Rational(3) / 4));
  EXPECT_EQ(hand.scene().materials[0].emission, Spectrum::scalar(1));
  hand.play("key ;");
  EXPECT_EQ(hand.scene().materials[0].emission, Spectrum::scalar(Rational(4) / 5));
  hand.play("key k");
  EXPECT_EQ(hand.scene().materials[0].reflectivity, Spectrum::scalar(Rational(4) / 5));
  hand.play("key k");
  EXPECT_FALSE(hand.scene().materials[0].reflectivity.is_scalar);
  const std::size_t materials = hand.scene().materials.size();
  hand.play("key shift+]");  // for the room alone
  EXPECT_EQ(hand.scene().materials.size(), materials + 1);
  EXPECT_NE(hand.scene().surfaces[1].material, hand.scene().surfaces[0].material);
  hand.play("move 3.5,1.8");
  hand.play("key k");
  EXPECT_EQ(hand.viewer->message(), "no edge lies under the mouse");
}

TEST(Viewer2, NoMaterialLiesUnderAMouseThatHasLeft) {
  Hand hand;
  hand.play("move 2,2.95\nleave\nkey ]");
  EXPECT_EQ(hand.viewer->message(), "no edge lies under the mouse");
  EXPECT_EQ(hand.changes(), "");
}

// Mouse.

TEST(Viewer2, DragsVerticesEdgesAndGroups) {
  Hand hand;
  hand.play("drag 2,1 1.5,0.7");
  EXPECT_EQ(hand.scene().edges[7].from, (Point2{Rational(3) / 2, Rational(7) / 10}));
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.changes(), "");
  hand.play("drag 2.5,1 2.5,0.8");
  EXPECT_EQ(hand.scene().edges[7], (Edge2{{2, Rational(4) / 5}, {3, Rational(4) / 5}}));
  hand.play("key ctrl+z\ndrag 2.5,1 2.3,1.2 ctrl");
  EXPECT_EQ(hand.selected().size(), 4u);
  EXPECT_EQ(hand.scene().edges[9], (Edge2{{Rational(14) / 5, Rational(11) / 5}, {Rational(9) / 5, Rational(11) / 5}}));
  EXPECT_FALSE(hand.viewer->editor().is_dragging());
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.changes(), "");
  hand.play("key escape\ndrag 2.5,1 2.5,0.5 alt");
  EXPECT_EQ(hand.selected().size(), 1u);
  EXPECT_NE(hand.changes(), "");
}

TEST(Viewer2, LightFollowsADragCoarseAndIsExactAtRest) {
  Scene2 scene = small_room();
  scene.grids = {grid_over(scene, 100, 75)};
  Hand hand(scene);
  hand.play("press 2.5,1\nmove 2.5,0.8");
  EXPECT_TRUE(hand.viewer->editor().is_dragging());
  EXPECT_EQ(hand.viewer->views().state().depth, LiveDepth2::kCoarse);
  EXPECT_EQ(hand.viewer->views().state().scene, hand.viewer->editor().scene());
  EXPECT_EQ(hand.play("hash"), "factors.csv - radiosity.csv - illumination.npy -\n");
  hand.play("release 2.5,0.8");
  EXPECT_EQ(hand.viewer->views().state().depth, LiveDepth2::kFull);
  EXPECT_EQ(hand.viewer->views().state().scene, hand.viewer->editor().scene());
  EXPECT_EQ(hand.viewer->views().state().light->grid.grid, scene.grids.front());
  EXPECT_THAT(hand.play("hash"), HasSubstr("factors.csv "));
}

TEST(Viewer2, EscapeDropsADrag) {
  Hand hand;
  hand.play("press 2.5,1\nmove 2.5,0.8");
  EXPECT_NE(hand.changes(), "");
  hand.play("key escape");
  EXPECT_EQ(hand.changes(), "");
  hand.play("move 3,2\nrelease 3,2");
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, AnotherButtonDoesNotEndADrag) {
  Hand hand;
  hand.play("press 2.5,1\nmove 2.5,0.8\npress 2.5,0.8 right\nrelease 2.5,0.8 right");
  EXPECT_TRUE(hand.viewer->editor().is_dragging());
  hand.play("move 2.5,0.7\nrelease 2.5,0.7");
  EXPECT_EQ(hand.scene().edges[7].from.y, Rational(7) / 10);
}

TEST(Viewer2, DeletingWhatIsHeldLeavesTheHandEmpty) {
  Hand hand;
  hand.play("press 1,1.5 alt\nkey delete\nmove 3,2\nmove 1,1\nrelease 1,1");
  EXPECT_EQ(hand.scene().surfaces.size(), 10u);
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, ClicksSelectAndBesideThemNothingIs) {
  Hand hand;
  hand.play("click 2.5,1");
  EXPECT_THAT(hand.selected(), ElementsAre("table[0]"));
  hand.play("click 1,1.5 shift");
  EXPECT_THAT(hand.selected(), ElementsAre("screen", "table[0]"));
  hand.play("click 1,1.5 shift");
  EXPECT_THAT(hand.selected(), ElementsAre("table[0]"));
  hand.play("click 1.5,0.5");
  EXPECT_THAT(hand.selected(), IsEmpty());
  hand.play("click 2.5,1 ctrl");
  EXPECT_EQ(hand.selected().size(), 4u);
  hand.play("key escape");
  EXPECT_THAT(hand.selected(), IsEmpty());
  hand.play("key ctrl+a");
  EXPECT_EQ(hand.selected().size(), 11u);
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, SelectsInARectangle) {
  Hand hand;
  hand.play("drag 1.8,0.8 3.2,2.2 shift");
  EXPECT_THAT(hand.selected(), ElementsAre("table[0]", "table[1]", "table[2]", "table[3]"));
  hand.play("drag 0.8,2.2 1.2,0.8 shift+ctrl");
  EXPECT_EQ(hand.selected().size(), 5u);
  hand.play("drag 0.8,2.2 1.2,0.8 shift");
  EXPECT_THAT(hand.selected(), ElementsAre("screen"));
  hand.play("press 1.8,0.8 shift\nmove 3.2,2.2");
  EXPECT_FALSE(hand.viewer->editor().is_dragging());
  hand.play("release 3.2,2.2");
  EXPECT_EQ(hand.selected().size(), 4u);
}

TEST(Viewer2, PansAndZooms) {
  Hand hand;
  const Pixel before = hand.viewer->pixel_of({1, 1});
  hand.play("drag @300,300 @340,280 right");
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).x, before.x + 40, 1e-6);
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).y, before.y - 20, 1e-6);
  hand.play("drag @40,500 @30,510\nwheel 1,1 3");  // beside everything, with the left button
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).x, before.x + 30, 1e-6);
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).y, before.y - 10, 1e-6);
  EXPECT_NEAR(hand.viewer->pixel_of({2, 1}).x - hand.viewer->pixel_of({1, 1}).x, (800 - 80) / 4.0, 400);
  hand.play("wheel 2,2 -3\nwheel 2,2 500\nwheel 2,2 -1000\nwheel 2,2 1e200\nkey f");
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).x, before.x, 1e-6);
  EXPECT_NEAR(hand.viewer->pixel_of({1, 1}).y, before.y, 1e-6);
  EXPECT_EQ(hand.changes(), "");
}

// The place under the mouse stays there, in each view mode, at each scale, also beside a panel.
TEST(Viewer2, ZoomsAndPansWhatIsPointedAtInEveryViewMode) {
  TemporaryFolder folder;
  std::ofstream(folder / "room.json") << write_scene_2(small_room());
  for (const double scale : {1.0, 1.5, 2.0}) {
    RecordingWindow window({640, 400});
    Viewer2 viewer(folder / "room.json", window, SimulationRequest2{}, scale);
    viewer.settle(Hand::kPatience);
    const auto place_at = [&] { return viewer.pixel_of({0.6, 1.3}); };
    for (int mode = 0; mode < kViewModes2; ++mode) {
      SCOPED_TRACE(std::to_string(scale) + " " + to_string(static_cast<ViewMode2>(mode)));
      viewer.command("fit");
      viewer.command(std::string("look ") + to_string(static_cast<ViewMode2>(mode)));
      viewer.update();
      const Pixel at = place_at();
      for (const double notches : {3.0, -5.0, 0.4}) {
        viewer.handle({.kind = EventKind::kWheel, .x = at.x, .y = at.y, .wheel = notches});
        viewer.update();
        EXPECT_NEAR(place_at().x, at.x, 1e-6);
        EXPECT_NEAR(place_at().y, at.y, 1e-6);
      }
      for (const auto& [kind, dx] : {std::pair(EventKind::kPress, 0), {EventKind::kMove, 9}, {EventKind::kMove, 31}})
        viewer.handle({.kind = kind, .x = at.x + dx, .y = at.y - dx, .button = MouseButton::kRight});
      EXPECT_NEAR(place_at().x, at.x + 31, 1e-6);
      EXPECT_NEAR(place_at().y, at.y - 31, 1e-6);
      viewer.handle({.kind = EventKind::kRelease, .x = at.x + 31, .y = at.y - 31, .button = MouseButton::kRight});
    }
  }
}

// A text that is longer than its room: the wheel over it scrolls it and does not zoom, and keys turn its pages.
TEST(Viewer2, ScrollsALongText) {
  Hand hand;
  hand.play("size 640x400\ndo look plan\ndo fit\nmove @600,80");
  const std::string before = hand.signature();
  const Raster first = hand.viewer->frame();
  hand.play("wheel @600,80 -2");
  EXPECT_EQ(hand.signature(), before) << "the view stays";
  EXPECT_NE(hand.viewer->frame().pixels, first.pixels);
  hand.play("key home");
  EXPECT_EQ(hand.viewer->frame().pixels, first.pixels);
  hand.play("key pagedown\nkey pageup");
  EXPECT_EQ(hand.viewer->frame().pixels, first.pixels);
  hand.play("move 1,1\nkey pagedown");
  EXPECT_EQ(hand.viewer->message(), "") << "also with the mouse elsewhere";
  hand.play("do look light\nkey pagedown");
  EXPECT_EQ(hand.viewer->message(), "no text has more to show");
  hand.play("click 2.5,1\nkey f1");
  const Raster help = hand.viewer->frame();
  hand.play("key down");
  EXPECT_NE(hand.viewer->frame().pixels, help.pixels);
  EXPECT_EQ(hand.changes(), "") << "arrows scroll the help, and nudge nothing beneath it";
  hand.play("key end\nkey home\nwheel @10,10 -1\nwheel @10,10 1");
  EXPECT_EQ(hand.viewer->frame().pixels, help.pixels);
}

TEST(Viewer2, FollowsTheSizeOfTheWindow) {
  Hand hand;
  hand.play("size 500x400");
  EXPECT_EQ(hand.viewer->frame().width, 500u);
  EXPECT_EQ(hand.window.frame().height, 400u);
  hand.play("size 1x1\nkey h\nkey 7\nsize 30x900\nkey f\nsize 900x30\nkey f");
  EXPECT_EQ(hand.window.frame().width, 900u);
}

TEST(Viewer2, DragsTheBarBetweenLightAndErrors) {
  Hand hand;
  hand.play("key 7\nmove @100,300");
  const Raster before = hand.viewer->frame();
  hand.play("drag @400,300 @650,300\nmove @100,300");
  EXPECT_NE(hand.viewer->frame(), before);
  hand.play("drag @650,300 @400,300\nmove @100,300\n");
  EXPECT_EQ(hand.changes(), "");
  EXPECT_THAT(hand.selected(), IsEmpty());
}

TEST(Viewer2, DrawsEdgesAndPolylines) {
  Hand hand;
  hand.play("move 2,2.95\nkey e\nclick 0.3,0.3\nclick 0.7,0.3");
  ASSERT_EQ(hand.scene().surfaces.size(), 12u);
  EXPECT_THAT(hand.selected(), ElementsAre("edge 1"));
  const std::uint32_t added = hand.viewer->editor().selected()[0];
  EXPECT_EQ(hand.scene().edges[added],
            (Edge2{{Rational(3) / 10, Rational(3) / 10}, {Rational(7) / 10, Rational(3) / 10}}));
  hand.play("key ctrl+z\nkey p\nclick 0.3,0.3\nclick 0.7,0.3\nclick 0.7,0.6\nkey enter");
  EXPECT_EQ(hand.scene().surfaces.size(), 13u);
  hand.play("key ctrl+z\nkey p\nclick 0.3,0.3\nclick 0.7,0.3\nclick 0.7,0.6\nclick 0.7,0.6\nclick 0.3,0.3");
  EXPECT_EQ(hand.scene().surfaces.size(), 14u);  // it closes on its first point
  EXPECT_EQ(hand.selected().size(), 3u);
  hand.play("key ctrl+z\nkey p\nclick 0.3,0.3\nkey escape\nclick 0.7,0.3");
  EXPECT_EQ(hand.changes(), "");
  hand.play("key p\nclick 0.3,0.3\nkey enter");
  EXPECT_EQ(hand.viewer->message(), "a line has two points at least");
  EXPECT_EQ(hand.changes(), "");
  hand.play("move 0.5,0.5\nkey l");
  EXPECT_EQ(hand.scene().surfaces.size(), 15u);
  EXPECT_THAT(hand.selected(), testing::Each(StartsWith("lamp 1")));
}

TEST(Viewer2, AToolIsDroppedWithItsMaterial) {
  Scene2 empty;
  empty.file = "empty.json";
  Hand hand(empty);
  hand.play("key e");
  EXPECT_EQ(hand.viewer->message(), "there is no material to draw with: add a lamp first");
  hand.play("move @300,300\nkey l\nmove @100,100\nkey e\nkey ctrl+z\nclick @100,100\nclick @200,200");
  EXPECT_TRUE(hand.scene().surfaces.empty());
  EXPECT_TRUE(hand.scene().materials.empty());
}

// Looks.

TEST(Viewer2, PickedFacesAreKeptByName) {
  Hand hand;
  hand.play("key 5\nclick 2.5,1");
  ASSERT_TRUE(hand.request().face);
  EXPECT_EQ(*hand.request().face, "table[0]");
  hand.play("drag 0.8,2.2 1.2,0.8 shift\nkey delete");  // the screen, which stands before it in the list
  EXPECT_EQ(hand.scene().surfaces.size(), 10u);
  ASSERT_TRUE(hand.request().face);
  EXPECT_EQ(*hand.request().face, "table[0]");
  hand.play("key ctrl+z");
  EXPECT_EQ(*hand.request().face, "table[0]");
  hand.play("click 2.5,1 ctrl\nkey delete");
  EXPECT_FALSE(hand.request().face);
}

// What lay under the mouse is not looked for in a scene that has been read since.
TEST(Viewer2, AFileIsReadWhileSomethingIsDragged) {
  Hand hand;
  hand.play("press 2.5,2\nmove 2.5,2.2");
  std::ofstream(hand.file()) << R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}},
    "edges": [{"name": "a", "points": [[0,0],[1,0]], "material": "m"}]})";
  hand.play("do reload\nkey r");
  ASSERT_EQ(hand.scene().edges.size(), 1u);
  for (const char* key : {"]", "k", "i", "u"}) hand.play(std::string("key ") + key + "\nkey escape");
  hand.play("move 2.5,2.4\nrelease 2.5,2.4\nkey k");
  EXPECT_EQ(hand.scene().edges.size(), 1u);
}

TEST(Viewer2, PicksPairsOfFaces) {
  Hand hand;
  hand.play("key 6\nclick 0.02,1.5\nclick 2.5,0.98");
  ASSERT_TRUE(hand.request().face && hand.request().other);
  EXPECT_EQ(*hand.request().face, "room[0]");
  EXPECT_EQ(*hand.request().other, "table[0]");
  ASSERT_NE(hand.viewer->views().result(), nullptr);
  EXPECT_NE(hand.viewer->views().result()->number, "");
  hand.play("key ctrl+c");
  EXPECT_EQ(hand.window.clipboard(), hand.viewer->views().result()->number);
  EXPECT_THAT(hand.viewer->message(), StartsWith("copied "));
  hand.play("click 2,2.98");
  EXPECT_FALSE(hand.request().other);
  EXPECT_EQ(*hand.request().face, "room[1]");
}

TEST(Viewer2, CopiesTheLightUnderTheMouse) {
  Hand hand;
  hand.play("move 0.5,1.5\nkey ctrl+c");
  const auto& light = *hand.viewer->views().result();
  EXPECT_EQ(hand.window.clipboard(), light.number);
  EXPECT_NE(light.number, "");
  hand.play("leave\nkey ctrl+c");
  EXPECT_EQ(hand.viewer->message(), "there is no number to copy");
}

TEST(Viewer2, GoesThroughMethodsSolversAndTones) {
  Hand hand;
  hand.play("key 7");
  std::set<std::string> methods;
  const std::string first = hand.request().method;
  do {
    methods.insert(hand.request().method);
    hand.viewer->command("next");
    ASSERT_LT(methods.size(), 60u);
  } while (!methods.contains(hand.request().method));
  EXPECT_GT(methods.size(), 5u);
  hand.viewer->command("previous");
  EXPECT_TRUE(methods.contains(hand.request().method));
  hand.viewer->command("look sweeps");
  std::set<Solver> solvers;
  for (int k = 0; k < 12; ++k) {
    solvers.insert(hand.request().solver);
    hand.viewer->command("next");
  }
  EXPECT_EQ(solvers.size(), 5u);
  hand.viewer->command("look light");
  std::set<Tone> tones;
  for (int k = 0; k < 8; ++k) {
    tones.insert(hand.viewer->views().tone().tone);
    hand.viewer->command("tone");
  }
  EXPECT_EQ(tones.size(), 4u);
  hand.viewer->command("brighter");
  EXPECT_GT(hand.viewer->views().tone().exposure, 1);
  hand.viewer->command("darker");
  EXPECT_NEAR(hand.viewer->views().tone().exposure, 1, 1e-12);
}

// While edits follow each other, what is drawn is of one version: in every view mode and frame.
TEST(Viewer2, DrawsEveryViewModeOfEveryVersion) {
  for (int k = 0; k < kViewModes2; ++k) {
    Hand hand;
    hand.play("click 0.02,1.5\nclick 2.5,0.98 shift\nkey escape");
    hand.viewer->command(std::string("look ") + to_string(static_cast<ViewMode2>(k)));
    hand.viewer->handle({.kind = EventKind::kMove, .x = 300, .y = 300});
    for (int n = 0; n < 12; ++n) {
      hand.viewer->command(n % 4 == 3 ? "undo" : "lamp");
      for (int frame = 0; frame < 6; ++frame) {
        hand.viewer->update();
        std::this_thread::sleep_for(std::chrono::milliseconds(frame));
      }
    }
    hand.viewer->settle(Hand::kPatience);
    EXPECT_EQ(hand.viewer->views().state().scene, hand.viewer->editor().scene());
  }
}

// Scenes without light.

TEST(Viewer2, AnInvalidSceneDimsTheLastLightAndSaysWhy) {
  Hand hand;
  const auto lit = hand.viewer->views().lit();
  const Raster before = hand.viewer->frame();
  hand.play("drag 1,1 1,2");  // the screen has no length
  EXPECT_EQ(hand.viewer->views().lit(), lit);
  EXPECT_THAT(hand.viewer->views().state().problem, HasSubstr("screen"));
  // The floor beside everything is the last light, paler.
  const Pixel place = hand.viewer->pixel_of({0.5, 0.5});
  const auto pixel = [&](const Raster& frame) {
    return frame.pixels[static_cast<std::size_t>(place.y) * frame.width + static_cast<std::size_t>(place.x)];
  };
  for (int c = 0; c < 3; ++c) {
    const double was = pixel(before) >> 8 * c & 255, is = pixel(hand.viewer->frame()) >> 8 * c & 255;
    const Colour paper{0.992, 0.988, 0.980, 0.62};
    const double over = 255 * (c == 0 ? paper.b : c == 1 ? paper.g : paper.r);
    EXPECT_NEAR(is, (1 - paper.a) * was + paper.a * over, 2) << c;
  }
  EXPECT_EQ(hand.play("hash"), "factors.csv - radiosity.csv - illumination.npy -\n");
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.viewer->views().state().problem, "");
  EXPECT_EQ(hand.changes(), "");
  hand.play("click 0.02,0.2\nkey delete");  // the room is open, and the file promised that it is closed
  EXPECT_THAT(hand.viewer->views().state().problem, HasSubstr("closed"));
  EXPECT_FALSE(hand.viewer->views().state().errors.empty());
  for (int k = 0; k < kViewModes2; ++k) hand.play(std::string("do look ") + to_string(static_cast<ViewMode2>(k)));
}

// Prompts.

TEST(Viewer2, TakesTypedCoordinates) {
  Hand hand;
  hand.play("click 2,1\nkey enter");
  EXPECT_EQ(hand.question(), "goes to");
  EXPECT_EQ(hand.viewer->prompt()->text, "2, 1");
  hand.play("key ctrl+u\ntype 1/3, 2\nkey enter");
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(hand.scene().edges[7].from, (Point2{Rational(1) / 3, 2}));
  hand.play(
      "key ctrl+z\nclick 2,1\nkey enter\nkey backspace\nkey backspace\nkey backspace\nkey backspace\ntype 5 x\nkey "
      "enter");
  ASSERT_TRUE(hand.viewer->prompt());  // wrong input stays, with what is wrong
  EXPECT_EQ(hand.viewer->prompt()->text, "5 x");
  EXPECT_NE(hand.viewer->prompt()->problem, "");
  hand.play("key backspace\ntype 1\nkey enter");
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(hand.scene().edges[7].from, (Point2{5, 1}));
  hand.play("key ctrl+z\nclick 2,1\ndo coordinates\nkey ctrl+u\ntype 1e400 0\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_THAT(hand.viewer->prompt()->problem, HasSubstr("too far away"));
  hand.play("key escape");
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, TakesTheTextThatFollowsACommand) {
  Hand hand;
  hand.play("key 2\nkey 1\nclick 2,1\ndo coordinates\nkey ctrl+u\ntype 1 1/2\nkey enter");
  EXPECT_EQ(hand.scene().edges[7].from, (Point2{1, Rational(1) / 2}));
  Hand other;
  other.play("click 2,1\nkey 1\ndo coordinates\ntype 5\nkey enter");
  EXPECT_EQ(other.scene().edges[7].from, (Point2{2, 15}));
}

TEST(Viewer2, TakesTypedMaterials) {
  Hand hand;
  hand.play("move 2,2.95\nkey i");
  EXPECT_EQ(hand.question(), "white");
  EXPECT_EQ(hand.viewer->prompt()->text, "reflectivity 0.7; emission 0");  // without the i
  hand.play("key enter");
  EXPECT_EQ(hand.changes(), "");
  EXPECT_FALSE(hand.viewer->editor().history().can_undo());
  hand.play("key i\nkey ctrl+u\ntype reflectivity 0.5; emission 1 2 1/3\nkey enter");
  EXPECT_EQ(hand.scene().materials[0].reflectivity, Spectrum::scalar(Rational(1) / 2));
  EXPECT_EQ(hand.scene().materials[0].emission, (Spectrum{{1, 2, Rational(1) / 3}, false}));
  for (const char* wrong :
       {"reflectivity 1.5", "reflectivity", "emission -1", "colour 1", "emission 1 2", "reflectivity x"}) {
    hand.play("key escape\nmove 2,2.95\nkey i\nkey ctrl+u\ntype " + std::string(wrong) + "\nkey enter");
    ASSERT_TRUE(hand.viewer->prompt()) << wrong;
    EXPECT_NE(hand.viewer->prompt()->problem, "") << wrong;
    EXPECT_EQ(hand.viewer->prompt()->text, wrong);
  }
  const std::size_t materials = hand.scene().materials.size();
  hand.play("key escape\nkey shift+i\nkey ctrl+u\ntype emission 3\nkey enter");
  EXPECT_EQ(hand.scene().materials.size(), materials + 1);
  EXPECT_EQ(hand.scene().materials[hand.scene().surfaces[1].material].emission, Spectrum::scalar(3));
}

// A number with more digits than are shown is not rounded by who looks at it.
TEST(Viewer2, EnterLeavesWhatIsNotTyped) {
  Scene2 scene = small_room();
  const Rational x = Rational(Integer("123456789012345678")) / Integer("98765432109876543210");
  scene = move_end(scene, 0, false, {x, 1});
  scene.materials[0].reflectivity = Spectrum::scalar(x);
  Hand hand(scene);
  hand.play("click " + std::to_string(to_double(x)) + ",1\nkey enter\nkey enter");
  hand.play("move 2,2.95\nkey i\nkey enter");
  EXPECT_EQ(difference(hand.scene(), scene), "");
}

// Files.

TEST(Viewer2, AsksBeforeItQuitsWithUnsavedChanges) {
  Hand hand;
  hand.play("close");
  EXPECT_TRUE(hand.viewer->wants_quit());
  for (const std::string way : {"close", "key ctrl+q"}) {
    Hand changed;
    changed.play("click 2.5,1\nkey right\n" + way);
    EXPECT_FALSE(changed.viewer->wants_quit());
    EXPECT_THAT(changed.question(), StartsWith("unsaved changes"));
    changed.play("key x\ntype hello\nkey enter");  // no answers
    EXPECT_THAT(changed.question(), StartsWith("unsaved changes"));
    changed.play("key escape");
    EXPECT_FALSE(changed.viewer->prompt());
    EXPECT_FALSE(changed.viewer->wants_quit());
    changed.play(way + "\nkey s");
    EXPECT_TRUE(changed.viewer->wants_quit());
    EXPECT_EQ(difference(read_scene_2(changed.file()), changed.scene()), "");
    Hand dropped;
    dropped.play("click 2.5,1\nkey right\n" + way + "\nkey d");
    EXPECT_TRUE(dropped.viewer->wants_quit());
    EXPECT_EQ(difference(read_scene_2(dropped.file()), small_room()), "");
  }
  hand.play("click 2.5,1\nkey right");  // a script ends where the window is closed
  EXPECT_EQ(hand.changes(), "");
}

TEST(Viewer2, SavesAndIsUnchangedThen) {
  Hand hand;
  hand.play("click 2.5,1\nkey right");
  EXPECT_TRUE(hand.viewer->editor().history().is_changed());
  EXPECT_THAT(hand.window.title(), HasSubstr("room.json *"));
  hand.play("key ctrl+s");
  EXPECT_FALSE(hand.viewer->editor().history().is_changed());
  EXPECT_EQ(hand.window.title(), "room.json - hottel");
  EXPECT_EQ(difference(read_scene_2(hand.file()), hand.scene()), "");
  EXPECT_EQ(hand.viewer->message(), "saved " + hand.file().string());
  hand.play("key ctrl+z");
  EXPECT_TRUE(hand.viewer->editor().history().is_changed());
  hand.play("key ctrl+y\nclose");
  EXPECT_TRUE(hand.viewer->wants_quit());
}

TEST(Viewer2, SavesUnderAnotherName) {
  Hand hand;
  hand.play("click 2.5,1\nkey right\nkey ctrl+shift+s");
  EXPECT_EQ(hand.question(), "save as");
  EXPECT_EQ(hand.viewer->prompt()->text, hand.file().string());
  const fs::path other = hand.path("other.json");
  hand.play("key ctrl+u\nkey enter");
  EXPECT_EQ(hand.viewer->prompt()->problem, "a name, please");
  hand.play("type " + hand.path("no/such/folder.json").string() + "\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_THAT(hand.viewer->prompt()->problem, HasSubstr("folder.json"));
  EXPECT_TRUE(hand.viewer->editor().history().is_changed());
  hand.play("key ctrl+u\ntype " + other.string() + "\nkey enter");
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(difference(read_scene_2(other), hand.scene()), "");
  EXPECT_EQ(difference(read_scene_2(hand.file()), small_room()), "");
  hand.play("key up\nkey ctrl+s");  // other.json is the scene's file now
  EXPECT_EQ(difference(read_scene_2(other), hand.scene()), "");
  EXPECT_EQ(difference(read_scene_2(hand.file()), small_room()), "");
}

TEST(Viewer2, WhatIsTypedReplacesTheShownName) {
  Hand hand;
  const fs::path other = hand.path("other.json");
  hand.play("key ctrl+shift+s\ntype " + other.string() + "\nkey enter");
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(difference(read_scene_2(other), hand.scene()), "");
  hand.play("key ctrl+shift+s\nkey end\nkey left\nkey left\nkey left\nkey left\nkey left\ntype _2\nkey enter");
  EXPECT_TRUE(fs::exists(hand.path("other_2.json"))) << hand.viewer->message();
  hand.play("key ctrl+shift+s\nkey tab\nkey escape");
  EXPECT_EQ(hand.viewer->message(), "") << "tab sets no light moving";
}

TEST(Viewer2, LosesNothingWhereTheFileCannotBeWritten) {
  Hand hand;
  hand.play("click 2.5,1\nkey right");
  const Scene2 edited = hand.scene();
  fs::remove(hand.file());
  fs::create_directory(hand.file());
  hand.play("key ctrl+s");
  EXPECT_THAT(hand.viewer->message(), StartsWith("not saved: "));
  EXPECT_TRUE(hand.viewer->editor().history().is_changed());
  hand.play("close\nkey s");
  EXPECT_FALSE(hand.viewer->wants_quit());
  EXPECT_THAT(hand.viewer->message(), StartsWith("not saved: "));
  EXPECT_EQ(difference(hand.scene(), edited), "");
  hand.play("save " + hand.path("elsewhere.json").string() + "\nclose");
  EXPECT_TRUE(hand.viewer->wants_quit());
  EXPECT_EQ(difference(read_scene_2(hand.path("elsewhere.json")), edited), "");
}

TEST(Viewer2, DoesNotSaveAnInvalidScene) {
  Hand hand;
  hand.play("drag 1,1 1,2\nkey ctrl+s");
  EXPECT_THAT(hand.viewer->message(), StartsWith("not saved: "));
  EXPECT_EQ(difference(read_scene_2(hand.file()), small_room()), "");
  EXPECT_TRUE(hand.viewer->editor().history().is_changed());
}

void look_again(Hand& hand) {
  hand.viewer->handle({.kind = EventKind::kFocus});
  hand.viewer->settle(Hand::kPatience);
}

TEST(Viewer2, OffersAFileThatSomeoneElseHasWritten) {
  Hand hand;
  look_again(hand);
  EXPECT_FALSE(hand.viewer->prompt());
  const Scene2 other = erase_surfaces(small_room(), std::vector<std::uint32_t>{7, 8, 9, 10});
  std::ofstream(hand.file()) << write_scene_2(other);
  hand.play("move 2.5,0.98");  // over what will be gone
  look_again(hand);
  EXPECT_THAT(hand.question(), StartsWith("room.json has changed on disk"));
  EXPECT_THAT(hand.question(), testing::Not(HasSubstr("lost")));
  hand.play("key r");
  EXPECT_EQ(difference(hand.scene(), other), "");
  EXPECT_FALSE(hand.viewer->editor().history().is_changed());
  hand.play("key k\nkey '\nkey i\nkey e\nkey escape");  // what was under the mouse is no more
  EXPECT_EQ(difference(hand.scene(), other), "");
  look_again(hand);
  EXPECT_FALSE(hand.viewer->prompt());
}

TEST(Viewer2, KeepsWhatIsThereWhenTheOfferIsRefused) {
  Hand hand;
  hand.play("click 2.5,1\nkey right");
  std::ofstream(hand.file()) << "no scene at all";
  look_again(hand);
  EXPECT_THAT(hand.question(), HasSubstr("your changes are lost"));
  hand.play("key escape");
  look_again(hand);
  EXPECT_FALSE(hand.viewer->prompt());  // it was offered once
  EXPECT_NE(hand.changes(), "");
  hand.play("key ctrl+o");
  EXPECT_THAT(hand.question(), StartsWith("unsaved changes"));
  hand.play("key r");
  EXPECT_THAT(hand.viewer->message(), HasSubstr("room.json"));  // why it cannot be read
  EXPECT_NE(hand.changes(), "");
}

TEST(Viewer2, TellsThatTheFileIsGoneAndReadsItWhenItIsBack) {
  Hand hand;
  fs::rename(hand.file(), hand.path("elsewhere.json"));
  look_again(hand);
  EXPECT_THAT(hand.viewer->message(), StartsWith("room.json is gone, or cannot be read"));
  EXPECT_THAT(hand.window.title(), HasSubstr("(gone)"));
  EXPECT_EQ(hand.changes(), "");
  hand.play("close");
  EXPECT_THAT(hand.question(), StartsWith("the file is gone"));
  hand.play("key escape");
  EXPECT_FALSE(hand.viewer->wants_quit());
  const Scene2 other = erase_surfaces(small_room(), std::vector<std::uint32_t>{7, 8, 9, 10});
  std::ofstream(hand.file()) << write_scene_2(other);
  look_again(hand);
  EXPECT_EQ(difference(hand.scene(), other), "");
  EXPECT_EQ(hand.viewer->message(), "read again");
  EXPECT_THAT(hand.window.title(), testing::Not(HasSubstr("gone")));
}

TEST(Viewer2, AsksWhereAFileIsBackAndThereAreUnsavedChanges) {
  Hand hand;
  hand.play("click 2.5,1\nkey right");
  const Scene2 edited = hand.scene();
  fs::remove(hand.file());
  look_again(hand);
  EXPECT_EQ(difference(hand.scene(), edited), "");
  std::ofstream(hand.file()) << write_scene_2(small_room());
  look_again(hand);
  EXPECT_THAT(hand.question(), StartsWith("room.json is there again"));
  EXPECT_THAT(hand.question(), HasSubstr("your changes are lost"));
  EXPECT_EQ(difference(hand.scene(), edited), "");
  hand.play("key escape");
  fs::remove(hand.file());
  look_again(hand);
  hand.play("key ctrl+s");  // what is here is the file again
  look_again(hand);
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_EQ(difference(read_scene_2(hand.file()), edited), "");
}

TEST(Viewer2, ReadsAgainInTheMiddleOfADrag) {
  Hand hand;
  const Scene2 other = erase_surfaces(small_room(), std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  hand.play("press 2.5,1\nmove 2.5,0.8");
  std::ofstream(hand.file()) << write_scene_2(other);
  look_again(hand);
  hand.play("key r\nmove 2.6,0.7\nrelease 2.6,0.7\nkey ]\nkey delete");
  EXPECT_EQ(difference(hand.scene(), other), "");
}

TEST(Viewer2, WritesPicturesOfWhatIsSeen) {
  Hand hand;
  const fs::path png = hand.path("seen.png"), svg = hand.path("seen.svg");
  hand.play("key ctrl+p");
  EXPECT_EQ(hand.question(), "picture");
  EXPECT_EQ(hand.viewer->prompt()->text, "room.png");
  hand.play("key ctrl+u\ntype " + hand.path("seen.gif").string() + "\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_THAT(hand.viewer->prompt()->problem, HasSubstr(".png, .svg or .pdf"));
  hand.play("key ctrl+u\ntype " + svg.string() + "\nkey enter\npicture " + png.string());
  EXPECT_THAT(read_text_file(svg), HasSubstr("<svg"));
  EXPECT_THAT(read_text_file(png), StartsWith("\x89PNG"));
  hand.play("screenshot " + hand.path("frame.png").string());
  EXPECT_NE(read_text_file(hand.path("frame.png")), read_text_file(png));  // the frame has texts
  EXPECT_FALSE(fs::exists(hand.path("seen.gif")));
}

// The first view.

Scene2 room_without_light() {
  Scene2 scene = small_room();
  for (Material& material : scene.materials) material.emission = Spectrum::scalar(0);
  return scene;
}

TEST(Viewer2, ShowsThePlanWhereNothingShines) {
  Hand hand(room_without_light());
  hand.play("leave");
  const std::vector<std::uint32_t>& pixels = hand.viewer->frame().pixels;
  EXPECT_EQ(std::ranges::count(pixels, 0xFF000000u), 0) << "nothing is black";
  EXPECT_GT(std::ranges::count(pixels, pixels[300 * 800 + 200]), 10000) << "the floor of the room";
}

TEST(Viewer2, ChoosesAToneForTheFirstLightAlone) {
  Scene2 furnace = small_room();
  for (Material& material : furnace.materials) {
    material.reflectivity = Spectrum::scalar(Rational(1, 2));
    material.emission = Spectrum::scalar(1);
  }
  Hand even(furnace);
  EXPECT_EQ(even.viewer->views().tone(), (ToneChoice{Tone::kMax, 0.7}));
  even.play("key t\nkey f4");
  EXPECT_EQ(even.viewer->views().tone(), (ToneChoice{Tone::kLog, 0.7 * 1.2}));
  Hand hand;
  EXPECT_EQ(hand.viewer->views().tone(), ToneChoice());
  hand.play("key f3\nmove 2.5,0.98\nkey f6");
  EXPECT_EQ(hand.viewer->views().tone(), (ToneChoice{Tone::kLog, 1 / 1.2}));
}

// Scripts.

std::string error_of(const std::string& script) {
  Hand hand;
  try {
    hand.play(script);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Script, HasStepsAsTheyStand) {
  const auto steps = parse_script("# a remark\n\n  click 1,2 shift \r\n\ttype  a  b \ndo look light\nhash", "s.txt");
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[0].word, "click");
  EXPECT_THAT(steps[0].arguments, ElementsAre("1,2", "shift"));
  EXPECT_EQ(steps[0].line, 3);
  EXPECT_EQ(steps[1].rest, "a  b ");
  EXPECT_EQ(steps[2].rest, "look light");
  EXPECT_EQ(steps[3].line, 6);
  EXPECT_TRUE(parse_script("", "s.txt").empty());
}

TEST(Script, ErrorsNameFileAndLine) {
  for (const auto& [script, message] : std::vector<std::pair<std::string, std::string>>{
           {"\njump 1,2", "hand.txt:2: a step begins with one of click, close"},
           {"click", "hand.txt:1: 'click' takes 1 argument or more"},
           {"click 1,2 3 4 5", "hand.txt:1: 'click' takes"},
           {"hash now", "hand.txt:1: 'hash' takes 0 arguments"},
           {"wheel 1,2", "hand.txt:1: 'wheel' takes 2 arguments"},
           {"\n\nclick 1;2", "hand.txt:3: a place is"},
           {"move @1,x", "hand.txt:1: a place is"},
           {"move 1,inf", "hand.txt:1: a place is"},
           {"move nan,1", "hand.txt:1: a place is"},
           {"click 1,2 upper", "hand.txt:1: a button is"},
           {"click 1,2 shift+up", "hand.txt:1: a button is"},
           {"wheel 1,2 x", "hand.txt:1: how many notches"},
           {"#\ndo jump", "hand.txt:2: there is no command called 'jump'"},
           {"do sleft", "hand.txt:1: there is no command called 'sleft'"},
           {"size 10", "hand.txt:1: a size is"},
           {"size 0x10", "hand.txt:1: a size is"},
           {"size 10.5x10", "hand.txt:1: a size is"},
           {"size 99999x10", "hand.txt:1: a size is"},
           {"pause -1", "hand.txt:1: seconds are"},
           {"picture a.gif", "hand.txt:1: a picture ends in"},
           {"screenshot a.svg", "hand.txt:1: a screenshot ends in"}}) {
    EXPECT_THAT(error_of(script), StartsWith(message)) << script;
  }
}

TEST(Script, EveryWordDoesSomething) {
  Hand hand;
  std::size_t frames = hand.window.frames();
  const auto shows = [&](const std::string& step) {
    hand.play(step);
    EXPECT_GT(hand.window.frames(), frames) << step;
    frames = hand.window.frames();
  };
  shows("move 1,2");
  shows("press 1,2 left alt");
  shows("release 1,2");
  shows("click 2.5,1 ctrl");
  shows("drag 2.5,1 2.6,1 2.4,1.1");
  shows("wheel 1,2 -0.5");
  shows("key enter");
  shows("type 1, 2");
  shows("key escape");
  shows("do look plan");
  shows("size 300x200");
  shows("leave");
  hand.play("wait\npause 0.1");
  hand.play("  do   look    light  ");
  EXPECT_EQ(hand.request().mode, ViewMode2::kLight);
  hand.play("save   " + hand.path("s.json").string() + "  ");
  EXPECT_TRUE(fs::exists(hand.path("s.json")));
  EXPECT_THROW(hand.play("save " + hand.path("no/such.json").string()), OutputError);
  EXPECT_THROW(hand.play("screenshot " + hand.path("no/such.png").string()), OutputError);
}

TEST(Script, RecordsAFrameForEachEventAndTwentyASecond) {
  Hand hand;
  const auto frames_of = [&](const std::string& script) {
    int frames = 0;
    play_script(parse_script(script, "s"), "s", *hand.viewer, hand.window,
                {.print = [](const std::string&) {},
                 .frame =
                     [&](const Raster& frame) {
                       EXPECT_EQ(frame, hand.window.frame());
                       ++frames;
                     }});
    return frames;
  };
  EXPECT_EQ(frames_of("key h\nkey h"), 2);
  EXPECT_EQ(frames_of("drag 2,1 2.2,1.1 2,1"), 24 + 1);
  EXPECT_EQ(frames_of("pause 0.5"), kFramesPerSecond / 2 + 1);
}

TEST(Script, DoesTheSameEachTime) {
  const std::string script =
      "drag 2.5,1 2.3,1.2 ctrl\nkey escape\nmove 2,2.95\nkey ]\nkey '\nhash\nkey 4\nmove 0.5,0.5\nkey r\nhash\n";
  Hand one, two;
  EXPECT_EQ(one.play(script), two.play(script));
  EXPECT_EQ(one.signature(), two.signature());
}

// (1) of Script and of the viewer at rest: hashes are those of what the library writes of a new simulation.
TEST(Script, HashesAreOfTheStateAtRest) {
  Hand hand;
  hand.play("drag 2.5,1 2.3,1.2 ctrl");
  LiveScene2 fresh({});
  fresh.set(std::make_shared<const Scene2>(saved_and_read(hand.scene())), LiveDepth2::kFull);
  ASSERT_TRUE(fresh.wait(Hand::kPatience));
  EXPECT_EQ(hand.play("hash"), result_hashes(*fresh.state()) + "\n");
  const std::string before = hand.play("hash");
  EXPECT_NE(hand.play("key ctrl+z\nhash"), before);
}

// A window on its own thread of events.
TEST(ViewerThread, RunsWhileEventsCome) {
  Hand hand;
  const Pixel at = hand.viewer->pixel_of({2.5, 1});
  std::thread events([&] {
    const auto push = [&](WindowEvent event) {
      hand.window.push(std::move(event));
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
    };
    for (int k = 0; k < 4; ++k) {
      push({.kind = EventKind::kMove, .x = at.x, .y = at.y});
      push({.kind = EventKind::kPress, .x = at.x, .y = at.y, .button = MouseButton::kLeft});
      for (int n = 0; n < 20; ++n) push({.kind = EventKind::kMove, .x = at.x + n, .y = at.y + n});
      push({.kind = EventKind::kRelease, .x = at.x + 20, .y = at.y + 20, .button = MouseButton::kLeft});
      push({.kind = EventKind::kKey, .key = "z", .held = {.ctrl = true}});
      push({.kind = EventKind::kKey, .key = std::to_string(k)});
    }
    push({.kind = EventKind::kKey, .key = "q", .held = {.ctrl = true}});
  });
  hand.viewer->run();
  events.join();
  EXPECT_TRUE(hand.viewer->wants_quit());
  EXPECT_EQ(hand.changes(), "");
  EXPECT_GT(hand.window.frames(), 10u);
}

TEST(ViewerThread, PlaysAScript) {
  Hand hand;
  hand.play("drag 2.5,1 2.4,1.1 2.5,1\nkey 4\nmove 0.5,0.5\nkey 8\nkey 7\nkey 1\nmove 2,2.95\nkey ]\npause 0.2\nhash");
  EXPECT_EQ(hand.viewer->views().state().scene, hand.viewer->editor().scene());
}

}  // namespace
}  // namespace hottel::viewer_test

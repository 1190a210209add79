// A viewer in space under a hand: events and scripts in, frames out, without a screen.
#include "viewer/window/space/viewer.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "io/files/output_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/viewer/window/space/hand.h"
#include "viewer/picture/space/camera_view.h"
#include "viewer/window/space/commands.h"
#include "viewer/window/space/first_light.h"

namespace hottel::viewer_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing_viewer::Hand;
using testing_viewer::kRoom;
namespace fs = std::filesystem;

// Commands.

TEST(Commands3, HaveUniqueKeysAndOneHelpEach) {
  std::set<std::string_view> keys, names;
  for (const Command& command : commands_3()) {
    if (!command.key.empty()) {
      EXPECT_TRUE(keys.insert(command.key).second) << command.key;
      EXPECT_EQ(command_of_key(command.key, commands_3()), command.name);
    }
    EXPECT_NE(names.insert(command.name).second && command.help.empty() && command.topic != "walk", true)
        << command.name;
  }
}

// A polygon is picked and under the mouse, and was changed and undone: so every command has something to do.
constexpr const char* kReady = "move 0,1.5,0.6\npick rear\nkey ]\nkey '\nkey ctrl+z\nkey h\nkey h";

TEST(Viewer3, DoesEachCommandByKeyAndByNameAlike) {
  Hand by_name, by_key;
  for (const Command& command : commands_3()) {
    SCOPED_TRACE(std::string(command.name) + ", " + std::string(command.key));
    if (command.name == "quit" || command.name == "save") continue;
    for (Hand* hand : {&by_name, &by_key}) hand->play("key escape\nkey 1\nkey f\n" + std::string(kReady));
    ASSERT_EQ(by_name.signature(), by_key.signature());
    const std::string before = by_name.signature();
    by_name.play("do " + std::string(command.name));
    by_key.play("key " + std::string(command.key));
    EXPECT_EQ(by_name.signature(), by_key.signature());
    // These show nothing that is not there.
    const std::set<std::string_view> quiet{"look light", "fit", "again", "help", "page up", "page down"};
    EXPECT_EQ(by_name.signature() == before, quiet.contains(command.name));
    while (by_name.viewer->editor().history().can_undo())
      for (Hand* hand : {&by_name, &by_key}) hand->viewer->command("undo");
    if (command.name == "gather")
      for (Hand* hand : {&by_name, &by_key}) hand->viewer->command("gather");
  }
}

TEST(Viewer3, RefusesOtherNames) {
  Hand hand;
  const std::string before = hand.signature();
  for (const char* name : {"", "lefty", "look", "look nothing", "own colour", "undo ", "polyline"})
    EXPECT_THROW(hand.viewer->command(name), UsageError) << name;
  EXPECT_EQ(hand.signature(), before);
}

TEST(Viewer3, SaysWhyACommandDoesNothing) {
  Hand hand;
  for (const auto& [command, message] : std::vector<std::pair<std::string, std::string>>{
           {"undo", "there is nothing to undo"},
           {"redo", "there is nothing to do again"},
           {"colour", "no polygon with a material lies under the mouse, and none is picked"},
           {"copy number", "there is no number to copy"}}) {
    hand.play("do " + command);
    EXPECT_EQ(hand.viewer->message(), message) << command;
  }
  hand.play("pick floor");
  for (int k = 0; k < 30; ++k) hand.viewer->command("more reflectivity");
  EXPECT_EQ(hand.viewer->message(), "it goes no further");
}

// Pointing.

double apart(const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// (7), in every view mode and at each scale, of surfaces and of what is seen beside them.
TEST(Viewer3, ZoomsAndPansWhatIsPointedAtInEveryViewMode) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    TemporaryFolder folder;
    std::ofstream(folder / "room.json") << kRoom;
    RecordingWindow window({640, 400});
    Viewer3 viewer({folder / "room.json", [file = folder / "room.json"] { return read_scene_3(file); }}, window,
                   FactorsRequest3{}, scale);
    viewer.settle(Hand::kPatience);
    play_script(parse_script("pick floor", "hand.txt"), "hand.txt", viewer, window, {.print = {}});
    for (int mode = 0; mode < kViewModes3; ++mode)
      for (const Pixel& mouse : {Pixel{250, 250}, {330, 120}, {30, 320}}) {
        SCOPED_TRACE(std::to_string(scale) + " " + to_string(static_cast<ViewMode3>(mode)));
        viewer.command("fit");
        viewer.command(std::string("look ") + to_string(static_cast<ViewMode3>(mode)));
        const auto shown_mode = static_cast<ViewMode3>(mode);
        if (shown_mode == ViewMode3::kSweeps || (shown_mode == ViewMode3::kErrors && scale > 1))
          viewer.update();  // these take seconds
        else
          viewer.settle(Hand::kPatience);
        const Direction3 place = viewer.pointed_place(mouse);
        const auto place_at = [&] { return viewer.camera().at(place, {640, 400}).value(); };
        EXPECT_LT(apart(place_at(), mouse), 1e-6);
        const auto send = [&](WindowEvent::Kind kind, double dx, double notches) {
          viewer.handle(
              {.kind = kind, .x = mouse.x + dx, .y = mouse.y - dx, .button = MouseButton::kRight, .wheel = notches});
          viewer.update();
        };
        for (const double notches : {2.0, -1.0, 0.5}) {
          send(WindowEvent::Kind::kWheel, 0, notches);
          EXPECT_LT(apart(place_at(), mouse), 1e-3) << notches;
        }
        send(WindowEvent::Kind::kPress, 0, 0);
        for (const double dx : {9.0, 14.0, 20.0}) {
          send(WindowEvent::Kind::kMove, dx, 0);
          EXPECT_LT(apart(place_at(), {mouse.x + dx, mouse.y - dx}), 1e-3);
        }
        send(WindowEvent::Kind::kRelease, 20, 0);
      }
  }
}

TEST(Viewer3, PointsAtTheSurfaceThatIsSeenThere) {
  Hand hand;
  const Direction3 rear = hand.viewer->pointed_place(hand.viewer->pixel_of_place(std::array{1.2, 2.0, 1.5}));
  EXPECT_LT(length(rear - Direction3{1.2, 2, 1.5}), 1e-6);
  const Direction3 top = hand.viewer->pointed_place(hand.viewer->pixel_of_place(std::array{1.2, 1.4, 0.4}));
  EXPECT_LT(length(top - Direction3{1.2, 1.4, 0.4}), 1e-6) << "the box before the wall";
}

TEST(Viewer3, ScrollsALongText) {
  Hand hand;
  hand.play("size 640x400\ndo look factors\npick floor\nmove @600,300");
  const std::string before = hand.signature();
  const Raster first = hand.viewer->frame();
  hand.play("wheel @600,300 -2");
  EXPECT_EQ(hand.signature(), before) << "the eye stays";
  EXPECT_NE(hand.viewer->frame().pixels, first.pixels);
  hand.play("key home\nkey pagedown\nkey pageup");
  EXPECT_EQ(hand.signature(), before) << "over a long text these keys are its own";
  hand.play("move @100,200\nkey shift+pagedown\nkey shift+pageup");
  EXPECT_EQ(hand.signature(), before);
  hand.play("key pageup");
  EXPECT_NE(hand.signature(), before) << "elsewhere they are of the eye";
}

// What is shown.

// (1) and (2): the frame is the picture of the camera, with the light of a new simulation.
TEST(Viewer3, ShowsTheLightOfTheSceneAtRest) {
  Hand hand;
  Scene3 scene = read_scene_3(hand.file());
  const Simulation3 fresh(scene, {.factors = {.granularity = Granularity::kElement}});
  const ChannelSolution& light = hand.viewer->state().version->radiosities()->channels[0];
  for (std::size_t i = 0; i < light.elements.size(); ++i)
    EXPECT_EQ(light.elements[i].radiosity, fresh.radiosities()->channels[0].elements[i].radiosity);
  const ElementPaint3 paint = light_paint_3(scene, *fresh.radiosities());
  const LiveModel3 model(*fresh.prepared());
  const ToneCurve tone(kUsualTone3, 1, paint.values, paint.channels);
  const Raster raster =
      SeenPicture3({model.prepared, model.table(), paint, &model.mesh}, hand.viewer->camera().camera({400, 300}))
          .raster(&tone);
  int same = 0, all = 0;
  for (const std::uint32_t y : {100u, 120u, 140u, 160u, 250u, 270u, 290u})  // beside the texts and the legend
    for (std::uint32_t x = 0; x < 400; ++x, ++all)
      same += raster.pixels[y * 400 + x] == hand.viewer->frame().pixels[y * 400 + x];
  EXPECT_EQ(same, all);
}

// Before there are factors: the first frames of a window.
TEST(Viewer3, ShowsTheSceneBeforeItsLight) {
  const Scene3 scene = parse_scene_3(kRoom, "room");
  const LiveModel3 model(prepare(scene));
  const ElementPaint3 paint = light_before_factors_3(scene, model.table());
  ASSERT_EQ(paint.channels, 3u);
  ASSERT_EQ(paint.values.size(), 3u * model.table().count());
  std::uint32_t lamp = 0, floor = 0;
  while (model.table().elements()[lamp].name != "lamp") ++lamp;
  while (model.table().elements()[floor].name != "floor#0") ++floor;
  EXPECT_GE(paint.value(lamp)[0], 4);
  EXPECT_GT(paint.value(floor)[0], 0);
  EXPECT_LT(paint.value(floor)[0], 4);
}

TEST(Viewer3, MovesTheEye) {
  Hand hand;
  const EyeCamera3 home = hand.viewer->camera();
  std::set<std::string> seen;
  for (const char* step :
       {"orbit 10 5", "turn 10", "pan 0.1 0.1", "zoom 1.5", "walk 0.2 0.1 0.1", "key w", "key shift+left",
        "drag @200,150 @260,170", "drag @200,150 @260,170 ctrl", "drag @200,150 @260,170 shift",
        "drag @200,150 @260,170 right", "wheel @200,150 2", "eye 1,0.5,1 1,2,1.5"}) {
    hand.play("key f\n" + std::string(step));
    EXPECT_NE(hand.viewer->camera(), home) << step;
    seen.insert(hand.signature());
  }
  EXPECT_EQ(seen.size(), 12u) << "dragging with shift and with the right button is one thing";
  hand.play("key f");
  EXPECT_EQ(hand.viewer->camera(), home);
}

// (3)
TEST(Viewer3, KeepsTheEyeOutOfSolids) {
  Hand hand;
  const EyeCamera3 before = hand.viewer->camera();
  hand.play("eye 1.2,1.4,0.2 1.2,0,0.2");
  EXPECT_EQ(hand.viewer->camera(), before);
  EXPECT_EQ(hand.viewer->message(), "there is the solid 'box'");
}

TEST(Viewer3, PicksWhatIsClicked) {
  Hand hand;
  hand.play("click 1,2,1.5");
  EXPECT_EQ(hand.picked(), "rear");
  hand.play("click 0.3,1.5,0");
  EXPECT_EQ(hand.picked(), "floor");
  hand.play("click 1.2,1.4,0.4");
  EXPECT_EQ(hand.picked(), "box.top");
  const std::vector<std::string> lines = face_lines_3(*hand.viewer->state().version, {0, false},
                                                      LiveElement3{hand.viewer->state().version->shared_model(), 0});
  EXPECT_EQ(lines[0], "floor");
  EXPECT_THAT(lines, testing::Contains("element\t1 of 4"));
  EXPECT_THAT(lines, testing::Contains(StartsWith("radiosity r\t0.")));
  hand.play("key escape");
  EXPECT_EQ(hand.picked(), "");
  hand.play("pick left");
  EXPECT_EQ(hand.picked(), "left");
  EXPECT_THROW(hand.play("pick nothing"), InputError);
}

TEST(Viewer3, ListsTheFactorsOfAPickedPolygonLargestFirst) {
  Hand hand;
  hand.play("key 5");
  EXPECT_THAT(hand.viewer->result()->lines, ElementsAre("click a polygon"));
  hand.play("pick left");
  Scene3 scene = read_scene_3(hand.file());
  const ExchangeMatrix matrix = Simulation3(scene).factors()->matrix;
  const auto lines = hand.viewer->result()->lines;
  ASSERT_EQ(lines.size(), matrix.row(*matrix.find("left")).size() + 1);
  EXPECT_EQ(lines[0], "from left");
  double before = 1;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double value = std::stod(lines[k]);
    EXPECT_LE(value, before);
    before = value;
    const std::string to = lines[k].substr(lines[k].find('\t') + 1, lines[k].rfind('\t') - lines[k].find('\t') - 1);
    EXPECT_EQ(value, matrix.factor("left", to).value) << lines[k];
  }
  ASSERT_TRUE(hand.viewer->result()->shown);
  EXPECT_EQ(hand.viewer->result()->shown->elements.size(), hand.viewer->state().version->factors()->matrix.size());
}

TEST(Viewer3, ShowsTheErrorsOfAMethodBesideTheLight) {
  Hand hand;
  hand.play("key 7");
  ASSERT_TRUE(hand.viewer->result()->shown);
  EXPECT_EQ(hand.viewer->result()->lines[0], "points:2");
  const Raster before = hand.viewer->frame();
  hand.play("drag @200,150 @100,150");
  EXPECT_NE(hand.viewer->frame(), before);
  hand.play("key m");
  EXPECT_THAT(hand.viewer->message(), StartsWith("method "));
  EXPECT_NE(hand.viewer->result()->lines[0], "points:2");
}

TEST(Viewer3, SweepsUntilTheLightIsThere) {
  Hand hand;
  hand.play("key 0");
  ASSERT_TRUE(hand.viewer->result()->radiosities);
  EXPECT_EQ(hand.viewer->result()->lines[0], "gauss-seidel, 50 sweeps");
  const double there = hand.viewer->state().version->radiosities()->channels[0].elements[0].radiosity;
  EXPECT_NEAR(hand.viewer->result()->radiosities->channels[0].elements[0].radiosity, there, 1e-12);
}

// Materials.

TEST(Viewer3, EmissionsAndReflectivitiesAreLive) {
  Hand hand;
  const auto factors = hand.viewer->state().version->factors();
  const auto light = [&] { return hand.viewer->state().version->radiosities()->channels[0].elements[0].radiosity; };
  const double before = light();
  hand.play("material lamp emission 8");
  EXPECT_EQ(hand.material("lamp").emission, Spectrum::scalar(8));
  EXPECT_NEAR(light(), 2 * before, 1e-12);
  EXPECT_EQ(hand.viewer->state().version->factors(), factors);
  hand.play("move 1,2,1.5\nkey ]");
  EXPECT_EQ(hand.material("white").reflectivity, Spectrum::scalar(Rational(55) / 100));
  EXPECT_GT(light(), 2 * before);
  EXPECT_EQ(hand.viewer->state().version->factors(), factors);
  hand.play("key ctrl+z\nkey ctrl+z");
  EXPECT_EQ(light(), before);
  hand.play("key ctrl+y\npick lamp\nleave\nkey i\nkey ctrl+u\ntype emission 1/3\nkey enter");
  EXPECT_EQ(hand.material("lamp").emission, Spectrum::scalar(Rational(1) / 3));
  EXPECT_FALSE(hand.viewer->prompt());
  EXPECT_THROW(hand.play("material lamp emission -1"), InputError);
  EXPECT_THROW(hand.play("material none emission 1"), InputError);
}

// The parts that are seen are kept while materials change: the frame is that of a viewer that has seen nothing before.
TEST(Viewer3, AnEditShowsWhatAFreshViewerWouldShow) {
  for (const std::string key : {"key 1", "key 3"}) {  // light, irradiance
    Hand hand;
    hand.play(key + "\nmaterial lamp emission 9 1 4\nmaterial white reflectivity 0.7");
    Hand fresh(write_scene_3(*hand.viewer->scene()));
    fresh.play(key);
    for (std::size_t y = 100; y < 220; ++y)  // between the texts, in which times are written
      for (std::size_t x = 0; x < 400; ++x)
        ASSERT_EQ(hand.viewer->frame().pixels[y * 400 + x], fresh.viewer->frame().pixels[y * 400 + x]) << x << " " << y;
  }
}

// Files.

TEST(Viewer3, WhatIsSavedIsWhatIsSeen) {
  Hand hand;
  const std::string hashes = hand.play("material lamp emission 2\nhash\nsave " + hand.path("saved.json").string());
  EXPECT_THAT(hashes, StartsWith("factors.csv "));
  RecordingWindow window({200, 100});
  Viewer3 fresh({hand.path("saved.json"), [&] { return read_scene_3(hand.path("saved.json")); }}, window, {}, 1);
  fresh.settle(Hand::kPatience);
  EXPECT_EQ(fresh.hashes() + "\n", hashes);
  EXPECT_THROW(hand.play("save " + hand.path("saved.obj").string()), InputError);
  EXPECT_THROW(hand.play("save " + hand.path("no/such.json").string()), OutputError);
}

TEST(Viewer3, AsksBeforeChangesAreLost) {
  Hand hand;
  hand.play("material lamp emission 2\nclose");
  EXPECT_FALSE(hand.viewer->wants_quit());
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_EQ(hand.window.title(), "room.json * - hottel");
  hand.play("key escape\ndo reload");
  ASSERT_TRUE(hand.viewer->prompt());
  hand.play("key r");
  EXPECT_EQ(hand.material("lamp").emission, Spectrum::scalar(4));
  hand.play("close");
  EXPECT_TRUE(hand.viewer->wants_quit());
}

TEST(Viewer3, OffersAFileThatAnotherProgramWrote) {
  Hand hand;
  std::string text = kRoom;
  text.replace(text.find("\"emission\": 4"), 13, "\"emission\": 40");
  std::ofstream(hand.file()) << text;
  hand.viewer->handle({.kind = WindowEvent::Kind::kFocus});
  hand.viewer->update();
  ASSERT_TRUE(hand.viewer->prompt());
  hand.play("key r");
  EXPECT_EQ(hand.material("lamp").emission, Spectrum::scalar(40));
}

TEST(Viewer3, WritesPictures) {
  Hand hand;
  for (const char* name : {"seen.png", "seen.svg", "seen.pdf"}) {
    hand.play("picture " + hand.path(name).string());
    EXPECT_GT(fs::file_size(hand.path(name)), 500u);
  }
  EXPECT_THROW(hand.play("picture " + hand.path("seen.gif").string()), InputError);
  EXPECT_THROW(hand.play("move 1,2"), InputError);
  EXPECT_THROW(hand.play("move 1,-2,1"), InputError) << "behind the eye";
  EXPECT_THROW(hand.play("zoom 0"), InputError);
}

// A scene without light is shown, and why.
TEST(Viewer3, SaysWhyThereIsNoLight) {
  Hand hand(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}, "n": {}}, "polygons": [
    {"name": "a", "points": [[0,0,0],[1,0,0],[0,1,0]], "material": "m"},
    {"name": "b", "points": [[0,0,0],[2,0,0],[0,2,0]], "material": "n"}]})");
  EXPECT_THAT(hand.viewer->state().problem, HasSubstr("different materials"));
  EXPECT_EQ(hand.play("hash"), "factors.csv - radiosity.csv -\n");
  hand.play("material n reflectivity 0.5");
  EXPECT_EQ(hand.viewer->state().problem, "");
  EXPECT_NE(hand.play("hash"), "factors.csv - radiosity.csv -\n");
  hand.play("material n reflectivity 0.25");
  EXPECT_THAT(hand.viewer->state().problem, HasSubstr("different materials"));
}

// The file.

TEST(Viewer3, TellsThatTheFileIsGoneAndReadsItWhenItIsBack) {
  Hand hand;
  const auto look_again = [&] {
    hand.viewer->handle({.kind = WindowEvent::Kind::kFocus});
    hand.viewer->settle(Hand::kPatience);
  };
  fs::rename(hand.file(), hand.path("elsewhere.json"));
  look_again();
  EXPECT_THAT(hand.viewer->message(), StartsWith("room.json is gone, or cannot be read"));
  EXPECT_THAT(hand.window.title(), HasSubstr("(gone)"));
  fs::rename(hand.path("elsewhere.json"), hand.file());
  look_again();
  EXPECT_EQ(hand.viewer->message(), "read again");
  hand.play("pick floor\nkey f6");
  const std::string edited = write_scene_3(*hand.viewer->scene());
  fs::remove(hand.file());
  look_again();
  std::ofstream(hand.file()) << kRoom;
  look_again();
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_THAT(hand.viewer->prompt()->question, StartsWith("room.json is there again"));
  EXPECT_EQ(write_scene_3(*hand.viewer->scene()), edited);
  hand.play("key r");
  EXPECT_EQ(write_scene_3(*hand.viewer->scene()), write_scene_3(parse_scene_3(kRoom, "room")));
}

// The first view.

std::string room_with(const std::string& lamp) {
  std::string text = kRoom;
  const std::string emits = R"("emission": 4)";
  return text.replace(text.find(emits), emits.size(), R"("emission": )" + lamp);
}

// (10)
TEST(Viewer3, ShowsTheFormWhereNothingShines) {
  Hand hand(room_with("0"));
  hand.play("leave");
  EXPECT_TRUE(hand.viewer->has_outlines());
  std::set<std::uint32_t> colours(hand.viewer->frame().pixels.begin(), hand.viewer->frame().pixels.end());
  EXPECT_GT(colours.size(), 20u);
  EXPECT_LT(std::ranges::count(hand.viewer->frame().pixels, 0xFF000000u), 200) << "next to nothing is black";
  hand.play("pick lamp\nkey f8");
  EXPECT_TRUE(hand.material("lamp").emission.value[0] > 0) << "what is lit then is light";
  EXPECT_FALSE(hand.viewer->has_outlines());
}

TEST(Viewer3, ALampIsSeenThroughTheUsualCurve) {
  Hand hand;
  EXPECT_EQ(hand.viewer->tone(), Tone::kReinhard);
  EXPECT_EQ(hand.viewer->exposure(), 1);
  EXPECT_FALSE(hand.viewer->has_outlines());
  hand.play("key f4\nkey x");
  EXPECT_EQ(hand.viewer->exposure(), 1.2);
  EXPECT_TRUE(hand.viewer->has_outlines());
}

}  // namespace
}  // namespace hottel::viewer_test

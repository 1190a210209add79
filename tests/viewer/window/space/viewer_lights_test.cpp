// The lights of a viewer in space under a hand.
#include <gmock/gmock.h>

#include <array>

#include "geometry/space/scene/moving_lights.h"
#include "kernel/support/failure.h"
#include "tests/viewer/window/space/hand.h"
#include "viewer/window/lights.h"

namespace hottel::viewer_lights_test {
namespace {

using testing::StartsWith;
using testing_viewer::Hand;
using testing_viewer::kRoom;

// The room with a spot that shines down in its middle, and a bulb at the left that walks.
std::string lit_room() {
  std::string text = kRoom;
  text.insert(text.find("\"camera\""), R"("lights": [
    {"type": "spot", "name": "torch", "position": [1, 1.4, 1.2], "direction": [0, 0, -1], "focus": 30, "power": 5},
    {"type": "point", "name": "bulb", "power": [2, 1, 1],
     "path": {"points": [[0.4, 1.2, 1], [0.4, 1.6, 1]], "seconds": 2, "closed": true}}],
  )");
  return text;
}

class LitHand : public Hand {
 public:
  LitHand() : Hand(lit_room()) {}
  const Light& light(std::size_t k = 0) const { return viewer->scene()->lights[k]; }
  const LightPlace3& place(std::size_t k = 0) const { return viewer->scene()->light_places[k]; }
  const ChannelSolution& radiosities() const { return viewer->state().version->radiosities()->channels[0]; }

  // Whether the light is that of a new simulation of a scene.
  bool is_light_of(const Scene3& scene) const {
    const Simulation3 fresh(scene, {.factors = {.granularity = Granularity::kElement}});
    const auto& elements = fresh.radiosities()->channels[0].elements;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (elements[i].radiosity != radiosities().elements[i].radiosity) return false;
    return true;
  }
};

TEST(Viewer3Lights, AreMovedAndTheirLightFollows) {
  LitHand hand;
  const auto factors = hand.viewer->state().version->factors();
  hand.play("drag 1,1.4,1.2 0.6,1.4,1.5");
  EXPECT_NEAR(to_double(hand.place().position.x), 0.6, 0.05);
  EXPECT_NEAR(to_double(hand.place().position.z), 1.5, 0.05);
  EXPECT_EQ(Rational(hand.place().position.x * 100).get_den(), 1);
  EXPECT_EQ(hand.viewer->editor().selected_light(), 0u);
  EXPECT_EQ(hand.viewer->state().version->factors(), factors);
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
  hand.play("key ctrl+z");
  EXPECT_EQ(hand.viewer->message(), "undone: move torch");
  EXPECT_EQ(hand.place().position, (Point3{1, Rational(7, 5), Rational(6, 5)}));
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
  hand.play("key ctrl+y\ndrag 0.6,1.4,1.5 0.6,1.4,1.2 shift");
  EXPECT_NEAR(to_double(hand.place().position.z), 1.2, 0.05);
}

// A drag shows light before it ends.
TEST(Viewer3Lights, AreSeenWhileTheyAreDragged) {
  LitHand hand;
  hand.play("press 1,1.4,1.2");
  const double before = hand.radiosities().elements[0].radiosity;
  hand.play("move 0.6,1.4,1.2");
  EXPECT_NE(hand.radiosities().elements[0].radiosity, before);
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
  hand.play("key escape");
  EXPECT_EQ(hand.radiosities().elements[0].radiosity, before);
}

TEST(Viewer3Lights, AreTurnedFocusedAndAimed) {
  LitHand hand;
  const Pixel axis = hand.viewer->pixel_of_place(std::array{1.0, 1.4, 0.764});
  const std::string from = "@" + std::to_string(axis.x) + "," + std::to_string(axis.y);
  hand.play("click 1,1.4,1.2\ndrag " + from + " 0.7,1.4,1");
  EXPECT_LT(to_double(hand.place().direction.x), -0.5);
  EXPECT_EQ(hand.viewer->message(), "");
  hand.play("key ctrl+z\ndrag " + from + " 0.4,1.5,0 ctrl");
  const Vector3& way = hand.place().direction;  // at that place of the floor
  EXPECT_NEAR(to_double(way.x), -0.6, 0.05);
  EXPECT_NEAR(to_double(way.y), 0.1, 0.1);
  EXPECT_EQ(way.z, Rational(-6, 5));
  hand.play("key ctrl+z");
  const LightShape3 shape = *light_shape(*hand.viewer->scene(), 0, [&] {
    Pointer3 pointer = hand.viewer->camera().pointer({}, {400, 300});
    pointer.arm = 60;
    return pointer;
  }());
  const Pixel left = hand.viewer->pixel_of_place(std::array{shape.left.x, shape.left.y, shape.left.z});
  hand.play("drag @" + std::to_string(left.x) + "," + std::to_string(left.y) + " @" + std::to_string(left.x - 15) +
            "," + std::to_string(left.y - 12));
  EXPECT_GT(hand.light().focus, 35);
  EXPECT_EQ(hand.light().focus.get_den(), 1);
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
}

TEST(Viewer3Lights, TakeTheKeysOfMaterials) {
  LitHand hand;
  const auto materials = hand.viewer->scene()->materials;
  hand.play("move 1,1.4,1.2\ndo less reflectivity\ndo more emission\ndo colour");
  EXPECT_EQ(hand.light().focus, 24);
  EXPECT_EQ(hand.light().power.value[0], Rational(63, 10));
  hand.play("key i\ntype ; falloff 2; rotation 0 0 -6\nkey enter");
  EXPECT_EQ(hand.light().falloff, 2);
  EXPECT_EQ(hand.place().rotation, (Vector3{0, 0, -6}));
  hand.play("key i\nkey ctrl+u\ntype focus 200\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_EQ(hand.viewer->prompt()->problem, "focus must be greater than 0 and at most 180 degrees");
  hand.play("key escape\nkey escape\npick bulb\nleave\nkey ;");  // nothing under the mouse: the one that is picked
  EXPECT_EQ(hand.light(1).power.value[0], Rational(8, 5));
  EXPECT_EQ(hand.viewer->message(), light_line(hand.viewer->scene()->lights[1], std::vector<Rational>(3)));
  EXPECT_EQ(hand.viewer->scene()->materials, materials);
  hand.play("move 1,2,1.5\nkey ]");  // a polygon is under the mouse
  EXPECT_NE(hand.viewer->scene()->materials, materials);
}

TEST(Viewer3Lights, ArePlacedTurnedCopiedAddedAndDeleted) {
  LitHand hand;
  hand.play("click 1,1.4,1.2\nkey enter\nkey ctrl+u\ntype 1/3, 1, 1.5\nkey enter");
  EXPECT_EQ(hand.place().position, (Point3{Rational(1, 3), 1, Rational(3, 2)}));
  hand.play("key enter\nkey enter");  // as it is shown
  EXPECT_EQ(hand.place().position.x, Rational(1, 3));
  hand.play("key r\nkey shift+r\nkey ctrl+r\nkey ctrl+d");
  ASSERT_EQ(hand.viewer->scene()->lights.size(), 3u);
  EXPECT_EQ(hand.light(2).name, "torch copy");
  hand.play("key delete\nmove 1,2,1.2\nkey b");
  ASSERT_EQ(hand.viewer->scene()->lights.size(), 3u);
  EXPECT_EQ(hand.light(2).name, "light 1");
  EXPECT_LT(hand.place(2).position.y, 2);
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
}

TEST(Viewer3Lights, StayOffSurfacesAndOutOfSolids) {
  LitHand hand;
  hand.play("pick torch\nkey enter\nkey ctrl+u\ntype 1, 1.4, 0\nkey enter");
  ASSERT_TRUE(hand.viewer->prompt());
  EXPECT_EQ(hand.viewer->prompt()->problem, "torch lies on the surface 'floor'; a light has to be beside it");
  hand.play("key ctrl+u\ntype 1.2 1.4 0.2\nkey enter");
  EXPECT_EQ(hand.viewer->prompt()->problem, "there is the solid 'box'");
  hand.play("key escape\nkey escape\ndrag 1,1.4,1.2 1.2,1.4,0.2");
  EXPECT_EQ(hand.viewer->message(), "there is the solid 'box'");
  EXPECT_GT(hand.place().position.z, Rational(2, 5));
  EXPECT_EQ(hand.viewer->state().problem, "");
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
}

TEST(Viewer3Lights, SayWhyACommandDoesNothing) {
  LitHand hand;
  for (const char* command : {"turn", "copy", "delete", "coordinates"}) {
    hand.play("do " + std::string(command));
    EXPECT_EQ(hand.viewer->message(), "nothing is selected") << command;
  }
  hand.play("do spin");
  EXPECT_EQ(hand.viewer->message(), "no light lies under the mouse, and none is selected");
  hand.play("pick torch\ndo turn");
  EXPECT_EQ(hand.viewer->message(), "it turns about the vertical, and that is its axis");
  hand.play("pick bulb\ndo turn");
  EXPECT_EQ(hand.viewer->message(), "a point light has no axis to turn");
  hand.play("do spin");
  EXPECT_EQ(hand.viewer->message(), "a point light has no axis to turn");
  hand.play("press 1,1.4,1.2\nmove 0.6,1.4,1.2\ndo turn");
  EXPECT_EQ(hand.viewer->message(), "not while something is dragged");
}

// (6)
TEST(Viewer3Lights, MoveWithTheirTime) {
  LitHand hand;
  const Scene3 standing = *hand.viewer->scene();
  hand.play("key tab\npause 0.5");
  EXPECT_EQ(hand.viewer->time(), Rational(1, 2));
  EXPECT_EQ(write_scene_3(*hand.viewer->scene()), write_scene_3(standing));
  EXPECT_TRUE(hand.is_light_of(scene_after(standing, Rational(1, 2))));
  EXPECT_FALSE(hand.is_light_of(standing));
  EXPECT_EQ(hand.play("hash"), "factors.csv - radiosity.csv -\n");
  hand.play("key tab");
  EXPECT_EQ(hand.viewer->time(), std::nullopt);
  EXPECT_TRUE(hand.is_light_of(standing));
}

TEST(Viewer3Lights, SpinAtOnceUntilTheyAreTouched) {
  LitHand hand;
  hand.play("pick torch\nkey r\ndo coordinates\nkey ctrl+u\ntype 1 1.4 1.3\nkey enter\nmove 1,1.4,1.3\nkey y\npause 1");
  EXPECT_EQ(hand.place().rotation, (Vector3{0, 0, 30}));
  EXPECT_EQ(hand.viewer->time(), 1);
  EXPECT_TRUE(hand.is_light_of(scene_after(*hand.viewer->scene(), 1)));
  hand.play("do more emission");  // an edit is seen where the light is by now
  EXPECT_TRUE(hand.is_light_of(scene_after(*hand.viewer->scene(), 1)));
  hand.play("drag 1,1.4,1.3 0.8,1.4,1.3");
  EXPECT_EQ(hand.viewer->time(), std::nullopt);
  EXPECT_LT(hand.place().position.x, 1);
  EXPECT_TRUE(hand.is_light_of(*hand.viewer->scene()));
}

TEST(Viewer3Lights, StandAgainWhereTheyWouldMeetASurface) {
  std::string text = lit_room();
  text.replace(text.find("[0.4, 1.6, 1]"), 13, "[0.4, 2.8, 1]");  // through the rear
  Hand hand(text);
  hand.play("key tab\npause 0.45");
  EXPECT_EQ(hand.viewer->time(), Rational(9, 20));
  hand.play("pause 0.05");
  EXPECT_EQ(hand.viewer->time(), std::nullopt);
  EXPECT_THAT(hand.viewer->message(), StartsWith("after 0.5 s: bulb lies on the surface 'rear'"));
}

TEST(Viewer3Lights, AreDrawnInTheirColour) {
  LitHand hand;
  const Pixel torch = hand.viewer->pixel_of_place(std::array{1.0, 1.4, 1.2});
  const Pixel bulb = hand.viewer->pixel_of_place(std::array{0.4, 1.2, 1.0});
  const auto pixel = [&](const Pixel& at) {
    return hand.viewer->frame().pixels[static_cast<std::size_t>(at.y) * 400 + static_cast<std::size_t>(at.x)] &
           0xFFFFFF;
  };
  EXPECT_EQ(pixel(torch), 0xFFFFFFu);
  EXPECT_EQ(pixel(bulb), 0xFF8080u);
  const Raster before = hand.viewer->frame();
  hand.play("pick torch");
  EXPECT_NE(hand.viewer->frame(), before);
}

TEST(Viewer3Lights, AreSavedAsTheyAreSeen) {
  LitHand hand;
  const std::string hashes =
      hand.play("drag 1,1.4,1.2 0.6,1.4,1.5\npick torch\nkey '\nhash\nsave " + hand.path("saved.json").string());
  Scene3 saved = read_scene_3(hand.path("saved.json"));
  EXPECT_EQ(saved.light_places, hand.viewer->scene()->light_places);
  EXPECT_EQ(saved.polygons, hand.viewer->scene()->polygons);
  EXPECT_TRUE(saved.light_places[1].path);
  RecordingWindow window({200, 100});
  Viewer3 fresh({hand.path("saved.json"), [&] { return read_scene_3(hand.path("saved.json")); }}, window, {}, 1);
  fresh.settle(Hand::kPatience);
  EXPECT_EQ(fresh.hashes() + "\n", hashes);
}

}  // namespace
}  // namespace hottel::viewer_lights_test

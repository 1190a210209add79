// Lights of space under a hand.
#include "viewer/edit/space/light_handles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/support/failure.h"

namespace hottel::light_handles_test {
namespace {

constexpr double kPixel = 0.01;

// A spot before the eye that shines to the right, and a bulb beside it that walks away from the eye.
Scene3 lit_space() {
  Scene3 scene;
  Light spot{.name = "spot", .type = LightType::kSpot, .focus = 30, .power = {}};
  spot.power = Spectrum::scalar(3);
  scene.add_light(spot, {.position = {0, 2, 0}, .direction = {2, 0, 0}, .rotation = {}, .path = {}});
  Light bulb{.name = "bulb", .power = {}};
  bulb.power = Spectrum::scalar(1);
  scene.add_light(
      bulb,
      {.position = {-1, 2, 0}, .rotation = {}, .path = LightPath3{.points = {{-1, 2, 0}, {-1, 3, 0}}, .seconds = 4}});
  return scene;
}

// The eye is at the origin and looks along y; a pixel is 0.02 long where the lights are, and their handles 1 from them.
Pointer3 at(const Pixel& place) { return {.at = place, .pixel = kPixel, .reach = 9, .arm = 50}; }
Pointer3 at(const Direction3& place) { return at(at(Pixel{}).seen(place)); }

LightPlace3 dragged(const Scene3& scene, const LightHold& hold, const Pointer3& pointer) {
  return drag_light(scene, hold, pointer).light_places[hold.light];
}

TEST(LightHandles3, AreWhereTheAxisAndTheBordersOfTheBeamPass) {
  const auto shape = light_shape(lit_space(), 0, at(Pixel{}));
  ASSERT_TRUE(shape && shape->is_spot);
  const auto expect_at = [](const Direction3& p, const Direction3& expected) {
    EXPECT_NEAR(length(p - expected), 0, 1e-12);
  };
  expect_at(shape->axis, {1, 2, 0});
  const double along = std::cos(M_PI / 6);
  EXPECT_NEAR(shape->left.x, along, 1e-12);
  EXPECT_NEAR(std::abs(shape->left.z), 0.5, 1e-12);
  expect_at(shape->right, {along, 2, -shape->left.z});
  for (const Direction3& corner : shape->rim) {
    EXPECT_NEAR(corner.x, along, 1e-12);
    EXPECT_NEAR(length(corner - shape->place), 1, 1e-12);
  }
  EXPECT_FALSE(light_shape(lit_space(), 1, at(Pixel{}))->is_spot);
  Pointer3 behind = at(Pixel{});
  behind.eye = {0, 5, 0};
  EXPECT_FALSE(light_shape(lit_space(), 0, behind));
}

TEST(LightHandles3, ArePickedNearestFirst) {
  const Scene3 scene = lit_space();
  const auto hold = [](std::uint32_t light, LightPart part) { return std::optional(LightHold{light, part}); };
  EXPECT_EQ(pick_light(scene, at(Direction3{0.02, 2, 0})), hold(0, LightPart::kPlace));
  EXPECT_EQ(pick_light(scene, at(Direction3{1, 2, 0.04})), hold(0, LightPart::kAxis));
  const LightShape3 shape = *light_shape(scene, 0, at(Pixel{}));
  EXPECT_EQ(pick_light(scene, at(shape.left)), hold(0, LightPart::kLeft));
  EXPECT_EQ(pick_light(scene, at(shape.right)), hold(0, LightPart::kRight));
  EXPECT_EQ(pick_light(scene, at(Direction3{-1, 2, 0})), hold(1, LightPart::kPlace));
  EXPECT_EQ(pick_light(scene, at(Direction3{-0.5, 2, 0})), std::nullopt);
  Pointer3 behind = at(Pixel{});
  behind.eye = {0, 5, 0};
  EXPECT_EQ(pick_light(scene, behind), std::nullopt);
}

// (1) and (2)
TEST(LightHandles3, ASunHasNone) {
  Scene3 scene = lit_space();
  scene.lights[1].type = LightType::kSun;
  EXPECT_EQ(pick_light(scene, at(Direction3{-1, 2, 0})), std::nullopt);
  EXPECT_FALSE(light_shape(scene, 1, at(Pixel{})));
}

TEST(LightHandles3, MoveParallelToThePictureAndTakeThePathAlong) {
  const LightPlace3 place = dragged(lit_space(), {1, LightPart::kPlace}, at(Direction3{-0.503, 2, 0.25}));
  EXPECT_EQ(place.position, (Point3{Rational(-1, 2), 2, Rational(1, 4)}));
  EXPECT_EQ(place.path->points.back(), (Point3{Rational(-1, 2), 3, Rational(1, 4)}));
}

TEST(LightHandles3, MoveAlongTheAxisThatGoesTheSameWay) {
  const auto moved = [](const Pixel& to) {
    Pointer3 pointer = at(to);
    pointer.along_axis = true;
    return dragged(lit_space(), {1, LightPart::kPlace}, pointer).position;
  };
  EXPECT_EQ(moved({-0.25, 0.03}), (Point3{Rational(-1, 2), 2, 0}));
  EXPECT_EQ(moved({-0.52, 0.25}).x, -1);
  EXPECT_EQ(moved({-0.52, 0.25}).z, Rational(1, 2));
  // A line that goes away from the eye is seen to go to the middle of the picture; here x goes there more directly.
  Scene3 scene = lit_space();
  scene.light_places[1].position = {-2, 2, 0};
  Pointer3 pointer = at(Pixel{-0.5, 0});
  pointer.along_axis = true;
  const Point3 to = dragged(scene, {1, LightPart::kPlace}, pointer).position;
  EXPECT_TRUE((to == Point3{-1, 2, 0}) || (to == Point3{-2, 4, 0}));
}

TEST(LightHandles3, KeepDigitsOfCoordinatesThatDoNotChange) {
  Scene3 scene = lit_space();
  scene.light_places[0].position = {0, 2, Rational(1, 3)};
  const LightPlace3 place = dragged(scene, {0, LightPart::kPlace}, at(Direction3{0.5, 2, 0.334}));
  EXPECT_EQ(place.position, (Point3{Rational(1, 2), 2, Rational(1, 3)}));
  EXPECT_EQ(dragged(scene, {0, LightPart::kPlace}, at(Direction3{0, 2, 0.333})), scene.light_places[0]);
}

// (3)
TEST(LightHandles3, AimExactlyAtThePlace) {
  Pointer3 pointer = at(Pixel{0.1, 0.1});
  pointer.aim = Direction3{1.001, 3, -1.2499};
  EXPECT_EQ(dragged(lit_space(), {0, LightPart::kAxis}, pointer).direction, (Vector3{1, 1, Rational(-5, 4)}));
  pointer.aim = Direction3{0.0001, 2, 0};  // where the light is
  EXPECT_EQ(dragged(lit_space(), {0, LightPart::kAxis}, pointer), lit_space().light_places[0]);
}

TEST(LightHandles3, TurnTheAxisUnderTheMouse) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-0.6, 0.6);
  for (int k = 0; k < 200; ++k) {
    Scene3 scene = lit_space();
    scene.light_places[0].direction = {Rational(anywhere(random)), Rational(anywhere(random)),
                                       Rational(anywhere(random))};
    const bool is_farther = scene.light_places[0].direction.y > 0;
    const Pointer3 pointer = at(Pixel{anywhere(random), anywhere(random)});
    scene = drag_light(scene, {0, LightPart::kAxis}, pointer);
    const Vector3& now = scene.light_places[0].direction;
    EXPECT_EQ(Rational(now.x * 1000).get_den(), 1);
    const Pixel end = pointer.seen(light_shape(scene, 0, pointer)->axis);
    if (std::hypot(pointer.at.x, pointer.at.y) < 0.45) {
      EXPECT_NEAR(end.x, pointer.at.x, 0.004);
      EXPECT_NEAR(end.y, pointer.at.y, 0.004);
      EXPECT_EQ(now.y > 0, is_farther);
    } else {  // at the rim, in that direction
      EXPECT_NEAR(std::atan2(end.y, end.x), std::atan2(pointer.at.y, pointer.at.x), 0.01);
    }
  }
}

// (4)
TEST(LightHandles3, FocusInWholeDegrees) {
  Scene3 scene = lit_space();
  const LightPart part = light_shape(scene, 0, at(Pixel{}))->left.z > 0 ? LightPart::kLeft : LightPart::kRight;
  const auto focus = [&](double degrees) {
    const double angle = degrees * M_PI / 180;
    return drag_light(scene, {0, part}, at(Direction3{std::cos(angle), 2, std::sin(angle)})).lights[0].focus;
  };
  EXPECT_EQ(focus(45), 45);
  EXPECT_EQ(focus(72.4), 72);
  EXPECT_EQ(focus(-20), 1);
  EXPECT_EQ(focus(180), 180);
  scene.lights[0].falloff = 1;
  EXPECT_EQ(focus(150), 90);
}

// (5)
TEST(LightHandles3, AreNotDraggedBehindTheEye) {
  const Scene3 scene = lit_space();
  Pointer3 behind = at(Pixel{});
  behind.eye = {0, 5, 0};
  for (const LightPart part : {LightPart::kPlace, LightPart::kAxis, LightPart::kLeft})
    EXPECT_EQ(drag_light(scene, {0, part}, behind).light_places, scene.light_places);
  EXPECT_THROW(drag_light(scene, {2, LightPart::kPlace}, at(Pixel{})), ContractViolation);
}

// (6)
TEST(LightHandles3, TurnAboutTheVerticalByQuartersExactly) {
  Scene3 scene = lit_space();
  scene.light_places[0].direction = {Rational(1, 3), Rational(1, 7), -1};
  EXPECT_EQ(turn_light(scene, 0, 90).light_places[0].direction, (Vector3{Rational(-1, 7), Rational(1, 3), -1}));
  EXPECT_EQ(turn_light(scene, 0, -270).light_places, turn_light(scene, 0, 90).light_places);
  const Vector3 turned = turn_light(scene, 0, 15).light_places[0].direction;
  EXPECT_NEAR(std::atan2(to_double(turned.y), to_double(turned.x)), std::atan2(3, 7) + M_PI / 12, 1e-5);
  EXPECT_EQ(Rational(turned.x * 1000000).get_den(), 1);
  EXPECT_EQ(turn_light(scene, 1, 15).light_places, scene.light_places);
}

}  // namespace
}  // namespace hottel::light_handles_test

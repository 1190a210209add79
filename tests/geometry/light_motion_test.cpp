// Lights that turn and follow paths: whole turns, quarters, corners, constant speed.
#include "geometry/light_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/plane/scene/moving_lights.h"
#include "geometry/space/scene/moving_lights.h"

namespace hottel::light_motion_test {
namespace {

using Way = std::vector<std::vector<Rational>>;

TEST(PathPlace, IsAtCornersWhenTheirTimeHasCome) {
  const Way square{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const auto at = [&](const Rational& part) { return place_on_path(square, true, part).point; };
  EXPECT_EQ(at(0), (std::vector<double>{0, 0}));
  EXPECT_EQ(at(Rational(4, 14)), (std::vector<double>{4, 0}));
  EXPECT_EQ(at(Rational(1, 2)), (std::vector<double>{4, 3}));
  EXPECT_EQ(at(Rational(11, 14)), (std::vector<double>{0, 3}));
  EXPECT_EQ(at(1), (std::vector<double>{0, 0}));
  EXPECT_EQ(at(Rational(2, 14)), (std::vector<double>{2, 0}));
}

TEST(PathPlace, MovesAtConstantSpeed) {
  const Way crooked{{0, 0, 0}, {1, 2, 0}, {1, 2, 0}, {-3, 1, 5}, {2, 2, 2}};
  double whole = 0;
  for (std::size_t k = 0; k + 1 < crooked.size(); ++k) {
    double squared = 0;
    for (std::size_t c = 0; c < 3; ++c) squared += std::pow(to_double(crooked[k + 1][c] - crooked[k][c]), 2);
    whole += std::sqrt(squared);
  }
  std::vector<double> before = place_on_path(crooked, false, 0).point;
  double done = 0;
  constexpr int kSteps = 1000;
  for (int k = 1; k <= kSteps; ++k) {
    Rational part(k, kSteps);
    part.canonicalize();
    const std::vector<double> here = place_on_path(crooked, false, part).point;
    const double step = std::hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
    EXPECT_LE(step, whole / kSteps * (1 + 1e-9));
    done += step;
    before = here;
  }
  EXPECT_NEAR(done, whole, 2e-2) << "less what is cut off at corners";
  EXPECT_EQ(before, (std::vector<double>{2, 2, 2}));
}

TEST(PathPlace, StaysAtTheEndUnlessClosed) {
  EXPECT_EQ(part_of_way(7, 2, false), 1);
  EXPECT_EQ(part_of_way(7, 2, true), Rational(1, 2));
  EXPECT_EQ(part_of_way(8, 2, true), 0);
  EXPECT_EQ(part_of_way(1, 2, false), Rational(1, 2));
}

TEST(Turned, QuartersAreExactAndOthersAreRotations) {
  const std::vector<Rational> v{1, 2, 4};
  const auto exact = [](double x, double y, double z) { return std::vector<double>{x, y, z}; };
  EXPECT_EQ(turned(v, {0, 0, 0}), exact(0.25, 0.5, 1));
  EXPECT_EQ(turned(v, {90, 0, 0}), exact(0.25, -1, 0.5)) << "about x: y to z";
  EXPECT_EQ(turned(v, {0, 90, 0}), exact(1, 0.5, -0.25)) << "about y: z to x";
  EXPECT_EQ(turned(v, {0, 0, 90}), exact(-0.5, 0.25, 1)) << "about z: x to y";
  EXPECT_EQ(turned(v, {90, 0, 90}), exact(1, 0.25, 0.5)) << "about x first";
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const auto draw = [&]() -> Rational { return Rational(static_cast<int>(random() % 3600)) / 10; };
    const std::vector<Rational> angles{draw(), draw(), draw()};
    const std::vector<double> w = turned(v, angles);
    EXPECT_NEAR(std::hypot(w[0], w[1], w[2]), std::sqrt(21.0) / 4, 1e-15);
    double x = 0.25, y = 0.5, z = 1;
    const auto turn = [](double& a, double& b, const Rational& degrees) {
      const double t = to_double(degrees) * std::numbers::pi / 180, a0 = a;
      a = std::cos(t) * a - std::sin(t) * b;
      b = std::sin(t) * a0 + std::cos(t) * b;
    };
    turn(y, z, angles[0]);
    turn(z, x, angles[1]);
    turn(x, y, angles[2]);
    EXPECT_NEAR(w[0], x, 1e-14);
    EXPECT_NEAR(w[1], y, 1e-14);
    EXPECT_NEAR(w[2], z, 1e-14);
  }
}

TEST(MovingLights2, ComeBackAfterWholeTurnsAndDoNotAddUpErrors) {
  LightPlace2 place{{1, 2}, {3, 1}};
  place.rotation = Rational(7, 3);
  place.turned = 10;
  const LightPlace2 still = place_after(place, 0);
  EXPECT_EQ(still.turned, 10);
  EXPECT_EQ(still.rotation, 0);
  const Rational turn = Rational(360) / place.rotation;
  EXPECT_EQ(place_after(place, turn), still);
  EXPECT_EQ(place_after(place, Rational(1'000'000'007) * turn), still);
  EXPECT_EQ(place_after(place, turn / 2).turned, 190);
  place.rotation = -90;
  EXPECT_EQ(place_after(place, 1).turned, 280);
}

TEST(MovingLights2, OnAPathStandAtDoubles) {
  LightPlace2 place{{0, 0}};
  place.path = LightPath2{{{Rational(1, 3), 0}, {1, 1}}, 3, false};
  const LightPlace2 at = place_after(place, 1);
  EXPECT_EQ(Rational(to_double(at.position.x)), at.position.x);
  EXPECT_NEAR(to_double(at.position.x), 5.0 / 9, 1e-16);
  EXPECT_NEAR(to_double(at.position.y), 1.0 / 3, 1e-16);
  EXPECT_FALSE(at.path.has_value());
  EXPECT_EQ(place_after(place, 100).position, (Point2{1, 1}));
}

TEST(MovingLights3, TurnAboutTheAxesAndComeBack) {
  LightPlace3 place;
  place.position = {1, 2, 3};
  place.rotation = {0, 45, 0};
  EXPECT_EQ(place_after(place, 0).direction, (Vector3{0, 0, -1}));
  EXPECT_EQ(place_after(place, 8).direction, (Vector3{0, 0, -1}));
  EXPECT_EQ(place_after(place, 2).direction, (Vector3{-1, 0, 0}));
  const Vector3 between = place_after(place, 1).direction;
  EXPECT_EQ(between.x, between.z) << "both rounded from one number";
  EXPECT_NEAR(to_double(between.x), -std::sqrt(0.5), 1e-16);
}

TEST(MovingLights, WithoutRotationAndPathThereAreNone) {
  Scene2 scene;
  Light light;
  light.type = LightType::kSpot;
  light.focus = 20;
  LightPlace2 place{{0, 0}, {1, 0}};
  scene.add_light(light, place);
  EXPECT_FALSE(has_moving_lights(scene));
  scene.light_places[0].rotation = 1;
  EXPECT_TRUE(has_moving_lights(scene));
  scene.lights[0].focus = 180;
  EXPECT_FALSE(has_moving_lights(scene)) << "what shines all around alike does not turn";
}

}  // namespace
}  // namespace hottel::light_motion_test

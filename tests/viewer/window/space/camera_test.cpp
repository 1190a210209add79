// The eye that hands move.
#include "viewer/window/space/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hottel::camera_test {
namespace {

constexpr FrameSize kFrame{800, 600};

Camera3 looking(const Point3& eye, const Point3& target) { return {.eye = eye, .target = target}; }

EyeCamera3 some() { return EyeCamera3(looking({-4, -3, 2}, {1, 1, 1}), 5); }

Direction3 place(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }
Direction3 eye(const EyeCamera3& c) { return place(c.camera(kFrame).eye); }
Direction3 target(const EyeCamera3& c) { return place(c.camera(kFrame).target); }
double distance(const Direction3& a, const Direction3& b) { return length(a - b); }

void expect_near(const EyeCamera3& a, const EyeCamera3& b) {
  EXPECT_LT(distance(eye(a), eye(b)), 1e-7);
  EXPECT_LT(distance(target(a), target(b)), 1e-7);
}

TEST(EyeCamera3, LooksAsTheCameraItIsMadeOf) {
  const Camera3 camera = some().camera(kFrame);
  EXPECT_LT(distance(place(camera.eye), {-4, -3, 2}), 1e-7);
  EXPECT_LT(distance(place(camera.target), {1, 1, 1}), 1e-7);
  EXPECT_EQ(camera.field_of_view, 40);
  EXPECT_EQ(camera.width, 800u);
  EXPECT_EQ(camera.height, 600u);
}

// (1)
TEST(EyeCamera3, NeverHasAProblem) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> amount(-300, 300);
  EyeCamera3 camera = some();
  for (int k = 0; k < 2000; ++k) {
    switch (random() % 5) {
      case 0:
        camera.orbit(amount(random), amount(random));
        break;
      case 1:
        camera.turn(amount(random), amount(random));
        break;
      case 2:
        camera.pan(amount(random) / 100, amount(random) / 100);
        break;
      case 3:
        camera.zoom(std::exp(amount(random) / 30));
        break;
      default:
        camera.walk(amount(random) / 100, amount(random) / 100, amount(random) / 100);
    }
    ASSERT_EQ(camera_problem(camera.camera(kFrame)), "") << k;
    ASSERT_GE(camera.distance(), 0.99e-6 * camera.size());
    ASSERT_LE(camera.distance(), 1.01e3 * camera.size());
  }
  EXPECT_EQ(camera_problem(EyeCamera3(looking({0, 0, 0}, {0, Rational(1) / 1000, 9}), 1).camera(kFrame)), "");
}

// (2)
TEST(EyeCamera3, KeepsWhatItsMovesKeep) {
  const EyeCamera3 before = some();
  const Direction3 way = target(before) - eye(before);
  EyeCamera3 camera = before;
  camera.orbit(25, 10);
  EXPECT_NEAR(camera.distance(), before.distance(), 1e-9);
  EXPECT_LT(distance(target(camera), target(before)), 1e-7);
  camera = before;
  camera.turn(25, 10);
  EXPECT_NEAR(camera.distance(), before.distance(), 1e-9);
  EXPECT_LT(distance(eye(camera), eye(before)), 1e-7);
  camera = before;
  camera.pan(0.5, 0.25);
  EXPECT_LT(distance(target(camera) - eye(camera), way), 1e-7);
  EXPECT_NEAR(dot(eye(camera) - eye(before), way), 0, 1e-6);
  camera = before;
  camera.walk(1, 0, 0);
  EXPECT_LT(distance(target(camera) - eye(camera), way), 1e-7);
  EXPECT_NEAR(eye(camera).z, 2, 1e-7);
  EXPECT_NEAR(distance(eye(camera), eye(before)), 1, 1e-7);
  EXPECT_GT(dot(eye(camera) - eye(before), way), 0);
  camera = before;
  camera.zoom(2);
  EXPECT_NEAR(camera.distance(), before.distance() / 2, 1e-9);
  EXPECT_LT(distance(target(camera), target(before)), 1e-7);
  EXPECT_LT(length(cross(target(camera) - eye(camera), way)), 1e-6);
}

// (4)
TEST(EyeCamera3, ComesBack) {
  EyeCamera3 camera = some();
  camera.orbit(30, 0);
  camera.orbit(0, 12);
  camera.orbit(0, -12);
  camera.orbit(-30, 0);
  expect_near(camera, some());
  camera.turn(-70, 0);
  camera.turn(70, 0);
  expect_near(camera, some());
  camera.orbit(360, 0);
  expect_near(camera, some());
}

TEST(EyeCamera3, GoesWhereItsWordsSay) {
  EyeCamera3 camera(looking({0, -5, 0}, {0, 0, 0}), 5);  // along y: right is x, up is z
  EyeCamera3 moved = camera;
  moved.orbit(90, 0);
  EXPECT_LT(distance(eye(moved), {5, 0, 0}), 1e-7);
  moved = camera;
  moved.orbit(0, 45);
  EXPECT_LT(distance(eye(moved), {0, -5 * std::sqrt(0.5), 5 * std::sqrt(0.5)}), 1e-7);
  moved = camera;
  moved.turn(90, 0);
  EXPECT_LT(distance(target(moved), {5, -5, 0}), 1e-7);
  moved = camera;
  moved.turn(0, 45);
  EXPECT_GT(target(moved).z, 1);
  moved = camera;
  moved.pan(2, 3);
  EXPECT_LT(distance(eye(moved), {2, -5, 3}), 1e-7);
  moved = camera;
  moved.walk(1, 2, 3);
  EXPECT_LT(distance(eye(moved), {2, -4, 3}), 1e-7);
}

TEST(EyeCamera3, SeesPlacesWhereTheyAre) {
  const EyeCamera3 camera(looking({0, -5, 0}, {0, 0, 0}), 5);
  EXPECT_NEAR(camera.at({0, 3, 0}, kFrame)->x, 400, 1e-9);
  EXPECT_NEAR(camera.at({0, 3, 0}, kFrame)->y, 300, 1e-9);
  const double length = camera.length_of_pixel(kFrame);
  EXPECT_NEAR(camera.at({100 * length, 0, 50 * length}, kFrame)->x, 500, 1e-9);
  EXPECT_NEAR(camera.at({100 * length, 0, 50 * length}, kFrame)->y, 250, 1e-9);
  EXPECT_FALSE(camera.at({0, -6, 0}, kFrame));
  const auto line = camera.line({-1, 0, 0}, {1, 0, 0}, kFrame);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->first.x + line->second.x, 800, 1e-9);
  EXPECT_TRUE(camera.line({1, 0, 0}, {1, -9, 0}, kFrame));
  EXPECT_FALSE(camera.line({1, -7, 0}, {1, -9, 0}, kFrame));
}

TEST(EyeCamera3, GoesNearerToAPlaceThatStaysWhereItIsSeen) {
  const Direction3 place{0.5, 2, 1.5};
  for (const double factor : {1.3, 0.4, 1e3, 1e9, 1e-9}) {
    EyeCamera3 camera = some();
    const Pixel before = camera.at(place, kFrame).value();
    const double far = length(place - eye(camera));
    camera.zoom_to(place, factor);
    const Pixel after = camera.at(place, kFrame).value();
    EXPECT_NEAR(after.x, before.x, 1e-3) << factor;
    EXPECT_NEAR(after.y, before.y, 1e-3) << factor;
    if (factor < 1e4 && factor > 1e-2) {
      EXPECT_NEAR(length(place - eye(camera)), far / factor, 1e-7) << factor;
    }
    ASSERT_EQ(camera_problem(camera.camera(kFrame)), "") << factor;
  }
}

// (3)
TEST(EyeCamera3, ANarrowFrameShowsAllThatTheCameraShows) {
  const EyeCamera3 camera = some();  // of 800 x 600
  const Direction3 way = target(camera) - eye(camera), right = unit(cross(way, {0, 0, 1}));
  const double half = std::tan(20 * std::acos(-1) / 180) * length(way);
  const Direction3 border = target(camera) + (half * 4 / 3) * right;
  for (const FrameSize frame : {FrameSize{800, 600}, {400, 600}, {640, 400}, {300, 900}}) {
    const Pixel seen = camera.at(border, frame).value();
    EXPECT_LE(seen.x, frame.width + 1e-6);
    const Camera3 exact = camera.camera(frame);
    EXPECT_EQ(camera_problem(exact), "");
    EXPECT_EQ(exact.field_of_view == 40, frame.width * 3 >= frame.height * 4);
    EXPECT_NEAR(std::tan(to_double(exact.field_of_view) / 360 * std::acos(-1)) * length(way),
                camera.length_of_pixel(frame) * frame.height / 2, 1e-9);
  }
  EXPECT_NEAR(camera.at(border, {400, 600}).value().x, 400, 1e-6);
}

}  // namespace
}  // namespace hottel::camera_test

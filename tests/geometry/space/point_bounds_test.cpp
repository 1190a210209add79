// Proven bounds of what a point sees, against closed forms, and against the maps in doubles that they are of.
#include "geometry/space/visibility/point_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "box_scene.h"
#include "geometry/space/visibility/seen_faces.h"

namespace hottel::point_bounds_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

// A scene of boxes, ready to be looked at.
struct Stage {
  explicit Stage(const Scene3& scene) : arrangement(scene), occluders(arrangement.polygons()) {}
  PointBounds3 bounds(const Point3& eye, const std::optional<Vector3>& normal = std::nullopt) const {
    return point_bounds(ExactVisibilityMap3(occluders, eye), arrangement, normal);
  }

  Arrangement3 arrangement;
  Occluders3 occluders;
};

int ulps_between(const Enclosure& bounds) {
  int count = 0;
  for (double x = bounds.lower; x < bounds.upper && count < 9; ++count) x = std::nextafter(x, 2);
  return count;
}

void expect_holds(const Enclosure& bounds, const Quad& value, const std::string& what) {
  EXPECT_LE(Quad(bounds.lower), value) << what;
  EXPECT_GE(Quad(bounds.upper), value) << what;
  EXPECT_LE(ulps_between(bounds), 2) << what;
}

BoxScene3 furnished_room() {
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {6, 5, 3}, true);
  scene.box("a", {1, 1, 0}, {2, 3, 1});
  scene.box("b", {2, 1, 0}, {3, 2, 2});
  scene.polygon("sail", {{{4, 1, 1}, {5, 4, 1}, {4, 3, 2}}});
  return scene;
}

// Properties (1) and (2), by symmetry: of a cube the middle sees a sixth in each face.
TEST(PointBounds3, HoldTheSixthsOfACube) {
  BoxScene3 scene;
  scene.box("room", {-1, -1, -1}, {1, 1, 1}, true);
  const PointBounds3 bounds = Stage(scene).bounds({0, 0, 0});
  ASSERT_EQ(bounds.shares.size(), 6U);
  for (const PointBounds3::Share& share : bounds.shares) expect_holds(share.fraction, Quad(1) / 6, "a face");
  EXPECT_EQ(bounds.sky_fraction.lower, 0);
  EXPECT_LE(bounds.sky_fraction.upper, 1e-30);
}

// Of a small area to a rectangle that is parallel, a corner above it. SEE: Howell's catalogue, B-3.
TEST(PointBounds3, HoldTheFactorOfARectangle) {
  for (const auto& [a, b, height] : {std::tuple(1L, 1L, 1L), {3, 1, 2}, {1, 1, 1000000}, {1000000, 3, 1}}) {
    BoxScene3 scene;
    scene.polygon("plate", {{{0, 0, height}, {0, b, height}, {a, b, height}, {a, 0, height}}});
    const PointBounds3 bounds = Stage(scene).bounds({0, 0, 0}, Vector3{0, 0, 7});
    const Quad x = Quad(a) / height, y = Quad(b) / height, rx = sqrt(1 + x * x), ry = sqrt(1 + y * y);
    const Quad factor = (x / rx * atan(y / rx) + y / ry * atan(x / ry)) / (2 * boost::math::constants::pi<Quad>());
    const Quad fraction = atan(x * y / sqrt(1 + x * x + y * y)) / (4 * boost::math::constants::pi<Quad>());
    ASSERT_EQ(bounds.shares.size(), 1U);
    expect_holds(bounds.shares.front().factor, factor, std::to_string(height));
    expect_holds(bounds.shares.front().fraction, fraction, std::to_string(height));
    expect_holds(bounds.sky_factor, 1 - factor, "sky");
    expect_holds(bounds.sky_fraction, Quad(1) / 2 - fraction, "sky");
  }
}

void expect_near(const Enclosure& bounds, double value, const std::string& what) {
  EXPECT_LE(bounds.lower - 1e-14, value) << what;
  EXPECT_GE(bounds.upper + 1e-14, value) << what;
}

void expect_of_map(const PointBounds3& bounds, const VisibilityMap3& map, const std::string& what) {
  ASSERT_EQ(bounds.shares.size(), map.shares.size()) << what;
  for (std::size_t k = 0; k < map.shares.size(); ++k) {
    EXPECT_EQ(bounds.shares[k].face, map.shares[k].face) << what;
    expect_near(bounds.shares[k].fraction, map.shares[k].fraction, what);
    expect_near(bounds.shares[k].factor, map.shares[k].factor, what);
    EXPECT_LE(ulps_between(bounds.shares[k].fraction), 2) << what;
    EXPECT_LE(ulps_between(bounds.shares[k].factor), 2) << what;
  }
  expect_near(bounds.sky_fraction, map.sky_fraction, what);
  expect_near(bounds.sky_factor, map.sky_factor, what);
}

// Property (3), from points anywhere and on faces, edges and corners, of the border of solids too.
TEST(PointBounds3, AreThoseOfTheMap) {
  const Stage stage(furnished_room());
  std::mt19937_64 engine(5);
  const auto any = [&engine](long most) { return Rational(static_cast<long>(engine() % (7 * most + 1)), 7); };
  std::size_t looks = 0;
  for (int n = 0; n < 60; ++n) {
    const bool is_on_lattice = n % 2 == 0;
    Point3 eye{any(6), any(5), any(3)};
    if (is_on_lattice) eye = {Rational(Integer(eye.x)), Rational(Integer(eye.y)), Rational(Integer(eye.z))};
    if (stage.arrangement.solids().around(eye)) continue;
    const std::string what = to_string(eye.x) + "," + to_string(eye.y) + "," + to_string(eye.z);
    expect_of_map(stage.bounds(eye), faces_seen_from(eye, stage.occluders, stage.arrangement), what);
    const Point3 normal{any(3) - 1, any(3) - 1, Rational(1, 3)};
    const VisibilityMap3 half = map_from(stage.occluders, {.eye = eye, .normal = normal});
    expect_of_map(stage.bounds(eye, normal - Point3{}), with_owners(half, stage.arrangement), what);
    ++looks;
  }
  EXPECT_GT(looks, 40U);
}

// A closed room has no sky, though doubles leave some.
TEST(PointBounds3, ARoomLeavesNoSky) {
  const Stage stage(furnished_room());
  const PointBounds3 bounds = stage.bounds({Rational(1, 3), Rational(10, 3), 0}, Vector3{0, 0, 1});
  EXPECT_EQ(bounds.sky_factor.lower, 0);
  EXPECT_LE(bounds.sky_factor.upper, 1e-30);
}

// A plate so far away that its cone is less than what doubles leave of the sphere.
TEST(PointBounds3, SmallConesHaveAllDigits) {
  const Rational far = Rational(Integer("1" + std::string(40, '0')));
  BoxScene3 scene;
  scene.polygon("plate", {{{0, 0, far}, {0, 1, far}, {1, 1, far}, {1, 0, far}}});
  const PointBounds3 bounds = Stage(scene).bounds({0, 0, 0}, Vector3{0, 0, 1});
  ASSERT_EQ(bounds.shares.size(), 1U);
  expect_holds(bounds.shares.front().factor, Quad("1e-80") / boost::math::constants::pi<Quad>(), "plate");
}

}  // namespace
}  // namespace hottel::point_bounds_test

#include "geometry/space/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "tests/refusal.h"

namespace hottel::scene_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Two walls of one material, each a group.
Scene3 two_walls() {
  Scene3 scene;
  scene.file = "two.json";
  scene.materials.push_back({"white", Spectrum::scalar(Rational(1) / 2), {}});
  const auto add = [&](const std::string& name, const Polygon3& polygon) {
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    surface.line = 10 + static_cast<int>(surface.group);
    scene.groups.push_back(name);
    scene.add(surface, polygon);
  };
  add("floor", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  add("wall", {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  return scene;
}

std::string refusal(const std::function<void(Scene3&)>& change) {
  Scene3 scene = two_walls();
  change(scene);
  return refusal_by([&] { validate(scene); });
}

TEST(Scene3, OfProperPolygonsIsValid) {
  EXPECT_EQ(refusal([](Scene3&) {}), "");
}

TEST(Scene3, HasAPolygonForEverySurface) {
  Scene3 scene = two_walls();
  scene.polygons.pop_back();
  EXPECT_THROW(validate(scene), ContractViolation);
}

TEST(Scene3, HasNoPolygonWithAProblem) {
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1].points.pop_back(); }), "");
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1].points.resize(2); }),
            "two.json:11: polygon 'wall' has fewer than three points");
  EXPECT_THAT(refusal([](Scene3& s) { s.polygons[0].points[2].z = Rational(1) / 4; }),
              StartsWith("two.json:10: polygon 'floor' is not plane: points lie 0.2"));
}

TEST(Scene3, MayHavePolygonsThatShareAnArea) {
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}}; }), "");
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1] = s.polygons[0]; }), "");
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1] = {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}}; }), "");
  // Polygons of different planes may go through each other.
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[1] = {{{0, 0, -1}, {1, 0, -1}, {0, 1, 1}}}; }), "");
}

TEST(Scene3, MayHavePolygonsWithHolesAndNotConvex) {
  EXPECT_EQ(refusal([](Scene3& s) { s.polygons[0].points[2] = {Rational(1) / 4, Rational(1) / 4, 0}; }), "");
  const auto with_hole = [](const std::vector<Point3>& hole) {
    return refusal([&](Scene3& s) { s.polygons[0].holes = {hole}; });
  };
  const Rational quarter(1, 4), half(1, 2);
  EXPECT_EQ(with_hole({{quarter, quarter, 0}, {half, quarter, 0}, {half, half, 0}}), "");
  EXPECT_EQ(with_hole({{0, 0, 0}, {half, quarter, 0}, {half, half, 0}}), "");  // it touches the outline
  EXPECT_EQ(with_hole({{2, 2, 0}, {3, 2, 0}, {3, 3, 0}}),
            "two.json:10: polygon 'floor' has holes that are not in it, or share an area");
  EXPECT_THAT(with_hole({{half, half, 0}, {2, half, 0}, {half, quarter, 0}}),
              StartsWith("two.json:10: polygon 'floor' crosses itself at the point (1, "));
  EXPECT_THAT(refusal([](Scene3& s) { std::swap(s.polygons[0].points[1], s.polygons[0].points[2]); }),
              StartsWith("two.json:10: polygon 'floor' crosses itself at the point (0.5, 0.5, 0)"));
}

TEST(Scene3, HasAValidTable) {
  EXPECT_EQ(refusal([](Scene3& s) { s.surfaces[1].name = "floor"; }),
            "two.json:11: two surfaces have the name 'floor', the other one in line 10");
  EXPECT_THAT(refusal([](Scene3& s) { s.surfaces[1].material = 1; }), HasSubstr("a material that is not defined"));
  EXPECT_THAT(refusal([](Scene3& s) { s.surfaces[1].elements = 0; }), HasSubstr("has 0 elements"));
  EXPECT_THAT(refusal([](Scene3& s) { s.materials[0].reflectivity = Spectrum::scalar(2); }),
              HasSubstr("must be from 0 to 1"));
}

TEST(Scene3, HasACameraThatSeesSomething) {
  const auto with = [](const Camera3& camera) { return refusal([&](Scene3& s) { s.camera = camera; }); };
  EXPECT_EQ(with({{0, 0, 0}, {1, 0, 0}}), "");
  EXPECT_EQ(with({{1, 0, 0}, {1, 0, 0}}), "two.json: camera: eye and target are one point");
  EXPECT_THAT(with({{0, 0, 0}, {0, 0, -5}}), HasSubstr("it looks along \"up\""));
  EXPECT_THAT(with({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}), HasSubstr("it looks along \"up\""));
  EXPECT_THAT(with({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 180}), HasSubstr("field_of_view"));
  EXPECT_THAT(with({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0}), HasSubstr("field_of_view"));
  EXPECT_THAT(with({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 40, 0, 5}), HasSubstr("from 1 to 16384"));
  EXPECT_THAT(with({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 40, 5, 16385}), HasSubstr("from 1 to 16384"));
}

}  // namespace
}  // namespace hottel::scene_test

// Closed forms of two rectangles: known numbers, their text, and the sum along edges.
#include "geometry/space/unobstructed/rectangle_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/space/exchange/exact_form.h"
#include "geometry/space/exchange/pair_report.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"

namespace hottel::rectangle_form_test {
namespace {

using Corners = std::vector<Point3>;

Corners rectangle(const Point3& corner, const Vector3& u, const Vector3& v) {
  const auto at = [&](int s, int t) {
    return Point3{corner.x + s * u.x + t * v.x, corner.y + s * u.y + t * v.y, corner.z + s * u.z + t * v.z};
  };
  return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
}

const Corners kFloor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
const Corners kCeiling = rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0});
const Corners kWall = rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1});  // looks along x

TEST(RectangleForm, HasTheTextbookFormsOfACube) {
  const auto opposite = rectangle_exchange(kFloor, kCeiling), beside = rectangle_exchange(kFloor, kWall);
  ASSERT_TRUE(opposite && beside);
  EXPECT_EQ(opposite->to_string(), "(-4*atan(1) + 4*sqrt(2)*atan(1/2*sqrt(2)) + 2*log(2) - log(3))/pi");
  EXPECT_NEAR(opposite->value(), 0.19982489569838746, 1e-16);
  EXPECT_NEAR(opposite->value() + 4 * beside->value(), 1, 1e-15);
}

TEST(RectangleForm, IsZeroWhereFrontsDoNotSeeEachOther) {
  const Corners up = rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), below = rectangle({0, 0, -1}, {0, 1, 0}, {1, 0, 0});
  for (const Corners& other : {up, below, kFloor}) {
    const auto form = rectangle_exchange(kFloor, other);
    ASSERT_TRUE(form);
    EXPECT_TRUE(form->is_zero());
    EXPECT_EQ(form->to_string(), "0");
  }
}

TEST(RectangleForm, IsOfRectanglesWithRationalSidesAlongEachOtherAlone) {
  const Corners turned =
      rectangle({0, 0, 1}, {Rational(3, 5), Rational(4, 5), 0}, {Rational(4, 5), Rational(-3, 5), 0});
  EXPECT_FALSE(rectangle_exchange(kFloor, turned));
  EXPECT_FALSE(rectangle_exchange(kFloor, rectangle({0, 0, 1}, {0, 1, 1}, {1, 0, 0})));
  EXPECT_FALSE(rectangle_exchange(rectangle({0, 0, 0}, {1, 1, 0}, {-1, 1, 0}), kCeiling));
  EXPECT_FALSE(rectangle_exchange({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, kCeiling));
  EXPECT_TRUE(rectangle_exchange(turned, turned));
  EXPECT_EQ(rectangle_area(turned), Rational(1));
}

// What stands behind the other one counts for nothing.
TEST(RectangleForm, IsWhatIsBeforeTheOtherOne) {
  const Corners through = rectangle({0, 0, -1}, {0, 1, 0}, {0, 0, 2}),
                wide = rectangle({-2, 0, 0}, {3, 0, 0}, {0, 1, 0});
  EXPECT_EQ(rectangle_exchange(kFloor, through), rectangle_exchange(kFloor, kWall));
  EXPECT_EQ(rectangle_exchange(wide, kWall), rectangle_exchange(kFloor, kWall));
}

Scene3 scene_of(const Corners& a, const Corners& b) {
  Scene3 scene;
  scene.materials.push_back({.name = "m", .reflectivity = {}, .emission = {}});
  for (const auto& [name, corners] : {std::pair("a", a), {"b", b}}) {
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(name);
    scene.add(surface, {corners, {}});
  }
  return scene;
}

TEST(RectangleForm, IsTheNumberOfThePairEngine) {
  std::mt19937_64 random(11);
  const auto number = [&](int most) { return Rational(static_cast<long>(random() % (4 * most)) + 1, 4); };
  for (int k = 0; k < 60; ++k) {
    const Corners a = rectangle({-number(3), -number(3), 0}, {number(3), 0, 0}, {0, number(3), 0});
    const Corners b = k % 2 == 0
                          ? rectangle({number(2), number(2) - 2, number(2)}, {0, number(3), 0}, {number(2), 0, 0})
                          : rectangle({-number(4), number(2) - 2, number(2) - 1}, {0, number(2), 0}, {0, 0, number(2)});
    const PreparedScene3 prepared = prepare(scene_of(a, b));
    const ExactForm3 form = exact_form_3(prepared, Face{0, false}, Face{1, false});
    ASSERT_TRUE(form.exchange) << k << form.why_not;
    const PairReport3 report = pair_report(prepared, Face{0, false}, Face{1, false}, 1e-12);
    EXPECT_NEAR(form.exchange->value(), report.exchange.value, 3e-13 * (1 + report.exchange.value)) << k;
    EXPECT_EQ(form.exchange->is_zero(), report.exchange.value == 0) << k;
  }
}

TEST(ExactForm3, SaysWhyThereIsNone) {
  const Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
  const PreparedScene3 prepared = prepare(scene);
  const Face floor{*scene.find("floor"), false}, ceiling{*scene.find("ceiling"), false};
  EXPECT_EQ(exact_form_3(prepared, floor, ceiling).why_not, "something hides a part of one from the other");
  EXPECT_TRUE(exact_form_3(prepared, floor, floor).exchange->is_zero());
}

}  // namespace
}  // namespace hottel::rectangle_form_test

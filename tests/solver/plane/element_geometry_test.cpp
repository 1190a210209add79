#include "solver/plane/methods/element_geometry.h"

#include <gtest/gtest.h>

#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::element_geometry_test {
namespace {

using testing_scenes::Line;
using testing_scenes::scene_of;

Rational power_of_two(long exponent) { return scaled_by_power_of_two(Rational(1), exponent); }

// A square room, fronts inside, clockwise from a corner.
void add_square(std::vector<Line>& lines, const std::string& name, const Rational& x, const Rational& y,
                const Rational& side) {
  const Point2 corner[] = {{x, y}, {x, y + side}, {x + side, y + side}, {x + side, y}};
  for (int k = 0; k < 4; ++k) {
    const Point2 &a = corner[k], &b = corner[(k + 1) % 4];
    lines.push_back({name + std::to_string(k), to_string(a.x), to_string(a.y), to_string(b.x), to_string(b.y)});
  }
}

void expect_same(const ElementGeometry2& a, const ElementGeometry2& b) {
  ASSERT_EQ(a.count(), b.count());
  for (std::uint32_t element = 0; element < a.count(); ++element) {
    ASSERT_EQ(a.runs(element).size(), b.runs(element).size());
    EXPECT_EQ(a.length(element), b.length(element));
    for (std::size_t k = 0; k < a.runs(element).size(); ++k) {
      const ElementRun2 &r = a.runs(element)[k], &s = b.runs(element)[k];
      for (const double t : {0.0, 0.3, 0.5, 1.0}) {
        const LocalPoint2 p = r.at(t), q = s.at(t);
        EXPECT_TRUE(p.x == q.x && p.y == q.y && p.x_low == q.x_low && p.y_low == q.y_low);
      }
      EXPECT_EQ(r.direction.x, s.direction.x);
      EXPECT_EQ(r.direction.y, s.direction.y);
    }
  }
  EXPECT_EQ(a.diagonal(), b.diagonal());
}

TEST(ElementGeometry2, IsTheSameAfterTranslationAndScaling) {
  const Scene2 scene =
      scene_of({{"a", "0", "0", "0.1", "1/3"}, {"b", "2", "0.7", "1", "5"}, {"c", "1", "1", "2", "-1"}});
  const ElementGeometry2 here(prepare(scene));
  const ElementGeometry2 there(prepare(testing_scenes::moved(scene, [](const Point2& p) {
    return Point2{p.x * power_of_two(-40) + power_of_two(53) + 1, p.y * power_of_two(-40) - power_of_two(60) + 7};
  })));
  expect_same(here, there);
  EXPECT_EQ(there.unit(), here.unit() * power_of_two(-40));
}

TEST(ElementGeometry2, KeepsTheShapeOfWhatIsSmallAndFarFromTheOrigin) {
  const Rational side = power_of_two(-40), big = power_of_two(40);
  std::vector<Line> lines;
  add_square(lines, "hall", 0, 0, big);
  add_square(lines, "slit", big - 3 * side, Rational(1, 3) * big, side);
  const PreparedScene2 prepared = prepare(scene_of(lines));
  const ElementGeometry2 geometry(prepared);
  const double unit = to_double(geometry.unit());
  const std::uint32_t first = 8;  // fronts and backs of the hall come before
  for (std::uint32_t k = 0; k < 4; ++k) {
    const ElementRun2& run = geometry.runs(first + 2 * k)[0];
    const ElementRun2& next = geometry.runs(first + 2 * ((k + 1) % 4))[0];
    EXPECT_EQ(run.length * unit, 0x1p-40);
    EXPECT_EQ(dot(run.direction, next.direction), 0);
    const LocalVector2 step = next.centre - run.centre;
    EXPECT_NEAR(length(step) * unit * 0x1p40, std::sqrt(0.5), 1e-6);
    EXPECT_GT(dot(step, run.normal()), 0);
  }
}

TEST(ElementGeometry2, HasEveryRunThatOthersLeave) {
  // Another surface owns the middle third; what is left are two runs with a quarter and three quarters of the rest.
  const PreparedScene2 prepared = prepare(
      scene_of({{"table", "1", "0", "2", "0", 1}, {"floor", "0", "0", "5", "0", 1, testing_scenes::kBlack, 1}}));
  const ElementGeometry2 geometry(prepared);
  const auto floor = geometry.runs(2);
  ASSERT_EQ(floor.size(), 2u);
  EXPECT_DOUBLE_EQ(floor[0].share, 0.25);
  EXPECT_DOUBLE_EQ(floor[1].share, 0.75);
  EXPECT_DOUBLE_EQ(geometry.length(2) * to_double(geometry.unit()), 4);
  for (const ElementRun2& run : floor) EXPECT_EQ(run.normal().y, -1);
  EXPECT_DOUBLE_EQ(length(floor[1].centre - floor[0].centre) * to_double(geometry.unit()), 3);
}

TEST(ElementGeometry2, MeetsBothEndsOfARunExactly) {
  const PreparedScene2 prepared = prepare(scene_of({{"a", "0", "0", "0.1", "1/3"}, {"b", "2", "0.7", "1/7", "5"}}));
  const ElementGeometry2 geometry(prepared);
  for (std::uint32_t element = 0; element < geometry.count(); ++element)
    for (const ElementRun2& run : geometry.runs(element)) {
      EXPECT_EQ(length(run.at(0) - run.from), 0);
      EXPECT_EQ(length(run.at(1) - run.to), 0);
      EXPECT_NEAR(length(run.at(0.25) - run.from), 0.25 * run.length, 1e-16);
      EXPECT_NEAR(length(run.at(0.75) - run.to), 0.25 * run.length, 1e-16);
    }
}

TEST(ElementGeometry2, LeavesOutWhatIsTooShortForDoubles) {
  const PreparedScene2 prepared =
      prepare(scene_of({{"long", "0", "0", "1", "0"}, {"speck", "0", "1", "0", "1." + std::string(199, '0') + "1"}}));
  const ElementGeometry2 geometry(prepared);
  EXPECT_EQ(geometry.runs(0).size(), 1u);
  EXPECT_EQ(geometry.runs(2).size(), 0u);
  EXPECT_TRUE(geometry.has_row(2));
}

}  // namespace
}  // namespace hottel::element_geometry_test

// What sum_convex_pairs says of convex rooms, against the sweep.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/plane/exchange/convex_sums.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel::convex_room_test {
namespace {

struct Room {
  const char* name;
  bool has_long_numbers;  // coordinates of 30 digits: no length is a whole number of units
  bool divides_walls;     // with vertices inside them
  std::uint32_t most_elements;
};

// A polygon inscribed in an ellipse, clockwise, fronts inside; each wall may be several surfaces in line.
Scene2 convex_room(const Room& room, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&random](std::uint64_t n) { return static_cast<long>(random() % n); };
  const Rational tiny = room.has_long_numbers ? Rational(1, Integer("1000000000000000000000000000007")) : Rational(0);
  std::vector<Point2> corners;
  const int sides = 3 + static_cast<int>(below(6));
  for (int k = sides; k > 0; --k) {
    // On the unit circle, at rational points: t -> ((1 - t²) / (1 + t²), 2t / (1 + t²)).
    const Rational t = Rational(2 * k - sides, 3) + tiny * below(1000);
    const Rational one = 1 + t * t;
    corners.push_back({3 * (1 - t * t) / one, 2 * t / one});
  }
  Scene2 scene;
  scene.materials.push_back({"wall", Spectrum{{0.5, 0.5, 0.5}}, {}});
  scene.groups.emplace_back("room");
  const auto add = [&](const Point2& from, const Point2& to) {
    Surface surface;
    surface.name = "s" + std::to_string(scene.surfaces.size());
    surface.elements = 1 + static_cast<std::uint32_t>(below(room.most_elements));
    scene.add(surface, {from, to});
  };
  // The first wall may begin in the middle of a side, as when a user starts there.
  const auto on = [](const Point2& a, const Point2& b, const Rational& t) {
    return Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    if (!room.divides_walls) {
      add(a, b);
      continue;
    }
    const Point2 inside = on(a, b, Rational(1 + below(6), 7)), further = on(inside, b, Rational(1, 3));
    add(a, inside);
    add(inside, further);
    add(further, b);
  }
  if (room.divides_walls) {
    std::rotate(scene.surfaces.begin(), scene.surfaces.begin() + 1, scene.surfaces.end());
    std::rotate(scene.edges.begin(), scene.edges.begin() + 1, scene.edges.end());
  }
  return scene;
}

TEST(IsConvexRoom, NotWithACornerThatJutsIn) {
  const auto room = [](const std::vector<Point2>& corners) {
    Scene2 scene;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      scene.add({}, {a, b});
    }
    return scene;
  };
  EXPECT_TRUE(is_convex_room(room({{0, 0}, {0, 2}, {1, 2}, {2, 1}, {2, 0}})));
  EXPECT_FALSE(
      is_convex_room(room({{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}})));  // its direction goes around once
  EXPECT_FALSE(is_convex_room(room({{0, 0}, {0, 2}, {1, 1}, {2, 2}, {2, 0}})));
  EXPECT_FALSE(is_convex_room(room({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}})));  // inside out
}

class ConvexRoom : public testing::TestWithParam<Room> {};

TEST_P(ConvexRoom, RowsCancelToTheLastBit) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PreparedScene2 prepared = prepare(convex_room(GetParam(), seed));
    ASSERT_TRUE(is_convex_room(prepared.scene)) << seed;
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
      const ElementTable2& table = *prepared.elements(granularity);
      EXPECT_EQ(closure_defect(sum_convex_pairs(prepared.arrangement, table), table), 0) << seed;
    }
  }
}

TEST_P(ConvexRoom, FactorsAreThoseOfTheSweep) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PreparedScene2 prepared = prepare(convex_room(GetParam(), seed));
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
      ExchangeRequest request{.granularity = granularity};
      const ExchangeMatrix strung = exact_exchange(prepared, request);
      request.always_sweeps = true;
      const ExchangeMatrix swept = exact_exchange(prepared, request);
      ASSERT_EQ(swept.size(), strung.size());
      for (std::uint32_t i = 0; i < swept.size(); ++i) {
        ASSERT_EQ(swept.row(i).size(), strung.row(i).size()) << seed;
        for (std::size_t k = 0; k < swept.row(i).size(); ++k) {
          const FactorEntry &one = swept.row(i)[k], &other = strung.row(i)[k];
          EXPECT_EQ(one.to, other.to);
          EXPECT_EQ(one.factor.value, other.factor.value);
          EXPECT_EQ(one.factor.side, other.factor.side);
          EXPECT_EQ(one.visibility, other.visibility);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rooms, ConvexRoom,
                         testing::Values(Room{"plain", false, false, 1}, Room{"divided", false, true, 1},
                                         Room{"elements", false, false, 9}, Room{"digits", true, true, 1},
                                         Room{"all", true, true, 5}),
                         [](const auto& room) { return room.param.name; });

}  // namespace
}  // namespace hottel::convex_room_test

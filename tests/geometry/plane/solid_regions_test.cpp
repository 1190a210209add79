#include "geometry/plane/arrangement/solid_regions.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/plane/visibility/point_location.h"
#include "tests/solver/plane/solid_scenes.h"

namespace hottel::solid_regions_test {
namespace {

struct Found {
  explicit Found(const Scene2& scene) : arrangement(prepare(scene).arrangement), regions(arrangement) {}

  Rational doubled_area(const SolidRegions2::Border& border) const {
    Rational sum = 0;
    for (std::size_t k = 0; k < border.size(); ++k) {
      const Vertices2& vertices = arrangement.vertices();
      const Point2 a = vertices.to_scene(vertices.exact(border[k])),
                   b = vertices.to_scene(vertices.exact(border[(k + 1) % border.size()]));
      sum += a.x * b.y - b.x * a.y;
    }
    return sum;
  }
  Rational doubled_area() const {
    Rational sum = 0;
    for (std::uint32_t region = 0; region < regions.count(); ++region)
      for (const SolidRegions2::Border& border : regions.borders(region)) sum += doubled_area(border);
    return sum;
  }

  Arrangement2 arrangement;
  SolidRegions2 regions;
};

TEST(SolidRegions2, AreWhereTheBoxesAre) {
  for (const BoxRoom& room : box_rooms()) {
    const Found found(room.scene);
    const Vertices2& vertices = found.arrangement.vertices();
    const PointLocation2 location(vertices, found.arrangement.triangulation());
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 30; ++j) {
        const Point2 p{Rational(i, 10) + Rational(1, 17), Rational(j, 10) + Rational(1, 17)};  // on no border
        const Location2 at = location.locate(Eye2(vertices, vertices.from_scene(p)));
        ASSERT_EQ(found.regions.of(at.half_edge) != SolidRegions2::kNone, room.is_in_solid(p)) << room.name;
      }
  }
}

TEST(SolidRegions2, HaveTheSolidOnTheLeftOfTheirBorders) {
  const Rational h(1, 2), q(1, 4);
  for (const BoxRoom& room : box_rooms()) {
    std::set<Rational> xs, ys;
    for (const Box2& box : room.boxes) {
      xs.insert({box.x0, box.x1});
      ys.insert({box.y0, box.y1});
    }
    Rational area = 0;  // of the union, part by part of the grid of all sides
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x)
      for (auto y = ys.begin(); std::next(y) != ys.end(); ++y) {
        const Rational right = *std::next(x), top = *std::next(y);
        if (room.is_in_solid({(*x + right) / 2, (*y + top) / 2})) area += (right - *x) * (top - *y);
      }
    EXPECT_EQ(Found(room.scene).doubled_area(), 2 * area) << room.name;
  }
}

TEST(SolidRegions2, AreOneWhereBoxesShareAWallAndTwoWhereTheyTouchInAPoint) {
  for (const BoxRoom& room : box_rooms()) {
    const Found found(room.scene);
    EXPECT_EQ(found.regions.count(), room.name == "touching in a point" ? 2u : 1u) << room.name;
    for (std::uint32_t region = 0; region < found.regions.count(); ++region)
      EXPECT_EQ(found.regions.borders(region).size(), room.name == "around a yard" ? 2u : 1u) << room.name;
  }
}

TEST(SolidRegions2, LeaveRoomsInBuildingsOut) {
  Scene2 scene;
  add_outline(scene, {{0, 0}, {6, 0}, {6, 5}, {0, 5}});
  add_outline(scene, {{1, 1}, {1, 4}, {5, 4}, {5, 1}});  // a room
  add_outline(scene, {{2, 2}, {3, 2}, {3, 3}, {2, 3}});  // a pillar in it
  const Found found(scene);
  EXPECT_EQ(found.regions.count(), 2u);
  EXPECT_EQ(found.doubled_area(), 2 * (30 - 12 + 1));
}

TEST(SolidRegions2, AreNoneWithoutSolids) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Found found(random_lattice_scene(seed, 20));
    EXPECT_EQ(found.regions.count(), 0u);
    EXPECT_EQ(found.regions.of(HalfEdgeId(0)), SolidRegions2::kNone);
  }
}

}  // namespace
}  // namespace hottel::solid_regions_test

// Light at points before it is reflected: closed forms, shadows, parts of faces that are lit.
#include "solver/space/light/direct_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/space/light/light_shares.h"
#include "tests/geometry/space/box_scene.h"

namespace hottel::direct_light_test {
namespace {

constexpr double kPi = std::numbers::pi;

// A room from -2 to 2 with a plate from -1 to 1 in z = 1.
PreparedScene3 room_with_plate() {
  BoxScene3 scene;
  scene.box("room", {-2, -2, -2}, {2, 2, 2}, true);
  scene.polygon("plate", level(-1, -1, 1, 1, 1));
  return prepare(scene);
}

const Point3 kOrigin{0, 0, 0};

TEST(DirectLight3, FallsOffWithTheSquareOfTheDistance) {
  const PreparedScene3 prepared = room_with_plate();
  const DirectLight3 light(prepared, kOrigin, {});
  const double intensity = 1 / (4 * kPi);
  EXPECT_DOUBLE_EQ(light.mean_irradiance({0, 0, -1}), intensity / 4);
  EXPECT_DOUBLE_EQ(light.mean_irradiance({0, 1, -1}), intensity / 8);
  EXPECT_DOUBLE_EQ(light.irradiance({0, 0, -2}, {0, 0, 5}), intensity / 4);
  EXPECT_DOUBLE_EQ(light.irradiance({0, 2, -2}, {0, 0, 1}), intensity / 8 * std::sqrt(0.5));
  EXPECT_EQ(light.irradiance({0, 0, -2}, {0, 0, -1}), 0);  // it looks away
  EXPECT_EQ(light.mean_irradiance(kOrigin), std::numeric_limits<double>::infinity());
}

TEST(DirectLight3, ThereIsNoneInShadows) {
  const PreparedScene3 prepared = room_with_plate();
  const DirectLight3 light(prepared, kOrigin, {});
  EXPECT_EQ(light.mean_irradiance({0, 0, Rational(3, 2)}), 0);
  EXPECT_EQ(light.irradiance({1, 1, 2}, {0, 0, -1}), 0);
  EXPECT_GT(light.irradiance({0, 0, 1}, {0, 0, -1}), 0);  // on the plate
  EXPECT_GT(light.irradiance({2, 0, 1}, {-1, 0, 0}), 0);
  // The border of the shadow on the ceiling is its corner.
  EXPECT_GT(light.irradiance({2, 0, 2}, {0, 0, -1}), 0);
  EXPECT_EQ(light.irradiance({Rational(2) - Rational(1, Integer(1) << 100), 0, 2}, {0, 0, -1}), 0);
}

TEST(DirectLight3, BeamsEndAtTheirBorder) {
  const PreparedScene3 prepared = room_with_plate();
  const DirectLight3 light(prepared, kOrigin, {{0, 0, -1}, 45, 2});
  const double at_axis = 3 / (2 * kPi * (1 - std::pow(0.5, 1.5)));
  EXPECT_DOUBLE_EQ(light.mean_irradiance({0, 0, -1}), at_axis / 4);
  EXPECT_DOUBLE_EQ(light.mean_irradiance({1, 0, -1}), at_axis / 2 / 8);  // cos^2 t = 1/2, r^2 = 2
  EXPECT_EQ(light.mean_irradiance({1 + Rational(1, Integer(1) << 100), 0, -1}), 0);
  EXPECT_EQ(light.mean_irradiance({0, 0, 1}), 0);
}

TEST(DirectLight3, ALightInASolidLightsNothing) {
  BoxScene3 scene;
  scene.box("box", {-1, -1, -1}, {1, 1, 1});
  const PreparedScene3 prepared = prepare(scene);
  const DirectLight3 light(prepared, kOrigin, {});
  EXPECT_TRUE(light.is_in_solid());
  EXPECT_EQ(light.mean_irradiance({2, 0, 0}), 0);
  EXPECT_EQ(light.mean_irradiance({0, 0, Rational(1, 2)}), 0);
  EXPECT_TRUE(light.lit_parts().empty());
}

// What falls on lit parts, point by point, is the share of their face.
TEST(DirectLight3, SumsOverLitPartsAreTheShares) {
  const PreparedScene3 prepared = room_with_plate();
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  for (const Beam3& beam : {Beam3{}, Beam3{{1, 1, 4}, 90, 1}, Beam3{{1, 2, -3}, 170, 0}}) {
    const Point3 position{Rational(1, 4), Rational(-1, 8), Rational(-1, 2)};
    const DirectLight3 light(prepared, position, beam);
    const LightShares3 shares = light_shares(prepared, table, light.map(), light.beam());
    std::vector<double> sums(table.count());
    std::mt19937 engine(5);
    for (const LitPart3& part : light.lit_parts()) {
      ASSERT_EQ(part.side, part.face);  // one piece a surface
      const Polygon3& polygon = prepared.arrangement().pieces()[part.side.surface].polygon;
      Vector3 normal = cross(polygon.points[1] - polygon.points[0], polygon.points[2] - polygon.points[0]);
      if (part.side.is_back) normal = {-normal.x, -normal.y, -normal.z};
      double& sum = sums[part.face.number()];
      for (std::size_t c = 1; c + 1 < part.corners.size(); ++c) {
        const Vector3 u = part.corners[c] - part.corners[0], v = part.corners[c + 1] - part.corners[0],
                      twice = cross(u, v);
        const double area = std::sqrt(to_double(dot(twice, twice))) / 2;
        constexpr int kSide = 24;
        for (int row = 0; row < kSide; ++row)
          for (int k = 0; k < 2 * (kSide - row) - 1; ++k) {
            // The middle of a small triangle.
            const Rational third = k % 2 == 0 ? Rational(1, 3) : Rational(2, 3);
            const Rational s = (k / 2 + third) / kSide, t = (row + third) / kSide;
            const Point3 at{part.corners[0].x + s * u.x + t * v.x, part.corners[0].y + s * u.y + t * v.y,
                            part.corners[0].z + s * u.z + t * v.z};
            sum += area / (kSide * kSide) * light.irradiance(at, normal);
          }
      }
    }
    for (std::uint32_t k = 0; k < table.count(); ++k) {
      EXPECT_NEAR(sums[k], shares.elements[k].value, 1e-3 * shares.elements[k].value + 3e-4) << k;
    }
  }
}

TEST(LitParts3, AreConvexAndEndAtTheBordersOfShadows) {
  const PreparedScene3 prepared = room_with_plate();
  const DirectLight3 light(prepared, {0, 0, Rational(1, 2)}, {});
  Rational ceiling = 0, walls = 0, plate = 0;
  for (const LitPart3& part : light.lit_parts()) {
    EXPECT_EQ(part.beam, LitPart3::Beam::kAll);
    Vector3 doubled{0, 0, 0};
    for (std::size_t c = 1; c + 1 < part.corners.size(); ++c) {
      const Vector3 turn = cross(part.corners[c] - part.corners[0], part.corners[c + 1] - part.corners[0]);
      doubled = {doubled.x + turn.x, doubled.y + turn.y, doubled.z + turn.z};
    }
    const std::string& name = prepared.scene.surfaces[part.face.surface].name;
    const Rational area = (abs(doubled.x) + abs(doubled.y) + abs(doubled.z)) / 2;  // all faces are parallel to axes
    (name == "room top" ? ceiling : name == "plate" ? plate : walls) += area;
    EXPECT_EQ(part.face.is_back, name == "plate");
  }
  EXPECT_EQ(ceiling, 0);  // the shadow of the plate, a half away, is three times as wide at the ceiling
  EXPECT_EQ(plate, 4);
  EXPECT_EQ(walls, 16 + 4 * 4 * Rational(7, 2));  // up to z = 3/2
}

}  // namespace
}  // namespace hottel::direct_light_test

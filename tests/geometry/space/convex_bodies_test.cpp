// Surfaces that bound convex bodies.
#include "geometry/space/hiding/convex_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/geometry/space/box_faces.h"

namespace hottel::convex_bodies_test {
namespace {

using box_faces::box;
using testing::IsEmpty;
using testing::SizeIs;
using box_faces::operator+;
using box_faces::Points;
using box_faces::polygons_of;

std::vector<Points> box_without(std::initializer_list<std::size_t> faces) {
  const std::vector<Points> all = box({0, 0, 0}, {2, 2, 2});
  std::vector<Points> some;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (std::find(faces.begin(), faces.end(), k) == faces.end()) some.push_back(all[k]);
  return some;
}

class Bodies {
 public:
  explicit Bodies(const std::vector<Points>& polygons) : occluders_(polygons_of(polygons)), bodies_(occluders_) {}
  const std::vector<ConvexBody3>& all() const { return bodies_.bodies(); }
  const ConvexBodies3& bodies() const { return bodies_; }
  // On which side of a plane of a body a point of the scene is: +1 outward.
  int side(const BodyPlane3& plane, const Point3& p) const {
    const Vertices3& vertices = occluders_.vertices();
    const IntegerVector& at = vertices.exact(plane.at);
    const Point3 from{vertices.origin().x + vertices.scale() * at.x, vertices.origin().y + vertices.scale() * at.y,
                      vertices.origin().z + vertices.scale() * at.z};
    return sgn(plane.outward.x * (p.x - from.x) + plane.outward.y * (p.y - from.y) + plane.outward.z * (p.z - from.z));
  }

 private:
  Occluders3 occluders_;
  ConvexBodies3 bodies_;
};

// (1), (2)
TEST(ConvexBodies3, ABoxIsABodyWhoseSurfacesAreItsBoundary) {
  const Bodies scene(box({0, 0, 0}, {2, 2, 2}));
  ASSERT_THAT(scene.all(), SizeIs(1));
  const ConvexBody3& body = scene.all()[0];
  EXPECT_THAT(body.surfaces, SizeIs(6));
  EXPECT_THAT(body.corners, SizeIs(8));
  ASSERT_THAT(body.planes, SizeIs(6));
  EXPECT_FALSE(body.lid);
  const std::array<Point3, 6> outside{{{1, 1, -1}, {1, 1, 3}, {1, -1, 1}, {1, 3, 1}, {-1, 1, 1}, {3, 1, 1}}};
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(scene.side(body.planes[body.plane_of[k]], outside[k]), 1);
    EXPECT_EQ(scene.side(body.planes[body.plane_of[k]], {1, 1, 1}), -1);
    EXPECT_EQ(scene.bodies().body_of(static_cast<std::uint32_t>(k)), 0u);
  }
}

// (1), (2)
TEST(ConvexBodies3, ABoxWithoutOneFaceHasALidThere) {
  const std::array<Point3, 6> outside{{{1, 1, -1}, {1, 1, 3}, {1, -1, 1}, {1, 3, 1}, {-1, 1, 1}, {3, 1, 1}}};
  for (std::size_t left_out = 0; left_out < 6; ++left_out) {
    const Bodies scene(box_without({left_out}));
    ASSERT_THAT(scene.all(), SizeIs(1));
    const ConvexBody3& body = scene.all()[0];
    EXPECT_THAT(body.planes, SizeIs(5));
    ASSERT_TRUE(body.lid);
    EXPECT_EQ(scene.side(*body.lid, outside[left_out]), 1);
    EXPECT_EQ(scene.side(*body.lid, {1, 1, 1}), -1);
  }
}

// (1): edges of one surface are in one plane.
TEST(ConvexBodies3, ABoxWithoutTwoFacesIsNone) {
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = a + 1; b < 6; ++b) EXPECT_THAT(Bodies(box_without({a, b})).all(), IsEmpty()) << a << ' ' << b;
}

// (1): exact.
TEST(ConvexBodies3, ABorderThatIsOffAPlaneByNearlyNothingIsNone) {
  for (const int digits : {20, 60, 200}) {
    std::vector<Points> walls = box_without({0, 1});  // with a roof of two triangles, and corners that hang lower
    walls.push_back({{0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}});
    EXPECT_THAT(Bodies(walls).all(), SizeIs(1));
    const Rational little = scaled_by_power_of_two(Rational(1), -digits);
    for (Points& wall : walls)
      for (Point3& p : wall)
        if (p == Point3{2, 2, 0}) p.z -= little;
    EXPECT_THAT(Bodies(walls).all(), IsEmpty()) << digits;
  }
}

// (2): what is in the plane of the lid bounds nothing.
TEST(ConvexBodies3, AFaceWithAHoleIsTheLid) {
  std::vector<Points> polygons = box_without({0});
  const Points outer{{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}};
  const Rational low = Rational(1) / 2, high = Rational(3) / 2;
  const Points inner{{low, low, 0}, {low, high, 0}, {high, high, 0}, {high, low, 0}};
  for (std::size_t k = 0; k < 4; ++k) polygons.push_back({outer[k], outer[(k + 1) % 4], inner[(k + 1) % 4], inner[k]});
  const Bodies scene(polygons);
  ASSERT_THAT(scene.all(), SizeIs(1));
  const ConvexBody3& body = scene.all()[0];
  EXPECT_THAT(body.surfaces, SizeIs(9));
  EXPECT_THAT(body.planes, SizeIs(5));
  ASSERT_TRUE(body.lid);
  EXPECT_EQ(scene.side(*body.lid, {1, 1, -1}), 1);
  for (std::size_t k = 5; k < 9; ++k) EXPECT_EQ(body.plane_of[k], ConvexBody3::kNone);
}

TEST(ConvexBodies3, HalfOfABottomIsInThePlaneOfTheLid) {
  const Bodies scene(box_without({0}) + std::vector<Points>{{{0, 0, 0}, {0, 2, 0}, {2, 0, 0}}});
  ASSERT_THAT(scene.all(), SizeIs(1));
  EXPECT_TRUE(scene.all()[0].lid);
  EXPECT_EQ(scene.all()[0].plane_of[5], ConvexBody3::kNone);
}

// (1)
TEST(ConvexBodies3, AFaceCutAlongItsDiagonalIsTwoSurfacesOfTheBody) {
  const Bodies scene(box_without({1}) +
                     std::vector<Points>{{{0, 0, 2}, {2, 0, 2}, {2, 2, 2}}, {{0, 0, 2}, {0, 2, 2}, {2, 2, 2}}});
  ASSERT_THAT(scene.all(), SizeIs(1));
  EXPECT_FALSE(scene.all()[0].lid);
  EXPECT_THAT(scene.all()[0].planes, SizeIs(7));
}

// (1): sides that are parts of sides are shared with nothing: the face is that of the lid.
TEST(ConvexBodies3, AFaceCutThroughItsSidesIsInThePlaneOfALid) {
  const Bodies scene(box_without({1}) + std::vector<Points>{{{0, 0, 2}, {1, 0, 2}, {1, 2, 2}, {0, 2, 2}},
                                                            {{1, 0, 2}, {1, 2, 2}, {2, 2, 2}, {2, 0, 2}}});
  ASSERT_THAT(scene.all(), SizeIs(1));
  const ConvexBody3& body = scene.all()[0];
  ASSERT_TRUE(body.lid);
  EXPECT_EQ(scene.side(*body.lid, {1, 1, 3}), 1);
  EXPECT_THAT(body.planes, SizeIs(5));
  EXPECT_EQ(body.plane_of[5], ConvexBody3::kNone);
  EXPECT_EQ(body.plane_of[6], ConvexBody3::kNone);
}

// (1): no edge has more than two surfaces.
TEST(ConvexBodies3, BodiesThatShareAnEdgeAreNoneAndBodiesThatShareACornerAreTwo) {
  EXPECT_THAT(Bodies(box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 0}, {4, 4, 2})).all(), IsEmpty());
  EXPECT_THAT(Bodies(box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 2}, {4, 4, 4})).all(), SizeIs(2));
  EXPECT_THAT(Bodies(box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 1}, {4, 4, 3})).all(), SizeIs(2));
  EXPECT_THAT(Bodies(box({0, 0, 0}, {2, 2, 2}) + std::vector<Points>{{{0, 0, 2}, {2, 0, 2}, {2, 0, 4}}}).all(),
              IsEmpty());
}

// (1): a wall that goes on below the lid is beyond no plane of the body alone.
TEST(ConvexBodies3, WhatHangsAtTheBorderIsOfNoBodyUnlessItIsInThePlaneOfTheLid) {
  EXPECT_THAT(Bodies(box_without({0}) + std::vector<Points>{{{0, 0, 0}, {2, 0, 0}, {2, 0, -1}}}).all(), IsEmpty());
  EXPECT_THAT(Bodies(box_without({0}) + std::vector<Points>{{{0, 0, 0}, {2, 0, 0}, {1, -1, 0}}}).all(), IsEmpty());
  EXPECT_THAT(Bodies(box_without({0}) + std::vector<Points>{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}}).all(), SizeIs(1));
}

// (1): convex.
TEST(ConvexBodies3, ADentIsNoBody) {
  const auto with_roof = [](const Point3& apex) {
    const std::array<Point3, 4> top{{{0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
    std::vector<Points> polygons = box_without({1});
    for (std::size_t k = 0; k < 4; ++k) polygons.push_back({top[k], top[(k + 1) % 4], apex});
    return polygons;
  };
  const Rational little = scaled_by_power_of_two(Rational(1), -60);
  EXPECT_THAT(Bodies(with_roof({1, 1, 3})).all(), SizeIs(1));
  EXPECT_THAT(Bodies(with_roof({1, 1, 2 + little})).all(), SizeIs(1));
  EXPECT_THAT(Bodies(with_roof({1, 1, 2})).all(), SizeIs(1));
  EXPECT_THAT(Bodies(with_roof({1, 1, 2 - little})).all(), IsEmpty());
  EXPECT_THAT(Bodies(with_roof({1, 1, 1})).all(), IsEmpty());
}

// The middle of the box around it is outside.
TEST(ConvexBodies3, OutwardOfATetrahedronIsWhereNoCornerIs) {
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const std::vector<Points> faces{{o, x, y}, {o, y, z}, {o, z, x}, {x, y, z}};
  for (const bool is_open : {false, true}) {
    const Bodies scene(is_open ? std::vector<Points>(faces.begin(), faces.end() - 1) : faces);
    ASSERT_THAT(scene.all(), SizeIs(1));
    const ConvexBody3& body = scene.all()[0];
    ASSERT_EQ(body.lid.has_value(), is_open);
    const BodyPlane3& slope = is_open ? *body.lid : body.planes[body.plane_of[3]];
    EXPECT_EQ(scene.side(slope, {Rational(1) / 2, Rational(1) / 2, Rational(1) / 2}), 1);
    EXPECT_EQ(scene.side(slope, {Rational(1) / 8, Rational(1) / 8, Rational(1) / 8}), -1);
  }
}

TEST(ConvexBodies3, ThreeFacesAtACornerAreNoBodyButForTheirLid) {
  EXPECT_THAT(Bodies(box_without({1, 3, 5})).all(), IsEmpty());
  EXPECT_THAT(Bodies({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}}}).all(), IsEmpty());
}

TEST(ConvexBodies3, WhatIsFlatIsNoBody) {
  const Point3 middle{1, 1, 0};
  const std::array<Point3, 4> outer{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
  std::vector<Points> polygons;
  for (std::size_t k = 0; k < 4; ++k) polygons.push_back({outer[k], outer[(k + 1) % 4], middle});
  EXPECT_THAT(Bodies(polygons).all(), IsEmpty());
}

TEST(ConvexBodies3, AComponentOfTooManySurfacesIsLeftOut) {
  for (const int sides : {254, 255}) {
    Points bottom, top;
    for (long k = 0; k < sides; ++k) {
      bottom.push_back({k, k * k, 0});
      top.push_back({k, k * k, 1});
    }
    std::vector<Points> polygons{bottom, top};
    for (std::size_t k = 0; k < bottom.size(); ++k) {
      const std::size_t next = (k + 1) % bottom.size();
      polygons.push_back({bottom[k], bottom[next], top[next], top[k]});
    }
    EXPECT_THAT(Bodies(polygons).all(), SizeIs(sides == 254 ? 1 : 0));
  }
}

}  // namespace
}  // namespace hottel::convex_bodies_test

#include "viewer/picture/plane/outlines.h"

#include <gtest/gtest.h>

#include "tests/viewer/plane/drawn_scenes.h"

namespace hottel::outlines_test {
namespace {

Outlines2 outlines(const Scene2& scene) {
  const Frame2 frame(scene, {}, 1000, {});
  return Outlines2(scene, Corners2(scene, frame));
}

TEST(Outlines2, JoinEdgesToRoomsAndFindSolidsInThem) {
  const Outlines2 found = outlines(furnished_room());
  ASSERT_EQ(found.closed.size(), 2u);
  EXPECT_FALSE(found.closed[0].is_outward);
  EXPECT_EQ(found.closed[0].surfaces.size(), 6u);
  EXPECT_TRUE(found.closed[1].is_outward);
  EXPECT_EQ(found.closed[1].around, 0u);
  EXPECT_EQ(found.loose, std::vector<std::uint32_t>{kScreen});
  EXPECT_EQ(found.around_loose.at(0), 0u);
}

TEST(Outlines2, DoorLeafAtAWallCornerIsLoose) {
  Scene2 scene = furnished_room();
  scene.edges[kScreen].from = {0, 0};
  const Outlines2 found = outlines(scene);
  EXPECT_EQ(found.closed.size(), 2u);
  EXPECT_EQ(found.loose, std::vector<std::uint32_t>{kScreen});
}

TEST(Outlines2, ATableThatTouchesTheWallLiesInTheRoom) {
  DrawnScene drawn;
  drawn.closed({{0, 0}, {0, 3}, {4, 3}, {4, 0}});
  drawn.closed({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Outlines2 found = outlines(drawn.scene);
  ASSERT_EQ(found.closed.size(), 2u);
  EXPECT_EQ(found.closed[1].around, 0u);
  EXPECT_EQ(found.closed[1].level, 1u);
}

TEST(Outlines2, AThinWallListedTwiceHasNoInside) {
  DrawnScene drawn;
  drawn.edge({0, 0}, {1, 2});
  drawn.edge({1, 2}, {0, 0});
  EXPECT_TRUE(outlines(drawn.scene).closed.empty());
}

TEST(Corners2, AreEqualExactlyWhenThePointsAre) {
  DrawnScene drawn;
  const Rational tiny = Rational(1) / Rational("1" + std::string(40, '0'));
  drawn.edge({0, 0}, {1, 1});
  drawn.edge({1, 1}, {2, 0});
  drawn.edge({1, 1 + tiny}, {2, 1});
  const Corners2 corners(drawn.scene, Frame2(drawn.scene, {}, 1000, {}));
  EXPECT_EQ(corners.to[0], corners.from[1]);
  EXPECT_NE(corners.to[0], corners.from[2]);
  EXPECT_EQ(corners.at.size(), 5u);
}

TEST(Frame2, FitsScenesOfAnySize) {
  const Rational huge("1" + std::string(1000, '0'));
  for (const Rational& scale : {Rational(1), huge, Rational(1 / huge)}) {
    Scene2 scene = furnished_room();
    for (Edge2& s : scene.edges)
      for (Point2* p : {&s.from, &s.to}) *p = {p->x * scale + huge, p->y * scale - 7};
    const Frame2 frame(scene, {}, 1000, {100, 100, 50, 50});
    const Pixel low = frame.at(scene.edges[0].from), high = frame.at(scene.edges[1].to);
    EXPECT_EQ(low, (Pixel{100, 650}));
    EXPECT_EQ(high, (Pixel{900, 50}));
    EXPECT_EQ(frame.height(), 700);
  }
}

TEST(Frame2, KeepsSlenderScenesWithinBounds) {
  for (const Point2& to : {Point2{1, 0}, Point2{0, 1}, Point2{1, 1000}, Point2{1000, 1}}) {
    DrawnScene drawn;
    drawn.edge({0, 0}, to);
    const Frame2 frame(drawn.scene, {}, 1000, {50, 50, 50, 50});
    EXPECT_LE(frame.height(), 3000);
    EXPECT_GE(frame.height(), 150);
    for (const Point2& p : {Point2{0, 0}, to}) {
      EXPECT_GE(frame.at(p).x, 50 - 1e-9);
      EXPECT_LE(frame.at(p).x, 950 + 1e-9);
      EXPECT_GE(frame.at(p).y, 50 - 1e-9);
      EXPECT_LE(frame.at(p).y, frame.height() - 50 + 1e-9);
    }
  }
}

TEST(Outlines2, PatchesBelongToWhatTheyLieOn) {
  DrawnScene drawn;
  drawn.closed({{0, 0}, {0, 3}, {4, 3}, {4, 0}});
  drawn.closed({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  Scene2& scene = drawn.scene;
  scene.bases = {{scene.surfaces[5].name}, {"patch"}};
  Surface patch = scene.surfaces[0];
  for (const auto& [name, on] : {std::pair{"patch", 0u}, {"inner", 1u}}) {
    patch.name = name;
    patch.on = on;
    patch.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(name);
    scene.add(patch, {{2, Rational(5, 4)}, {2, Rational(7, 4)}});
  }
  validate(scene);
  const Outlines2 found = outlines(scene);
  ASSERT_EQ(found.closed.size(), 2u);
  EXPECT_TRUE(found.loose.empty());
  EXPECT_EQ(found.closed[1].surfaces, (std::vector<std::uint32_t>{4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(found.closed[1].polygon.size(), 4u);
}

}  // namespace
}  // namespace hottel::outlines_test

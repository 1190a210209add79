#include "geometry/plane/visibility/point_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene_builder.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "kernel/support/failure.h"

namespace hottel::point_place_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A room with a pillar in it, and a wall outside.
PreparedScene2 room() {
  SceneBuilder2 builder;
  builder.add_material("white").add_edge("wall", {6, 0}, {6, 4}, "white");
  builder.add_polyline("room", {{0, 0}, {0, 4}, {4, 4}, {4, 0}}, "white", {.closed = true});
  builder.add_polyline("pillar", {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, "white", {.closed = true});
  return prepare(builder.build());
}

TEST(PlaceOf2, TellsSurfacesSolidsAndTheSky) {
  const PreparedScene2 prepared = room();
  const PointPlace2 inside = place_of(prepared, {3, 3}), outside = place_of(prepared, {5, 1});
  EXPECT_THAT(inside.surfaces, IsEmpty());
  EXPECT_FALSE(inside.solid);
  EXPECT_FALSE(inside.sees_sky);
  EXPECT_TRUE(outside.sees_sky);
  const PointPlace2 in_pillar = place_of(prepared, {Rational(3, 2), Rational(3, 2)});
  ASSERT_TRUE(in_pillar.solid);
  EXPECT_EQ(prepared.scene.groups[*in_pillar.solid].name, "pillar");
  EXPECT_FALSE(in_pillar.sees_sky);
  const PointPlace2 on_side = place_of(prepared, {Rational(3, 2), 1}), on_corner = place_of(prepared, {1, 1});
  EXPECT_THAT(on_side.surfaces, ElementsAre(5));
  EXPECT_FALSE(on_side.solid);
  EXPECT_THAT(on_corner.surfaces, ElementsAre(5, 8));
  EXPECT_THAT(place_of(prepared, {6, 4}).surfaces, ElementsAre(0));
  EXPECT_THAT(place_of(prepared, {6, Rational(401, 100)}).surfaces, IsEmpty());
}

TEST(PlaceOf2, KnowsPointsOfASceneOnOneLine) {
  SceneBuilder2 builder;
  builder.add_material("white").add_edge("a", {0, 0}, {2, 1}, "white").add_edge("b", {4, 2}, {6, 3}, "white");
  const PreparedScene2 prepared = prepare(builder.build());
  EXPECT_THAT(place_of(prepared, {1, Rational(1, 2)}).surfaces, ElementsAre(0));
  EXPECT_THAT(place_of(prepared, {3, Rational(3, 2)}).surfaces, IsEmpty());
  EXPECT_TRUE(place_of(prepared, {3, Rational(3, 2)}).sees_sky);
  EXPECT_TRUE(place_of(prepared, {1, Rational(1, 2)}).sees_sky);
}

TEST(PlaceOf2, AgreesWithWhatThePointSees) {
  const PreparedScene2 prepared = room();
  for (int i = -1; i <= 14; ++i)
    for (int j = -1; j <= 10; ++j) {
      const Point2 point{Rational(i) / 2, Rational(j) / 2};
      const PointPlace2 place = place_of(prepared, point);
      const PointView2 sight = point_view(prepared, point);
      EXPECT_EQ(place.solid.has_value(), sight.polygon.solid != Solids2::kNone) << i << " " << j;
      bool sees_sky = false;
      for (const SeenFrom2& seen : sight.faces) sees_sky |= seen.name == "sky";
      EXPECT_EQ(place.sees_sky, sees_sky) << i << " " << j;
    }
}

TEST(CriticalPoints2, OfAPreparedSceneAreThoseOfItsArrangement) {
  const PreparedScene2 prepared = room();
  const Face from{1, false}, to{3, false};
  const auto points = critical_points(prepared, from, to);
  const auto expected = critical_points(prepared.arrangement, prepared.scene, from, to);
  ASSERT_EQ(points.size(), expected.size());
  EXPECT_FALSE(points.empty());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k].t, expected[k].t);
  EXPECT_THROW(critical_points(prepared, Face{99, false}, to), ContractViolation);
}

}  // namespace
}  // namespace hottel::point_place_test

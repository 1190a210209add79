// Event surfaces between two faces: that their lines touch what they say, that there are those there must be.
#include "geometry/space/exchange/event_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/space/prepared/prepared_scene.h"

namespace hottel::event_surfaces_test {
namespace {

using Corners = std::vector<Point3>;
using Kind = EventSurface3::Kind;

Scene3 scene_of(const std::vector<Corners>& polygons) {
  Scene3 scene;
  scene.materials.push_back({.name = "m", .reflectivity = {}, .emission = {}});
  for (const Corners& points : polygons) {
    Surface surface;
    surface.name = "p" + std::to_string(scene.surfaces.size());
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(surface.name);
    scene.add(surface, {points, {}});
  }
  return scene;
}

const Corners kFloor{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
const Corners kLamp{{3, 3, 8}, {3, 5, 8}, {5, 5, 8}, {5, 3, 8}};

std::vector<EventSurface3> events_of(std::vector<Corners> between) {
  between.insert(between.begin(), {kFloor, kLamp});
  return event_surfaces(prepare(scene_of(between)), Face{1, false}, Face{0, false});
}

std::size_t count(const std::vector<EventSurface3>& events, Kind kind) {
  return static_cast<std::size_t>(std::ranges::count(events, kind, &EventSurface3::kind));
}

using Vector = std::array<double, 3>;
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector times(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double size(const Vector& a) { return std::sqrt(product(a, a)); }

// How far the line of a ruling is from that of two points.
double distance(const EventSurface3::Ruling& ruling, const std::array<Point3, 2>& edge) {
  const Vector way = minus(ruling.on_to, ruling.on_from), a = to_doubles(edge[0]),
               along = minus(to_doubles(edge[1]), a);
  const Vector normal = times(way, along);
  return std::abs(product(normal, minus(a, ruling.on_from))) / size(normal);
}
double distance(const EventSurface3::Ruling& ruling, const Point3& vertex) {
  const Vector way = minus(ruling.on_to, ruling.on_from);
  return size(times(way, minus(to_doubles(vertex), ruling.on_from))) / size(way);
}

void expect_touching(const std::vector<EventSurface3>& events) {
  for (const EventSurface3& event : events) {
    EXPECT_LT(event.begin, event.end);
    EXPECT_GE(event.rulings.size(), 9u);
    for (const EventSurface3::Ruling& ruling : event.rulings) {
      EXPECT_LT(distance(ruling, event.edge), 1e-8);
      if (event.vertex) {
        EXPECT_LT(distance(ruling, *event.vertex), 1e-5);
      }
      for (const auto& other : event.others) EXPECT_LT(distance(ruling, other), 1e-5);
      EXPECT_NEAR(ruling.on_from[2], 8, 1e-9);
      EXPECT_NEAR(ruling.on_to[2], 0, 1e-9);
    }
  }
}

TEST(EventSurfaces3, ThereAreNoneWithNothingBetween) { EXPECT_TRUE(events_of({}).empty()); }

// Each of the 4 edges of either square with the corners of the other one that lie beyond or before it: of two parallel
// squares of one sense each edge has one of the other square with which it bounds the shadow, and one with which it
// bounds the part that sees nothing of the lamp.
TEST(EventSurfaces3, OfASquareAreThoseOfItsShadowAndHalfShadow) {
  const auto events = events_of({{{3, 3, 4}, {5, 3, 4}, {5, 5, 4}, {3, 5, 4}}});
  expect_touching(events);
  EXPECT_EQ(count(events, Kind::kEEE), 0u);
  for (const EventSurface3& event : events) EXPECT_TRUE(event.vertex);
  // The shadow of the corner (3, 3, 4) in the light of the lamp's corner (5, 5, 8) is (1, 1, 0).
  EXPECT_TRUE(std::ranges::any_of(events, [](const EventSurface3& event) {
    return std::ranges::any_of(event.rulings, [](const EventSurface3::Ruling& ruling) {
      return size(minus(ruling.on_to, {1, 1, 0})) < 1e-5 && size(minus(ruling.on_from, {5, 5, 8})) < 1e-5;
    });
  }));
}

TEST(EventSurfaces3, OfSkewEdgesThereAreQuadrics) {
  const auto events =
      events_of({{{2, 4, 3}, {6, 3, 4}, {6, 2, 3}, {2, 1, Rational(3, 2)}}, {{4, 2, 5}, {5, 6, 6}, {7, 6, 7}}});
  expect_touching(events);
  EXPECT_GT(count(events, Kind::kEV), 0u);
  EXPECT_GT(count(events, Kind::kEEE), 0u);
}

TEST(EventSurfaces3, AreTheSameFromBothFaces) {
  std::vector<Corners> polygons{kFloor, kLamp, {{4, 2, 5}, {5, 6, 6}, {3, 6, 4}}};
  const PreparedScene3 prepared = prepare(scene_of(polygons));
  const auto there = event_surfaces(prepared, Face{1, false}, Face{0, false});
  const auto back = event_surfaces(prepared, Face{0, false}, Face{1, false});
  ASSERT_EQ(there.size(), back.size());
  for (std::size_t k = 0; k < there.size(); ++k) {
    EXPECT_EQ(there[k].edge, back[k].edge);
    ASSERT_EQ(there[k].rulings.size(), back[k].rulings.size());
    EXPECT_EQ(there[k].rulings[0].on_from, back[k].rulings[0].on_to);
  }
}

}  // namespace
}  // namespace hottel::event_surfaces_test

// Event surfaces against the brute force: wherever a point that moves on one face sees another shape of the other face,
// it crosses a surface that is listed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "geometry/space/exchange/event_surfaces.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/oracle/space/visible_shape.h"

namespace hottel::oracle::event_surfaces_against_oracle_test {
namespace {

constexpr int kScenes = 8;
constexpr int kWays = 6;       // of a point, by scene
constexpr int kSteps = 120;    // of each way
constexpr double kOff = 1e-6;  // how far a change may be from the surface

Polygon3 polygon_of(std::vector<Point3> points) { return {.points = std::move(points)}; }

// The corner of a box by bits of its number.
Point3 corner_of(const Point3& origin, const std::array<Vector3, 3>& sides, unsigned bits) {
  Point3 corner = origin;
  for (unsigned k = 0; k < 3; ++k)
    if ((bits >> k & 1U) != 0) corner = {corner.x + sides[k].x, corner.y + sides[k].y, corner.z + sides[k].z};
  return corner;
}

// The six sides of a box, fronts outwards where its sides are right-handed.
std::vector<Polygon3> box(const Point3& origin, const std::array<Vector3, 3>& sides) {
  constexpr std::array<std::array<unsigned, 4>, 6> kSides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<Polygon3> result;
  for (const auto& side : kSides) {
    std::vector<Point3> points;
    for (const unsigned bits : side) points.push_back(corner_of(origin, sides, bits));
    result.push_back(polygon_of(std::move(points)));
  }
  return result;
}

// A floor that looks up, a ceiling that looks down, and boxes between, one above the other; every second scene has them
// turned.
Scene3 scene_of(int seed, int boxes) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto number = [&random](long low, long high) -> Rational {
    return Rational(low * 64 + static_cast<long>(random() % static_cast<std::uint64_t>((high - low) * 64))) / 64;
  };
  Scene3 scene;
  scene.materials = {Material{.name = "m", .reflectivity = {}, .emission = {}}};
  const auto add = [&scene](const std::string& name, Polygon3 polygon) {
    Surface surface;
    surface.name = name;
    surface.material = 0;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(name);
    scene.add(std::move(surface), std::move(polygon));
  };
  add("floor", polygon_of({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}));
  add("ceiling", polygon_of({{1, 1, 10}, {1, 7, 10}, {7, 7, 10}, {7, 1, 10}}));
  for (int b = 0; b < boxes; ++b) {
    const Rational turn = seed % 2 == 0 ? Rational(0) : number(0, 1), tilt = seed % 2 == 0 ? Rational(0) : number(0, 1);
    const Rational wide = number(1, 3), deep = number(1, 3);
    const std::array<Vector3, 3> sides{
        {{wide, turn, tilt / 3}, {-turn, deep, tilt / 5}, {tilt / 7, turn / 9, Rational(1) + number(0, 1) / 2}}};
    int part = 0;
    for (Polygon3& side : box({number(1, 5), number(1, 5), Rational(1 + 3 * b) + number(0, 1) / 3}, sides))
      add(fmt::format("box{}_{}", b, part++), std::move(side));
  }
  return scene;
}

Vector flat(const Point3& p) { return {p.x.get_d(), p.y.get_d(), p.z.get_d()}; }

FlatPolygon flat(const Polygon3& polygon) {
  FlatPolygon result;
  for (const Point3& p : polygon.points) result.push_back(flat(p));
  return result;
}

// How far the line from the eye to a place is from the line of an edge, as it is seen.
double off_edge(const Vector& eye, const Vector& place, const std::array<Vector, 2>& edge) {
  const Vector plane = cross(edge[0] - eye, edge[1] - eye);
  return length(plane) == 0 ? 0 : std::abs(dot(plane, place - eye)) / (length(plane) * length(place - eye));
}

double off_vertex(const Vector& eye, const Vector& place, const Vector& vertex) {
  return length(cross(place - eye, vertex - eye)) / (length(place - eye) * length(vertex - eye));
}

// How far the eye is from a line of an event surface: the least over its stretch of what the other edges, or the
// vertex, are beside the line.
double off_lines(const Vector& eye, const EventSurface3& event) {
  const Vector from = flat(event.edge[0]), along = flat(event.edge[1]) - from;
  std::vector<std::array<Vector, 2>> others;
  for (const auto& edge : event.others) others.push_back({flat(edge[0]), flat(edge[1])});
  const auto off = [&](double t) {
    const Vector place = from + t * along;
    double result = event.vertex ? off_vertex(eye, place, flat(*event.vertex)) : 0;
    for (const auto& edge : others) result = std::max(result, off_edge(eye, place, edge));
    return result;
  };
  // Where the eye, a place of the stretch and another edge are in one plane.
  std::vector<double> tries{event.begin, event.end};
  const auto try_plane = [&](const Vector& normal) {
    const double rise = dot(normal, along);
    if (rise != 0) tries.push_back(std::clamp(dot(normal, eye - from) / rise, event.begin, event.end));
  };
  for (const auto& edge : others) try_plane(cross(edge[0] - eye, edge[1] - eye));
  if (event.vertex) {  // square to the plane of the eye, the edge and the vertex
    const Vector way = flat(*event.vertex) - eye;
    try_plane(cross(way, cross(way, along)));
  }
  double least = 1;
  for (const double t : tries) least = std::min(least, off(t));
  return least;
}

// What two faces see of each other, and what stands between them.
struct Sight {
  std::vector<EventSurface3> events;
  std::vector<FlatPolygon> polygons;  // by surface: the two faces first
  VisibleShape shape;

  explicit Sight(const Scene3& scene)
      : events(event_surfaces(prepare(scene), Face{0, false}, Face{1, false})),
        polygons(flat(scene)),
        shape(polygons[1], {polygons.begin() + 2, polygons.end()}) {}

  // How far the eye is from the nearest event. Where lines run in the plane of a face, which its edge and `crossing`
  // name, beyond that plane the face comes into view, and those that are listed are some of them: the eye is to be in
  // the plane.
  double off_events(const Vector& eye) const {
    double least = 1;
    for (const EventSurface3& event : events)
      least = std::min(least, event.crossing.empty() ? off_lines(eye, event) : off_planes(eye, event));
    return least;
  }

 private:
  static std::vector<FlatPolygon> flat(const Scene3& scene) {
    std::vector<FlatPolygon> result;
    for (const Polygon3& polygon : scene.polygons) result.push_back(event_surfaces_against_oracle_test::flat(polygon));
    return result;
  }

  double off_planes(const Vector& eye, const EventSurface3& event) const {
    double least = 1;
    for (const std::uint32_t surface : event.crossing)
      if (std::ranges::find(event.surfaces, surface) != event.surfaces.end())
        least = std::min(least, std::abs(FlatPlane(polygons[surface]).height(eye)) / 10);
    return least;
  }
};

struct Way {
  Vector from, to;
  Vector at(double s) const { return from + s * (to - from); }
};

// Where between two points of a way the shape changes first, of those that are found by halving.
double change_between(const VisibleShape& shape, const Way& way, double low, double high) {
  const auto before = shape.seen_from(way.at(low));
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (shape.seen_from(way.at(middle)) == before ? low : high) = middle;
  }
  return (low + high) / 2;
}

Way random_way(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0.01, 7.99);
  return {{place(random), place(random), 0}, {place(random), place(random), 0}};
}

// Calls take(eye) wherever the shape changes along a way.
template <class Take>
void for_each_change(const VisibleShape& shape, const Way& way, const Take& take) {
  auto before = shape.seen_from(way.at(0));
  for (int k = 1; k <= kSteps; ++k) {
    const double low = (k - 1.0) / kSteps, high = static_cast<double>(k) / kSteps;
    auto after = shape.seen_from(way.at(high));
    if (after != before) take(way.at(change_between(shape, way, low, high)));
    before = std::move(after);
  }
}

TEST(VisibleShape, OfASquarePastAnotherOne) {
  const FlatPolygon target{{0, 0, 2}, {0, 2, 2}, {2, 2, 2}, {2, 0, 2}},
      screen{{1, 1, 1}, {3, 1, 1}, {3, 3, 1}, {1, 3, 1}};
  const VisibleShape shape(target, {screen});
  EXPECT_EQ(shape.seen_from({-1, -1, 0}).size(), 4U);    // the screen is seen beside it
  EXPECT_EQ(shape.seen_from({1.5, 1.5, 0}).size(), 6U);  // it cuts a corner off
}

TEST(EventSurfaces, AreCrossedWhereverTheShapeOfWhatIsSeenChanges) {
  std::mt19937_64 random(7);
  int changes = 0;
  for (int seed = 0; seed < kScenes; ++seed) {
    const Sight sight(scene_of(seed, 1 + seed % 3));
    for (int w = 0; w < kWays; ++w)
      for_each_change(sight.shape, random_way(random), [&](const Vector& eye) {
        EXPECT_LT(sight.off_events(eye), kOff) << "scene " << seed << ", way " << w << ": " << eye.x << ", " << eye.y;
        ++changes;
      });
  }
  EXPECT_GT(changes, 300);
}

// What is left out is noticed: of each kind.
TEST(EventSurfaces, OfWhichSomeAreMissingAreNotAll) {
  const auto farthest_without = [](const auto& is_left_out) {
    Sight sight(scene_of(3, 3));
    std::erase_if(sight.events, is_left_out);
    std::mt19937_64 random(3);
    double farthest = 0;
    for (int w = 0; w < kWays; ++w)
      for_each_change(sight.shape, random_way(random),
                      [&](const Vector& eye) { farthest = std::max(farthest, sight.off_events(eye)); });
    return farthest;
  };
  EXPECT_LT(farthest_without([](const EventSurface3&) { return false; }), kOff);
  EXPECT_GT(farthest_without([](const EventSurface3& event) { return event.vertex.has_value(); }), 100 * kOff);
  EXPECT_GT(farthest_without([](const EventSurface3& event) { return event.others.size() == 2; }), 100 * kOff);
  EXPECT_GT(farthest_without([](const EventSurface3& event) { return !event.crossing.empty(); }), 100 * kOff);
}

}  // namespace
}  // namespace hottel::oracle::event_surfaces_against_oracle_test

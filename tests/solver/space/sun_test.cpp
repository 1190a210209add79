// Suns in space: what rays meet first against a slow oracle, lit areas by hand, borders, points and divided elements.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/moving_lights.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/space/visibility/visibility_finder.h"
#include "kernel/support/failure.h"
#include "solver/space/light/direct_light.h"
#include "solver/space/light/refinement.h"
#include "solver/space/light/scene_light_shares.h"
#include "solver/space/light/tested_shares.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/geometry/space/box_scene.h"
#include "tests/oracle/space/nearest_polygon.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::sun_test {
namespace {

Light sun() {
  Light light;
  light.name = "sun";
  light.type = LightType::kSun;
  light.power = Spectrum::scalar(1);
  return light;
}

// What of each element a sun lights, by name.
struct Lit {
  std::vector<Element> elements;
  LightShares shares;

  Enclosure of(const std::string& name) const {
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (elements[k].name == name) return shares.of_element[k];
    ADD_FAILURE() << name;
    return {-1, -1};
  }
  double sum() const {
    double result = 0;
    for (const Enclosure& share : shares.of_element) result += share.upper;
    return result;
  }
};

Lit lit(Scene3 scene, const Vector3& direction, LightTest test = LightTest::kExact,
        Granularity granularity = Granularity::kFace) {
  scene.add_light(sun(), {.position = {}, .direction = direction, .rotation = {}});
  validate(scene);
  const PreparedScene3 prepared = prepare(std::move(scene));
  const ElementTable3& table = *prepared.elements(granularity);
  return {table.elements(), light_shares(prepared, granularity, test).front()};
}

void expect_area(const Enclosure& share, double area, const std::string& what) {
  EXPECT_TRUE(share.lower <= area * (1 + 0x1p-49) && area * (1 - 0x1p-49) <= share.upper)
      << what << ": " << share.lower << " to " << share.upper << ", not " << area;
  EXPECT_LE(share.width(), 0x1p-48 * share.upper) << what;
}

const Enclosure kNothing{0, 0};

// Ground of 10 x 10 with a box of 2 x 2 x 3 on it.
Scene3 box_on_ground() {
  BoxScene3 scene;
  scene.polygon("ground", level(0, 0, 10, 10, 0));
  scene.box("box", {2, 4, 0}, {4, 6, 3});
  return scene;
}

// Rays that move by 4 on 3 down: the shadow is 4 long and 2 wide, behind the box.
TEST(Sun3, ABoxThrowsItsShadowOnTheGround) {
  const Lit found = lit(box_on_ground(), {4, 0, -3});
  expect_area(found.of("ground"), (100 - 4 - 8) * 0.6, "ground");
  expect_area(found.of("box top"), 4 * 0.6, "top");
  expect_area(found.of("box west"), 6 * 0.8, "west");
  for (const char* dark : {"box east", "box south", "box north", "ground:back"})
    EXPECT_EQ(found.of(dark), kNothing) << dark;
  expect_area(found.shares.whole, 60, "all");  // what the box takes the ground lacks
  EXPECT_EQ(found.shares.sky, kNothing);
}

// The shadow in the plane z = 0 is the hexagon of the foot and the foot moved by (3/2, 3): area 4 + 2 (3/2 + 3) of it.
TEST(Sun3, SlantedRays) {
  const Lit found = lit(box_on_ground(), {1, 2, -2});
  expect_area(found.of("ground"), (100 - 4 - 2 * 4.5) * 2 / 3, "ground");
  expect_area(found.of("box top"), 4 * 2.0 / 3, "top");
  expect_area(found.of("box west"), 6 * 1.0 / 3, "west");
  expect_area(found.of("box south"), 6 * 2.0 / 3, "south");
  const Lit irrational = lit(box_on_ground(), {Rational(1, 3), Rational(1, 7), -1});
  const double length = std::sqrt(1.0 / 9 + 1.0 / 49 + 1);
  expect_area(irrational.of("ground"), (96 - 2 * (1 + 3.0 / 7)) / length, "ground");
  expect_area(irrational.of("box west"), 6 / 3.0 / length, "west");
  expect_area(irrational.of("box south"), 6 / 7.0 / length, "south");
}

TEST(Sun3, GivesNothingWhereItsRaysRunAlong) {
  const Lit level_rays = lit(box_on_ground(), {1, 0, 0});
  for (const char* dark : {"ground", "box top", "box east", "box south", "box north"})
    EXPECT_EQ(level_rays.of(dark), kNothing) << dark;
  expect_area(level_rays.of("box west"), 6, "west");
  const Lit noon = lit(box_on_ground(), {0, 0, -1});
  expect_area(noon.of("ground"), 96, "ground");
  expect_area(noon.of("box top"), 4, "top");
  EXPECT_EQ(noon.of("box west"), kNothing);
  const Lit from_below = lit(box_on_ground(), {0, 1, 1});
  expect_area(from_below.of("ground:back"), 100 / std::sqrt(2.0), "from below");
  for (const char* dark : {"ground", "box top", "box south"}) EXPECT_EQ(from_below.of(dark), kNothing) << dark;
}

TEST(Sun3, AClosedRoomIsDarkAndAHoleLetsItIn) {
  BoxScene3 closed;
  closed.box("room", {0, 0, 0}, {4, 4, 4}, true);
  const Lit dark = lit(closed, {1, 2, -3});
  for (const char* side : {"bottom", "top", "south", "north", "west", "east"})
    EXPECT_EQ(dark.of(std::string("room ") + side), kNothing) << side;
  BoxScene3 open;
  open.box("room", {0, 0, 0}, {4, 4, 4}, true);
  open.polygons[1].holes.push_back({{1, 1, 4}, {1, 2, 4}, {2, 2, 4}, {2, 1, 4}});
  const Lit found = lit(open, {1, 0, -4});  // the hole is 1 x 1: its light falls on the floor, 1 further
  expect_area(found.of("room bottom"), 4 / std::sqrt(17.0), "floor");
  EXPECT_EQ(found.of("room east"), kNothing);
  const Lit aside = lit(open, {4, 0, -4});  // 4 further: the wall is before that
  expect_area(aside.of("room bottom"), 0, "floor");
  expect_area(aside.of("room east"), 1 / std::sqrt(2.0), "east");
}

// The outline of a box across the rays: of each axis, two sides times the cosine.
TEST(Sun3, ConvexBodiesTakeTheirOutline) {
  std::mt19937 random(3);
  for (int run = 0; run < 40; ++run) {
    const auto draw = [&] { return static_cast<int>(random() % 21) - 10; };
    const Vector3 d{draw(), draw(), draw()};
    if (d.is_zero()) continue;
    BoxScene3 scene;
    scene.box("box", {-1, 2, 5}, {1, 5, 6});
    const Lit found = lit(scene, d);
    const double x = std::fabs(to_double(d.x)), y = std::fabs(to_double(d.y)), z = std::fabs(to_double(d.z));
    const double outline = (3 * x + 2 * y + 6 * z) / std::sqrt(x * x + y * y + z * z);
    expect_area(found.shares.whole, outline, "outline");
    EXPECT_NEAR(found.sum(), outline, 1e-13);
  }
}

TEST(Sun3, ElementsShareWhatTheirFaceGetsAndTestsAskPoints) {
  BoxScene3 scene;
  scene.polygon("ground", level(0, 0, 8, 8, 0));
  scene.polygon("roof", level(0, 0, 4, 8, 3));
  scene.surfaces[0].elements = 4;
  // The shadow of the roof is from x = 1 to 5.
  const Lit found = lit(scene, {1, 0, -3}, LightTest::kExact, Granularity::kElement);
  const double cosine = 3 / std::sqrt(10.0);
  for (int row = 0; row < 4; ++row) {
    const auto at = [&](int column) { return found.of("ground#" + std::to_string(4 * row + column)); };
    expect_area(at(0), 2 * cosine, "first");  // between 0 and 1
    EXPECT_EQ(at(1), kNothing);
    expect_area(at(2), 2 * cosine, "third");  // between 5 and 6
    expect_area(at(3), 4 * cosine, "fourth");
  }
  const Lit centroids = lit(scene, {1, 0, -3}, LightTest::kCentroid, Granularity::kElement);
  EXPECT_EQ(centroids.of("ground#1"), kNothing);
  EXPECT_NEAR(centroids.of("ground#3").lower, 4 * cosine, 1e-14);
  const Lit vertices = lit(scene, {1, 0, -3}, LightTest::kVertices, Granularity::kElement);
  EXPECT_NEAR(vertices.of("ground#4").lower, 2 * cosine, 1e-14);              // two of its corners
  EXPECT_NEAR(vertices.shares.whole.lower, found.shares.whole.upper, 1e-12);  // exact all the same
}

TEST(Sun3, ElementsAreDividedWhereShadowsEnd) {
  BoxScene3 scene;
  scene.polygon("ground", level(0, 0, 8, 8, 0));
  scene.polygon("roof", level(0, 0, 4, 8, 3));
  scene.add_light(sun(), {.position = {}, .direction = {2, 0, -3}, .rotation = {}});  // shadow from 2 to 6
  const std::vector<SurfaceTrees> trees = refined_trees(prepare(scene), {.everywhere = 0, .at_borders = 3});
  EXPECT_EQ(trees[0].front.size(), 16u);  // of 2 x 2: the border is between them
  EXPECT_TRUE(trees[1].front.empty());
}

TEST(Sun3, PointsAreLitUpToTheBorderOfShadows) {
  const PreparedScene3 prepared = prepare(box_on_ground());
  const DirectLight3 light(prepared, Vector3{4, 0, -3});
  const Vector3 up{0, 0, 7};
  EXPECT_EQ(light.mean_irradiance({1, 1, 1}), 0.25);
  EXPECT_EQ(light.mean_irradiance({5, 5, 1}), 0);
  EXPECT_EQ(light.mean_irradiance({1000, 1000, 1000}), 0.25);
  EXPECT_EQ(light.mean_irradiance({5, 5, -1}), 0);
  EXPECT_DOUBLE_EQ(light.irradiance({1, 1, 0}, up), 0.6);
  EXPECT_DOUBLE_EQ(light.irradiance({8, 5, 0}, up), 0.6);  // where the shadow ends
  EXPECT_EQ(light.irradiance({Rational(79, 10), 5, 0}, up), 0);
  EXPECT_EQ(light.irradiance({1, 1, 0}, {0, 0, -1}), 0);
  EXPECT_EQ(light.irradiance({1, 1, 0}, {3, 0, 4}), 0);
  double area = 0;
  for (const LitPart3& part : light.lit_parts()) {
    Vector3 doubled;
    for (std::size_t k = 1; k + 1 < part.corners.size(); ++k) {
      const Vector3 more = cross(part.corners[k] - part.corners[0], part.corners[k + 1] - part.corners[0]);
      doubled = {doubled.x + more.x, doubled.y + more.y, doubled.z + more.z};
    }
    area += std::fabs(to_double(dot(doubled, {4, 0, -3}))) / 10;
  }
  EXPECT_NEAR(area, 60, 1e-12);
}

// The ray through a point, followed from far before the scene by brute force; against the cones of the map.
void expect_rays_alike(const std::vector<oracle::SpacePolygon>& polygons, const Vector3& d, std::mt19937& random,
                       int& compared, int& hit) {
  const Occluders3 occluders(oracle::engine_polygons(polygons));
  const ExactVisibilityMap3 map = ExactVisibilityMap3::of_sun(occluders, d);
  const VisibilityFinder3 finder(map);
  for (int k = 0; k < 40; ++k) {
    const auto draw = [&] { return Rational(static_cast<int>(random() % 1201), 101); };
    const Point3 p{draw(), draw(), draw()};
    const oracle::SpacePoint eye{p.x - 1000 * d.x, p.y - 1000 * d.y, p.z - 1000 * d.z};
    const oracle::NearestPolygon nearest = oracle::RayCaster(polygons, eye)({d.x, d.y, d.z});
    const IntegerVector ray = map.toward(p);
    bool is_on_border = false;  // where a polygon is cut into fragments, along lines of edges
    for (std::size_t f = 0; f < map.size(); ++f) {
      const ExactCone3::Place place = map.cone(f).locate(ray).place;
      is_on_border |= place == ExactCone3::Place::kOnEdge || place == ExactCone3::Place::kAtCorner;
    }
    if (!nearest.is_plain || is_on_border) continue;
    ++compared;
    int met = oracle::NearestPolygon::kNoPolygon;
    for (std::size_t f = 0; f < map.size(); ++f)
      if (map.cone(f).locate(ray).place == ExactCone3::Place::kInside) {
        EXPECT_EQ(met, oracle::NearestPolygon::kNoPolygon) << "two cones";
        met = static_cast<int>(map.map().fragments[f].face.surface);
      }
    EXPECT_EQ(met, nearest.polygon);
    if (met == oracle::NearestPolygon::kNoPolygon) continue;
    ++hit;
    EXPECT_EQ(finder.sees(p), map.nearness(p, static_cast<std::uint32_t>(met)) >= 0);
  }
}

TEST(Sun3, RaysMeetWhatBruteForceMeets) {
  std::mt19937 random(17);
  int compared = 0, hit = 0;
  const auto draw = [&](int most) { return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most; };
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const Vector3 d{draw(3), draw(3), draw(3)};
    if (d.is_zero()) continue;
    expect_rays_alike(oracle::piercing_triangles(seed, 25, 12, 6), d, random, compared, hit);
    std::vector<oracle::SpacePolygon> lattice = oracle::lattice_room(seed, 3, 2, 1, 1);
    lattice.erase(lattice.begin(), lattice.begin() + 6);  // without the walls
    if (!lattice.empty()) expect_rays_alike(lattice, d, random, compared, hit);
  }
  EXPECT_GT(compared, 800);
  EXPECT_GT(hit, 200);
}

// What random suns light of each face, front and back, is what rays count that are followed by brute force from a
// lattice across them.
TEST(Sun3, LitAreasAreWhatRaysCount) {
  constexpr int kAcross = 25;
  std::mt19937 random(29);
  const auto draw = [&](int most) { return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most; };
  int faces_lit = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Vector3 d{draw(5), draw(5), draw(5) - 1};
    if (d.x == 0 && d.y == 0) continue;
    std::vector<oracle::SpacePolygon> polygons =
        seed % 2 == 0 ? oracle::piercing_triangles(seed, 16, 12, 6) : oracle::lattice_room(seed, 3, 2, 1, 1);
    if (seed % 2 == 1) polygons.erase(polygons.begin(), polygons.begin() + 6);  // without the walls
    BoxScene3 scene;
    for (const Polygon3& polygon : oracle::engine_polygons(polygons))
      scene.polygon("p" + std::to_string(scene.surfaces.size()), polygon, 0, 1);
    const std::vector<Polygon3> shapes = scene.polygons;
    const Lit lit_by_sun = lit(std::move(scene), d);
    // Two axes across the rays, and how far the scene reaches along each.
    const Vector3 u{d.y, -d.x, 0}, v = cross(d, u);
    std::array<Rational, 2> low, high;
    for (const Polygon3& polygon : shapes)
      for (const Point3& p : polygon.points)
        for (const auto& [axis, way] : {std::pair(0u, u), std::pair(1u, v)}) {
          const Rational at = dot(way, p - Point3{0, 0, 0}) / dot(way, way);
          const bool is_first = &polygon == shapes.data() && &p == polygon.points.data();
          low[axis] = is_first ? at : std::min(low[axis], at);
          high[axis] = is_first ? at : std::max(high[axis], at);
        }
    std::vector<int> counts(2 * shapes.size());
    const Vector3 width{(high[0] - low[0]) / kAcross, (high[1] - low[1]) / kAcross, 0};
    for (int a = 0; a < kAcross; ++a)
      for (int b = 0; b < kAcross; ++b) {
        const auto at = [&](int k) -> Rational { return k + Rational(1 + static_cast<int>(random() % 96), 97); };
        const Rational s = low[0] + width.x * at(a), t = low[1] + width.y * at(b);
        const oracle::SpacePoint eye{s * u.x + t * v.x - 1000 * d.x, s * u.y + t * v.y - 1000 * d.y,
                                     s * u.z + t * v.z - 1000 * d.z};
        const oracle::NearestPolygon nearest = oracle::RayCaster(polygons, eye)({d.x, d.y, d.z});
        if (!nearest.is_plain || nearest.polygon == oracle::NearestPolygon::kNoPolygon) continue;
        const auto met = static_cast<std::uint32_t>(nearest.polygon);
        ++counts[Face{met, dot(doubled_area(shapes[met]), d) > 0}.number()];
      }
    const double cell = to_double(width.x * width.y) * std::sqrt(to_double(dot(u, u)) * to_double(dot(v, v)));
    for (std::size_t k = 0; k < lit_by_sun.elements.size(); ++k) {
      const Element& element = lit_by_sun.elements[k];
      const double count = counts[Face{element.surface, element.is_back}.number()];
      const double share = lit_by_sun.shares.of_element[k].upper / cell;
      // A ray in each cell: of a cell of which a share p is lit the variance is p (1 - p).
      EXPECT_NEAR(count, share, 5 * std::sqrt(share) + 2) << seed << " " << element.name;
      faces_lit += count > 0;
    }
  }
  EXPECT_GT(faces_lit, 40);
}

// All that is lit of crossing triangles, within the outline of the whole: what one loses another one has.
TEST(Sun3, LitAreasDoNotDependOnWhereOrHowLarge) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto whole = [&](const mpq_class& scale, const oracle::SpacePoint& offset) {
      BoxScene3 scene;
      int k = 0;
      for (const Polygon3& polygon :
           oracle::engine_polygons(oracle::moved(oracle::piercing_triangles(seed, 12, 10, 5), scale, offset)))
        scene.polygon("t" + std::to_string(k++), polygon);
      return lit(scene, {1, 2, -2}).shares.whole;
    };
    const Enclosure here = whole(1, {0, 0, 0}), there = whole(4, {mpq_class(1, 3), 7, -11});
    EXPECT_EQ(there.lower, 16 * here.lower);
    EXPECT_EQ(there.upper, 16 * here.upper);
  }
}

TEST(Sun3, TurnsAsTimePasses) {
  const LightPlace3 place{.position = {}, .direction = {0, 0, -1}, .rotation = {15, 0, 0}};
  EXPECT_EQ(place_after(place, 6).direction, (Vector3{0, 1, 0}));
  EXPECT_EQ(place_after(place, 24).direction, (Vector3{0, 0, -1}));
  Scene3 scene = box_on_ground();
  scene.add_light(sun(), place);
  EXPECT_TRUE(has_moving_lights(scene));
  EXPECT_TRUE(is_lit_alike_3(sun(), place, sun(), place_after(place, 24)));
  EXPECT_FALSE(is_lit_alike_3(sun(), place, sun(), place_after(place, 1)));
  scene.light_places[0].direction = {};
  EXPECT_THROW(validate(scene), InputError);
}

}  // namespace
}  // namespace hottel::sun_test

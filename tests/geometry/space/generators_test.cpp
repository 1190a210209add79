#include "geometry/space/generate/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "geometry/space/generate/generator_canvas.h"
#include "geometry/space/scene/polygon.h"
#include "kernel/support/failure.h"
#include "tests/sanitizers.h"

namespace hottel::generators_test {
namespace {

GeneratorRequest3 request(const std::string& kind, std::uint64_t n, std::uint64_t seed, bool has_bottoms = true) {
  return {kind, n, seed, has_bottoms};
}

// Every kind, and those that may do so without bottoms, with some n.
std::vector<GeneratorRequest3> requests(std::uint64_t seed) {
  std::vector<GeneratorRequest3> all;
  for (const GeneratorKind3& kind : generator_kinds_3())
    for (const std::uint64_t n : {kind.min_n, kind.usual_n, kind.usual_n + 29, kind.usual_n * 2})
      for (const bool has_bottoms : {true, false})
        if (has_bottoms || kind.stands) all.push_back(request(kind.name, n, seed, has_bottoms));
  return all;
}

bool may_overlap(const GeneratorRequest3& r) {
  static const std::set<std::string> kStanding = {"room-boxes", "room-stacked",   "street-blocks",
                                                  "town",       "furnished-room", "flat"};
  return r.kind == "room-touching" || r.kind == "lattice-boxes" || (kStanding.contains(r.kind) && r.has_bottoms);
}

bool is_under_the_sky(const std::string& kind) {
  return kind == "street-blocks" || kind == "town" || kind == "terrain";
}

std::string text_of(const Point3& p) { return p.x.get_str() + " " + p.y.get_str() + " " + p.z.get_str(); }

std::string text_of(const Scene3& scene) {
  std::string text;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    text += surface.name + " " + scene.groups[surface.group].name + " " + scene.materials[surface.material].name;
    for (const Point3& p : scene.polygons[s].points) text += " " + text_of(p);
    text += "\n";
  }
  return text;
}

// FNV-1a.
std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

// The polygons of each group.
std::map<std::string, std::vector<const Polygon3*>> groups_of(const Scene3& scene) {
  std::map<std::string, std::vector<const Polygon3*>> groups;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    groups[scene.groups[scene.surfaces[s].group].name].push_back(&scene.polygons[s]);
  return groups;
}

// How often each side is passed from one end to the other. Points are numbered as they come.
std::map<std::pair<std::size_t, std::size_t>, int> sides_of(const std::vector<const Polygon3*>& polygons,
                                                            std::vector<Point3>& points) {
  std::map<std::string, std::size_t> number;
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  const auto number_of = [&](const Point3& p) {
    const auto [entry, is_new] = number.emplace(text_of(p), points.size());
    if (is_new) points.push_back(p);
    return entry->second;
  };
  for (const Polygon3* polygon : polygons) {
    const std::vector<Point3>& p = polygon->points;
    for (std::size_t k = 0; k < p.size(); ++k) ++sides[{number_of(p[k]), number_of(p[(k + 1) % p.size()])}];
  }
  return sides;
}

// Six times the volume that a closed mesh has within its fronts outward; negative where they are inward.
Rational volume_of(const std::vector<const Polygon3*>& polygons) {
  Rational volume = 0;
  for (const Polygon3* polygon : polygons)
    for (std::size_t k = 2; k < polygon->points.size(); ++k) {
      const Point3 origin;
      const std::vector<Point3>& p = polygon->points;
      volume += dot(p[0] - origin, cross(p[k - 1] - origin, p[k] - origin));
    }
  return volume;
}

// Where a polygon lies: the corners of the box around it.
std::array<Point3, 2> box_of(const std::vector<Point3>& points) {
  std::array<Point3, 2> box = {points[0], points[0]};
  for (const Point3& p : points)
    for (Rational Point3::*c : {&Point3::x, &Point3::y, &Point3::z}) {
      box[0].*c = std::min<Rational>(box[0].*c, p.*c);
      box[1].*c = std::max<Rational>(box[1].*c, p.*c);
    }
  return box;
}

// True iff two polygons of one plane share an area: no line through a side of one parts them. (Convex ones.)
bool share_an_area(const Polygon3& a, const Polygon3& b) {
  const Vector3 normal = doubled_area(a);
  for (const Point3& p : b.points)
    if (dot(p - a.points[0], normal) != 0) return false;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const std::vector<Point3>& p = one->points;
    const Vector3 up = doubled_area(*one);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Vector3 inward = cross(up, p[(k + 1) % p.size()] - p[k]);
      if (std::all_of(other->points.begin(), other->points.end(),
                      [&](const Point3& q) { return dot(q - p[k], inward) <= 0; }))
        return false;
    }
  }
  return true;
}

std::size_t count_of_overlaps(const Scene3& scene) {
  // By planes: normals in lowest terms.
  std::map<std::string, std::vector<const Polygon3*>> planes;
  for (const Polygon3& polygon : scene.polygons) {
    Vector3 normal = doubled_area(polygon);
    const Rational first = normal.x != 0 ? normal.x : normal.y != 0 ? normal.y : normal.z;
    normal = {normal.x / first, normal.y / first, normal.z / first};
    planes[normal.x.get_str() + " " + normal.y.get_str() + " " + normal.z.get_str() + " " +
           Rational(dot(polygon.points[0] - Point3{}, normal)).get_str()]
        .push_back(&polygon);
  }
  std::size_t count = 0;
  for (const auto& [plane, polygons] : planes)
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) count += share_an_area(*polygons[i], *polygons[j]);
  return count;
}

TEST(Generators3, SameRequestGivesTheSameScene) {
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    const auto r = request(kind.name, kind.usual_n, 7);
    EXPECT_EQ(text_of(generate_3(r)), text_of(generate_3(r))) << kind.name;
    EXPECT_NE(text_of(generate_3(r)), text_of(generate_3(request(kind.name, kind.usual_n, 8)))) << kind.name;
  }
}

TEST(Generators3, ScenesAreTheSameOnEveryPlatform) {
  const auto fingerprint_of = [](const char* kind, std::uint64_t n) {
    return fingerprint(text_of(generate_3(request(kind, n, 1))));
  };
  EXPECT_EQ(fingerprint_of("room-boxes", 9), 5562844281196800111u);
  EXPECT_EQ(fingerprint_of("room-stacked", 9), 13967849583942164277u);
  EXPECT_EQ(fingerprint_of("room-touching", 9), 6110834644103434679u);
  EXPECT_EQ(fingerprint_of("room-floating", 9), 6893804568641903373u);
  EXPECT_EQ(fingerprint_of("room-turned", 9), 3546268340081892169u);
  EXPECT_EQ(fingerprint_of("room-piercing", 9), 4078404909363811079u);
  EXPECT_EQ(fingerprint_of("street-blocks", 9), 683384474053243381u);
  EXPECT_EQ(fingerprint_of("town", 30), 244774277903438918u);
  EXPECT_EQ(fingerprint_of("terrain", 300), 12104322002016372919u);
  EXPECT_EQ(fingerprint_of("nested-cubes", 9), 15842301745209269911u);
  EXPECT_EQ(fingerprint_of("triangle-soup", 50), 4371724733401593418u);
  EXPECT_EQ(fingerprint_of("furnished-room", 348), 2822215380481117405u);
  EXPECT_EQ(fingerprint_of("flat", 1090), 6815800375113218192u);
  EXPECT_EQ(fingerprint_of("lattice-boxes", 9), 4025473882041548957u);
}

TEST(Generators3, EveryPolygonIsExactlyPlaneAndConvex) {
  for (const GeneratorRequest3& r : requests(3)) {
    const Scene3 scene = generate_3(r);
    ASSERT_EQ(scene.polygons.size(), scene.surfaces.size());
    for (std::size_t s = 0; s < scene.polygons.size(); ++s) {
      const std::vector<Point3>& p = scene.polygons[s].points;
      ASSERT_EQ(polygon_problem(scene.polygons[s]).text, "") << scene.about << ": " << scene.surfaces[s].name;
      // And once more, by hand.
      const Vector3 normal = cross(p[1] - p[0], p[2] - p[0]);
      ASSERT_FALSE(normal.is_zero()) << scene.about << ": " << scene.surfaces[s].name;
      for (const Point3& q : p) ASSERT_EQ(dot(q - p[0], normal), 0) << scene.about << ": " << scene.surfaces[s].name;
    }
  }
}

// True iff each side is passed once in each sense; but for the sides of the bottom, which a body without one has open.
void expect_closed_but_below(const std::vector<const Polygon3*>& polygons, bool is_open_below,
                             const std::string& group) {
  std::vector<Point3> points;
  const auto sides = sides_of(polygons, points);
  Rational lowest = points[0].z;
  for (const Point3& p : points) lowest = std::min<Rational>(lowest, p.z);
  std::size_t open = 0;
  for (const auto& [side, count] : sides) {
    ASSERT_EQ(count, 1) << group;
    if (sides.contains({side.second, side.first})) continue;
    ++open;
    EXPECT_EQ(points[side.first].z, lowest) << group;
    EXPECT_EQ(points[side.second].z, lowest) << group;
  }
  EXPECT_EQ(open, is_open_below ? 4u : 0u) << group;
}

// Of a request without bottoms: what stands on something.
bool stands(const std::string& kind, const std::string& group) {
  if (group == "room" || group == "ground") return false;
  if (kind != "furnished-room" && kind != "flat") return true;
  return group.find(".leg") != std::string::npos || group.find(".side") != std::string::npos ||
         group.find(".foot") != std::string::npos;
}

// True of hills: one height over each point, 0 along the border of a square; no side is open but those there.
void expect_open_at_the_border(const std::vector<const Polygon3*>& polygons, const std::string& about) {
  std::vector<Point3> points;
  const auto sides = sides_of(polygons, points);
  const Rational end = box_of(points)[1].x;
  const auto is_at_the_border = [&](const Point3& p) {
    return p.z == 0 && (p.x == 0 || p.y == 0 || p.x == end || p.y == end);
  };
  std::size_t open = 0;
  for (const auto& [side, count] : sides) {
    ASSERT_EQ(count, 1) << about;
    if (sides.contains({side.second, side.first})) continue;
    ++open;
    EXPECT_TRUE(is_at_the_border(points[side.first]) && is_at_the_border(points[side.second])) << about;
  }
  EXPECT_EQ(open * open, 8 * polygons.size()) << about;  // 4 g sides about g x g cells of two triangles
  for (const Polygon3* polygon : polygons) EXPECT_GT(doubled_area(*polygon).z, 0) << about;
  for (const Point3& p : points) EXPECT_GE(p.z, 0) << about;
}

TEST(Generators3, GroupsAreClosedMeshes) {
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (const GeneratorRequest3& r : requests(seed)) {
      const Scene3 scene = generate_3(r);
      for (const auto& [group, polygons] : groups_of(scene)) {
        if (r.kind == "terrain" && group == "ground") {
          expect_open_at_the_border(polygons, scene.about);
          continue;
        }
        if (group == "ground" || group.starts_with("triangle")) {
          EXPECT_EQ(polygons.size(), 1u) << group;
          continue;
        }
        expect_closed_but_below(polygons, !r.has_bottoms && stands(r.kind, group), scene.about + ": " + group);
      }
    }
}

TEST(Generators3, BoxesHaveTheirFrontsOutwardAndRoomsInward) {
  for (const GeneratorRequest3& r : requests(4)) {
    if (!r.has_bottoms) continue;
    const Scene3 scene = generate_3(r);
    for (const auto& [group, polygons] : groups_of(scene)) {
      if (polygons.size() == 1 || (r.kind == "terrain" && group == "ground")) continue;
      const bool is_even_cube = group.starts_with("cube") && (group.back() - '0') % 2 == 0;
      EXPECT_EQ(sgn(volume_of(polygons)), group == "room" || is_even_cube ? -1 : 1) << scene.about << ": " << group;
    }
  }
}

TEST(Generators3, NothingLiesOutsideTheRoom) {
  for (const GeneratorRequest3& r : requests(5)) {
    const Scene3 scene = generate_3(r);
    EXPECT_EQ(scene.closed, !is_under_the_sky(r.kind)) << r.kind;
    if (!scene.closed) continue;
    std::vector<Point3> points, walls;
    for (std::size_t s = 0; s < scene.polygons.size(); ++s)
      for (const Point3& p : scene.polygons[s].points) {
        points.push_back(p);
        if (scene.surfaces[s].group == 0) walls.push_back(p);
      }
    EXPECT_EQ(box_of(points), box_of(walls)) << scene.about;
    EXPECT_EQ(box_of(walls)[0], (Point3{0, 0, 0})) << scene.about;
  }
}

TEST(Generators3, PolygonsShareAnAreaOnlyInKindsThatSaySo) {
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (const GeneratorRequest3& r : requests(seed)) {
      const std::size_t overlaps = count_of_overlaps(generate_3(r));
      const std::string about = r.kind + " --n " + std::to_string(r.n) + " --seed " + std::to_string(seed);
      if (!may_overlap(r)) {
        EXPECT_EQ(overlaps, 0u) << about;
      } else if (r.kind != "lattice-boxes" || r.n > 1) {
        EXPECT_GT(overlaps, 0u) << about;
      }
    }
}

TEST(Generators3, EverySceneIsOneThatFilesMayHold) {
  for (const GeneratorRequest3& r : requests(6)) EXPECT_NO_THROW(validate(generate_3(r))) << r.kind << " " << r.n;
}

// The boxes of a scene, one a group, and whether two of them have a point in common; boxes along the axes only.
std::vector<std::array<Point3, 2>> boxes_of(const Scene3& scene) {
  std::vector<std::array<Point3, 2>> boxes;
  for (const auto& [group, polygons] : groups_of(scene)) {
    if (group == "room") continue;
    std::vector<Point3> points;
    for (const Polygon3* polygon : polygons)
      points.insert(points.end(), polygon->points.begin(), polygon->points.end());
    boxes.push_back(box_of(points));
  }
  return boxes;
}

// In how many coordinates the insides of two boxes overlap, and in how many they only touch.
std::pair<int, int> contact_of(const std::array<Point3, 2>& a, const std::array<Point3, 2>& b) {
  int overlaps = 0, touches = 0;
  for (const Rational Point3::*c : {&Point3::x, &Point3::y, &Point3::z}) {
    const Rational width = std::min<Rational>(a[1].*c, b[1].*c) - std::max<Rational>(a[0].*c, b[0].*c);
    overlaps += width > 0;
    touches += width == 0;
  }
  return {overlaps, touches};
}

std::map<std::pair<int, int>, int> contacts_of(const Scene3& scene) {
  std::map<std::pair<int, int>, int> contacts;
  const auto boxes = boxes_of(scene);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) ++contacts[contact_of(boxes[i], boxes[j])];
  return contacts;
}

TEST(Generators3, BoxesMeetAsTheirKindSays) {
  constexpr std::pair<int, int> kFace{2, 1}, kSide{1, 2}, kCorner{0, 3}, kInside{3, 0};
  const auto of = [](const char* kind) { return contacts_of(generate_3(request(kind, 60, 2))); };
  auto touching = of("room-touching");
  EXPECT_GE(touching[kFace], 30);
  EXPECT_GT(touching[kSide], 0);
  EXPECT_EQ(touching[kInside], 0);
  auto stacked = of("room-stacked");
  EXPECT_GT(stacked[kFace], 10);
  EXPECT_EQ(stacked[kSide] + stacked[kCorner] + stacked[kInside], 0);
  auto lattice = of("lattice-boxes");
  for (const auto& contact : {kFace, kSide, kCorner, kInside}) EXPECT_GT(lattice[contact], 0);
  for (const char* kind : {"room-boxes", "room-floating"}) {
    auto apart = of(kind);
    EXPECT_EQ(apart[kFace] + apart[kSide] + apart[kCorner] + apart[kInside], 0) << kind;
  }
}

// The boxes around turned boxes of different places do not meet either.
TEST(Generators3, TurnedBoxesAreTurnedAndApart) {
  const Scene3 scene = generate_3(request("room-turned", 60, 2));
  for (const auto& [group, polygons] : groups_of(scene)) {
    if (group == "room") continue;
    int oblique = 0;
    for (const Polygon3* polygon : polygons) {
      const Vector3 n = doubled_area(*polygon);
      oblique += (n.x != 0) + (n.y != 0) + (n.z != 0) > 1;
    }
    EXPECT_GE(oblique, 4) << group;
  }
  auto contacts = contacts_of(scene);
  EXPECT_EQ((contacts[{3, 0}]), 0);
}

// True iff a point lies in the inside of a closed convex mesh with its fronts outward.
bool is_inside(const Point3& point, const std::vector<const Polygon3*>& polygons) {
  return std::all_of(polygons.begin(), polygons.end(), [&](const Polygon3* polygon) {
    return dot(point - polygon->points[0], doubled_area(*polygon)) < 0;
  });
}

TEST(Generators3, EveryPiercingBoxHasAPointInCommonWithAnother) {
  for (const std::uint64_t n : {2u, 3u, 4u, 5u, 40u}) {
    const Scene3 scene = generate_3(request("room-piercing", n, 6));
    const auto groups = groups_of(scene);
    EXPECT_EQ(groups.size(), n + 1);
    // The middles of the places, where boxes pierce each other.
    const std::int64_t side = side_of_cube(std::max<std::uint64_t>(1, n / 3));
    for (const auto& [group, polygons] : groups) {
      if (group == "room") continue;
      int others = 0;
      for (std::int64_t place = 0; place < side * side * side; ++place) {
        const auto middle = [](std::int64_t k) -> Rational { return Rational(1500 * k + 1050) / 1000; };
        const Point3 point{middle(place % side), middle(place / side % side), middle(place / side / side)};
        if (!is_inside(point, polygons)) continue;
        for (const auto& [name, other] : groups) others += name != group && name != "room" && is_inside(point, other);
      }
      EXPECT_GE(others, 1) << group << " of " << n;
      EXPECT_LE(others, 4) << group << " of " << n;
    }
  }
}

TEST(Generators3, NumberOfPolygonsIsAsPromised) {
  for (const std::uint64_t n : {7u, 30u, 101u}) {
    const auto count = [n](const char* kind, bool has_bottoms = true) {
      return static_cast<std::uint64_t>(generate_3(request(kind, n, 3, has_bottoms)).surfaces.size());
    };
    for (const char* kind : {"room-boxes", "room-stacked", "room-touching", "room-floating", "room-turned",
                             "room-piercing", "lattice-boxes"})
      EXPECT_EQ(count(kind), 6 + 6 * n) << kind;
    EXPECT_EQ(count("room-boxes", false), 6 + 5 * n);
    EXPECT_EQ(count("room-stacked", false), 6 + 5 * n);
    EXPECT_EQ(count("street-blocks"), 1 + 6 * n);
    EXPECT_EQ(count("street-blocks", false), 1 + 5 * n);
    EXPECT_EQ(count("town"), 1 + 6 * n);
    EXPECT_EQ(count("town", false), 1 + 5 * n);
    EXPECT_EQ(count("nested-cubes"), 6 * n);
    EXPECT_EQ(count("triangle-soup"), n);
  }
  for (const std::uint64_t places : {1u, 2u, 3u, 5u})
    for (const std::uint64_t more : {0u, 335u}) {
      const Scene3 scene = generate_3(request("furnished-room", 12 + 336 * places + more, 3));
      EXPECT_EQ(scene.surfaces.size(), 12 + 336 * places);
      for (const Polygon3& polygon : scene.polygons) EXPECT_EQ(polygon.points.size(), 3u);
    }
}

TEST(Generators3, ATownHasABuildingOnEachLotAndElements) {
  const Scene3 scene = generate_3(request("town", 60, 2));
  const auto groups = groups_of(scene);
  EXPECT_EQ(box_of(groups.at("ground")[0]->points), (std::array<Point3, 2>{Point3{0, 0, 0}, Point3{500, 60, 0}}));
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) EXPECT_EQ(scene.surfaces[s].elements, s == 0 ? 20u : 2u);
  for (int k = 0; k < 60; ++k) {
    std::vector<Point3> points;
    for (const Polygon3* polygon : groups.at(numbered("building", k)))
      points.insert(points.end(), polygon->points.begin(), polygon->points.end());
    const auto [low, high] = box_of(points);
    const Rational west = 20 * (k % 25), south = 20 * (k / 25);
    for (const Rational& gap :
         std::vector<Rational>{low.x - west, low.y - south, west + 20 - high.x, south + 20 - high.y})
      EXPECT_GE(gap, 2) << k;
    for (const Rational& side : std::vector<Rational>{high.x - low.x, high.y - low.y}) {
      EXPECT_GE(side, 8) << k;
      EXPECT_LE(side, 14) << k;
    }
    EXPECT_EQ(low.z, 0) << k;
    EXPECT_GE(high.z, 6) << k;
    EXPECT_LE(high.z, 40) << k;
  }
}

// Each building has its feet in the ground, all around, and all of its top above.
TEST(Generators3, TerrainHasSoManyPolygonsAndBuildingsWithTheirFeetInTheGround) {
  for (const std::uint64_t n : {200u, 201u, 205u, 333u, 1000u, 5001u}) {
    const Scene3 scene = generate_3(request("terrain", n, n));
    EXPECT_LE(scene.surfaces.size(), n);
    EXPECT_GT(scene.surfaces.size() + 6, n);
    const auto groups = groups_of(scene);
    EXPECT_GE(groups.size(), 1 + n / 60);
    std::map<std::string, Rational> heights;
    const auto key = [](const Rational& x, const Rational& y) { return x.get_str() + " " + y.get_str(); };
    for (const Polygon3* polygon : groups.at("ground")) {
      EXPECT_EQ(polygon->points.size(), 3u);
      for (const Point3& p : polygon->points) heights[key(p.x, p.y)] = p.z;
    }
    std::vector<std::array<Point3, 2>> boxes;
    for (const auto& [group, polygons] : groups) {
      if (group == "ground") continue;
      std::vector<Point3> points;
      for (const Polygon3* polygon : polygons)
        points.insert(points.end(), polygon->points.begin(), polygon->points.end());
      boxes.push_back(box_of(points));
      const auto [low, high] = boxes.back();
      const std::int64_t west = 20 * static_cast<std::int64_t>(low.x.get_d() / 20),
                         south = 20 * static_cast<std::int64_t>(low.y.get_d() / 20);
      EXPECT_LT(high.x, west + 20) << group;
      EXPECT_LT(high.y, south + 20) << group;
      for (int corner = 0; corner < 9; ++corner) {
        const Rational& height = heights.at(key(Rational(static_cast<long>(west + 10 * (corner % 3))),
                                                Rational(static_cast<long>(south + 10 * (corner / 3)))));
        EXPECT_GE(height, low.z + 1) << group;
        EXPECT_LE(height, high.z - 3) << group;
      }
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_LT(contact_of(boxes[i], boxes[j]).first, 3);
  }
}

TEST(Generators3, AFlatHasSoManyTriangles) {
  for (const std::uint64_t rooms : {1u, 2u, 3u, 5u, 14u})
    for (const std::uint64_t more : {0u, 369u}) {
      const Scene3 scene = generate_3(request("flat", 370 * rooms - 20 + more, 3));
      EXPECT_EQ(scene.surfaces.size(), 370 * rooms - 20);
      for (const Polygon3& polygon : scene.polygons) EXPECT_EQ(polygon.points.size(), 3u);
    }
}

// What the walls, floors and ceilings enclose are the rooms of 5 m x 4 m x 2.6 m and a doorway for each but the first,
// of 0.9 m x 2 m x 0.15 m.
TEST(Generators3, AFlatEnclosesItsRoomsAndDoorways) {
  for (const int rooms : {1, 2, 3, 8, 14}) {
    const Scene3 scene = generate_3(request("flat", static_cast<std::uint64_t>(370 * rooms - 20), 5));
    const Rational volume = -volume_of(groups_of(scene).at("room")) / 6;
    EXPECT_EQ(volume, 52 * rooms + Rational(27, 100) * (rooms - 1)) << rooms;
  }
}

TEST(Generators3, SomethingEmitsAndEveryNameIsThatOfAMesh) {
  for (const GeneratorRequest3& r : requests(4)) {
    const Scene3 scene = generate_3(r);
    bool emits = !scene.sky_emission.is_zero();
    std::map<std::string, std::size_t> count;
    std::set<std::uint32_t> used;
    for (const Surface& s : scene.surfaces) {
      ASSERT_LT(s.material, scene.materials.size());
      ASSERT_LT(s.group, scene.groups.size());
      emits |= !scene.materials[s.material].emission.is_zero();
      const std::string& group = scene.groups[s.group].name;
      EXPECT_EQ(s.name, group + "[" + std::to_string(count[group]++) + "]");
      EXPECT_FALSE(s.back.has_value());
      used.insert(s.material);
    }
    EXPECT_EQ(count.size(), scene.groups.size()) << scene.about;
    EXPECT_EQ(used.size(), scene.materials.size()) << scene.about;
    EXPECT_TRUE(emits) << scene.about;
    EXPECT_NO_THROW(validate_table(scene)) << scene.about;
    if (scene.camera) {
      EXPECT_EQ(camera_problem(*scene.camera), "") << scene.about;
    }
  }
}

// Of the largest scenes there may be; sanitizers take a tenth.
TEST(Generators3, MakeTheirLargestScenes) {
  constexpr std::uint32_t kBodies =
      kHasAddressSanitizer || kHasThreadSanitizer ? kMaxGeneratedBodies / 10 : kMaxGeneratedBodies;
  for (const char* kind : {"room-turned", "street-blocks", "triangle-soup", "room-piercing"}) {
    const Scene3 scene = generate_3(request(kind, kBodies, 1));
    EXPECT_GE(scene.surfaces.size(), kBodies) << kind;
    std::set<std::string> names;
    for (const Group& group : scene.groups) EXPECT_TRUE(names.insert(group.name).second) << group.name;
  }
}

TEST(Generators3, RefusesWhatItCannotMake) {
  EXPECT_THROW(generate_3(request("castle", 100, 1)), UsageError);
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    EXPECT_THROW(generate_3(request(kind.name, kind.min_n - 1, 1)), UsageError) << kind.name;
    EXPECT_THROW(generate_3(request(kind.name, kMaxGeneratedBodies + 1, 1)), UsageError) << kind.name;
    if (!kind.stands) {
      EXPECT_THROW(generate_3(request(kind.name, kind.usual_n, 1, false)), UsageError) << kind.name;
    }
  }
}

TEST(Generators3, NoKindHasTheNameOfOneInThePlane) {
  for (const GeneratorKind3& kind : generator_kinds_3())
    for (const GeneratorKind2& other : generator_kinds_2()) EXPECT_NE(kind.name, other.name);
}

TEST(PlaneOf3, IsTheSameForEveryThreePointsOfAPlane) {
  const Dot3 a{3, 1, 4}, u{2, -6, 4}, v{5, 0, -7};
  const auto plane = plane_of(a, a + u, a + v);
  EXPECT_EQ(plane_of(a + v, a + u, a), plane);
  EXPECT_EQ(plane_of(a + 3 * u, a + 2 * v, a + u + v), plane);
  EXPECT_NE(plane_of(a + Dot3{0, 0, 1}, a + u + Dot3{0, 0, 1}, a + v + Dot3{0, 0, 1}), plane);
}

}  // namespace
}  // namespace hottel::generators_test

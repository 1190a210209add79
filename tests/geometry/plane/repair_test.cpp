// What a repair closes, and what it leaves alone.
#include "geometry/plane/check/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/near_misses.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/closest_point.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::repair_test {
namespace {

using namespace testing_scenes;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> kinds(const Repair2& repair) {
  std::vector<std::string> result;
  for (const RepairStep& step : repair.steps) result.push_back(step.kind + " " + step.surface);
  return result;
}

bool same_places(const Scene2& a, const Scene2& b) {
  return a.edges == b.edges && std::ranges::equal(a.surfaces, b.surfaces, {}, &Surface::name, &Surface::name);
}

TEST(Repair2, PutsAnEndExactlyOntoTheNearestSurface) {
  const Scene2 scene = scene_of(room("4") + std::vector<Line>{{"door", "2", "0", "2", "3.9999999"}});
  const Repair2 repair = close_gaps(scene, number("1e-6"));
  EXPECT_THAT(kinds(repair), ElementsAre("snapped door"));
  EXPECT_EQ(repair.scene.edges[4].to, (Point2{2, 4}));
  EXPECT_THAT(find_near_misses(repair.scene), IsEmpty());
}

TEST(Repair2, PutsAnEndOntoASlantedSurfaceWithFewDigits) {
  const Scene2 scene = scene_of({{"wall", "0", "0", "1000", "333.333"}, {"fin", "500", "0", "123.456789", "41.15"}});
  const Repair2 repair = close_gaps(scene, number("0.01"));
  ASSERT_THAT(kinds(repair), ElementsAre("snapped fin"));
  const Contacts2 contacts = find_contacts(repair.scene);
  ASSERT_EQ(contacts.junctions.size(), 1u);  // exactly on it
  EXPECT_LT(to_string(repair.scene.edges[1].to.x).size(), 32u);
}

TEST(Repair2, CutsAStubOff) {
  const Scene2 scene = scene_of(room("4") + std::vector<Line>{{"door", "2", "0", "2", "4.0000001"}});
  EXPECT_EQ(close_gaps(scene, number("1e-6")).scene.edges[4].to, (Point2{2, 4}));
}

TEST(Repair2, MergesEndsIntoTheOneListedFirst) {
  const Scene2 scene =
      scene_of({{"a", "0", "0", "1", "0"}, {"b", "1.0000001", "0", "2", "1"}, {"c", "1", "1e-7", "0", "3"}});
  const Repair2 repair = close_gaps(scene, number("1e-6"));
  EXPECT_THAT(kinds(repair), ElementsAre("merged b", "merged c"));
  for (const std::size_t s : {1u, 2u}) EXPECT_EQ(repair.scene.edges[s].from, (Point2{1, 0}));
}

TEST(Repair2, MovesNothingFartherThanAsked) {
  // A chain of ends, each within reach of the next only.
  std::vector<Line> lines;
  for (int k = 0; k < 6; ++k)
    lines.push_back({"e" + std::to_string(k), std::to_string(k), "0", std::to_string(k), "100"});
  const Scene2 scene = scene_of(lines);
  const Repair2 repair = close_gaps(scene, number("1.5"));
  for (std::size_t s = 0; s < repair.scene.surfaces.size(); ++s) {
    const std::string& name = repair.scene.surfaces[s].name;
    const Edge2 &before = scene.edges[*scene.find(name)], &after = repair.scene.edges[s];
    EXPECT_LE(squared_distance(before.from, after.from), number("2.25")) << name;
    EXPECT_LE(squared_distance(before.to, after.to), number("2.25")) << name;
  }
}

TEST(Repair2, DoesNothingToItsOwnResult) {
  // What joins k to n keeps both from g, which m keeps in place; joined, the two would be within reach of g still, and
  // a second repair would not know why they are not to go there. So it is with q, r and h, p.
  const Scene2 scene = scene_of({{"k", "0", "0", "-100", "-100"},
                                 {"n", "-0.1", "0", "-100", "-110"},
                                 {"g", "0.9", "0", "190", "-100"},
                                 {"m", "1.5", "0", "200", "-110"},
                                 {"q", "0", "0.95", "-100", "100"},
                                 {"r", "0", "1", "-100", "110"},
                                 {"h", "0.92", "0.95", "190", "100"},
                                 {"p", "1.5", "0.95", "200", "110"}});
  const Repair2 repair = close_gaps(scene, number("1"));
  const Repair2 again = close_gaps(repair.scene, number("1"));
  EXPECT_EQ(again.scene.edges, repair.scene.edges);
  EXPECT_THAT(again.moved, IsEmpty());
}

TEST(Repair2, ReachesAsFarAsAskedInAnyScale) {
  for (const std::string e : {"e-300", "e-30", "e0", "e300"}) {
    const std::string scale = "1" + e;
    // Edges that are nothing beside the gap, an end before an end, an end before an edge.
    for (const char* length : {"1e-500", "1e-30", "1"}) {
      const Scene2 scene = scene_of({{"far", "10" + e, "0", "11" + e, "0"},
                                     {"a", "0", "0", "0", to_string(number(length) * number(scale))},
                                     {"b", "0.4" + e, "0", "0.4" + e, to_string(-number(length) * number(scale))}});
      const Repair2 repair = close_gaps(scene, number("0.5") * number(scale));
      ASSERT_GE(repair.scene.surfaces.size(), 1u);
      EXPECT_EQ(repair.scene.edges[0].from, scene.edges[0].from);
      if (const auto found = repair.scene.find("b")) {
        EXPECT_EQ(repair.scene.edges[*found].from, (Point2{0, 0})) << scale << ", " << length;
      }
      EXPECT_EQ(repair.scene.surfaces.size(), std::string(length) == "1" ? 3u : 1u) << scale << ", " << length;
    }
    const Scene2 gap = scene_of({{"wall", "0", "0", "4" + e, "0"},
                                 {"fin", "2" + e, to_string(number("1e-300") * number(scale)), "2" + e, "3" + e}});
    EXPECT_THAT(kinds(close_gaps(gap, number("1e-300") * number(scale))), ElementsAre("snapped fin")) << scale;
    EXPECT_THAT(kinds(close_gaps(gap, number("9e-301") * number(scale))), IsEmpty()) << scale;
  }
}

Repair2 with_polylines(const Scene2& scene, const char* distance) {
  Repair2 repair = close_gaps(scene, number(distance));
  restore_polylines(repair);
  return repair;
}

// Polylines "p", "q" and "r" of the given points, each its own group as the reader makes them.
Scene2 polylines(const std::vector<std::vector<Point2>>& of) {
  Scene2 scene = scene_of({});
  for (std::size_t k = 0; k < of.size(); ++k) {
    const std::string name(1, static_cast<char>('p' + k));
    scene.groups.push_back(name);
    for (std::size_t i = 0; i + 1 < of[k].size(); ++i) {
      Surface piece;
      piece.name = name + "[" + std::to_string(i) + "]";
      piece.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
      scene.add(piece, {of[k][i], of[k][i + 1]});
    }
  }
  return scene;
}

std::vector<std::string> surface_names(const Scene2& scene) {
  std::vector<std::string> names;
  for (const Surface& surface : scene.surfaces) names.push_back(surface.name);
  return names;
}

const Rational kTiny = Rational(1, 1000000);

TEST(RestoredPolylines, AreCountedAnewWhereAPieceBecameAPoint) {
  const Scene2 scene = polylines({{{0, 0}, {0, 3}, {kTiny, 3}, {4, 3}, {4, 0}, {0, 0}}, {{1, 1}, {2, 1}, {2, 2}}});
  const Repair2 repair = with_polylines(scene, "1e-3");
  EXPECT_THAT(kinds(repair), ElementsAre("merged p[1]", "dropped p[1]", "renumbered p"));
  EXPECT_EQ(repair.steps.back().message, "the pieces of 'p' are counted anew: 'p[2]' is 'p[1]' now");
  EXPECT_THAT(surface_names(repair.scene), ElementsAre("p[0]", "p[1]", "p[2]", "p[3]", "q[0]", "q[1]"));
  EXPECT_THAT(repair.former_names, ElementsAre("p[0]", "p[2]", "p[3]", "p[4]", "q[0]", "q[1]"));
  EXPECT_EQ(repair.scene.edges[1].from, (Point2{0, 3}));
}

TEST(RestoredPolylines, AreListedTheOtherWayRoundWhereAllWasReversed) {
  Repair2 repair{polylines({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}}), {}, {"p[0]", "p[1]", "p[2]"}};
  for (Edge2& surface : repair.scene.edges) std::swap(surface.from, surface.to);
  restore_polylines(repair);
  EXPECT_THAT(kinds(repair), ElementsAre("renumbered p"));
  EXPECT_EQ(repair.steps.back().message, "the pieces of 'p' are listed the other way round: 'p[2]' is 'p[0]' now");
  EXPECT_THAT(surface_names(repair.scene), ElementsAre("p[0]", "p[1]", "p[2]"));
  EXPECT_THAT(repair.former_names, ElementsAre("p[2]", "p[1]", "p[0]"));
  EXPECT_EQ(repair.scene.edges[0].from, (Point2{0, 3}));
  EXPECT_EQ(repair.scene.edges[2].to, (Point2{0, 0}));
}

TEST(RestoredPolylines, OfOthersThePiecesAreEdgesBeforeAllPolylines) {
  // The second piece of q repeats the first of p.
  const Scene2 scene = polylines({{{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {0, 0}, {4, 0}, {4, -1}}, {{1, 1}, {2, 2}}});
  const Repair2 repair = with_polylines(scene, "1e-3");
  EXPECT_THAT(kinds(repair), ElementsAre("dropped q[1]", "split q"));
  EXPECT_THAT(surface_names(repair.scene), ElementsAre("q[0]", "q[2]", "p[0]", "p[1]", "r[0]"));
  EXPECT_EQ(repair.former_names, surface_names(repair.scene));
}

TEST(RestoredPolylines, AreAsTheyWereWithoutAChange) {
  for (const Scene2& scene : all_kinds(60)) {
    Repair2 repair{scene, {}, surface_names(scene)};
    restore_polylines(repair);
    EXPECT_THAT(repair.steps, IsEmpty()) << scene.about;
    EXPECT_TRUE(same_places(repair.scene, scene)) << scene.about;
    EXPECT_EQ(repair.former_names, surface_names(scene)) << scene.about;
  }
}

TEST(Repair2, DropsWhatBecameAPointOrRepeats) {
  const Scene2 scene = scene_of({{"a", "0", "0", "1", "0"},
                                 {"tiny", "1", "0", "1.0000001", "0"},
                                 {"again", "0", "0", "1.0000001", "0"},
                                 {"other", "0", "0", "1", "0", 1},
                                 {"back", "1", "0", "0", "0"}});
  const Repair2 repair = close_gaps(scene, number("1e-6"));
  EXPECT_THAT(kinds(repair), ElementsAre("merged tiny", "dropped tiny", "dropped again"));
  ASSERT_EQ(repair.scene.surfaces.size(), 3u);
  EXPECT_EQ(repair.scene.surfaces[1].name, "other");  // another material: not the same
}

TEST(Repair2, LeavesAnAngleAlone) {
  const Scene2 scene = scene_of({{"a", "0", "0", "2", "0"}, {"b", "0", "0", "1", "1e-7"}});
  const Repair2 repair = close_gaps(scene, number("1e-6"));
  EXPECT_THAT(kinds(repair), ElementsAre("not-repaired b"));
  EXPECT_TRUE(same_places(repair.scene, scene));
}

TEST(Repair2, LeavesAGoodSceneAsItIs) {
  for (const Scene2& scene : all_kinds(100)) {
    const Repair2 repair = close_gaps(scene, number("1e-12"));
    for (const RepairStep& step : repair.steps) EXPECT_EQ(step.kind, "dropped") << scene.about << ": " << step.message;
    EXPECT_TRUE(!repair.steps.empty() || same_places(repair.scene, scene)) << scene.about;
  }
}

// Every end moved by less than 1e-9, each time it is listed in another direction.
Scene2 shaken(const Scene2& scene, std::uint64_t seed) {
  const auto next = [&seed]() -> Rational {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return Rational(static_cast<long>(seed >> 40) - (1l << 23)) / (Rational(1l << 23) * 2000000000);
  };
  return moved(scene, [&next](const Point2& p) { return Point2{p.x + next(), p.y + next()}; });
}

std::size_t count_of_ends(const Scene2& scene) {
  PointIndex2 index;
  for (const Edge2& surface : scene.edges) {
    index.insert(surface.from);
    index.insert(surface.to);
  }
  return index.points().size();
}

TEST(Repair2, ClosesEveryGapOfASceneThatWasShaken) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Scene2 maze = generated("maze", 120, seed), apart = shaken(maze, seed);
    ASSERT_GT(find_near_misses(apart).size(), 50u);
    const Repair2 repair = close_gaps(apart, number("2e-9"));
    EXPECT_THAT(find_near_misses(repair.scene), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(count_of_ends(repair.scene), count_of_ends(maze)) << "seed " << seed;
    EXPECT_TRUE(find_contacts(repair.scene).crossings.empty()) << "seed " << seed;
  }
}

TEST(Repair2, PutsFinsBackOntoTheirWall) {
  std::vector<Line> lines{{"wall", "0", "0", "100", "37"}};
  for (int k = 1; k < 100; ++k) {
    const std::string x = std::to_string(k);
    lines.push_back({"fin" + x, x, std::to_string(37 * k) + "/100", x, "50"});
  }
  const Scene2 scene = scene_of(lines);
  ASSERT_EQ(find_contacts(scene).junctions.size(), 99u);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene2 apart = shaken(scene, seed);
    ASSERT_TRUE(find_contacts(apart).junctions.empty());
    const Repair2 repair = close_gaps(apart, number("2e-9"));
    EXPECT_EQ(find_contacts(repair.scene).junctions.size(), 99u) << "seed " << seed;
    EXPECT_THAT(find_near_misses(repair.scene), IsEmpty()) << "seed " << seed;
  }
}

// A segment in doubles.
struct Flat {
  double ax, ay, dx, dy, length;
  explicit Flat(const Edge2& s)
      : ax(s.from.x.get_d()),
        ay(s.from.y.get_d()),
        dx(s.to.x.get_d() - ax),
        dy(s.to.y.get_d() - ay),
        length(std::hypot(dx, dy)) {}
  double distance(double x, double y) const {
    const double t = std::clamp(((x - ax) * dx + (y - ay) * dy) / (length * length), 0.0, 1.0);
    return std::hypot(x - ax - t * dx, y - ay - t * dy);
  }
};

TEST(NearMisses2, AreThoseOfAllPairsAmongDisjointSegments) {
  const Scene2 scene = generated("clutter", 3000, 4);
  std::set<std::string> expected, tips;
  for (const NearMiss2& miss : find_near_misses(scene)) {
    tips.insert(place_text(miss.tip));
    if (miss.is_at_end) tips.insert(place_text(miss.foot));
  }
  std::vector<Flat> flat;
  for (const Edge2& edge : scene.edges) flat.emplace_back(edge);
  for (std::size_t i = 4; i < flat.size(); ++i)  // the walls of the room meet each other
    for (const bool second : {false, true})
      for (std::size_t j = 0; j < flat.size(); ++j) {
        const Flat &s = flat[i], &t = flat[j];
        if (i == j ||
            kNearPart * t.distance(s.ax + second * s.dx, s.ay + second * s.dy) >= std::min(s.length, t.length))
          continue;
        expected.insert(place_text(second ? scene.edges[i].to : scene.edges[i].from));
      }
  EXPECT_EQ(tips, expected);
  EXPECT_GT(tips.size(), 3u);
}

TEST(NearMisses2, DoNotDependOnScaleAndPlace) {
  const Scene2 scene = generated("clutter", 400, 9);
  const auto misses = find_near_misses(scene);
  for (const char* factor : {"1e-200", "3/7", "1e200"}) {
    const Rational f = number(factor);
    const auto scaled = find_near_misses(moved(scene, [&f](const Point2& p) {
      return Point2{p.x * f + number("9007199254740993"), p.y * f};
    }));
    ASSERT_EQ(scaled.size(), misses.size()) << factor;
    for (std::size_t k = 0; k < misses.size(); ++k) EXPECT_EQ(scaled[k].surfaces, misses[k].surfaces);
  }
}

TEST(NearMisses2, BeginExactlyBelowTheirPart) {
  const auto misses = [](const std::string& gap) {
    return find_near_misses(scene_of({{"wall", "0", "0", "4", "0"}, {"fin", "2", gap, "2", "3"}})).size();
  };
  EXPECT_EQ(misses("3/1025"), 0u);  // the fin is 3 - gap long: gap = (3 - gap) / 1024
  EXPECT_EQ(misses("2999/1025000"), 1u);
  EXPECT_EQ(misses("0"), 0u);
  EXPECT_EQ(misses("1e-300"), 1u);
}

}  // namespace
}  // namespace hottel::repair_test

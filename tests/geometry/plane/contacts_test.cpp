// Contacts of surfaces against all pairs over rationals.
#include "geometry/plane/check/contacts.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::contacts_test {
namespace {

using namespace testing_scenes;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Every contact as a set of pairs; a point as its text.
struct Pairs {
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> crossings;  // s < t
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> junctions;  // the first ends inside the second
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> overlaps;   // s < t, with from and to
  std::set<Pair> duplicates;
  friend bool operator==(const Pairs&, const Pairs&) = default;
};

std::string text(const Point2& p) { return to_string(p.x) + " " + to_string(p.y); }

Rational cross(const Point2& o, const Point2& p, const Point2& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

// Where p lies along a -> b: 0 at a, 1 at b. REQUIRES p on the line.
Rational along(const Edge2& s, const Point2& p) {
  const Rational dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  return ((p.x - s.from.x) * dx + (p.y - s.from.y) * dy) / (dx * dx + dy * dy);
}

bool are_parallel(const Edge2& s, const Edge2& t) {
  return (s.to.x - s.from.x) * (t.to.y - t.from.y) == (s.to.y - s.from.y) * (t.to.x - t.from.x);
}

void add_pair(const Scene2& scene, std::uint32_t i, std::uint32_t j, Pairs& pairs) {
  const Edge2 &s = scene.edges[i], &t = scene.edges[j];
  if (are_parallel(s, t)) {
    if (cross(s.from, s.to, t.from) != 0) return;
    Rational low = along(s, t.from), high = along(s, t.to);
    if (high < low) std::swap(low, high);
    const bool same = low == 0 && high == 1;
    low = std::max(low, Rational(0));
    high = std::min(high, Rational(1));
    if (low >= high) return;
    std::string a = text(point_at(s, low)), b = text(point_at(s, high));
    if (b < a) std::swap(a, b);
    pairs.overlaps.emplace(i, j, a + " to " + b);
    if (same) pairs.duplicates.emplace(i, j);
    return;
  }
  const Rational sa = cross(t.from, t.to, s.from), sb = cross(t.from, t.to, s.to);
  const Rational ta = cross(s.from, s.to, t.from), tb = cross(s.from, s.to, t.to);
  const Point2 meet = point_at(s, sa / (sa - sb));
  const bool inside_s = sgn(sa) * sgn(sb) < 0, inside_t = sgn(ta) * sgn(tb) < 0;
  if (inside_s && inside_t) pairs.crossings.emplace(i, j, text(meet));
  if (inside_s && sgn(ta) * sgn(tb) == 0) pairs.junctions.emplace(j, i, text(meet));
  if (inside_t && sgn(sa) * sgn(sb) == 0) pairs.junctions.emplace(i, j, text(meet));
}

Pairs brute_force(const Scene2& scene) {
  Pairs pairs;
  for (std::uint32_t j = 0; j < scene.surfaces.size(); ++j)
    for (std::uint32_t i = 0; i < j; ++i) add_pair(scene, i, j, pairs);
  return pairs;
}

// Overlaps are told by stretches with the same surfaces: those of a pair are joined where they follow each other.
void add_overlaps(const Scene2& scene, const Contacts2& contacts, Pairs& pairs) {
  std::map<Pair, std::pair<Rational, Rational>> stretch;  // along the first
  for (const Overlap2& overlap : contacts.overlaps)
    for (const PieceSource2& s : overlap.covering)
      for (const PieceSource2& t : overlap.covering) {
        if (s.surface >= t.surface) continue;
        const Edge2& first = scene.edges[s.surface];
        Rational low = along(first, overlap.from), high = along(first, overlap.to);
        EXPECT_EQ(high < low, s.is_reversed);
        if (high < low) std::swap(low, high);
        const auto [place, is_new] = stretch.try_emplace({s.surface, t.surface}, low, high);
        if (is_new) continue;
        place->second = {std::min(low, place->second.first), std::max(high, place->second.second)};
      }
  for (const auto& [pair, ends] : stretch) {
    const Edge2& first = scene.edges[pair.first];
    std::string a = text(point_at(first, ends.first)), b = text(point_at(first, ends.second));
    if (b < a) std::swap(a, b);
    pairs.overlaps.emplace(pair.first, pair.second, a + " to " + b);
  }
}

Pairs found(const Scene2& scene) {
  const Contacts2 contacts = find_contacts(scene);
  const auto parallel = [&](std::uint32_t s, std::uint32_t t) { return are_parallel(scene.edges[s], scene.edges[t]); };
  Pairs pairs;
  for (const Crossing2& crossing : contacts.crossings)
    for (const std::uint32_t s : crossing.surfaces)
      for (const std::uint32_t t : crossing.surfaces)
        if (s < t && !parallel(s, t)) pairs.crossings.emplace(s, t, text(crossing.at));
  for (const Junction2& junction : contacts.junctions)
    for (const std::uint32_t s : junction.ends)
      for (const std::uint32_t t : junction.through)
        if (!parallel(s, t)) pairs.junctions.emplace(s, t, text(junction.at));
  for (const auto& surfaces : contacts.duplicates)
    for (const std::uint32_t s : surfaces)
      for (const std::uint32_t t : surfaces)
        if (s < t) pairs.duplicates.emplace(s, t);
  add_overlaps(scene, contacts, pairs);
  return pairs;
}

TEST(Contacts2, AreThoseOfAllPairsInScenesFullOfCoincidences) {
  std::size_t crossings = 0, junctions = 0, overlaps = 0, duplicates = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    for (const std::uint64_t n : {8, 30, 90}) {
      const Scene2 scene = generated("lattice", n, seed);
      const Pairs expected = brute_force(scene), pairs = found(scene);
      EXPECT_EQ(pairs.crossings, expected.crossings) << "n = " << n << ", seed = " << seed;
      EXPECT_EQ(pairs.junctions, expected.junctions) << "n = " << n << ", seed = " << seed;
      EXPECT_EQ(pairs.overlaps, expected.overlaps) << "n = " << n << ", seed = " << seed;
      EXPECT_EQ(pairs.duplicates, expected.duplicates) << "n = " << n << ", seed = " << seed;
      crossings += pairs.crossings.size();
      junctions += pairs.junctions.size();
      overlaps += pairs.overlaps.size();
      duplicates += pairs.duplicates.size();
    }
  EXPECT_GT(crossings, 100u);
  EXPECT_GT(junctions, 100u);
  EXPECT_GT(overlaps, 100u);
  EXPECT_GT(duplicates, 10u);
}

TEST(Contacts2, AreThoseOfAllPairsInEveryKindOfScene) {
  for (const Scene2& scene : all_kinds(60)) EXPECT_EQ(found(scene), brute_force(scene)) << scene.about;
}

TEST(Contacts2, OneCrossingListsAllThatPassThroughThePoint) {
  const Contacts2 contacts = find_contacts(scene_of({{"a", "-1", "0", "1", "0"},
                                                     {"b", "0", "-1", "0", "1"},
                                                     {"c", "-1", "-1", "1", "1"},
                                                     {"d", "0", "0", "1", "2"}}));
  ASSERT_EQ(contacts.crossings.size(), 1u);
  EXPECT_EQ(contacts.crossings[0].surfaces, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(text(contacts.crossings[0].at), "0 0");
  ASSERT_EQ(contacts.junctions.size(), 1u);
  EXPECT_EQ(contacts.junctions[0].ends, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(contacts.junctions[0].through, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Contacts2, CommonEndPointsAreNoContact) {
  const Contacts2 contacts = find_contacts(scene_of(room("4")));
  EXPECT_TRUE(contacts.crossings.empty() && contacts.junctions.empty() && contacts.overlaps.empty() &&
              contacts.duplicates.empty());
}

TEST(Contacts2, SayWhichFacesOwnAnything) {
  const Contacts2 contacts = find_contacts(scene_of({{"a", "0", "0", "2", "0", 1},
                                                     {"b", "1", "0", "2", "0", 1},
                                                     {"c", "1", "0", "0", "0", 2},
                                                     {"d", "1", "0", "3", "0", 1}}));
  // The front of b is covered by a; c has the other side of a; d sticks out.
  EXPECT_EQ(contacts.faces.has_area, (std::vector<char>{1, 1, 0, 0, 1, 0, 1, 1}));
}

}  // namespace
}  // namespace hottel::contacts_test

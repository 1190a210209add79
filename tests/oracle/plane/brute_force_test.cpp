#include "tests/oracle/plane/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/oracle/plane/laws.h"
#include "tests/oracle/plane/random_scene.h"

namespace hottel::oracle::brute_force_test {
namespace {

constexpr int kScenes = 40;

std::vector<InputSegment> scene(int seed) {
  return random_scene(static_cast<std::uint64_t>(seed), 5 + seed / 3, seed % 4 < 2).edges;
}

// Joins pieces of one edge again, at most two at a point, so that others end inside them: T-junctions.
std::vector<Segment> joined(std::vector<Segment> pieces) {
  std::set<std::pair<mpq_class, mpq_class>> passed;
  const auto follows = [](const Segment& s, const Segment& t) {
    return s.bx == t.ax && s.by == t.ay && s.left == t.left && s.right == t.right &&
           (s.bx - s.ax) * (t.by - t.ay) == (s.by - s.ay) * (t.bx - t.ax);
  };
  for (std::size_t i = 0; i < pieces.size();) {
    const auto next =
        std::find_if(pieces.begin(), pieces.end(), [&](const Segment& t) { return follows(pieces[i], t); });
    if (next == pieces.end() || !passed.insert({next->ax, next->ay}).second) {
      ++i;
      continue;
    }
    pieces[i].bx = next->bx;
    pieces[i].by = next->by;
    i -= next < pieces.begin() + static_cast<std::ptrdiff_t>(i) ? 1 : 0;
    pieces.erase(next);
  }
  return pieces;
}

class OracleBruteForce2 : public testing::TestWithParam<int> {
 protected:
  std::vector<InputSegment> edges_ = scene(GetParam());
  std::vector<Segment> pieces_ = split(edges_).pieces;
};

TEST_P(OracleBruteForce2, AgreesWithTheLineSweep) { EXPECT_EQ(broken_sweep(pieces_), ""); }

TEST_P(OracleBruteForce2, HasRowsThatCancelInIntegers) { EXPECT_EQ(broken_integer_closure(pieces_), ""); }

TEST_P(OracleBruteForce2, HasRowSumsOfTwiceTheLength) { EXPECT_EQ(broken_closure(pieces_), ""); }

TEST_P(OracleBruteForce2, IsPositive) { EXPECT_EQ(broken_positivity(pieces_), ""); }

TEST_P(OracleBruteForce2, DoesNotDependOnOrderOrDirection) {
  std::vector<Segment> shuffled;
  for (const Segment& s : pieces_) {
    if (shuffled.size() % 2 == 0)
      shuffled.push_back(s);
    else
      shuffled.push_back({s.bx, s.by, s.ax, s.ay, s.right, s.left});
  }
  std::reverse(shuffled.begin(), shuffled.end());
  EXPECT_EQ(exchange_measures(shuffled), exchange_measures(pieces_));
}

TEST_P(OracleBruteForce2, AllowsTJunctions) {
  std::vector<Segment> whole = joined(pieces_);
  EXPECT_EQ(exact_measures(whole), exact_measures(pieces_));
  std::reverse(whole.begin(), whole.end());
  EXPECT_EQ(exact_measures(whole), exact_measures(pieces_));
  EXPECT_EQ(broken_integer_closure(whole), "");
  EXPECT_EQ(broken_sweep(whole), "");
}

TEST_P(OracleBruteForce2, MirrorsWithTheScene) {
  std::vector<Segment> mirrored;
  for (const Segment& s : pieces_) mirrored.push_back({-s.ax, s.ay, -s.bx, s.by, s.right, s.left});
  EXPECT_EQ(exchange_measures(mirrored), exchange_measures(pieces_));
}

// Far from the origin doubles tell no two vertices apart, so every sign is decided in rationals.
TEST_P(OracleBruteForce2, IsInvariantUnderTranslation) {
  const mpq_class x = (mpq_class(1) << 53) + 1, y = 7 - (mpq_class(1) << 60);
  std::vector<Segment> moved;
  for (const Segment& s : pieces_) moved.push_back({s.ax + x, s.ay + y, s.bx + x, s.by + y, s.left, s.right});
  EXPECT_EQ(exchange_measures(moved), exchange_measures(pieces_));
}

TEST_P(OracleBruteForce2, ScalesWithTheScene) {
  const mpq_class k = mpq_class(1) << 20;
  std::vector<Segment> scaled;
  for (const Segment& s : pieces_) scaled.push_back({s.ax * k, s.ay * k, s.bx * k, s.by * k, s.left, s.right});
  ExactMeasures expected = exact_measures(pieces_);
  for (auto& entry : expected) entry.second *= k;
  EXPECT_EQ(exact_measures(scaled), expected);
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, OracleBruteForce2, testing::Range(0, kScenes));

TEST(OracleTJunctions2, AreManyInTheRandomScenes) {
  std::size_t joints = 0;
  for (int seed = 0; seed < kScenes; ++seed) {
    const std::vector<Segment> pieces = split(scene(seed)).pieces;
    joints += pieces.size() - joined(pieces).size();
  }
  EXPECT_GT(joints, 100u);
}

TEST(OracleRandomScene2, HasTheEdgesAskedForAndNoConflict) {
  for (int n : {4, 10, 60}) {
    for (int seed = 0; seed < 10; ++seed) {
      for (const bool lattice : {false, true}) {
        const RandomScene random = random_scene(static_cast<std::uint64_t>(seed), n, lattice);
        EXPECT_EQ(random.edges.size(), static_cast<std::size_t>(n));
        EXPECT_TRUE(split(random.edges).conflicts.empty());
      }
    }
  }
}

TEST(OracleRandomScene2, CrossesAndOverlapsOnLatticesOnly) {
  std::size_t cut = 0, overlapped = 0;
  for (int seed = 0; seed < 10; ++seed) {
    const std::vector<InputSegment> apart = random_scene(static_cast<std::uint64_t>(seed), 30, false).edges;
    EXPECT_EQ(split(apart).pieces.size(), apart.size());
    const std::vector<InputSegment> lattice = random_scene(static_cast<std::uint64_t>(seed), 30, true).edges;
    std::size_t separately = 0;
    for (const InputSegment& edge : lattice) {
      std::vector<InputSegment> ends = {edge};
      for (const InputSegment& other : lattice)
        if (&other != &edge) ends.push_back(other);
      for (const Segment& s : split(ends).pieces) separately += s.left / 2 == 0 || s.right / 2 == 0;
    }
    const std::size_t pieces = split(lattice).pieces.size();
    cut += pieces > lattice.size();
    overlapped += separately > pieces;
  }
  EXPECT_EQ(cut, 10u);
  EXPECT_GT(overlapped, 5u);
}

}  // namespace
}  // namespace hottel::oracle::brute_force_test

// Tips and edges moved across a degeneracy, step by step, down to steps of 2^-200: what faces exchange changes by no
// more than the way that they go.
//
// A line that meets one side of a triangle meets two. Where one end of a segment goes by d, what meets the segment
// before or after, but not both, meets that way, and such lines have measure 2 d: S of two other faces changes by d at
// most. Of the segment itself it may change by as much again, by what stands in the triangle between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "geometry/plane/prepared/prepared_scene.h"
#include "tests/geometry/plane/degenerate_scenes.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::degenerate_scenes_continuity_test {
namespace {

using namespace testing_scenes;

struct Sweep {
  std::string name;
  Scene2 scene;
  std::string edge;                     // that moves
  bool moves_from, moves_to;            // which of its ends
  Rational x, y;                        // where to: a vector of length 1 at most
  std::vector<std::string> together{};  // edges that give each other pieces where they overlap, looked at as one face

  friend std::ostream& operator<<(std::ostream& out, const Sweep& sweep) { return out << sweep.name; }
};

std::vector<Sweep> sweeps() {
  const auto in_room = [](const std::vector<Line>& lines) { return scene_of(room("4") + lines); };
  const Scene2 overlap = in_room({{"a", "1/2", "2", "2", "2", 1, 1}, {"b", "1", "2", "3", "2", 1, 1}});
  const Line diagonal{"b", "1", "3", "3", "1", 1, 2};
  const Scene2 star = in_room({{"a", "1", "1", "3", "3", 1, 2}, diagonal, {"c", "1/2", "2", "7/2", "2", 2, 1}});
  const Scene2 junction = in_room({{"a", "2", "2", "3", "3", 1, 2}, diagonal});
  Scene2 hanging = degenerate("tip_misses_floor");
  hanging.edges[hanging.find("partition").value()].from = {2, 0};
  const Rational half(1, 2);
  return {
      {"tip on a slanting wall", degenerate("fin_on_wall"), "fin", true, false, half, -half},
      {"tip on a joint of the floor", hanging, "partition", true, false, 0, -1},
      {"overlap lifted off", overlap, "b", true, true, 0, 1, {"a", "b"}},
      {"overlap turned off", overlap, "b", true, false, 0, 1, {"a", "b"}},
      {"tips that overlap or part", degenerate("tips_touch"), "east", true, false, 1, 0},
      {"tips past each other", degenerate("tips_touch"), "east", true, false, 0, 1},
      {"three through one point", star, "c", true, true, 0, 1},
      {"tip through a wall", junction, "a", true, false, half, half},
      {"grazing tips", degenerate("grazing_tips"), "second", false, true, 0, 1},
  };
}

Scene2 at(const Sweep& sweep, const Rational& t) {
  Scene2 scene = sweep.scene;
  auto& [from, to] = scene.edges[scene.find(sweep.edge).value()];
  if (sweep.moves_from) from = {from.x + t * sweep.x, from.y + t * sweep.y};
  if (sweep.moves_to) to = {to.x + t * sweep.x, to.y + t * sweep.y};
  return scene;
}

// A scene of a sweep, and S of every two of its faces, as they stand and as printed.
struct Place {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  Place(const Sweep& sweep, const Rational& t) : exact(at(sweep, t)) {
    const ExchangeMatrix& matrix = exact.matrix();
    const auto face = [&](std::uint32_t i) {
      if (i == matrix.sky()) return i;
      const std::string& edge = sweep.scene.surfaces[matrix.elements()[i].surface].name;
      const auto& together = sweep.together;
      return std::find(together.begin(), together.end(), edge) == together.end() ? i : matrix.sky() + 1;
    };
    std::vector<ElementPair> pairs;
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::uint32_t j = i + 1; j <= matrix.sky(); ++j)
        if (face(i) != face(j)) pairs.emplace_back(i, j);
    const std::vector<RootSum> sums = exact_exchange_measures(exact.prepared(), Granularity::kFace, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      measures[std::minmax({face(pairs[k].first), face(pairs[k].second)})] += sums[k];
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
        if (const std::uint32_t j = matrix.row(i)[k].to; i < j || !matrix.has_row(j))
          if (face(i) != face(j)) printed[std::minmax({face(i), face(j)})] += matrix.measures(i)[k];
  }

  // What the degeneracy changes at once.
  std::tuple<std::size_t, std::size_t, std::size_t> shape() const {
    const Arrangement2& arrangement = exact.prepared().arrangement;
    return {arrangement.vertices().size(), arrangement.pieces().size(), exact.matrix().entry_count()};
  }

  Exact exact;
  std::map<Pair, RootSum> measures;
  std::map<Pair, double> printed;
};

void expect_near(Place& before, Place& after, const Rational& bound) {
  RootSum most;
  most.add(bound, 1);
  ASSERT_EQ(before.measures.size(), after.measures.size());
  for (const auto& [pair, measure] : before.measures) {
    const RootSum change = after.measures.at(pair) - measure;
    EXPECT_LE((change - most).sign(), 0) << pair.first << " " << pair.second;
    EXPECT_GE((change + most).sign(), 0) << pair.first << " " << pair.second;
    const double printed = before.printed[pair];
    EXPECT_LE(std::abs(after.printed[pair] - printed), to_double(bound) + 0x1p-50 * printed);
  }
}

class Continuity : public testing::TestWithParam<Sweep> {};

TEST_P(Continuity, StepsAcrossADegeneracyChangeExchangeByNoMoreThanTheirLength) {
  const Sweep& sweep = GetParam();
  const int ends = static_cast<int>(sweep.moves_from) + static_cast<int>(sweep.moves_to);
  for (int bits = 50; bits <= 200; bits += 25) {
    const Rational step = scaled_by_power_of_two(1, -bits);
    std::vector<Place> places;
    for (int k = -2; k <= 2; ++k) places.emplace_back(sweep, k * step);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      SCOPED_TRACE(testing::Message() << "from " << static_cast<int>(k) - 2 << " steps of 2^-" << bits);
      expect_near(places[k], places[k + 1], 2 * ends * step);
    }
    EXPECT_TRUE(places[1].shape() != places[2].shape() || places[3].shape() != places[2].shape());
  }
}

INSTANTIATE_TEST_SUITE_P(, Continuity, testing::ValuesIn(sweeps()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

}  // namespace
}  // namespace hottel::degenerate_scenes_continuity_test

// What holds of every scene in scenes/degenerate/. The sketches are in its README; the answers, with the reason for
// each, in the files.
#include "tests/geometry/plane/degenerate_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "geometry/plane/exchange/gap_terms.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/oracle/plane/laws.h"

namespace hottel::degenerate_scenes_test {
namespace {

using namespace testing_scenes;

// The sum over the root q sqrt(r), a sum again.
RootSum over_one_root(const RootSum& sum, const RootSum& root) {
  const RootSum::Term& below = root.terms().front();
  RootSum result;
  for (const RootSum::Term& term : sum.terms())
    result.add(term.coefficient / below.coefficient / below.radicand, Rational(term.radicand * below.radicand));
  return result;
}

// The smallest difference of two coordinates along one axis, over the largest coordinate.
Rational resolution(const Scene2& scene) {
  std::set<Rational> xs, ys;
  for (const Edge2& s : scene.edges)
    for (const Point2& p : {s.from, s.to}) xs.insert(p.x), ys.insert(p.y);
  Rational largest = 0, smallest = abs(*xs.rbegin() - *xs.begin()) + 1;
  for (const std::set<Rational>& values : {xs, ys}) {
    largest = std::max({largest, Rational(abs(*values.begin())), Rational(abs(*values.rbegin()))});
    for (auto next = std::next(values.begin()); next != values.end(); ++next)
      smallest = std::min(smallest, Rational(*next - *std::prev(next)));
  }
  return smallest / largest;
}

std::vector<ElementPair> all_pairs(const ExchangeMatrix& matrix) {
  std::vector<ElementPair> pairs;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::uint32_t j = i; j <= matrix.sky(); ++j)
      if (matrix.has_row(i) || (j < matrix.sky() && matrix.has_row(j))) pairs.emplace_back(i, j);
  return pairs;
}

// Vis(from, to), NaN where there is no entry.
double visibility(const ExchangeMatrix& matrix, const std::string& from, const std::string& to) {
  for (const FactorEntry& entry : matrix.row(matrix.find(from).value()))
    if (entry.to == matrix.find(to).value()) return entry.visibility;
  return std::nan("");
}

class DegenerateScenes : public testing::TestWithParam<std::string> {};

TEST_P(DegenerateScenes, HaveTheClosedFormsOfTheirFile) {
  const Exact exact(degenerate(GetParam()));
  const std::vector<RootSum> areas = exact_areas(exact.prepared(), Granularity::kFace);
  for (const Expectation& row : exact.prepared().scene.expect) {
    if (row.quantity != "factor") continue;
    EXPECT_FALSE(row.derivation.empty());
    const RootSum& area = areas[exact.matrix().find(row.of.at(0)).value()];
    ASSERT_EQ(area.terms().size(), 1u) << "expectations start from straight faces";
    EXPECT_EQ(over_one_root(exact.measure(row.of[0], row.of.at(1)), area).to_string(), row.form) << row.name;
  }
}

TEST_P(DegenerateScenes, HaveTheValuesOfTheirFile) {
  const Exact exact(degenerate(GetParam()));
  const Scene2& scene = exact.prepared().scene;
  const Arrangement2& arrangement = exact.prepared().arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const auto computed = [&](const Expectation& row) {
    if (row.quantity == "factor") return exact.factor(row.of.at(0), row.of.at(1));
    const Edge2& from = scene.edges[scene.find(row.of.at(0)).value()];
    const Face to{scene.find(row.of.at(1)).value(), false};
    RootSum sum;
    for (const PointFactor2& part : point_factors(arrangement, location, from.from, from.to, false, number(row.at)))
      if (part.side != kSky && arrangement.owner(part.side) == to) sum += part.factor;
    EXPECT_EQ(sum.to_string(), row.form) << row.name;
    return round_quotient(sum, RootSum(Rational(1))).number;
  };
  for (const Expectation& row : scene.expect) {
    if (row.quantity == "radiosity") continue;  // tests/solver/plane/degenerate_radiosity_test.cpp
    if (row.quantity == "group_visibility") {
      const ExchangeMatrix groups = exact_exchange(exact.prepared(), {.granularity = Granularity::kGroup});
      EXPECT_EQ(visibility(groups, row.of.at(0), row.of.at(1)), to_double(number(row.value))) << row.name;
      continue;
    }
    ASSERT_EQ(row.kind, row.quantity == "factor" ? "exact" : "point");
    const Rounded rounded = computed(row);
    const Rational value = number(row.value);
    EXPECT_EQ(rounded.value, to_double(value)) << row.name;
    EXPECT_LE(Rational(rounded.enclosure().lower), value) << row.name;
    EXPECT_GE(Rational(rounded.enclosure().upper), value) << row.name;
  }
}

TEST_P(DegenerateScenes, AgreeWithTheBruteForceInEveryPair) {
  oracle::ComparisonCounts counts;
  EXPECT_EQ(oracle::disagreement(degenerate(GetParam()), counts), "");
  EXPECT_GT(counts.factors, 0u);
}

// 2 S(i, j) as coefficients of the lengths of gaps, before gaps on one line or of one class of roots are put together.
oracle::Measures coefficients_by_gap(const PreparedScene2& prepared) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const auto label = [&](std::uint32_t i) { return i == table.sky() ? oracle::kInfinity : static_cast<int>(i); };
  oracle::Measures measures;
  View2 view;
  for (const VertexId v : vertices.ids()) {
    look_around(vertices, prepared.arrangement.triangulation(), v, view);
    for_each_gap(vertices, v, view, true, [&](const Gap2& gap) {
      const Rational squared_length = vertices.squared_distance(gap.v, gap.w) * vertices.scale() * vertices.scale();
      for_each_term(gap, table, [&](std::uint32_t i, std::uint32_t j, int sign) {
        measures[std::minmax({label(i), label(j)})][squared_length] += i == j ? 2 * sign : sign;
      });
    });
  }
  return measures;
}

// Pairs of which one has a row, and coefficients other than 0.
void tidy(oracle::Measures& measures, const ExchangeMatrix& matrix) {
  const auto has_row = [&](int i) {
    return 0 <= i && static_cast<std::uint32_t>(i) < matrix.size() && matrix.has_row(static_cast<std::uint32_t>(i));
  };
  for (auto& [pair, lengths] : measures) std::erase_if(lengths, [](const auto& term) { return term.second == 0; });
  std::erase_if(measures, [&](const auto& entry) {
    return entry.second.empty() || !(has_row(entry.first.first) || has_row(entry.first.second));
  });
}

TEST_P(DegenerateScenes, HaveTheCoefficientsOfTheBruteForceForEachLengthOfGap) {
  const Exact exact(degenerate(GetParam()));
  oracle::Measures mine = coefficients_by_gap(exact.prepared());
  oracle::Measures other = oracle::exchange_measures(oracle::split(oracle::to_edges(exact.prepared().scene)).pieces);
  tidy(mine, exact.matrix());
  tidy(other, exact.matrix());
  EXPECT_FALSE(mine.empty());
  EXPECT_TRUE(mine == other);
}

TEST_P(DegenerateScenes, ObeyTheLawsOfTheOracles) {
  const Scene2 scene = degenerate(GetParam());
  const std::vector<oracle::Segment> pieces = oracle::split(oracle::to_edges(scene)).pieces;
  EXPECT_EQ(oracle::broken_integer_closure(pieces), "");
  EXPECT_EQ(oracle::broken_closure(pieces), "");
  EXPECT_EQ(oracle::broken_positivity(pieces), "");
  const bool fits_doubles = resolution(scene) > Rational(1, 1000000);
  if (fits_doubles) {
    EXPECT_EQ(oracle::broken_sweep(pieces, 1e-10), "");
  }
}

TEST_P(DegenerateScenes, CloseAsIntegersAndAreNotNegative) {
  const Exact exact(degenerate(GetParam()));
  const ExchangeMatrix& matrix = exact.matrix();
  EXPECT_TRUE(exact.report().closure_is_exact);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) {
      EXPECT_GT(entry.factor.value, 0);
      EXPECT_GE(entry.factor.enclosure().lower, 0);
      EXPECT_LE(entry.factor.enclosure().upper, 1);
      EXPECT_GT(entry.visibility, 0);
      EXPECT_LE(entry.visibility, 1);
      sum += entry.factor.value;
    }
    if (matrix.has_row(i)) {
      EXPECT_NEAR(sum, 1, 1e-15 * static_cast<double>(matrix.row(i).size()));
    }
  }
  // The same as exact sums: what a face exchanges with all others is its length.
  const std::vector<ElementPair> pairs = all_pairs(matrix);
  const std::vector<RootSum> sums = exact_exchange_measures(exact.prepared(), Granularity::kFace, pairs);
  std::vector<RootSum> left = exact_areas(exact.prepared(), Granularity::kFace);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_GE(sums[k].sign(), 0);
    left[pairs[k].first] -= sums[k];
    if (pairs[k].second < matrix.sky() && pairs[k].second != pairs[k].first) left[pairs[k].second] -= sums[k];
  }
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) {
      EXPECT_TRUE(left[i].is_zero()) << matrix.elements()[i].name;
    }
}

// S(from, to), 0 where there is no entry.
double printed_measure(const ExchangeMatrix& matrix, const std::string& from, const std::string& to) {
  const std::uint32_t i = matrix.find(from).value(), j = matrix.find(to).value();
  for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
    if (matrix.row(i)[k].to == j) return matrix.measures(i)[k];
  return 0;
}

// The last group first; polylines stay what they are.
void reverse_groups(Scene2& scene) {
  std::vector<std::uint32_t> order;
  for (auto end = static_cast<std::uint32_t>(scene.surfaces.size()); end > 0;) {
    std::uint32_t begin = end - 1;
    while (begin > 0 && scene.surfaces[begin - 1].group == scene.surfaces[begin].group) --begin;
    for (std::uint32_t s = begin; s < end; ++s) order.push_back(s);
    end = begin;
  }
  scene.keep(order);
}

// Of a scene and of its edges in reverse order, where each pair is computed the other way round. Not of faces that own
// something else then: where edges overlap, the first listed of equal claims owns the piece.
TEST_P(DegenerateScenes, AreSymmetric) {
  Scene2 scene = degenerate(GetParam());
  const Exact forth(scene);
  reverse_groups(scene);
  const Exact back(scene);
  const ExchangeMatrix &matrix = forth.matrix(), &other = back.matrix();
  const auto owns_the_same = [&](std::uint32_t i) {
    return matrix.elements()[i].area == other.elements()[other.find(matrix.elements()[i].name).value()].area;
  };
  std::size_t alike = 0, compared = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    alike += matrix.has_row(i) && owns_the_same(i);
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const std::uint32_t j = matrix.row(i)[k].to;
      if (j == matrix.sky() || !matrix.has_row(j) || !owns_the_same(i) || !owns_the_same(j)) continue;
      const std::string &from = matrix.elements()[j].name, &to = matrix.elements()[i].name;
      EXPECT_EQ(matrix.measures(i)[k], printed_measure(other, from, to)) << to << " " << from;
      EXPECT_EQ(matrix.row(i)[k].visibility, back.visibility(from, to)) << to << " " << from;
      ++compared;
    }
  }
  EXPECT_TRUE(compared > 0 || alike == 1);
}

Rational power_of_two(unsigned exponent) { return Rational(Integer(1) << exponent); }

TEST_P(DegenerateScenes, AreTheSameMagnifiedAndFarAway) {
  const Scene2 scene = degenerate(GetParam());
  const Printed expected = printed(scene);
  const Rational east = power_of_two(53) + 1, south = -power_of_two(60) + 7, size = power_of_two(20);
  EXPECT_TRUE(printed(moved(scene, [&](const Point2& p) {
                return Point2{p.x * size + east, p.y * size + south};
              })) == expected);
}

TEST_P(DegenerateScenes, AreTheSumsOfTheirElements) {
  Scene2 scene = degenerate(GetParam());
  const Exact whole(scene);
  for (Surface& surface : scene.surfaces) surface.elements = 3;
  const Exact parts(scene, Granularity::kElement);
  std::map<ElementPair, RootSum> sums;
  const auto face = [&](std::uint32_t i) {
    if (i == parts.matrix().sky()) return whole.matrix().sky();
    const std::string& name = parts.matrix().elements()[i].name;
    return whole.matrix().find(name.substr(0, name.find('#'))).value();
  };
  const std::vector<ElementPair> pairs = all_pairs(parts.matrix());
  const std::vector<RootSum> measures = exact_exchange_measures(parts.prepared(), Granularity::kElement, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    sums[std::minmax({face(pairs[k].first), face(pairs[k].second)})] += measures[k];
  const std::vector<ElementPair> faces = all_pairs(whole.matrix());
  const std::vector<RootSum> expected = exact_exchange_measures(whole.prepared(), Granularity::kFace, faces);
  for (std::size_t k = 0; k < faces.size(); ++k)
    EXPECT_TRUE((sums[faces[k]] - expected[k]).is_zero()) << faces[k].first << " " << faces[k].second;
}

// The walls of the canyon cut by hand: what the balconies cover of them, and of the balconies what lies on them, is not
// listed. The parts of a wall are a group, so that they have one row.
TEST(CanyonWithBalconies, IsTheOneWhoseWallsAreCutByHand) {
  const Scene2 canyon = degenerate("canyon_with_balconies");
  Scene2 cut = canyon;
  cut.keep({});
  const auto add_parts = [&](const std::string& name, const std::vector<std::pair<int, int>>& heights) {
    for (const auto& [from, to] : heights) {
      const std::uint32_t wall = canyon.find(name).value();
      Surface part = canyon.surfaces[wall];
      part.name += " " + std::to_string(from);
      Edge2 edge = canyon.edges[wall];
      edge.from.y = from;
      edge.to.y = to;
      cut.add(part, edge);
    }
  };
  add_parts("west", {{0, 2}, {3, 5}, {6, 8}});
  add_parts("east", {{8, 4}, {3, 0}});
  for (std::size_t s = 0; s < canyon.surfaces.size(); ++s) {
    const Surface& surface = canyon.surfaces[s];
    const bool is_wall = surface.name == "west" || surface.name == "east";
    if (is_wall || surface.name == "low[3]" || surface.name == "high[3]" || surface.name == "opposite[1]") continue;
    Surface alone = surface;
    if (surface.group > 1) {  // of a balcony: a group of its own
      alone.group = static_cast<std::uint32_t>(cut.groups.size());
      cut.groups.push_back(surface.name);
    }
    cut.add(alone, canyon.edges[s]);
  }
  EXPECT_TRUE(printed(canyon) == printed(exact_exchange(prepare(cut), {.granularity = Granularity::kGroup})));
}

// The section of a scene in the README: from its heading to the next one.
std::string section_of(const std::string& scene) {
  std::ifstream file(degenerate_folder() / "README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = text.find("\n## " + scene + "\n");
  return begin == std::string::npos ? "" : text.substr(begin + 1, text.find("\n## ", begin + 1) - begin);
}

TEST_P(DegenerateScenes, AreDescribedAndSketchedInTheReadme) {
  const std::string section = section_of(GetParam());
  EXPECT_NE(section, "");
  const std::size_t begin = section.find("\n```\n"), end = section.find("\n```\n", begin + 1);
  ASSERT_NE(end, std::string::npos) << "a sketch is a block of code";
  EXPECT_GT(begin, GetParam().size() + 20) << "a sentence stands before it";
  EXPECT_GT(end, begin + 10);
}

TEST(RefusedScenes, AreDescribedAndSketchedInTheReadmeToo) {
  for (const auto& entry : std::filesystem::directory_iterator(degenerate_folder() / "refused")) {
    const std::string section = section_of("refused/" + entry.path().stem().string());
    EXPECT_NE(section.find("\n```\n"), std::string::npos) << entry.path();
  }
}

TEST_P(DegenerateScenes, SayWhatIsExpectedOfThem) {
  const std::vector<Expectation> rows = degenerate(GetParam()).expect;
  EXPECT_TRUE(
      std::any_of(rows.begin(), rows.end(), [](const Expectation& row) { return row.quantity != "radiosity"; }));
}

INSTANTIATE_TEST_SUITE_P(, DegenerateScenes, testing::ValuesIn(degenerate_stems()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace hottel::degenerate_scenes_test

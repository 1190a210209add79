// How fast the methods that look at pairs come near the truth, and what is known of single ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/open_space.h"
#include "solver/plane/methods/run_points.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::pair_methods_test {
namespace {

using testing_scenes::kBlack;
using testing_scenes::Line;
using testing_scenes::room;
using testing_scenes::scene_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PreparedScene2 prepared_of(const std::vector<Line>& lines) { return prepare(scene_of(lines), Divided2::kYes); }

ExchangeMatrix computed(const std::string& method, const PreparedScene2& prepared) {
  MethodReport report;
  return methods_2().make(method)->compute(prepared, {.granularity = Granularity::kElement}, report);
}

double factor(const ExchangeMatrix& matrix, const std::string& from, const std::string& to) {
  return matrix.factor(matrix.find(from).value(), matrix.find(to).value()).value;
}

double largest_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  double error = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j)
      error = std::max(error, std::fabs(matrix.factor(i, j).value - exact.factor(i, j).value));
  return error;
}

double largest_row_sum(const ExchangeMatrix& matrix) {
  double largest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
    largest = std::max(largest, sum);
  }
  return largest;
}

std::string gauss(int n) { return "gauss:" + std::to_string(n); }

// Two unit plates, one above the other, fronts inside; `elements` each.
std::vector<Line> plates(const std::string& height, std::uint32_t elements = 1) {
  return {{"lower", "1", "0", "0", "0", 0, kBlack, elements}, {"upper", "0", height, "1", height, 0, kBlack, elements}};
}

// A unit floor and a unit wall that touch.
std::vector<Line> corner() { return {{"floor", "1", "0", "0", "0"}, {"wall", "0", "0", "0", "1"}}; }

TEST(GaussMethod, ConvergesExponentiallyBetweenSeparatedPlates) {
  const PreparedScene2 prepared = prepared_of(plates("1"));
  const ExchangeMatrix exact = computed("exact", prepared);
  // Foci 1 apart and the nearest point above their middle: the error falls like rho^(-2 n) with rho = 2 + sqrt 5.
  const double rho = 2 + std::sqrt(5.0);
  for (int n = 1; n <= 9; ++n)
    EXPECT_LT(largest_error(computed(gauss(n), prepared), exact), 0.1 * std::pow(rho, -2 * (n - 1))) << n;
  EXPECT_GT(largest_error(computed(gauss(4), prepared), exact), 1e-6);
  for (const int n : {12, 16, 33, 64, 100}) EXPECT_LT(largest_error(computed(gauss(n), prepared), exact), 1e-15) << n;
}

TEST(GaussMethod, ConvergesAlgebraicallyWhereElementsTouch) {
  const PreparedScene2 prepared = prepared_of(corner());
  const double exact = factor(computed("exact", prepared), "floor", "wall");
  // The kernel is homogeneous of degree -1 about the corner: the error falls like 1 / n^2.
  double previous = 0;
  for (const int n : {8, 16, 32, 64, 128}) {
    const double error = std::fabs(factor(computed(gauss(n), prepared), "floor", "wall") - exact);
    if (n > 8) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.15) << n;
    }
    previous = error;
  }
}

TEST(CenterMethod, HasSecondOrderInTheSizeOfSeparatedElements) {
  for (const std::string name : {"center", "center-vis", "vertices"}) {
    double previous = 0;
    for (std::uint32_t elements = 1; elements <= 64; elements *= 2) {
      const PreparedScene2 prepared = prepared_of(plates("1/2", elements));
      const ExchangeMatrix matrix = computed(name, prepared), exact = computed("exact", prepared);
      // The mean over the elements of one plate of what goes to the other plate.
      double error = 0;
      for (std::uint32_t i = 0; i < elements; ++i)
        for (const FactorEntry& entry : exact.row(i))
          if (entry.to != exact.sky()) error += (matrix.factor(i, entry.to).value - entry.factor.value) / elements;
      error = std::fabs(error);
      if (elements > 4) {
        EXPECT_NEAR(std::log2(previous / error), 2, 0.1) << name << " with " << elements;
      }
      previous = error;
    }
  }
}

TEST(CenterMethod, NeedsNoExactVisibilityInAConvexRoom) {
  auto lines = room("3");
  for (Line& line : lines) line.elements = 7;
  const PreparedScene2 prepared = prepared_of(lines);
  EXPECT_EQ(testing_scenes::printed(computed("center", prepared)).size(), 28u * 21u);
  const ExchangeMatrix plain = computed("center", prepared), with_exact = computed("center-vis", prepared);
  EXPECT_EQ(largest_error(plain, with_exact), 0);
}

TEST(StringsMethod, IsExactWhereNothingHides) {
  auto lines = room("3") + std::vector<Line>{{"shelf", "1", "4", "2", "5"}};  // outside the room
  for (Line& line : lines) line.elements = 9;
  const PreparedScene2 prepared = prepared_of(lines);
  const ExchangeMatrix exact = computed("exact", prepared), strings = computed("strings", prepared);
  const auto method = methods_2().make("strings");
  const auto claimed = method->claimed_errors(prepared);
  for (std::uint32_t i = 0; i < exact.size(); ++i)
    for (const FactorEntry& entry : exact.row(i)) {
      EXPECT_LE(std::fabs(strings.factor(i, entry.to).value - entry.factor.value), claimed(i, entry.to));
      EXPECT_LT(claimed(i, entry.to), entry.to == exact.sky() ? 1e-12 : 1e-13);
    }
}

// The centres see each other or not: what is hidden in part is all there or not at all.
TEST(StringsMethod, SeesAllOrNothing) {
  const auto with_wall = [](const std::string& x0, const std::string& x1) {
    const PreparedScene2 prepared = prepared_of(plates("1") + std::vector<Line>{{"wall", x0, "1/2", x1, "1/2"}});
    return factor(computed("strings", prepared), "lower", "upper");
  };
  EXPECT_NEAR(with_wall("0.51", "2"), std::sqrt(2.0) - 1, 1e-15);
  EXPECT_EQ(with_wall("0.49", "0.51"), 0);
}

TEST(InverseSquare, HasRowSumsThatGrowWithTheNumberOfElements) {
  const std::pair<std::uint32_t, double> known[] = {{1, 3}, {4, 23}, {16, 316}, {64, 4.9e3}};
  for (const auto& [elements, sum] : known) {
    auto lines = room("1");
    for (Line& line : lines) line.elements = elements;
    const PreparedScene2 prepared = prepared_of(lines);
    EXPECT_NEAR(largest_row_sum(computed("center-vis:inverse-square=1", prepared)), sum, 0.01 * sum);
    EXPECT_NEAR(largest_row_sum(computed("center-vis:inverse-square=1/4", prepared)), sum / 4, 0.01 * sum);
  }
}

TEST(InverseSquare, DependsOnTheUnitOfLength) {
  const double here = factor(computed("center-vis:inverse-square=1", prepared_of(room("1"))), "top", "bottom");
  const double there = factor(computed("center-vis:inverse-square=1", prepared_of(room("10"))), "top", "bottom");
  EXPECT_NEAR(here, 1, 1e-15);
  EXPECT_NEAR(there, 0.01, 1e-17);
}

TEST(InverseSquare, IsRefusedWhereTheUnitOfLengthIsBeyondDoubles) {
  EXPECT_THROW(computed("center-vis:inverse-square=1", prepared_of(room("1e400"))), RequestError);
  EXPECT_THROW(computed("center-vis:inverse-square=1", prepared_of(room("1e-400"))), RequestError);
}

TEST(VertexQuadrature, IsTheTrapezoidRuleAndLiterallyTwiceThat) {
  const PreparedScene2 prepared = prepared_of(plates("1"));
  // Two straight pairs of ends with kernel 1/2, two diagonal ones with (1/2) / (2 sqrt 2).
  const double mean = (2 * 0.5 + 2 * 0.25 / std::sqrt(2.0)) / 4;
  EXPECT_NEAR(factor(computed("vertices", prepared), "lower", "upper"), mean, 1e-15);
  EXPECT_NEAR(factor(computed("vertices:centroid", prepared), "lower", "upper"), mean, 1e-15);
  EXPECT_NEAR(factor(computed("vertices:literal", prepared), "lower", "upper"), 2 * mean, 1e-15);
}

TEST(VertexQuadrature, DropsPairsThatAreTooNear) {
  // R = sqrt(1 + h^2) / 2; straight pairs, h apart, count iff h >= 0.005 R.
  const auto of_plates = [](const std::string& height) {
    return factor(computed("vertices", prepared_of(plates(height))), "lower", "upper");
  };
  EXPECT_GT(of_plates("0.0026"), 90);
  EXPECT_LT(of_plates("0.0024"), 1e-3);
}

TEST(VertexQuadrature, TestsExactVisibilityOrTheCentres) {
  const PreparedScene2 prepared =
      prepared_of(plates("1") + std::vector<Line>{{"wall", "0.0001", "1/2", "0.9999", "1/2"}});
  EXPECT_GT(factor(computed("vertices", prepared), "lower", "upper"), 0.3);
  EXPECT_EQ(factor(computed("vertices:centroid", prepared), "lower", "upper"), 0);
}

TEST(Claims, AreRealNumbersBetweenSeparatedPlates) {
  const PreparedScene2 prepared = prepared_of(plates("10"));
  const std::pair<std::string, double> most[] = {{"center", 1e-3},  {"center-vis", 1e-3},         {"vertices", 1e-3},
                                                 {"gauss:4", 1e-9}, {"gauss:8", 1e-13},           {"strings", 1e-12},
                                                 {"exact", 0},      {"gauss:8:normalised", 1e-12}};
  for (const auto& [name, bound] : most) {
    const auto claimed = methods_2().make(name)->declared_error(prepared);
    ASSERT_TRUE(claimed.has_value()) << name;
    EXPECT_LE(*claimed, bound) << name;
    EXPECT_LE(largest_error(computed(name, prepared), computed("exact", prepared)), *claimed) << name;
  }
}

TEST(Claims, AreNotMadeWhereElementsTouchOrHideInPart) {
  const auto touching = prepared_of(corner());
  for (const std::string name : {"center", "center-vis", "vertices", "gauss:4"}) {
    const auto method = methods_2().make(name);
    EXPECT_FALSE(method->declared_error(touching).has_value()) << name;
    EXPECT_EQ(method->claimed_errors(touching)(0, 2), kInfinity) << name;
  }
  const auto hidden = prepared_of(plates("10") + std::vector<Line>{{"wall", "1/2", "5", "2", "5"}});
  for (const std::string name : {"center", "center-vis", "vertices", "gauss:4", "strings"}) {
    const auto method = methods_2().make(name);
    const double claimed = method->claimed_errors(hidden)(0, 2);
    if (name == "center-vis")
      EXPECT_LT(claimed, 1e-3);
    else
      EXPECT_EQ(claimed, kInfinity) << name;
  }
}

// What is too short for doubles exchanges nothing, and nothing is claimed of it.
TEST(Claims, AreNotMadeOfSpecks) {
  const PreparedScene2 prepared =
      prepared_of(room("3") + std::vector<Line>{{"speck", "1", "1", "1." + std::string(199, '0') + "1", "1"}});
  for (const std::string name :
       {"center", "center-vis", "center-vis:inverse-square=1", "vertices", "strings", "gauss:4"}) {
    const ExchangeMatrix matrix = computed(name, prepared);
    EXPECT_TRUE(matrix.row(matrix.find("speck").value()).empty()) << name;
    const auto method = methods_2().make(name);
    EXPECT_EQ(method->claimed_errors(prepared)(matrix.find("speck").value(), matrix.find("bottom").value()), kInfinity);
    EXPECT_FALSE(method->declared_error(prepared).has_value());
  }
}

TEST(Claims, HoldOnALineWhereNothingFacesAnything) {
  const PreparedScene2 prepared = prepared_of({{"one", "0", "0", "1", "0"}, {"two", "3", "0", "2", "0"}});
  for (const std::string name : {"center", "center-vis", "vertices", "strings", "gauss:4"}) {
    EXPECT_EQ(factor(computed(name, prepared), "one", "sky"), 1) << name;
    EXPECT_EQ(methods_2().make(name)->declared_error(prepared), 0) << name;
  }
}

TEST(Sky, IsWhatIsLeftInTheOpenAndNothingInsideClosedWalls) {
  const PreparedScene2 prepared =
      prepared_of(room("3") + std::vector<Line>{{"shelf", "1", "4", "2", "5"}, {"lamp", "1", "1", "2", "1"}});
  const ExchangeMatrix matrix = computed("center", prepared);
  for (const std::string name : {"left", "top", "right", "bottom", "lamp"})
    EXPECT_EQ(factor(matrix, name, "sky"), 0) << name;
  EXPECT_GT(factor(matrix, "shelf", "sky"), 0.25);
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(matrix.find("shelf").value())) sum += entry.factor.value;
  EXPECT_DOUBLE_EQ(sum, 1);
}

TEST(Sky, BordersWhatAWayFromInfinityReaches) {
  const PreparedScene2 prepared = prepared_of({{"left", "0", "0", "0", "3"},
                                               {"top", "0", "3", "3", "3"},
                                               {"right", "3", "3", "3", "1/1000"},  // ajar
                                               {"bottom", "3", "0", "0", "0"},
                                               {"a", "1", "1", "1", "2"},
                                               {"b", "1", "2", "2", "1"},
                                               {"c", "2", "1", "1", "1"}});
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const std::vector<char> is_open = borders_open_space(prepared.arrangement, table);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    const std::string& name = table.elements()[i].name;
    EXPECT_EQ(is_open[i] != 0, !(name == "a" || name == "b" || name == "c")) << name;
  }
}

// A floor of which another surface owns the middle exchanges as its two parts do, by their lengths.
TEST(Runs, AreElementsOfTheirOwn) {
  const Line table{"table", "2", "0", "1", "0", 1}, wall{"wall", "0", "1", "7", "3"};
  const PreparedScene2 whole = prepared_of({table, {"floor", "5", "0", "0", "0", 1}, wall});
  const PreparedScene2 parts =
      prepared_of({table, {"first", "5", "0", "2", "0", 1}, {"second", "1", "0", "0", "0", 1}, wall});
  for (const std::string name : {"center", "center-vis", "vertices", "strings", "gauss:3"}) {
    const ExchangeMatrix one = computed(name, whole), two = computed(name, parts);
    EXPECT_NEAR(factor(one, "floor", "wall"),
                0.75 * factor(two, "first", "wall") + 0.25 * factor(two, "second", "wall"), 1e-15);
    EXPECT_NEAR(factor(one, "wall", "floor"), factor(two, "wall", "first") + factor(two, "wall", "second"), 1e-15);
  }
}

// What is asked of views instead of all pairs is found by asking all pairs.
TEST(RunPoints2, HaveAllElementsThatTheySeeAsPartners) {
  std::size_t seen = 0;
  for (const char* kind : {"lattice", "clutter"})
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      const PreparedScene2 prepared = prepare(testing_scenes::generated(kind, 60, seed), Divided2::kYes);
      const ElementGeometry2 geometry(prepared);
      const RunPoints2 points(prepared, geometry, {Rational(1, 3), Rational(1, 2)});
      for (std::uint32_t i = 0; i < geometry.count(); ++i) {
        std::vector<std::uint32_t> others;
        points.append_partners(i, others);
        const std::set<std::uint32_t> known(others.begin(), others.end());
        for (std::uint32_t j = 0; j < geometry.count(); ++j)
          for (const ElementRun2& a : geometry.runs(i))
            for (const ElementRun2& b : geometry.runs(j))
              for (const std::size_t k : {0u, 1u})
                for (const std::size_t l : {0u, 1u})
                  if (points.see_each_other(a, k, b, l)) {
                    ++seen;
                    ASSERT_TRUE(known.contains(j)) << kind << " " << seed << ": " << i << " " << j;
                  }
      }
    }
  EXPECT_GT(seen, 5000u);
}

TEST(Names, ThatMakeNoSenseAreRefused) {
  for (const std::string name :
       {"center:1", "strings:2", "gauss", "gauss:", "gauss:0", "gauss:-1", "gauss:4x", "gauss:1025", "vertices:first",
        "vertices:centroid:literal", "center-vis:1", "center-vis:inverse-square=", "center-vis:inverse-square=-1",
        "center-vis:inverse-square=x", "middle"})
    EXPECT_THROW(methods_2().make(name), UsageError) << name;
}

}  // namespace
}  // namespace hottel::pair_methods_test

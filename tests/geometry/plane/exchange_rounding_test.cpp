// Which tier settles a view factor, and that it is rounded correctly where only the last one can.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::exchange_rounding_test {
namespace {

using namespace testing_scenes;

std::uint64_t count(const ExchangeReport& report, Tier tier) { return report.tiers.by_tier[static_cast<int>(tier)]; }

// An edge of length 2^55 in a right angle with a wall of height h: F = (2^55 + h - sqrt(2^110 + h^2)) / 2^56. For
// h = 2^108 - 1 this is 1/2 - 2^-55 exactly: half-way between 0.5 and the double below it.
Exact corner(const Integer& height) {
  const Integer length = Integer(1) << 55;
  return Exact(scene_of({{"edge", length.get_str(), "0", "0", "0"}, {"wall", "0", "0", "0", height.get_str()}}));
}

TEST(RoundingOfFactors2, SettlesAnExactTieByTheSumOfRoots) {
  const Integer height = Integer(1) << 108;
  const Exact tie = corner(height - 1);
  const RootSum exact = tie.measure("edge", "wall");
  const Integer length = Integer(1) << 55;
  Rational expected = Rational(length) / 2 - 1;
  EXPECT_EQ(exact.to_string(), to_string(expected)) << "(1/2 - 2^-55) 2^55";
  EXPECT_EQ(tie.factor("edge", "wall"), (Rounded{0.5, -1}));
  EXPECT_EQ(count(tie.report(), Tier::kRootSum), 4u) << "every string is an integer: both ways, and to the sky";
}

TEST(RoundingOfFactors2, SettlesTheNeighboursOfATieByPrecision) {
  const Integer height = Integer(1) << 108;
  const Exact below = corner(height - 2), above = corner(height);
  EXPECT_EQ(below.value("edge", "wall"), 0.49999999999999994);
  EXPECT_EQ(above.value("edge", "wall"), 0.5);
  EXPECT_EQ(count(below.report(), Tier::kRootSum), 0u);
  EXPECT_EQ(count(above.report(), Tier::kRootSum), 0u);
  EXPECT_GT(count(below.report(), Tier::kBall), 0u);
}

TEST(RoundingOfFactors2, CountsOneTierForEveryNumber) {
  for (const Scene2& scene : all_kinds(60)) {
    const Exact exact(scene);
    std::uint64_t numbers = 0, total = 0;
    for (std::uint32_t i = 0; i < exact.matrix().size(); ++i) numbers += exact.matrix().row(i).size();
    for (const Tier tier : {Tier::kDouble, Tier::kDoubleDouble, Tier::kBall, Tier::kRootSum})
      total += count(exact.report(), tier);
    EXPECT_GT(total, numbers / 2) << scene.about;
    EXPECT_GT(count(exact.report(), Tier::kDoubleDouble), 0u);
  }
}

TEST(RoundingOfFactors2, KnowsWhichFactorsAreDoubles) {
  // 3, 4, 5: every string is an integer.
  const Exact exact(
      scene_of({{"up", "0", "0", "0", "3"}, {"slope", "0", "3", "4", "0"}, {"along", "4", "0", "0", "0"}}));
  EXPECT_EQ(exact.factor("along", "up"), (Rounded{0.25, 0}));
  EXPECT_EQ(exact.factor("along", "slope"), (Rounded{0.75, 0}));
  EXPECT_EQ(exact.factor("up", "along").value, 1.0 / 3);
  EXPECT_EQ(exact.factor("slope", "along"), (Rounded{0.6, 1}));
  EXPECT_EQ(count(exact.report(), Tier::kBall) + count(exact.report(), Tier::kRootSum), 0u);
}

TEST(RoundingOfFactors2, OfUnobstructedPairsAreThoseOfTheExactSums) {
  std::size_t facing = 0, pairs = 0;
  for (const char* kind : {"clutter", "lattice", "comb", "plates"}) {
    const PreparedScene2 prepared = prepare(generate_2({.kind = kind, .n = 60, .seed = 2}), Divided2::kYes);
    const Vertices2& vertices = prepared.arrangement.vertices();
    const ElementTable2& table = *prepared.elements(Granularity::kElement);
    const PairsAlone2 alone(prepared, table, Granularity::kElement);
    for (std::uint32_t i = 0; i < table.count(); ++i)
      for (std::uint32_t j = 0; j < table.count() && table.has_row(i); ++j) {
        const RootSum exact = alone.exact(i, j);
        const double factor = alone.factor(i, j);
        ++pairs;
        if (exact.is_zero()) {
          EXPECT_EQ(factor, 0) << kind;
          continue;
        }
        ++facing;
        EXPECT_EQ(factor, round_quotient(exact, table.exact_length(i, vertices) * vertices.scale()).number.value);
      }
  }
  EXPECT_GT(facing, 1000u);
  EXPECT_GT(pairs, 2 * facing);
}

TEST(RoundingOfFactors2, RoundsMeasuresAndAreasToo) {
  const Exact exact(
      scene_of({{"low", "1", "0", "0", "0"}, {"high", "0", "1", "1", "1"}, {"slant", "5", "5", "6", "6"}}));
  EXPECT_EQ(exact.matrix().measures(0)[0], 0.41421356237309504880);
  EXPECT_EQ(exact.matrix().elements()[4].area, (Rounded{std::sqrt(2.0), -1}));
  EXPECT_EQ(exact.matrix().elements()[0].area, (Rounded{1, 0}));
}

}  // namespace
}  // namespace hottel::exchange_rounding_test

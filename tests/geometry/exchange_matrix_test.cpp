// What an exchange matrix refuses to hold.
#include "geometry/exchange_matrix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel::exchange_matrix_test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Two faces and the sky.
ExchangeMatrix two_faces(Guarantee guarantee) {
  std::vector<Element> elements(2);
  elements[0].name = "floor";
  elements[1].name = "wall";
  return ExchangeMatrix(elements, guarantee);
}

using Entries = std::vector<FactorEntry>;
const Entries kGood = {{1, {0.5, 0}, 1}, {2, {0.5, 0}, 1}, {0, {1, 0}, 1}};

TEST(ExchangeMatrix, HoldsRowsThatAscend) {
  for (const Guarantee guarantee : {Guarantee::kExact, Guarantee::kEstimated}) {
    ExchangeMatrix matrix = two_faces(guarantee);
    matrix.assign({0, 2, 3}, kGood);
    EXPECT_EQ(matrix.factor(0, matrix.sky()).value, 0.5);
    EXPECT_EQ(matrix.factor(1, 0).value, 1);
    EXPECT_EQ(matrix.factor(1, matrix.sky()).value, 0);
  }
}

TEST(ExchangeMatrix, RefusesABrokenPattern) {
  const auto assigned = [](std::vector<std::size_t> begin, Entries entries) {
    return [begin = std::move(begin), entries = std::move(entries)] {
      two_faces(Guarantee::kEstimated).assign(begin, entries);
    };
  };
  EXPECT_THAT(assigned({0, 3}, kGood), ThrowsMessage<ContractViolation>(HasSubstr("2 rows that begin in 2 places")));
  EXPECT_THAT(assigned({0, 2, 4}, kGood), ThrowsMessage<ContractViolation>(HasSubstr("3 entries")));
  EXPECT_THAT(assigned({1, 2, 3}, kGood), ThrowsMessage<ContractViolation>(HasSubstr("not an exchange matrix")));
  EXPECT_THAT(assigned({0, 4, 3}, kGood), ThrowsMessage<ContractViolation>(HasSubstr("ends before it begins")));
  EXPECT_THAT(assigned({0, 1, 1}, {{3, {1, 0}, 1}}),
              ThrowsMessage<ContractViolation>(HasSubstr("the columns of 'floor' do not ascend to 2 at most: 3")));
  EXPECT_THAT(assigned({0, 0, 2}, {{2, {1, 0}, 1}, {0, {1, 0}, 1}}),
              ThrowsMessage<ContractViolation>(HasSubstr("the columns of 'wall' do not ascend to 2 at most: 2, 0")));
  EXPECT_THAT(assigned({0, 2, 2}, {{1, {1, 0}, 1}, {1, {1, 0}, 1}}),
              ThrowsMessage<ContractViolation>(HasSubstr("'floor'")));
}

TEST(ExchangeMatrix, RefusesWhatItsGuaranteeRulesOut) {
  const auto exact = [](const Rounded& factor) {
    return [factor] { two_faces(Guarantee::kExact).assign({0, 1, 1}, {{1, factor, 1}}); };
  };
  EXPECT_NO_THROW(exact({0, 1})());  // positive, but below the smallest double
  for (const Rounded& none :
       {Rounded{0, 0}, Rounded{0, -1}, Rounded{-0.5, 0}, Rounded{-0.5, 1},
        Rounded{std::numeric_limits<double>::quiet_NaN(), 0}, Rounded{std::numeric_limits<double>::infinity(), 0}})
    EXPECT_THAT(exact(none), ThrowsMessage<ContractViolation>(HasSubstr("an exact factor of 'floor' is")));

  const auto enclosed = [](std::vector<Enclosure> bounds) {
    return [bounds = std::move(bounds)] {
      two_faces(Guarantee::kEnclosed).assign({0, 1, 1}, {{1, {0.5, 0}, 1}}, {}, bounds);
    };
  };
  EXPECT_NO_THROW(enclosed({{0, 1}})());
  EXPECT_NO_THROW(enclosed({{0.5, 0.5}})());
  EXPECT_THAT(enclosed({}), ThrowsMessage<ContractViolation>(HasSubstr("1 entries, and bounds of 0")));
  for (const Enclosure& none : {Enclosure{-0.1, 1}, Enclosure{0.6, 1}, Enclosure{0, 0.4}, Enclosure{1, 0},
                                Enclosure{0, std::numeric_limits<double>::infinity()}})
    EXPECT_THAT(enclosed({none}), ThrowsMessage<ContractViolation>(HasSubstr("a factor of 'floor' is 0.5 within")));
  EXPECT_THAT(
      [] {
        two_faces(Guarantee::kExact).assign({0, 2, 3}, kGood, {1, 2});
      },
      ThrowsMessage<ContractViolation>(HasSubstr("3 entries, and measures of 2")));
}

using Guarantees = std::vector<Guarantee>;
using Bounds = std::vector<Enclosure>;

TEST(MixedExchangeMatrix, SaysOfEachEntryWhatIsGuaranteedAndOfAllTheWeakest) {
  ExchangeMatrix matrix = two_faces(Guarantee::kExact);
  const Entries entries = {{1, {0.5, 1}, 1}, {2, {0.4, 0}, 1}, {0, {1.5, 0}, 1}};
  matrix.assign({0, 2, 3}, entries, {}, {{0, 0}, {0.375, 0.5}, {0.25, 1}},
                {Guarantee::kExact, Guarantee::kEnclosed, Guarantee::kEstimated});
  EXPECT_EQ(matrix.guarantee(), Guarantee::kEstimated);
  EXPECT_EQ(matrix.guarantee(0, 0), Guarantee::kExact);
  EXPECT_EQ(matrix.guarantee(0, 1), Guarantee::kEnclosed);
  EXPECT_EQ(matrix.guarantee(1, 0), Guarantee::kEstimated);
  EXPECT_EQ(matrix.bounds(0, 0), (Enclosure{0.5, std::nextafter(0.5, 1)}));  // its own, not those given
  EXPECT_EQ(matrix.bounds(0, 1), (Enclosure{0.375, 0.5}));
  EXPECT_EQ(matrix.bounds(1, 0), (Enclosure{0.25, 1}));  // proven, though the guess lies elsewhere

  matrix.assign({0, 2, 3}, entries, {}, {}, {Guarantee::kExact, Guarantee::kEstimated, Guarantee::kEstimated});
  EXPECT_EQ(matrix.bounds(0, 0), (Enclosure{0.5, std::nextafter(0.5, 1)}));
  EXPECT_EQ(matrix.bounds(0, 1), (Enclosure{0, 1}));
}

TEST(MixedExchangeMatrix, IsAsWeakAsItsWeakestEntry) {
  const Guarantee all[] = {Guarantee::kExact, Guarantee::kEnclosed, Guarantee::kEstimated};
  for (const Guarantee a : all)
    for (const Guarantee b : all)
      for (const Guarantee c : all)
        for (const Guarantee of_constructor : all) {
          ExchangeMatrix matrix = two_faces(of_constructor);
          matrix.assign({0, 2, 3}, kGood, {}, Bounds(3, {0, 1}), {a, b, c});
          EXPECT_EQ(matrix.guarantee(), std::max({a, b, c}));
          EXPECT_EQ((Guarantees{matrix.guarantee(0, 0), matrix.guarantee(0, 1), matrix.guarantee(1, 0)}),
                    (Guarantees{a, b, c}));
        }
  ExchangeMatrix empty = two_faces(Guarantee::kEnclosed);
  empty.assign({0, 0, 0}, {});
  EXPECT_EQ(empty.guarantee(), Guarantee::kEnclosed);
}

TEST(MixedExchangeMatrix, RefusesEntriesThatBreakTheirOwnPromise) {
  const auto assigned = [](Guarantees guarantees, Bounds bounds, double factor) {
    return [=] {
      two_faces(Guarantee::kExact).assign({0, 2, 2}, {{1, {0.5, 0}, 1}, {2, {factor, 0}, 1}}, {}, bounds, guarantees);
    };
  };
  const auto refuses = [](const char* why) { return ThrowsMessage<ContractViolation>(HasSubstr(why)); };
  constexpr Guarantee kExact = Guarantee::kExact, kEnclosed = Guarantee::kEnclosed, kEstimated = Guarantee::kEstimated;
  EXPECT_NO_THROW(assigned({kExact, kEstimated}, {}, -0.5)());
  EXPECT_NO_THROW(assigned({kExact, kEstimated}, {{0, 1}, {0, 1}}, 1.5)());
  EXPECT_THAT(assigned({kExact}, {}, 0.5), refuses("2 entries, and guarantees of 1"));
  EXPECT_THAT(assigned({kExact, kEnclosed}, {{0, 1}}, 0.5), refuses("2 entries, and bounds of 1"));
  EXPECT_THAT(assigned({kExact, kEstimated}, {{0, 1}}, 0.5), refuses("2 entries, and bounds of 1"));
  EXPECT_THAT(assigned({kExact, kEnclosed}, {}, 0.5), refuses("2 entries, and bounds of 0"));
  EXPECT_THAT(assigned({kEnclosed, kExact}, Bounds(2, {0, 1}), 0), refuses("an exact factor of 'floor' is 0"));
  EXPECT_THAT(assigned({kEstimated, kEnclosed}, {{0, 1}, {0, 0.25}}, 0.5), refuses("is 0.5 within [0, 0.25]"));
  EXPECT_THAT(assigned({kExact, kEstimated}, {{0, 1}, {0.5, 0.25}}, 0.5), refuses("is 0.5 within [0.5, 0.25]"));
  EXPECT_THAT(assigned({kExact, kEstimated}, {{0, 1}, {-0.5, 1}}, 0.5), refuses("is 0.5 within [-0.5, 1]"));
}

TEST(ExchangeMatrix, NamesEveryColumn) {
  const ExchangeMatrix matrix = two_faces(Guarantee::kEstimated);
  for (std::uint32_t column = 0; column <= matrix.sky(); ++column) EXPECT_EQ(matrix.find(matrix.name(column)), column);
  EXPECT_EQ(matrix.name(1), "wall");
  EXPECT_EQ(matrix.name(matrix.sky()), "sky");
  EXPECT_THROW(matrix.name(matrix.sky() + 1), ContractViolation);
  EXPECT_EQ(ExchangeMatrix().name(0), "sky");
}

TEST(ExchangeMatrix, HasFactorsByName) {
  std::vector<Element> elements(3);
  elements[0].name = "floor";
  elements[1].name = "wall";
  elements[2].name = "wall:back";
  elements[0].material = elements[1].material = 0;
  elements[0].area = elements[2].area = {1, 0};
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  matrix.assign({0, 2, 2, 2}, {{2, {0.25, 0}, 1}, {3, {0.75, 0}, 1}});
  EXPECT_EQ(matrix.factor("floor", "wall:back").value, 0.25);
  EXPECT_EQ(matrix.factor("floor", "sky").value, 0.75);
  EXPECT_EQ(matrix.factor("floor", "wall").value, 0);
  const auto asked = [&](const char* from, const char* to) { return [&matrix, from, to] { matrix.factor(from, to); }; };
  EXPECT_THAT(asked("flor", "wall"), ThrowsMessage<UsageError>("there is no face called 'flor'"));
  EXPECT_THAT(asked("floor", "ceiling"), ThrowsMessage<UsageError>("there is no face called 'ceiling'"));
  EXPECT_THAT(asked("sky", "floor"), ThrowsMessage<UsageError>("there are no view factors from the sky"));
  EXPECT_THAT(asked("wall", "floor"),
              ThrowsMessage<UsageError>("there are no view factors from 'wall': it has no area"));
  EXPECT_THAT(asked("wall:back", "floor"),
              ThrowsMessage<UsageError>("there are no view factors from 'wall:back': it has no material"));
}

}  // namespace
}  // namespace hottel::exchange_matrix_test

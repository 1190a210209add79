// Rows that come a range at a time: those of the whole matrix, bit for bit.
#include "geometry/plane/exchange/exact_rows.h"

#include <gtest/gtest.h>

#include <functional>

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/requested_sums.h"
#include "kernel/support/failure.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/geometry/same_rows.h"

namespace hottel::exact_rows_test {
namespace {

using namespace testing_scenes;

void expect_same_report(const ExchangeReport& a, const ExchangeReport& b) {
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.gaps, b.gaps);
  EXPECT_EQ(a.terms, b.terms);
  EXPECT_EQ(a.tiers, b.tiers);
}

void expect_same(const Scene2& scene, const ExchangeRequest& request, std::size_t entries_in_range) {
  const PreparedScene2 prepared =
      prepare(scene, request.granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo);
  ExchangeReport of_whole, of_rows;
  const ExchangeMatrix whole = exact_exchange(prepared, request, &of_whole);
  const auto table = table_with_rows(prepared, request);
  const SumsInMemory2 sums(requested_sums(prepared, *table, request, kBytesPerSum2, of_rows), entries_in_range);
  ExactRows2 rows(prepared, *table, request, sums, of_rows);
  expect_same_rows(whole, rows);
  expect_same_report(of_whole, of_rows);
  expect_same_rows(whole, rows);  // and once more
}

TEST(ExactRows2, AreThoseOfTheMatrixHoweverTheyAreCut) {
  for (Scene2 scene : all_kinds(60)) {
    for (std::size_t k = 0; k < scene.surfaces.size(); k += 3) scene.surfaces[k].elements = 2;
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement})
      for (const std::size_t entries : {1U, 100U, 1000000U}) expect_same(scene, {.granularity = granularity}, entries);
  }
}

TEST(ExactRows2, AreThoseOfTheMatrixOnLattices) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    expect_same(generated("lattice", 10 + seed, seed), {}, 1 + seed * seed);
    expect_same(in_groups_of_five(generated("lattice", 10 + seed, seed)), {.granularity = Granularity::kGroup}, 20);
  }
}

TEST(ExactRows2, AreThoseOfTheMatrixWhereSomeAreAskedFor) {
  const Scene2 scene = generated("clutter", 200, 2);
  expect_same(scene, {.rows = RowChoice::fronts_of({3, 4, 150})}, 5);
  expect_same(scene, {.wants_visibility = false, .rows = RowChoice::of(scene, "fronts", Granularity::kFace)}, 500);
  expect_same(scene_of(room("4")), {}, 2);  // convex
}

// Sums in which one pair was tampered with.
class Tampered final : public SumSource2 {
 public:
  Tampered(const SumSource2& sums, std::function<void(std::vector<PairSum2>&)> tamper)
      : sums_(sums), tamper_(std::move(tamper)) {}
  const RowCuts& cuts() const override { return sums_.cuts(); }
  std::vector<PairSum2> sums(std::size_t k) const override {
    std::vector<PairSum2> sums = sums_.sums(k);
    if (k + 1 == cuts().count()) tamper_(sums);
    return sums;
  }

 private:
  const SumSource2& sums_;
  std::function<void(std::vector<PairSum2>&)> tamper_;
};

TEST(ExactRows2, AreRefusedWhereASumIsLostOrThereTwiceOrAnother) {
  const PreparedScene2 prepared = prepare(generated("clutter", 100, 1));
  const ExchangeRequest request;
  ExchangeReport report;
  const auto table = table_with_rows(prepared, request);
  const SumsInMemory2 sums(requested_sums(prepared, *table, request, kBytesPerSum2, report), 100);
  ASSERT_GT(sums.cuts().count(), 2U);
  const auto make = [&](const std::function<void(std::vector<PairSum2>&)>& tamper) {
    ExactRows2(prepared, *table, request, Tampered(sums, tamper), report);
  };
  EXPECT_NO_THROW(make([](std::vector<PairSum2>&) {}));
  EXPECT_THROW(make([](std::vector<PairSum2>& some) { some.pop_back(); }), ContractViolation);
  EXPECT_THROW(make([](std::vector<PairSum2>& some) { some.push_back(some.back()); }), ContractViolation);
  EXPECT_THROW(make([](std::vector<PairSum2>& some) { ++some.back().value; }), ContractViolation);
}

TEST(RowCuts, FollowEachOther) {
  for (const std::uint32_t rows : {0U, 1U, 7U, 100U})
    for (const std::size_t ranges : {1U, 3U, 50U, 1000U}) {
      const RowCuts cuts(rows, ranges);
      std::uint32_t next = 0;
      for (std::size_t k = 0; k < cuts.count(); ++k) {
        EXPECT_EQ(cuts.range(k).first, next);
        next = cuts.range(k).end;
        for (std::uint32_t row = cuts.range(k).first; row < next; ++row) EXPECT_EQ(cuts.of(row), k);
      }
      EXPECT_EQ(next, rows);
    }
}

}  // namespace
}  // namespace hottel::exact_rows_test

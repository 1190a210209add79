// Bounds of pairs narrowed by their rows: the numbered properties of RowBounds3.
#include "geometry/space/exchange/narrow_by_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/generate/generators.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::narrow_by_rows_test {
namespace {

class NarrowByRows : public testing::Test {
 protected:
  NarrowByRows() { rows_.add_all(); }

  std::vector<PairSum3> proven() const {
    std::vector<PairSum3> pairs(rows_.pairs().begin(), rows_.pairs().end());
    std::erase_if(pairs, [](const PairSum3& pair) { return pair.is_zero(); });
    return pairs;
  }
  std::uint64_t narrow(std::vector<PairSum3>& pairs) const {
    RowBounds3 bounds(table_);
    bounds.add(RowRange::all(), pairs);
    return bounds.narrow(RowRange::all(), pairs);
  }
  // What the bounds of a row leave open.
  double width_of_row(const std::vector<PairSum3>& pairs, std::uint32_t row) const {
    double width = 0;
    for (const PairSum3& pair : pairs) width += pair.i == row || pair.j == row ? pair.bounds.width() : 0;
    return width;
  }

  const PreparedScene3 prepared_ = prepare(generate_3({.kind = "room-touching", .n = 2, .seed = 1}));
  ExchangeRows3 rows_{prepared_, {.wants_visibility = false, .proves = true}};
  const ElementTable3& table_ = rows_.table();
};

// Without being narrowed: areas are within the sums of bounds.
TEST_F(NarrowByRows, RowsHoldTheirAreasBefore) {
  const std::vector<PairSum3> pairs = proven();
  for (std::uint32_t i = 0; i < table_.count(); ++i) {
    if (!table_.has_row(i)) continue;
    long double lower = 0, upper = 0;
    for (const PairSum3& pair : pairs) {
      if (pair.i != i && pair.j != i) continue;
      lower += pair.bounds.lower;
      upper += pair.bounds.upper;
    }
    EXPECT_LE(lower, table_.extent(i).enclosure().upper * (1 + 1e-17L));
    EXPECT_GE(upper, table_.extent(i).enclosure().lower * (1 - 1e-17L));
  }
}

TEST_F(NarrowByRows, APairOfWhichLittleIsKnownIsToldByItsRow) {
  const std::vector<PairSum3> known = proven();
  std::size_t told = 0;
  for (std::size_t k = 0; k < known.size(); k += 3) {
    std::vector<PairSum3> pairs = known;
    const double area = table_.extent(pairs[k].i).enclosure().upper;
    pairs[k].bounds = {0, area};
    EXPECT_GE(narrow(pairs), 1u);
    // No wider than all others of the row, and what is known of it is within.
    const double others = width_of_row(known, pairs[k].i) - known[k].bounds.width();
    EXPECT_LE(pairs[k].bounds.width(), others + 1e-13 * area);
    EXPECT_LE(pairs[k].bounds.lower, known[k].bounds.upper);
    EXPECT_GE(pairs[k].bounds.upper, known[k].bounds.lower);
    EXPECT_EQ(pairs[k].measure, known[k].measure);
    ++told;
    // Nothing becomes wider.
    for (std::size_t other = 0; other < pairs.size(); ++other)
      if (other != k) {
        EXPECT_GE(pairs[other].bounds.lower, known[other].bounds.lower);
        EXPECT_LE(pairs[other].bounds.upper, known[other].bounds.upper);
        EXPECT_LE(pairs[other].bounds.lower, pairs[other].bounds.upper);
      }
  }
  EXPECT_GT(told, 10u);
}

TEST_F(NarrowByRows, AMeasureOutsideIsMoved) {
  std::vector<PairSum3> pairs = proven();
  const double measure = pairs[3].measure, area = table_.extent(pairs[3].i).enclosure().upper;
  pairs[3].bounds = {0, area};
  pairs[3].measure = area;
  narrow(pairs);
  EXPECT_EQ(pairs[3].measure, pairs[3].bounds.upper);
  EXPECT_NEAR(pairs[3].measure, measure, 1e-6 * area);
}

TEST_F(NarrowByRows, BoundsThatAreWrongAreNoticed) {
  std::vector<PairSum3> pairs = proven();
  const double off = 2 * width_of_row(pairs, pairs[3].i) + 1e-9 * table_.extent(pairs[3].i).value;
  pairs[3].bounds = {pairs[3].bounds.lower + off, pairs[3].bounds.upper + off};
  EXPECT_THROW(narrow(pairs), ContractViolation);
}

// The matrix has narrowed bounds where proofs are asked for, and the factors that it has without them.
TEST_F(NarrowByRows, ProvenFactorsAreWithinWhatWasKnownBefore) {
  ExchangeReport3 report;
  const ExchangeMatrix matrix = exact_exchange(prepared_, {.wants_visibility = false, .proves = true}, &report);
  const ExchangeMatrix plain = exact_exchange(prepared_, {.wants_visibility = false});
  EXPECT_GT(report.proof.parts, 0u);
  const std::vector<PairSum3> before = proven();
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const std::uint32_t to = matrix.row(i)[k].to;
      const auto known = std::ranges::find_if(
          before, [&](const PairSum3& pair) { return pair.i == std::min(i, to) && pair.j == std::max(i, to); });
      ASSERT_NE(known, before.end());
      const double area = table_.extent(i).value;
      EXPECT_LE(matrix.bounds(i, k).width(), known->bounds.width() / area * (1 + 1e-12) + 1e-15);
      EXPECT_EQ(matrix.row(i)[k].factor, plain.row(i)[k].factor);
    }
}

}  // namespace
}  // namespace hottel::narrow_by_rows_test

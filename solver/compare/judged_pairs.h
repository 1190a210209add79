// The pairs of a foreign matrix beside the exact ones, and which of them are off.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/written_factors.h"

namespace hottel {

// One ordered pair of elements; `to` may be the sky.
struct JudgedPair {
  std::uint32_t from = 0, to = 0;
  double value = 0, exact = 0;
  double visibility = 1;  // exact; 0 where nothing goes
  bool is_off = false;
  bool is_reverse_off = false;  // F(to, from) is off too

  double error() const { return value > exact ? value - exact : exact - value; }
};

// All pairs with a factor in either matrix, by rows; columns that the file lacks are left out.
//
//   (1) a pair is off iff value and exact differ by more than tolerance(): what the caller allows, and half of the last
//       digit that the file writes of such a number
//   (2) pairs() is sorted by row, then by column, each pair once; off() counts those that are
// COST: 40 bytes a pair.
class JudgedPairs {
 public:
  // REQUIRES the same elements. Both matrices outlive this.
  JudgedPairs(const ExchangeMatrix& exact, const ExchangeMatrix& matrix, double beyond, const WrittenFactors& written);

  const ExchangeMatrix& exact() const { return *exact_; }
  const ExchangeMatrix& matrix() const { return *matrix_; }
  bool has_column(std::uint32_t column) const { return written_.has_column.empty() || written_.has_column[column]; }

  std::span<const JudgedPair> pairs() const { return pairs_; }
  std::span<const JudgedPair> row(std::uint32_t i) const {
    return pairs().subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  std::size_t index_of(const JudgedPair& pair) const { return static_cast<std::size_t>(&pair - pairs_.data()); }
  std::uint64_t off() const { return off_; }

  // How far a number of the file may be from what is right.
  double tolerance(double value) const { return beyond_ + written_.digits.rounding(value); }
  // Whether a pair that is off agrees with another number, and so much better than with the exact one.
  bool agrees(const JudgedPair& pair, double with) const;

 private:
  const ExchangeMatrix* exact_;
  const ExchangeMatrix* matrix_;
  double beyond_;
  WrittenFactors written_;
  std::vector<JudgedPair> pairs_;
  std::vector<std::size_t> begin_;
  std::uint64_t off_ = 0;
};

}  // namespace hottel

// The pairs of an external matrix beside the exact ones, and which of them are off.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"

namespace hottel {

// One ordered pair of elements; `to` may be the sky. A factor that a matrix does not hold is 0 here.
struct JudgedPair {
  std::uint32_t from = 0, to = 0;
  double value = 0, exact = 0;
  double visibility = 1;  // exact; 0 where nothing goes
  bool is_off = false;
  bool is_reverse_off = false;  // F(to, from) is off too

  double error() const { return value > exact ? value - exact : exact - value; }
};

// All pairs with a factor in either matrix, by rows; rows and columns that the file lacks are left out.
//
//   (1) a pair is off iff value and exact differ by more than tolerance(): what the caller allows, and half of the last
//       digit that the file writes of such a number
//   (2) pairs() is sorted by row, then by column, each pair once; off() counts those that are
//   (3) where the exact matrix has no entry the exact factor is 0 and so is the visibility
// COST: 40 bytes a pair.
class JudgedPairs {
 public:
  // `beyond`: what the caller allows a factor to differ by, besides the digits of the file.
  // REQUIRES both matrices to be over the same elements, and to outlive this. COST: one pass over both.
  JudgedPairs(const ExchangeMatrix& exact, const ExchangeMatrix& matrix, double beyond, const WrittenFactors& written);

  const ExchangeMatrix& exact() const { return *exact_; }
  const ExchangeMatrix& matrix() const { return *matrix_; }
  // Whether the file has a place for what goes to this element, or to the sky (column exact().sky()).
  bool has_column(std::uint32_t column) const { return written_.has_column.empty() || written_.has_column[column]; }
  // And whether it has one for this pair: some number of its row, and its column.
  bool has_place(std::uint32_t from, std::uint32_t to) const { return written_.has_place(from, to); }

  // The places that there are, without digits: of numbers that were computed from those of the file.
  WrittenFactors places() const { return {{}, written_.has_column, written_.has_row}; }

  // All of them, and those of one row.
  std::span<const JudgedPair> pairs() const { return pairs_; }
  std::span<const JudgedPair> row(std::uint32_t i) const {
    return pairs().subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  // Calls visit(from, to) for each pair of elements with a place that is 0 in both matrices, until it returns true.
  // Returns whether it did. COST: the square of the number of elements.
  template <class Visit>
  bool any_of_zeros(const Visit& visit) const;
  // The place of a pair in pairs(). REQUIRES a reference into pairs(), not a copy.
  std::size_t index_of(const JudgedPair& pair) const { return static_cast<std::size_t>(&pair - pairs_.data()); }
  std::uint64_t off() const { return off_; }

  // How far a number of the file may be from what is right: what the caller allows, and half of its last digit.
  double tolerance(double value) const { return beyond_ + rounding(value); }
  // Half of its last digit alone.
  double rounding(double value) const { return written_.digits.rounding(value); }
  // Whether `with` would explain the value of a pair: it is within tolerance() of it, and at most half as far away as
  // the exact factor is.
  bool agrees(const JudgedPair& pair, double with) const;
  // What the other factors of the file leave of 1 in the row of a pair.
  double rest_of_row(const JudgedPair& pair) const;

 private:
  const ExchangeMatrix* exact_;
  const ExchangeMatrix* matrix_;
  double beyond_;
  WrittenFactors written_;
  std::vector<JudgedPair> pairs_;
  std::vector<std::size_t> begin_;
  std::uint64_t off_ = 0;
};

template <class Visit>
bool JudgedPairs::any_of_zeros(const Visit& visit) const {
  for (std::uint32_t i = 0; i < exact_->size(); ++i) {
    if (!exact_->has_row(i)) continue;
    auto next = row(i).begin();
    for (std::uint32_t j = 0; j < exact_->size(); ++j) {
      while (next != row(i).end() && next->to < j) ++next;
      if ((next == row(i).end() || next->to != j) && has_place(i, j) && visit(i, j)) return true;
    }
  }
  return false;
}

}  // namespace hottel

// Matrices of methods that fill one row after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// Returns the estimated matrix with these rows, one for each element; those without a row are empty.
// REQUIRES rows that ascend by column, the sky last; throws ContractViolation otherwise (ExchangeMatrix::assign).
ExchangeMatrix matrix_of_rows(const std::vector<Element>& elements, const std::vector<std::vector<FactorEntry>>& rows);

// The factors of one row while they are summed. One object serves many rows, one after the other.
// COST: that of the columns that receive something; 8 bytes a column.
class RowSums {
 public:
  explicit RowSums(std::size_t columns) : sums_(columns, 0) {}

  void add(std::uint32_t column, double amount) {  // REQUIRES amount >= 0
    if (amount == 0) return;
    if (sums_[column] == 0) touched_.push_back(column);
    sums_[column] += amount;
  }
  // Divides all sums. REQUIRES a divisor other than 0.
  void divide_by(double divisor) {
    for (const std::uint32_t column : touched_) sums_[column] /= divisor;
  }
  // Moves out what is not 0, by ascending columns, with visibilities NaN; all sums are 0 afterwards.
  std::vector<FactorEntry> take();

 private:
  std::vector<double> sums_;
  std::vector<std::uint32_t> touched_;  // columns that are not 0
};

// Fills the row of an element: adds F(from, j) to column j, the sky last. `by` is empty when it is called.
using FillRow = std::function<void(std::uint32_t from, RowSums& by)>;

// Returns the matrix of the rows that are wanted, estimated; an entry for each factor that is not 0. `make_fill` is
// called for every range of rows, by the thread that fills them.
//
//   (1) an element whose row is not wanted has an empty one
//   (2) the result does not depend on the number of threads where what `fill` adds does not
// COST: parallel over rows. Stops when it is interrupted.
// progress: fraction of the rows done, from any thread; may throw to stop.
ExchangeMatrix matrix_by_rows(const std::vector<Element>& elements,
                              const std::function<bool(std::uint32_t element)>& wants_row,
                              const std::function<void(double)>& progress, const std::function<FillRow()>& make_fill);

}  // namespace hottel

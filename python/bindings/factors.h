// View factors as Python holds them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "python/bindings/arrays.h"

namespace hottel::python {

// A matrix that has visibilities too, and the pairs that are hidden.
struct MatrixWithVisibility {
  std::shared_ptr<const ExchangeMatrix> matrix;
  std::vector<ElementPair> hidden;
};

// A matrix of view factors, and arrays of it, each made when it is first asked for. REQUIRES the lock of the
// interpreter for every function.
class PythonFactors {
 public:
  using WithVisibility = std::function<MatrixWithVisibility()>;
  // Why no factors of a pair that has no entry: it is proven to exchange nothing, or the method does not say.
  PythonFactors(std::shared_ptr<const ExchangeMatrix> matrix, bool proves_zeros, WithVisibility with_visibility)
      : matrix_(std::move(matrix)), proves_zeros_(proves_zeros), with_visibility_(std::move(with_visibility)) {}

  const ExchangeMatrix& matrix() const { return *matrix_; }
  bool proves_zeros() const { return proves_zeros_; }
  // "factor", "lower", "upper" or "visibility" of all pairs, rows from, columns to, the sky last.
  py::array dense(const std::string& quantity) const;
  // The same of those with an entry, in the order of rows: the numbers of the matrix itself, or those made of them.
  py::array entries(const std::string& quantity) const;
  // Where the entries of each row begin, and their columns, as scipy.sparse takes them; the columns are those of the
  // matrix itself. The sky has a row without entries.
  std::pair<py::array, py::array> places() const;
  const MatrixWithVisibility& visibility() const;

 private:
  const std::shared_ptr<const ExchangeMatrix>& matrix_with(const std::string& quantity) const;
  std::vector<double> dense_values(const std::string& quantity) const;

  std::shared_ptr<const ExchangeMatrix> matrix_;
  bool proves_zeros_;
  WithVisibility with_visibility_;
  mutable std::optional<MatrixWithVisibility> visibility_;
  mutable py::dict dense_, bounds_;  // those that were asked for, by quantity
};

}  // namespace hottel::python

#include "solver/compare/matrix_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/support/failure.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

// Calls visit(PairError) for each pair that is present in either matrix, by from, then to.
template <class Visit>
void for_each_pair(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, const Visit& visit) {
  HOTTEL_REQUIRE(matrix.size() == exact.size());
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    const auto found = matrix.row(i), wanted = exact.row(i);
    auto f = found.begin();
    const auto found_before = [&](std::uint32_t column) {
      for (; f != found.end() && f->to < column; ++f)
        if (f->factor.value != 0) visit(PairError{i, f->to, f->factor.value, 0});
    };
    for (const FactorEntry& entry : wanted) {
      found_before(entry.to);
      const bool has = f != found.end() && f->to == entry.to;
      visit(PairError{i, entry.to, has ? (f++)->factor.value : 0, entry.factor.value});
    }
    found_before(exact.sky() + 1);
  }
}

}  // namespace

double PairError::error() const {
  return std::isfinite(value) ? std::abs(value - exact) : std::numeric_limits<double>::infinity();
}

MatrixErrors matrix_errors(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  MatrixErrors errors;
  long double squares = 0;  // its exponents hold the square of any double
  for_each_pair(matrix, exact, [&](const PairError& pair) {
    const double error = pair.error();
    errors.max = std::max(errors.max, error);
    squares += static_cast<long double>(error) * error;
    ++errors.pairs;
  });
  if (errors.pairs > 0) errors.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(errors.pairs)));
  errors.closure = closure_defect(matrix);
  return errors;
}

std::vector<PairError> worst_pairs(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, std::size_t count) {
  std::vector<PairError> worst;  // a heap, the least bad pair on top
  const auto is_worse = [](const PairError& a, const PairError& b) {
    if (a.error() != b.error()) return a.error() > b.error();
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  };
  if (count == 0) return worst;
  for_each_pair(matrix, exact, [&](const PairError& pair) {
    if (pair.error() == 0) return;
    if (worst.size() == count) {
      if (!is_worse(pair, worst.front())) return;
      std::pop_heap(worst.begin(), worst.end(), is_worse);
      worst.pop_back();
    }
    worst.push_back(pair);
    std::push_heap(worst.begin(), worst.end(), is_worse);
  });
  std::sort_heap(worst.begin(), worst.end(), is_worse);
  return worst;
}

}  // namespace hottel

#include "solver/compare/matrix_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/name.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

// Calls visit(PairError) for each pair that is present in either matrix and has a place, by from, then to.
template <class Visit>
void for_each_pair(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, const WrittenFactors& places,
                   const Visit& visit_any) {
  const auto visit = [&](const PairError& pair) {
    if (places.has_place(pair.from, pair.to)) visit_any(pair);
  };
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

// Rows by which light leaves and columns to which it goes, that have no place.
void count_missing(const ExchangeMatrix& exact, const WrittenFactors& places, MissingFactors& missing) {
  std::vector<char> is_column(exact.size() + 1, 0);
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    bool is_row = false;
    for (const FactorEntry& entry : exact.row(i)) {
      if (entry.factor.value == 0) continue;
      is_row = is_row || places.has_column.empty() || places.has_column[entry.to];
      if (!places.has_column.empty() && !places.has_column[entry.to]) is_column[entry.to] = 1;
    }
    if (is_row && !places.has_row.empty() && !places.has_row[i]) missing.rows.push_back(i);
  }
  for (std::uint32_t j = 0; j < is_column.size(); ++j)
    if (is_column[j]) missing.columns.push_back(j);
}

// As closure_defect(), over the rows and columns there are.
double closure_of(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, const WrittenFactors& places) {
  if (places.is_whole()) return closure_defect(matrix);
  double largest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i) || (!places.has_row.empty() && !places.has_row[i])) continue;
    long double defect = 0;
    for (const FactorEntry& entry : matrix.row(i)) defect += entry.factor.value;
    for (const FactorEntry& entry : exact.row(i))
      if (places.has_place(i, entry.to)) defect -= entry.factor.value;
    largest = std::max(largest, static_cast<double>(std::abs(defect)));
  }
  return largest;
}

}  // namespace

double PairError::error() const {
  return std::isfinite(value) ? std::abs(value - exact) : std::numeric_limits<double>::infinity();
}

MatrixErrors matrix_errors(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, const WrittenFactors& places) {
  MatrixErrors errors;
  count_missing(exact, places, errors.missing);
  long double squares = 0;  // its exponents hold the square of any double
  for_each_pair(matrix, exact, places, [&](const PairError& pair) {
    const double error = pair.error();
    errors.max = std::max(errors.max, error);
    if (pair.value == 0 && pair.exact > 0) {
      ++errors.missing.pairs;
      errors.missing.largest = std::max(errors.missing.largest, pair.exact);
    } else {
      errors.max_of_others = std::max(errors.max_of_others, error);
    }
    squares += static_cast<long double>(error) * error;
    ++errors.pairs;
  });
  if (errors.pairs > 0) errors.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(errors.pairs)));
  errors.closure = closure_of(matrix, exact, places);
  if (errors.pairs == 0 && !places.is_whole())
    errors.max = errors.rms = errors.closure = std::numeric_limits<double>::quiet_NaN();
  return errors;
}

std::vector<std::string> missing_sentences(const MatrixErrors& errors, const ExchangeMatrix& exact) {
  const MissingFactors& missing = errors.missing;
  const auto names = [&](const std::vector<std::uint32_t>& elements) {
    std::vector<std::string> all;
    for (const std::uint32_t i : elements) all.push_back(exact.name(i));
    return listed_names(all);
  };
  std::vector<std::string> sentences;
  if (!missing.rows.empty())
    sentences.push_back(fmt::format("there {} no {} of {}: errors are of the other rows, and radiosities are without",
                                    missing.rows.size() == 1 ? "is" : "are", missing.rows.size() == 1 ? "row" : "rows",
                                    names(missing.rows)));
  if (!missing.columns.empty())
    sentences.push_back("errors leave out what goes to " + names(missing.columns) + ", which has no place in the file");
  if (missing.pairs > 0)
    sentences.push_back(fmt::format(
        "{} 0 or left out where light goes, the largest of an exact factor of {:.3g}; the others are off by up to "
        "{:.3g}",
        counted(missing.pairs, "pair") + (missing.pairs == 1 ? " is" : " are"), missing.largest, errors.max_of_others));
  return sentences;
}

std::vector<PairError> worst_pairs(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, std::size_t count,
                                   const WrittenFactors& places) {
  std::vector<PairError> worst;  // a heap, the least bad pair on top
  const auto is_worse = [](const PairError& a, const PairError& b) {
    if (a.error() != b.error()) return a.error() > b.error();
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  };
  if (count == 0) return worst;
  for_each_pair(matrix, exact, places, [&](const PairError& pair) {
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

// Rows and columns at the places of others: shifted, or in another order each by themselves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/name.h"
#include "solver/compare/hypotheses.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostShuffled = 500;
constexpr int kFarthestShift = 3;
constexpr std::uint64_t kFewestFactors = 3;

// Elements in an order that goes round, and the place of each; the sky may be among them.
struct Ring {
  std::vector<std::uint32_t> elements;
  std::vector<std::size_t> place;  // by element, the sky last; elements.size() where it is none of them

  Ring(std::vector<std::uint32_t> of, std::uint32_t sky) : elements(std::move(of)), place(sky + 1, elements.size()) {
    for (std::size_t k = 0; k < elements.size(); ++k) place[elements[k]] = k;
  }
  std::uint32_t moved(std::uint32_t element, int by) const {
    if (place[element] == elements.size()) return element;
    const auto n = static_cast<int>(elements.size());
    return elements[static_cast<std::size_t>((static_cast<int>(place[element]) + by % n + n) % n)];
  }
};

std::vector<Ring> rings(const ExchangeMatrix& exact) {
  std::vector<std::uint32_t> all, with_row;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    all.push_back(i);
    if (exact.has_row(i)) with_row.push_back(i);
  }
  std::vector<std::uint32_t> and_sky = all;
  and_sky.push_back(exact.sky());
  return {{std::move(and_sky), exact.sky()}, {std::move(all), exact.sky()}, {std::move(with_row), exact.sky()}};
}

// What stands in a row of the exact matrix; nothing in that of the sky, or of a face without one.
double factor(const ExchangeMatrix& exact, std::uint32_t from, std::uint32_t to) {
  return from == exact.sky() ? 0 : exact.factor(from, to).value;
}

Hypothesis shifted_by(const JudgedPairs& judged, const Ring& ring, int rows, int columns, std::uint64_t& factors) {
  Hypothesis result = explains_nothing(Fault::kShifted, judged);
  factors = 0;
  for (const JudgedPair& pair : judged.pairs()) {
    if (!pair.is_off) continue;
    const double with = factor(judged.exact(), ring.moved(pair.from, rows), ring.moved(pair.to, columns));
    if (!judged.agrees(pair, with)) continue;
    result.explains[judged.index_of(pair)] = 1;
    factors += with != 0;
  }
  return result;
}

// Numbers by row and column, the sky last.
struct Dense {
  std::size_t rows = 0, columns = 0;
  std::vector<double> found, exact;
  std::vector<char> is_off;  // by row

  double at(const std::vector<double>& values, std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

// `is_of_columns`: turned, so that a row of it is a column.
Dense dense(const JudgedPairs& judged, bool is_of_columns) {
  const std::size_t n = judged.exact().size() + std::size_t{1};
  Dense result{n, n, std::vector<double>(n * n, 0), std::vector<double>(n * n, 0), std::vector<char>(n, 0)};
  for (const JudgedPair& pair : judged.pairs()) {
    const std::size_t i = is_of_columns ? pair.to : pair.from, j = is_of_columns ? pair.from : pair.to;
    result.found[i * n + j] = pair.value;
    result.exact[i * n + j] = pair.exact;
    result.is_off[i] |= static_cast<char>(pair.is_off);
  }
  return result;
}

Hypothesis permuted(const JudgedPairs& judged, bool is_of_columns) {
  const Fault fault = is_of_columns ? Fault::kColumnsPermuted : Fault::kRowsPermuted;
  Hypothesis result = explains_nothing(fault, judged);
  const ExchangeMatrix& exact = judged.exact();
  if (judged.off() < 2 || exact.size() > kMostShuffled) return result;
  const Dense numbers = dense(judged, is_of_columns);
  const auto is_same = [&](std::size_t row, std::size_t as) {
    for (std::size_t j = 0; j < numbers.columns; ++j) {
      const double value = numbers.at(numbers.found, row, j);
      if (std::abs(value - numbers.at(numbers.exact, as, j)) > judged.tolerance(value)) return false;
    }
    return true;
  };
  std::optional<std::pair<std::uint32_t, std::uint32_t>> example;
  std::size_t moved = 0;
  for (std::size_t row = 0; row < numbers.rows; ++row) {
    if (!numbers.is_off[row]) continue;
    std::size_t as = 0;
    while (as < numbers.rows && !is_same(row, as)) ++as;
    if (as == numbers.rows) return result;
    ++moved;
    const bool has_numbers =
        std::any_of(numbers.found.begin() + static_cast<std::ptrdiff_t>(row * numbers.columns),
                    numbers.found.begin() + static_cast<std::ptrdiff_t>((row + 1) * numbers.columns),
                    [](double value) { return value != 0; });
    if (!example && has_numbers) example = {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(as)};
  }
  if (moved < 2 || !example) return result;
  for (const JudgedPair& pair : judged.pairs()) result.explains[judged.index_of(pair)] = pair.is_off;
  const char* const noun = is_of_columns ? "column" : "row";
  result.words = fmt::format(
      "only the {}s are in another order, the {}s are as they should be: what stands in the {} of {} is "
      "that of {}",
      noun, is_of_columns ? "row" : "column", noun, quoted_name(exact.name(example->first)),
      quoted_name(exact.name(example->second)));
  return result;
}

}  // namespace

Hypothesis suppose_shifted(const JudgedPairs& judged) {
  Hypothesis best = explains_nothing(Fault::kShifted, judged);
  std::uint64_t most = 0;
  for (const Ring& ring : rings(judged.exact())) {
    if (ring.elements.size() < 2) continue;
    for (int by = -kFarthestShift; by <= kFarthestShift; ++by) {
      for (const auto& [rows, columns, what] :
           {std::tuple(by, by, "rows and columns"), std::tuple(by, 0, "only the rows"),
            std::tuple(0, by, "only the columns")}) {
        std::uint64_t factors = 0;
        Hypothesis each = by == 0 ? best : shifted_by(judged, ring, rows, columns, factors);
        if (by == 0 || factors < kFewestFactors || each.count() <= most || 10 * each.count() < 9 * judged.off())
          continue;
        most = each.count();
        best = std::move(each);
        const std::uint32_t first = ring.elements.front();
        best.words = fmt::format("indices are shifted, {} by {}: what stands at {} is that of {}", what, std::abs(by),
                                 quoted_name(judged.exact().name(first)),
                                 quoted_name(judged.exact().name(ring.moved(first, by))));
      }
    }
  }
  return best;
}

Hypothesis suppose_rows_permuted(const JudgedPairs& judged) { return permuted(judged, false); }

Hypothesis suppose_columns_permuted(const JudgedPairs& judged) { return permuted(judged, true); }

}  // namespace hottel

// The pairs that files of view factors list, and what all of these files say of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/row_ranges.h"
#include "io/results/factor_table.h"

namespace hottel {

// Whether a list that is empty for all has a label.
inline bool is_asked(const std::vector<std::uint32_t>& only, std::uint32_t label) {
  return only.empty() || std::binary_search(only.begin(), only.end(), label);
}

// Calls visit(from, entry, its bounds, its guarantee) for every pair that the table lists in rows from `first` up to
// `end`, by from, then to: those with a factor, and the hidden ones with factor and visibility 0, exactly.
template <class Visit>
void for_each_listed(const FactorTable& table, std::uint32_t first, std::uint32_t end, const Visit& visit_asked) {
  const auto visit = [&](std::uint32_t from, const FactorEntry& entry, const Enclosure& bounds, Guarantee guarantee) {
    if (is_asked(table.only_rows, from) && is_asked(table.only_columns, entry.to))
      visit_asked(from, entry, bounds, guarantee);
  };
  auto hidden = std::lower_bound(table.hidden.begin(), table.hidden.end(), ElementPair{first, 0});
  for (std::uint32_t i = first; i < end; ++i) {
    const auto hidden_before = [&](std::uint32_t to) {
      for (; hidden != table.hidden.end() && hidden->first == i && hidden->second < to; ++hidden)
        visit(i, FactorEntry{hidden->second, Rounded{}, 0}, Enclosure{0, 0}, Guarantee::kExact);
    };
    const auto row = table.matrix.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      hidden_before(row[k].to);
      visit(i, row[k], table.matrix.bounds(i, k), table.matrix.guarantee(i, k));
    }
    hidden_before(table.matrix.sky() + 1);
  }
}

// Calls visit(first, end) for ranges of rows, which are there then, in their order.
template <class Visit>
void for_each_range(const FactorTable& table, const Visit& visit) {
  if (table.ranges == nullptr) return visit(std::uint32_t{0}, table.matrix.size());
  for (std::size_t k = 0; k < table.ranges->count(); ++k) {
    const RowRange rows = table.ranges->load(k);
    visit(rows.first, rows.end);
  }
}

template <class Visit>
void for_each_listed(const FactorTable& table, const Visit& visit) {
  for_each_range(table, [&](std::uint32_t first, std::uint32_t end) { for_each_listed(table, first, end, visit); });
}

// How many pairs each row lists.
std::vector<std::uint64_t> listed_counts(const FactorTable& table);

// The names of all elements and the sky, as a csv holds them.
std::vector<std::string> csv_names(const ExchangeMatrix& matrix);

std::string area_of(const ExchangeMatrix& matrix, std::uint32_t label);

}  // namespace hottel

#include "io/results/view_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/rational.h"

namespace hottel {

void merge_columns(ViewEntries& entries) {
  std::ranges::stable_sort(entries, {}, &ViewEntries::value_type::first);
  std::size_t last = 0;
  for (std::size_t k = 1; k < entries.size(); ++k) {
    if (entries[k].first == entries[last].first)
      entries[last].second += entries[k].second;
    else
      entries[++last] = entries[k];
  }
  if (!entries.empty()) entries.resize(last + 1);
}

std::string view_matrix_head(const std::string& what_rows_are, std::uint64_t rows, std::uint64_t columns,
                             std::uint64_t entries, std::uint64_t in_solids) {
  return fmt::format(
      "%%MatrixMarket matrix coordinate real general\n"
      "% fraction of all directions in which the centre of a cell (row) sees an element (column)\n"
      "% rows: {}, as in illumination.npy\n"
      "% columns: as in the .faces.csv beside this file, the sky last\n"
      "% {} of {} rows have no entries: the centres of these cells lie in solids\n"
      "{} {} {}\n",
      what_rows_are, in_solids, rows, rows, columns, entries);
}

std::string view_row_text(std::uint64_t number, const ViewEntries& entries) {
  std::string text;
  for (const auto& [column, fraction] : entries)
    text += fmt::format("{} {} {}\n", number, column + 1, shortest(fraction));
  return text;
}

}  // namespace hottel

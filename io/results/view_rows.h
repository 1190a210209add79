// The matrix of what the cells of a grid see, in whatever dimension, as text of Matrix Market.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hottel {

// A row: columns from 0, each with the fraction of all directions that it has.
using ViewEntries = std::vector<std::pair<std::uint32_t, double>>;

// Each column once, ascending. What is seen in several places is summed in their order.
void merge_columns(ViewEntries& entries);

// `coordinate real general`; rows: what they are, "3 x 2 cells, ..."; so many of them have no entries.
std::string view_matrix_head(const std::string& what_rows_are, std::uint64_t rows, std::uint64_t columns,
                             std::uint64_t entries, std::uint64_t in_solids);

// The lines of a row by its number from 1, a line an entry, columns from 1.
std::string view_row_text(std::uint64_t number, const ViewEntries& entries);

}  // namespace hottel

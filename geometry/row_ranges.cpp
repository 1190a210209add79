#include "geometry/row_ranges.h"

namespace hottel {

ExchangeMatrix whole_matrix(RowRanges& rows, const std::shared_ptr<const FolderMemory>& memory) {
  ExchangeMatrix result(rows.matrix().elements(), rows.matrix().guarantee());
  FactorEntries entries(memory);
  entries.reserve(rows.begins().back());
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const RowRange range = rows.load(k);
    for (std::uint32_t row = range.first; row < range.end; ++row) entries.append(rows.matrix().row(row));
  }
  result.assign({rows.begins().begin(), rows.begins().end()}, std::move(entries));
  return result;
}

}  // namespace hottel

#include "io/results/plane/light_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "io/results/view_rows.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/light_rows.h"

namespace hottel {
namespace {

constexpr std::size_t kRowsAtATime = 512;
constexpr std::uint64_t kBytesOfANumber = 20;  // the shortest decimals of most fractions

// As they were told, by column.
void collect(const LightRow2& row, ViewEntries& entries) {
  entries.clear();
  for (std::size_t k = 0; k < row.columns.size(); ++k) entries.emplace_back(row.columns[k], row.fractions[k]);
  merge_columns(entries);
}

}  // namespace

LightMatrixSize light_matrix_size(const LightMatrix2& matrix, const std::function<void(double)>& progress) {
  std::atomic<std::uint64_t> entries = 0, in_solids = 0;
  for_each_light_row(matrix.prepared, matrix.grid, matrix.table, Blacks2::kListed, progress,
                     [&](std::size_t, const LightRow2& row) {
                       thread_local ViewEntries of_row;
                       collect(row, of_row);
                       entries += of_row.size();
                       in_solids += row.is_in_solid ? 1 : 0;
                     });
  return {entries, in_solids};
}

std::uint64_t light_matrix_bytes(const LightMatrix2& matrix, const LightMatrixSize& size) {
  const auto digits = [](std::uint64_t number) { return fmt::formatted_size("{}", number); };
  return size.entries * (digits(matrix.rows()) + digits(matrix.columns()) + kBytesOfANumber + 3);
}

void write_light_matrix_mtx(const LightMatrix2& matrix, const LightMatrixSize& size,
                            const std::function<void(double)>& progress, const Sink& sink) {
  sink(view_matrix_head(fmt::format("{} x {} cells, iy * {} + ix + 1 with iy = 0 the lowest", matrix.grid.nx,
                                    matrix.grid.ny, matrix.grid.nx),
                        matrix.rows(), matrix.columns(), size.entries, size.in_solids));
  for_each_light_band(matrix.prepared, matrix.grid, matrix.table, Blacks2::kListed, matrix.memory, progress,
                      [&](std::size_t first, const LightRowBlock2& rows) {
                        for (std::size_t begin = 0; begin < rows.size(); begin += kRowsAtATime) {
                          std::vector<std::string> texts(std::min(kRowsAtATime, rows.size() - begin));
                          parallel_for(texts.size(), [&](std::size_t k) {
                            thread_local ViewEntries entries;
                            collect(rows.row(begin + k), entries);
                            texts[k] = view_row_text(first + begin + k + 1, entries);
                          });
                          for (const std::string& text : texts) sink(text);
                        }
                      });
}

}  // namespace hottel

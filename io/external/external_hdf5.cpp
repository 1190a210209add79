// A matrix in an HDF5 file, its rows in compressed arrays: hottel's own, or one of others who lay theirs out so.
#include <algorithm>
#include <cmath>
#include <limits>

#include "io/external/external_file.h"
#include "io/files/hdf5.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint64_t kNewestLayout = 1;

class CompressedRows {
 public:
  CompressedRows(const std::string& file, const Hdf5Reader& reader) : reader_(reader) { matrix_.file = file; }
  ExternalMatrix read();

 private:
  [[noreturn]] void refuse(const std::string& text) const { throw InputError({matrix_.file, 0}, text); }
  void require_ours() const;
  void read_names();
  void read_rows(const std::vector<std::uint64_t>& begin);
  double factor_at(std::uint64_t k, std::uint32_t row) const;

  const Hdf5Reader& reader_;
  std::vector<std::uint64_t> columns_;
  std::vector<double> factors_;
  ExternalMatrix matrix_;
};

void CompressedRows::require_ours() const {
  for (const char* array : {"begin", "column", "factor"})
    if (!reader_.has(array))
      throw InputError({matrix_.file, 0}, "holds no view factors: there is no array `" + std::string(array) + "`",
                       {"a matrix is its compressed rows: `begin`, `column` and `factor`"});
  const std::uint64_t layout = reader_.said_number("layout").value_or(kNewestLayout);
  if (layout != kNewestLayout)
    refuse("has the layout " + std::to_string(layout) + ", and this hottel reads " + std::to_string(kNewestLayout));
}

// Names make it a list of pairs, whose places are found by name.
void CompressedRows::read_names() {
  if (!reader_.has("names")) return;
  std::vector<std::string> names = reader_.texts("names");
  if (names.size() != matrix_.rows)
    refuse("has " + std::to_string(matrix_.rows) + " rows and " + std::to_string(names.size()) + " names");
  for (std::string& name : names) matrix_.row_names.push_back({std::move(name), 0});
  matrix_.column_names = matrix_.row_names;
  matrix_.names_file = matrix_.file;
  matrix_.is_list = true;
  matrix_.has_row.assign(matrix_.rows, 1);
  matrix_.has_column.assign(matrix_.rows, 1);
}

double CompressedRows::factor_at(std::uint64_t k, std::uint32_t row) const {
  if (columns_[k] >= matrix_.columns)
    refuse("row " + std::to_string(row) + " has the column " + std::to_string(columns_[k]) + " of " +
           std::to_string(matrix_.columns));
  if (!std::isfinite(factors_[k]))
    refuse("the number in row " + std::to_string(row) + ", column " + std::to_string(columns_[k]) +
           " is not finite (rows and columns from 0)");
  return factors_[k];
}

void CompressedRows::read_rows(const std::vector<std::uint64_t>& begin) {
  const bool has_part = reader_.said_text("rows") == "chosen";
  matrix_.entries.reserve(factors_.size());
  for (std::uint32_t row = 0; row < matrix_.rows; ++row) {
    if (has_part && matrix_.is_list) matrix_.has_row[row] = begin[row] < begin[row + 1];
    for (std::uint64_t k = begin[row]; k < begin[row + 1]; ++k)
      matrix_.entries.push_back({row, static_cast<std::uint32_t>(columns_[k]), 0, factor_at(k, row)});
  }
}

ExternalMatrix CompressedRows::read() {
  require_ours();
  const std::vector<std::uint64_t> begin = reader_.whole_numbers("begin");
  columns_ = reader_.whole_numbers("column");
  factors_ = reader_.numbers("factor");
  if (begin.size() < 2 || begin.size() - 1 > std::numeric_limits<std::int32_t>::max()) refuse("has no rows");
  if (columns_.size() != factors_.size())
    refuse("has " + std::to_string(columns_.size()) + " columns and " + std::to_string(factors_.size()) + " factors");
  if (begin.front() != 0 || begin.back() != factors_.size() || !std::is_sorted(begin.begin(), begin.end()))
    refuse("its rows do not begin one after the other, from 0 to the number of its factors");
  matrix_.rows = matrix_.columns = static_cast<std::uint32_t>(begin.size() - 1);
  matrix_.digits.relative = std::numeric_limits<double>::epsilon() / 2;
  read_names();
  read_rows(begin);
  if (reader_.has("area")) matrix_.areas = reader_.numbers("area");
  if (!matrix_.areas.empty() && matrix_.areas.size() != matrix_.rows)
    refuse("has " + std::to_string(matrix_.rows) + " rows and " + std::to_string(matrix_.areas.size()) + " areas");
  return std::move(matrix_);
}

}  // namespace

ExternalMatrix read_hdf5(const std::string& file, std::string_view text) {
  return CompressedRows(file, Hdf5Reader(file, text)).read();
}

}  // namespace hottel

// A matrix in NumPy's format.
#include <cmath>

#include "io/external/external_file.h"
#include "io/external/numpy_array.h"
#include "kernel/support/failure.h"

namespace hottel {

ExternalMatrix read_numpy(const std::string& file, std::string_view text) {
  const NumpyArray array = parse_numpy(file, text, 2);
  ExternalMatrix matrix;
  matrix.file = file;
  matrix.rows = array.shape[0];
  matrix.columns = array.shape[1];
  matrix.digits.relative = array.relative_rounding();
  const std::uint32_t inner = array.is_by_columns ? matrix.rows : matrix.columns;
  for (std::uint64_t k = 0; k < array.count(); ++k) {
    const double value = array.number(k);
    if (value == 0) continue;
    const auto outer_index = static_cast<std::uint32_t>(k / inner), inner_index = static_cast<std::uint32_t>(k % inner);
    const std::uint32_t row = array.is_by_columns ? inner_index : outer_index;
    const std::uint32_t column = array.is_by_columns ? outer_index : inner_index;
    if (!std::isfinite(value))
      throw InputError({file, 0}, "the number in row " + std::to_string(row + 1) + ", column " +
                                      std::to_string(column + 1) + " is not finite");
    matrix.entries.push_back({row, column, 0, value});
  }
  return matrix;
}

}  // namespace hottel

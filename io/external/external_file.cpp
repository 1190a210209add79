#include "io/external/external_file.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/name.h"
#include "io/external/sidecar_names.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Sorts the entries, leaves zeros out, and refuses a place that is given twice.
void put_in_order(ExternalMatrix& matrix) {
  std::vector<ExternalEntry>& entries = matrix.entries;
  std::sort(entries.begin(), entries.end(), [](const ExternalEntry& a, const ExternalEntry& b) {
    return std::tie(a.row, a.column, a.line) < std::tie(b.row, b.column, b.line);
  });
  for (std::size_t k = 1; k < entries.size(); ++k) {
    const ExternalEntry &before = entries[k - 1], &entry = entries[k];
    if (before.row != entry.row || before.column != entry.column) continue;
    const std::string what =
        matrix.row_names.empty()
            ? "row " + std::to_string(entry.row + 1) + ", column " + std::to_string(entry.column + 1)
            : "from " + quoted_name(matrix.row_names[entry.row].name) + " to " +
                  quoted_name(matrix.column_names[entry.column].name);
    throw InputError({matrix.file, entry.line},
                     "the factor " + what + " is given twice, first in line " + std::to_string(before.line));
  }
  std::erase_if(entries, [](const ExternalEntry& entry) { return entry.value == 0; });
}

// Names from FILE.faces.csv, or beside a NumPy array from FILE.json, where the file itself has none.
void name_faces(ExternalMatrix& matrix, bool is_numpy) {
  if (matrix.is_list || !matrix.column_names.empty()) return;
  std::string beside = matrix.file + ".faces.csv";
  std::vector<ExternalName> names;
  std::error_code ignored;
  if (std::filesystem::exists(beside, ignored)) {
    names = read_faces_csv(beside, read_text_file(beside));
  } else {
    if (!is_numpy) return;
    beside = matrix.file + ".json";
    for (std::string& name : sidecar_names(beside)) names.push_back({std::move(name), 0});
    if (names.empty()) return;
  }
  if (names.size() != matrix.columns || matrix.rows > names.size())
    throw InputError({beside, 0}, "names " + std::to_string(names.size()) + " faces for a matrix of " +
                                      std::to_string(matrix.rows) + " x " + std::to_string(matrix.columns));
  matrix.names_file = beside;
  matrix.column_names = names;
  names.resize(matrix.rows);
  matrix.row_names = std::move(names);
}

// By the reader of its format.
ExternalMatrix read_as_written(const std::filesystem::path& file, std::string_view text) {
  const std::string name = file.string();
  switch (external_kind(file, text)) {
    case ExternalKind::kMatrixMarket:
      return read_matrix_market(name, text);
    case ExternalKind::kNumpy:
      return read_numpy(name, text);
    case ExternalKind::kView3d:
      return read_view3d(name, text);
    case ExternalKind::kHdf5:
      return read_hdf5(name, text);
    case ExternalKind::kPairList:
      return read_pair_list(name, text);
    case ExternalKind::kDenseCsv:
      return read_dense_csv(name, text);
    case ExternalKind::kRadiosity:
      throw InputError({name, 1}, "holds radiosities, not view factors");
    case ExternalKind::kUnknown:
      break;
  }
  throw InputError(
      {name, 0}, text.empty() ? "is empty" : "holds no view factors in a format that hottel reads",
      {"hottel reads csv, Matrix Market (%%MatrixMarket), NumPy (.npy), HDF5 (.h5) and View3D's text and binary output",
       "each is told by its first bytes, csv by the ending .csv, or .txt where it begins with numbers"});
}

}  // namespace

ExternalMatrix parse_external_matrix(const std::filesystem::path& file, std::string_view text) {
  ExternalMatrix matrix = read_as_written(file, text);
  put_in_order(matrix);
  return matrix;
}

ExternalMatrix read_external_matrix(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  ExternalMatrix matrix = parse_external_matrix(file, text);
  name_faces(matrix, external_kind(file, text) == ExternalKind::kNumpy);
  return matrix;
}

}  // namespace hottel

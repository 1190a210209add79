// View factors that another program computed, as its file has them: before they are matched with a scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "solver/compare/method_report.h"

namespace hottel {

// One number of a file, with its place in the matrix, from 0, and its line, from 1.
struct ExternalEntry {
  std::uint32_t row = 0, column = 0;
  int line = 0;  // 0 in binary formats
  double value = 0;
};

// A face that the file names, and where.
struct ExternalName {
  std::string name;
  int line = 0;
};

// A matrix of numbers, sparse.
//
//   (1) entries are finite and not 0, ascend by row, then column, and no place has two
//   (2) memory is proportional to the size of the file, whatever its head claims
struct ExternalMatrix {
  std::string file;
  std::uint32_t rows = 0, columns = 0;

  // Empty when nothing names its faces: then they are in the order of the scene.
  std::vector<ExternalName> row_names, column_names;
  std::string names_file;        // FILE, FILE.faces.csv or FILE.json
  bool is_list = false;          // a list of pairs: what it leaves out is 0
  std::vector<char> has_row;     // of a list: which of the names stand before a factor; else empty
  std::vector<char> has_column;  // and which behind one

  std::vector<ExternalEntry> entries;
  std::vector<double> areas;  // by row, where the format has them
  WrittenDigits digits;
  std::vector<std::string> notes;
};

// Reads a matrix. What it is shows in its first bytes:
//
//   %%MatrixMarket      coordinate or array, real or integer, general or symmetric
//   \x93NUMPY           float64 or float32, C or Fortran order, two dimensions
//   View3D              text (out=0) or binary (out=1)
//   \x89HDF             HDF5: rows in compressed arrays `begin`, `column`, `factor`, perhaps `names` and `area`
//   csv with a head     `from`, `to` and `factor` among its columns: a list of pairs
//   other csv           dense: names in the first row and column, or numbers alone
//
// Faces of a file without names are named by FILE.faces.csv, if there is one (columns `face`, perhaps `index` from 1,
// and `element`), those of a NumPy array else by the sidecar FILE.json (sidecar_names.h).
//
// Throws InputError (with the line, where there is one) for what is none of these or breaks off, for numbers that are
// not finite, for places given twice. COST: one pass; the file is held in memory.
ExternalMatrix read_external_matrix(const std::filesystem::path& file);

// The same from the text of a file; FILE.faces.csv is not looked for.
ExternalMatrix parse_external_matrix(const std::filesystem::path& file, std::string_view text);

// What a file holds, judged by its first bytes and, for csv, by the names of its columns.
enum class ExternalKind { kMatrixMarket, kNumpy, kView3d, kHdf5, kPairList, kDenseCsv, kRadiosity, kUnknown };
ExternalKind external_kind(const std::filesystem::path& file, std::string_view text);

// One reader a format, of the file's whole text; property (1) is not yet there.
ExternalMatrix read_matrix_market(const std::string& file, std::string_view text);
ExternalMatrix read_numpy(const std::string& file, std::string_view text);
ExternalMatrix read_hdf5(const std::string& file, std::string_view text);
ExternalMatrix read_view3d(const std::string& file, std::string_view text);
ExternalMatrix read_pair_list(const std::string& file, std::string_view text);
ExternalMatrix read_dense_csv(const std::string& file, std::string_view text);
std::vector<ExternalName> read_faces_csv(const std::string& file, std::string_view text);

}  // namespace hottel

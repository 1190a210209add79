// Factors as csv: a list of pairs, or a dense matrix with or without names; and the names of faces beside a file.
#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "geometry/name.h"
#include "io/external/csv_reader.h"
#include "io/external/external_file.h"
#include "io/external/external_number.h"
#include "io/files/hdf5.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

using Record = std::vector<std::string_view>;

std::optional<std::size_t> column_called(const Record& head, std::string_view name) {
  const auto found = std::find(head.begin(), head.end(), name);
  return found == head.end() ? std::nullopt : std::optional<std::size_t>(found - head.begin());
}

bool is_number(std::string_view text) {
  text = trimmed(text, " \t");
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && end == text.data() + text.size() && error != std::errc::invalid_argument;
}

void require_fields(const CsvReader& csv, std::size_t count) {
  if (csv.fields().size() == count) return;
  throw InputError(csv.where(),
                   std::to_string(csv.fields().size()) + " fields where " + std::to_string(count) + " are expected");
}

// Two names and a number are an entry of a list of pairs, in which columns are told by the first line.
void refuse_headless_list(const FileLine& first_line, const Record& fields) {
  if (fields.size() < 3 || fields[0].empty() || is_number(fields[1]) || fields[1].empty() || !is_number(fields[2]))
    return;
  throw InputError(first_line, "the first line must be from,to,factor, or the names of a matrix' columns",
                   {"what follows begins with two names and a number: " + quoted_name(fields[0]) + ", " +
                    quoted_name(fields[1]) + ", " + quoted_name(fields[2])});
}

void require_distinct(const std::string& file, const std::vector<ExternalName>& names) {
  std::set<std::string_view> seen;
  for (const ExternalName& name : names)
    if (!seen.insert(name.name).second)
      throw InputError({file, name.line}, "the face " + quoted_name(name.name) + " is named twice");
}

// The csv of numbers that stand in rows; `skip` leading fields of each record are names.
void read_rows(CsvReader& csv, bool has_names, ExternalMatrix& matrix) {
  ExternalNumbers numbers(matrix.file);
  do {
    require_fields(csv, matrix.columns + (has_names ? 1u : 0u));
    const Record& fields = csv.fields();
    const int line = csv.where().line;
    if (has_names) matrix.row_names.push_back({std::string(fields[0]), line});
    for (std::uint32_t column = 0; column < matrix.columns; ++column)
      if (const double value = numbers.read(fields[column + (has_names ? 1 : 0)], line); value != 0)
        matrix.entries.push_back({matrix.rows, column, line, value});
    ++matrix.rows;
  } while (csv.next());
  matrix.digits = numbers.digits();
}

}  // namespace

ExternalKind external_kind(const std::filesystem::path& file, std::string_view text) {
  if (text.starts_with("\x93NUMPY")) return ExternalKind::kNumpy;
  if (text.starts_with("%%MatrixMarket")) return ExternalKind::kMatrixMarket;
  if (text.starts_with("View3D")) return ExternalKind::kView3d;
  if (is_hdf5(text)) return ExternalKind::kHdf5;
  const std::string ending = file.extension().string();
  for (const char* other : {".npy", ".mtx", ".bin", ".h5"})
    if (ending == other) return ExternalKind::kUnknown;
  if (ending != ".csv" && text.substr(0, 4096).find('\0') != std::string_view::npos) return ExternalKind::kUnknown;
  CsvReader csv(file.string(), text, csv_dialect_of(text));
  if (!csv.next()) return ExternalKind::kUnknown;
  // Of texts that are not called csv a table of numbers is one.
  if (ending == ".txt" && !std::all_of(csv.fields().begin(), csv.fields().end(), is_number))
    return ExternalKind::kUnknown;
  if (column_called(csv.fields(), "radiosity")) return ExternalKind::kRadiosity;
  if (column_called(csv.fields(), "from") && column_called(csv.fields(), "to")) return ExternalKind::kPairList;
  return ExternalKind::kDenseCsv;
}

ExternalMatrix read_pair_list(const std::string& file, std::string_view text) {
  CsvReader csv(file, text, csv_dialect_of(text));
  csv.next();
  const Record head = csv.fields();
  const auto from = column_called(head, "from"), to = column_called(head, "to"), factor = column_called(head, "factor");
  const std::size_t width = head.size();
  if (!factor) throw InputError(csv.where(), "a list of pairs needs a column 'factor' beside 'from' and 'to'");
  ExternalMatrix matrix;
  matrix.file = matrix.names_file = file;
  matrix.is_list = true;
  ExternalNumbers numbers(file);
  std::unordered_map<std::string, std::uint32_t> index;
  const auto index_of = [&](std::string_view name, int line) {
    const auto [place, is_new] = index.emplace(name, static_cast<std::uint32_t>(index.size()));
    if (is_new) matrix.row_names.push_back({place->first, line});
    return place->second;
  };
  while (csv.next()) {
    require_fields(csv, width);
    const Record& fields = csv.fields();
    const int line = csv.where().line;
    const std::uint32_t row = index_of(fields[*from], line), column = index_of(fields[*to], line);
    matrix.entries.push_back({row, column, line, numbers.read(fields[*factor], line)});
    matrix.has_row.resize(index.size(), 0);
    matrix.has_column.resize(index.size(), 0);
    matrix.has_row[row] = matrix.has_column[column] = 1;
  }
  matrix.rows = matrix.columns = static_cast<std::uint32_t>(index.size());
  matrix.column_names = matrix.row_names;
  matrix.digits = numbers.digits();
  return matrix;
}

ExternalMatrix read_dense_csv(const std::string& file, std::string_view text) {
  CsvReader csv(file, text, csv_dialect_of(text));
  csv.next();
  ExternalMatrix matrix;
  matrix.file = file;
  const bool has_names = !is_number(csv.fields()[0]);
  if (!has_names) {
    matrix.columns = static_cast<std::uint32_t>(csv.fields().size());
    read_rows(csv, false, matrix);
    return matrix;
  }
  matrix.names_file = file;
  for (const std::string_view name : csv.fields()) matrix.column_names.push_back({std::string(name), csv.where().line});
  matrix.column_names.erase(matrix.column_names.begin());
  matrix.columns = static_cast<std::uint32_t>(matrix.column_names.size());
  refuse_headless_list(csv.where(), csv.fields());
  if (matrix.columns == 0 || !csv.next())
    throw InputError(csv.where(),
                     "is no list of pairs (from,to,factor) and no matrix with names in its first row and "
                     "column");
  refuse_headless_list({file, matrix.column_names.front().line}, csv.fields());
  read_rows(csv, true, matrix);
  require_distinct(file, matrix.column_names);
  require_distinct(file, matrix.row_names);
  return matrix;
}

std::vector<ExternalName> read_faces_csv(const std::string& file, std::string_view text) {
  CsvReader csv(file, text);
  const bool has_head = csv.next();
  const Record head = csv.fields();
  const auto face = column_called(head, "face"), index = column_called(head, "index"),
             element = column_called(head, "element");
  if (!has_head || !face) throw InputError({file, 1}, "needs a column 'face'");
  struct Row {
    std::string face, element;
    int line;
  };
  std::map<std::uint32_t, Row> rows;
  std::map<std::string, int> parts;
  const ExternalNumbers numbers(file);
  while (csv.next()) {
    require_fields(csv, head.size());
    const int line = csv.where().line;
    const std::uint32_t place =
        index ? numbers.read_count(csv.fields()[*index], 1, std::numeric_limits<std::int32_t>::max(), "an index", line)
              : static_cast<std::uint32_t>(rows.size() + 1);
    Row row{std::string(csv.fields()[*face]), element ? std::string(csv.fields()[*element]) : "", line};
    ++parts[row.face];
    if (!rows.emplace(place, std::move(row)).second)
      throw InputError({file, line}, "the index " + std::to_string(place) + " is given twice");
  }
  std::vector<ExternalName> names;
  for (const auto& [place, row] : rows) {
    if (place != names.size() + 1)
      throw InputError({file, row.line}, "the index " + std::to_string(names.size() + 1) + " is missing");
    const bool is_divided = element && parts[row.face] > 1;
    names.push_back({is_divided ? row.face + "#" + row.element : row.face, row.line});
  }
  require_distinct(file, names);
  return names;
}

}  // namespace hottel

// Records of a csv file (RFC 4180), one at a time.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

// How fields are written.
struct CsvDialect {
  char separator = ',';       // ' ': any number of blanks and tabs
  bool trims = false;         // blanks around fields that are not quoted do not count
  bool has_comments = false;  // lines that begin with '#' are skipped
};

// Returns how others wrote a table of numbers: commas, or where the first record has none, semicolons, else tabs, else
// blanks. Blanks do not count where they follow every separator of the second record, or of the only one. Lines that
// begin with '#' are comments.
CsvDialect csv_dialect_of(std::string_view text);

// Reads fields separated by commas, or as a dialect has it, and records separated by line ends (LF or CR LF). A quoted
// field may hold commas, line ends and doubled quotes. Blank lines are skipped, and a byte order mark at the beginning.
//
//   (1) blanks around a field belong to it, unless the dialect trims; a field may be empty
//   (2) records may have different numbers of fields: the caller checks them
// Throws InputError for a quote that is not closed, or followed by something else than a comma or a line end.
// COST: linear; only fields with doubled quotes are copied.
class CsvReader {
 public:
  // REQUIRES that `text` outlives this.
  CsvReader(std::string file, std::string_view text, CsvDialect dialect = {});

  // Moves to the next record; false at the end.
  bool next();

  // The fields of the record, until next() is called again.
  const std::vector<std::string_view>& fields() const { return fields_; }
  // The line on which the record begins, 1-based.
  FileLine where() const { return {file_, line_of_record_}; }

 private:
  std::string_view quoted();
  std::string_view plain();
  void skip_blanks();
  bool is_at_line_end() const;

  std::string file_;
  std::string_view text_;
  CsvDialect dialect_;
  std::size_t at_ = 0;
  int line_ = 1, line_of_record_ = 0;
  std::vector<std::string_view> fields_;
  std::vector<std::unique_ptr<std::string>> unquoted_;  // fields of the record that held doubled quotes
};

// Returns the number of a field, exactly: an integer, a decimal or p/q. Throws InputError for anything else.
Rational exact_number(std::string_view field, const FileLine& where);

}  // namespace hottel

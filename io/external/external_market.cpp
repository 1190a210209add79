// Matrix Market: https://math.nist.gov/MatrixMarket/formats.html
#include <algorithm>
#include <limits>

#include "geometry/name.h"
#include "io/external/external_file.h"
#include "io/external/external_number.h"
#include "kernel/support/failure.h"
#include "kernel/support/lower_case.h"

namespace hottel {
namespace {

struct MarketHead {
  bool is_array = false, is_symmetric = false;
};

MarketHead read_head(const std::string& file, std::string_view line) {
  ExternalWords words(line);
  std::vector<std::string> terms;
  while (words.next()) terms.push_back(lower_case(words.word()));
  if (terms.size() != 5 || terms[0] != "%%matrixmarket" || terms[1] != "matrix")
    throw InputError({file, 1}, "the first line must read '%%MatrixMarket matrix FORMAT NUMBERS SYMMETRY'");
  const auto one_of = [&](std::size_t k, const char* a, const char* b, const char* what) {
    if (terms[k] != a && terms[k] != b)
      throw InputError({file, 1}, std::string(what) + " must be " + a + " or " + b + ", not " + quoted_name(terms[k]));
    return terms[k] == b;
  };
  MarketHead head;
  head.is_array = one_of(2, "coordinate", "array", "the format");
  one_of(3, "real", "integer", "the numbers");
  head.is_symmetric = one_of(4, "general", "symmetric", "the symmetry");
  return head;
}

class MarketReader {
 public:
  MarketReader(const std::string& file, std::string_view text) : words_(text), numbers_(file) { matrix_.file = file; }
  ExternalMatrix read();

 private:
  std::string_view word();
  void read_coordinates();
  void read_array();
  void add(std::uint32_t row, std::uint32_t column, double value);

  MarketHead head_;
  ExternalWords words_;
  ExternalNumbers numbers_;
  ExternalMatrix matrix_;
};

std::string_view MarketReader::word() {
  if (words_.next()) return words_.word();
  throw InputError({matrix_.file, words_.line()}, "breaks off: more numbers are expected");
}

void MarketReader::add(std::uint32_t row, std::uint32_t column, double value) {
  matrix_.entries.push_back({row, column, words_.line(), value});
  if (head_.is_symmetric && row != column) matrix_.entries.push_back({column, row, words_.line(), value});
}

void MarketReader::read_coordinates() {
  const std::uint64_t count =
      numbers_.read_count(word(), 0, std::numeric_limits<std::uint32_t>::max(), "the number of entries", words_.line());
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint32_t row = numbers_.read_count(word(), 1, matrix_.rows, "a row", words_.line()) - 1;
    const std::uint32_t column = numbers_.read_count(word(), 1, matrix_.columns, "a column", words_.line()) - 1;
    add(row, column, numbers_.read(word(), words_.line()));
  }
}

// Column by column; of a symmetric matrix the lower triangle.
void MarketReader::read_array() {
  for (std::uint32_t column = 0; column < matrix_.columns; ++column)
    for (std::uint32_t row = head_.is_symmetric ? column : 0; row < matrix_.rows; ++row)
      if (const double value = numbers_.read(word(), words_.line()); value != 0) add(row, column, value);
}

ExternalMatrix MarketReader::read() {
  head_ = read_head(matrix_.file, words_.rest_of_line());
  do word();
  while (words_.word().starts_with('%') && (words_.rest_of_line(), true));
  const auto side = [&](std::string_view text, const char* what) {
    return numbers_.read_count(text, 1, std::numeric_limits<std::int32_t>::max(), what, words_.line());
  };
  matrix_.rows = side(words_.word(), "the number of rows");
  matrix_.columns = side(word(), "the number of columns");
  if (head_.is_symmetric && matrix_.rows != matrix_.columns)
    throw InputError({matrix_.file, words_.line()}, "a symmetric matrix must be square");
  head_.is_array ? read_array() : read_coordinates();
  if (words_.next()) throw InputError({matrix_.file, words_.line()}, "goes on after the last entry");
  matrix_.digits = numbers_.digits();
  return std::move(matrix_);
}

}  // namespace

ExternalMatrix read_matrix_market(const std::string& file, std::string_view text) {
  return MarketReader(file, text).read();
}

}  // namespace hottel

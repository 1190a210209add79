// NumPy's format 1.0 to 3.0: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "geometry/name.h"
#include "io/foreign/foreign_file.h"
#include "io/foreign/foreign_number.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as the machine holds them");

struct NumpyHead {
  std::string_view dictionary, body;
};

NumpyHead split(const std::string& file, std::string_view text) {
  const auto byte = [&](std::size_t k) { return std::size_t{static_cast<unsigned char>(text[k])}; };
  const auto breaks_off = [&] { throw InputError({file, 0}, "breaks off in NumPy's head"); };
  constexpr std::size_t kMagic = 6;
  if (text.size() < kMagic + 4) breaks_off();
  const std::size_t major = byte(kMagic);
  if (major < 1 || major > 3)
    throw InputError({file, 0}, "is of NumPy's format " + std::to_string(major) + "; 1 to 3 are known");
  std::size_t begin = kMagic + 4, length = byte(8) + 256 * byte(9);
  if (major > 1) {
    begin += 2;
    if (text.size() < begin) breaks_off();
    length += 65536 * (byte(10) + 256 * byte(11));
  }
  if (text.size() - begin < length) breaks_off();
  return {text.substr(begin, length), text.substr(begin + length)};
}

// What follows 'KEY': in the head, without blanks before it; empty when there is no such key.
std::string_view value_of(std::string_view dictionary, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted = quote + std::string(key) + quote;
    const std::size_t at = dictionary.find(quoted);
    if (at == std::string_view::npos) continue;
    std::string_view rest = dictionary.substr(at + quoted.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" :"), rest.size()));
    return rest;
  }
  return {};
}

template <class Number>
void take_numbers(std::string_view body, bool is_by_columns, ForeignMatrix& matrix) {
  const std::uint32_t inner = is_by_columns ? matrix.rows : matrix.columns;
  const std::size_t count = std::size_t{matrix.rows} * matrix.columns;
  for (std::size_t k = 0; k < count; ++k) {
    Number value;
    std::memcpy(&value, body.data() + k * sizeof value, sizeof value);
    if (value == 0) continue;
    const auto outer_index = static_cast<std::uint32_t>(k / inner), inner_index = static_cast<std::uint32_t>(k % inner);
    const std::uint32_t row = is_by_columns ? inner_index : outer_index;
    const std::uint32_t column = is_by_columns ? outer_index : inner_index;
    if (!std::isfinite(value))
      throw InputError({matrix.file, 0}, "the number in row " + std::to_string(row + 1) + ", column " +
                                             std::to_string(column + 1) + " is not finite");
    matrix.entries.push_back({row, column, 0, value});
  }
  matrix.digits.relative = std::ldexp(1.0, -std::numeric_limits<Number>::digits);
}

// "(3, 4)"
void read_shape(std::string_view shape, ForeignMatrix& matrix) {
  const std::size_t end = shape.find(')');
  if (!shape.starts_with('(') || end == std::string_view::npos)
    throw InputError({matrix.file, 0}, "NumPy's head has no shape");
  std::string sides(shape.substr(1, end - 1));
  for (char& c : sides)
    if (c == ',') c = ' ';
  ForeignWords words(sides);
  const ForeignNumbers numbers(matrix.file);
  std::vector<std::uint32_t> numbers_found;
  while (words.next() && numbers_found.size() < 3)
    numbers_found.push_back(
        numbers.read_count(words.word(), 1, std::numeric_limits<std::int32_t>::max(), "a side of the array", 0));
  if (numbers_found.size() != 2)
    throw InputError({matrix.file, 0}, "holds an array of another dimension than 2: a matrix is expected");
  matrix.rows = numbers_found[0];
  matrix.columns = numbers_found[1];
}

}  // namespace

ForeignMatrix read_numpy(const std::string& file, std::string_view text) {
  const auto [dictionary, body] = split(file, text);
  ForeignMatrix matrix;
  matrix.file = file;
  const std::string_view type = value_of(dictionary, "descr").substr(0, 5);
  const bool is_double = type == "'<f8'", is_single = type == "'<f4'";
  if (!is_double && !is_single)
    throw InputError({file, 0}, "holds numbers of the type " + quoted_name(type) +
                                    "; float64 ('<f8') or float32 "
                                    "('<f4') are read");
  const std::string_view order = value_of(dictionary, "fortran_order");
  if (!order.starts_with("True") && !order.starts_with("False"))
    throw InputError({file, 0}, "NumPy's head does not say whether the order is Fortran's");
  read_shape(value_of(dictionary, "shape"), matrix);
  const std::size_t bytes = is_double ? sizeof(double) : sizeof(float);
  const std::uint64_t count = std::uint64_t{matrix.rows} * matrix.columns;
  if (body.size() % bytes != 0 || body.size() / bytes != count)
    throw InputError({file, 0}, "has " + std::to_string(body.size()) + " bytes of numbers; " +
                                    std::to_string(matrix.rows) + " x " + std::to_string(matrix.columns) + " of " +
                                    std::to_string(bytes) + " bytes are expected");
  if (is_double)
    take_numbers<double>(body, order.starts_with("True"), matrix);
  else
    take_numbers<float>(body, order.starts_with("True"), matrix);
  return matrix;
}

}  // namespace hottel

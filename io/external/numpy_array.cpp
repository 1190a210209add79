// NumPy's format 1.0 to 3.0: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include "io/external/numpy_array.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/name.h"
#include "io/external/external_number.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct NumpyHead {
  std::string_view dictionary, body;
};

NumpyHead split(const std::string& file, std::string_view text) {
  const auto byte = [&](std::size_t k) { return std::size_t{static_cast<unsigned char>(text[k])}; };
  const auto breaks_off = [&] { throw InputError({file, 0}, "ends within NumPy's header"); };
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

// "'<f8'", and what follows.
NumpyType type_of(const std::string& file, std::string_view descr) {
  std::string_view name;
  if (descr.starts_with('\'') || descr.starts_with('"')) {
    const std::size_t end = descr.find(descr.front(), 1);
    if (end != std::string_view::npos) name = descr.substr(1, end - 1);
  }
  const bool has_order = !name.empty() && std::string_view("<>=|").find(name.front()) != std::string_view::npos;
  const std::string_view rest = name.substr(has_order ? 1 : 0);
  const bool is_float = rest == "f4" || rest == "f8";
  const bool is_integer = rest.size() == 2 && (rest[0] == 'i' || rest[0] == 'u') &&
                          std::string_view("1248").find(rest[1]) != std::string_view::npos;
  if (!is_float && !is_integer)
    throw InputError({file, 0}, "holds numbers of the type " + (name.empty() ? "of no name" : quoted_name(name)) +
                                    "; floats of 4 or 8 bytes and integers are read ('<f8', '>f4', '|u1', ...)");
  return {rest[0], static_cast<unsigned>(rest[1] - '0'), has_order && name.front() == '>'};
}

// "(3, 4)"
std::vector<std::uint32_t> shape_of(const std::string& file, std::string_view shape) {
  const std::size_t end = shape.find(')');
  if (!shape.starts_with('(') || end == std::string_view::npos)
    throw InputError({file, 0}, "NumPy's header has no shape");
  std::string sides(shape.substr(1, end - 1));
  for (char& c : sides)
    if (c == ',') c = ' ';
  ExternalWords words(sides);
  const ExternalNumbers numbers(file);
  std::vector<std::uint32_t> found;
  while (words.next())
    found.push_back(
        numbers.read_count(words.word(), 1, std::numeric_limits<std::int32_t>::max(), "a side of the array", 0));
  return found;
}

}  // namespace

std::uint64_t NumpyArray::count() const {
  std::uint64_t product = 1;
  for (const std::uint32_t side : shape) product *= side;
  return product;
}

double NumpyArray::number(std::uint64_t place) const {
  std::uint64_t bits = 0;
  for (unsigned k = 0; k < type.bytes; ++k) {
    const unsigned at = type.is_big_endian ? k : type.bytes - 1 - k;  // from the highest byte down
    bits = bits << 8 | static_cast<unsigned char>(body[place * type.bytes + at]);
  }
  if (type.kind == 'u') return static_cast<double>(bits);
  if (type.kind == 'i') {
    const unsigned unused = 64 - 8 * type.bytes;
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }
  return type.bytes == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

double NumpyArray::relative_rounding() const {
  const bool is_float32 = type.kind == 'f' && type.bytes == 4;
  return std::ldexp(1.0, is_float32 ? -std::numeric_limits<float>::digits : -std::numeric_limits<double>::digits);
}

NumpyArray parse_numpy(const std::string& file, std::string_view text, std::size_t most_sides) {
  const auto [dictionary, body] = split(file, text);
  NumpyArray array;
  array.type = type_of(file, value_of(dictionary, "descr"));
  const std::string_view order = value_of(dictionary, "fortran_order");
  if (!order.starts_with("True") && !order.starts_with("False"))
    throw InputError({file, 0}, "NumPy's header does not say whether the order is Fortran's");
  array.is_by_columns = order.starts_with("True");
  array.shape = shape_of(file, value_of(dictionary, "shape"));
  array.body = body;
  const std::size_t bytes = array.type.bytes;
  std::uint64_t room = body.size() / bytes;  // what is left of it, side by side: the product may overflow
  bool fits = body.size() % bytes == 0;
  std::string sides;
  for (const std::uint32_t side : array.shape) {
    fits = fits && room % side == 0;
    room /= side;
    sides += (sides.empty() ? "" : " x ") + std::to_string(side);
  }
  if (array.shape.empty() || array.shape.size() > most_sides || array.shape.size() < 2)
    throw InputError({file, 0}, "holds an array of " + counted(array.shape.size(), "dimension") +
                                    (most_sides == 2 ? "; a matrix, of 2, is expected"
                                                     : "; 2 or 3 are expected: rows, columns and perhaps channels"));
  if (!fits || room != 1)
    throw InputError({file, 0}, "has " + std::to_string(body.size()) + " bytes of numbers; " + sides + " of " +
                                    std::to_string(bytes) + " bytes are expected");
  return array;
}

}  // namespace hottel

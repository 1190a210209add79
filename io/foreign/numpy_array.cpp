// NumPy's format 1.0 to 3.0: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include "io/foreign/numpy_array.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/name.h"
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

// "(3, 4)"
std::vector<std::uint32_t> shape_of(const std::string& file, std::string_view shape) {
  const std::size_t end = shape.find(')');
  if (!shape.starts_with('(') || end == std::string_view::npos)
    throw InputError({file, 0}, "NumPy's head has no shape");
  std::string sides(shape.substr(1, end - 1));
  for (char& c : sides)
    if (c == ',') c = ' ';
  ForeignWords words(sides);
  const ForeignNumbers numbers(file);
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
  if (is_double) {
    double value = 0;
    std::memcpy(&value, body.data() + place * sizeof value, sizeof value);
    return value;
  }
  float value = 0;
  std::memcpy(&value, body.data() + place * sizeof value, sizeof value);
  return value;
}

double NumpyArray::relative_rounding() const {
  return std::ldexp(1.0, is_double ? -std::numeric_limits<double>::digits : -std::numeric_limits<float>::digits);
}

NumpyArray parse_numpy(const std::string& file, std::string_view text, std::size_t most_sides) {
  const auto [dictionary, body] = split(file, text);
  NumpyArray array;
  const std::string_view type = value_of(dictionary, "descr").substr(0, 5);
  array.is_double = type == "'<f8'";
  if (!array.is_double && type != "'<f4'")
    throw InputError({file, 0}, "holds numbers of the type " + quoted_name(type) +
                                    "; float64 ('<f8') or float32 "
                                    "('<f4') are read");
  const std::string_view order = value_of(dictionary, "fortran_order");
  if (!order.starts_with("True") && !order.starts_with("False"))
    throw InputError({file, 0}, "NumPy's head does not say whether the order is Fortran's");
  array.is_by_columns = order.starts_with("True");
  array.shape = shape_of(file, value_of(dictionary, "shape"));
  array.body = body;
  const std::size_t bytes = array.is_double ? sizeof(double) : sizeof(float);
  std::uint64_t room = body.size() / bytes;  // what is left of it, side by side: the product may overflow
  bool fits = body.size() % bytes == 0;
  std::string sides;
  for (const std::uint32_t side : array.shape) {
    fits = fits && room % side == 0;
    room /= side;
    sides += (sides.empty() ? "" : " x ") + std::to_string(side);
  }
  if (array.shape.empty() || array.shape.size() > most_sides || array.shape.size() < 2)
    throw InputError({file, 0}, most_sides == 2
                                    ? "holds an array of another dimension than 2: a matrix is expected"
                                    : "holds an array of another dimension than 2 or 3: rows, columns and perhaps "
                                      "channels are expected");
  if (!fits || room != 1)
    throw InputError({file, 0}, "has " + std::to_string(body.size()) + " bytes of numbers; " + sides + " of " +
                                    std::to_string(bytes) + " bytes are expected");
  return array;
}

}  // namespace hottel

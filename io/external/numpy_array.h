// NumPy's files, as their heads describe them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// What an array holds, as NumPy writes it after the byte order: 'f8', 'u2'.
struct NumpyType {
  char kind = 'f';  // f: float, i: integer, u: integer without sign
  unsigned bytes = 8;
  bool is_big_endian = false;
};

// An array of floats of 4 or 8 bytes or of integers of 1 to 8, its numbers as they lie in the file.
//
//   (1) sides are from 1 to 2^31 - 1, and `body` holds exactly as many numbers as their product
struct NumpyArray {
  std::vector<std::uint32_t> shape;
  bool is_by_columns = false;  // Fortran's order: the first index runs fastest
  NumpyType type;
  std::string_view body;

  std::uint64_t count() const;
  // The number at a place in the file, as the nearest double. REQUIRES a place below count().
  double number(std::uint64_t place) const;
  double relative_rounding() const;  // 2^-53, of float32 2^-24
};

// Reads the head of NumPy's format 1.0 to 3.0. Throws InputError for what is no such file, breaks off, holds numbers of
// another type, or has none or more than `most_sides` sides. REQUIRES that the text outlives the array, and begins with
// NumPy's magic.
NumpyArray parse_numpy(const std::string& file, std::string_view text, std::size_t most_sides);

}  // namespace hottel

// NumPy's files, as their heads describe them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// An array of float64 or float32, its numbers as they lie in the file.
//
//   (1) sides are from 1 to 2^31 - 1, and `body` holds exactly as many numbers as their product
struct NumpyArray {
  std::vector<std::uint32_t> shape;
  bool is_by_columns = false;  // Fortran's order: the first index runs fastest
  bool is_double = true;
  std::string_view body;

  std::uint64_t count() const;
  // The number at a place in the file. REQUIRES a place below count().
  double number(std::uint64_t place) const;
  double relative_rounding() const;  // 2^-53 or 2^-24
};

// Reads the head of NumPy's format 1.0 to 3.0. Throws InputError for what is no such file, breaks off, holds numbers of
// another type, or has none or more than `most_sides` sides. REQUIRES that the text outlives the array, and begins with
// NumPy's magic.
NumpyArray parse_numpy(const std::string& file, std::string_view text, std::size_t most_sides);

}  // namespace hottel

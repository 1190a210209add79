// The values in a binary file, one after another.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

#include "kernel/support/failure.h"

namespace hottel {

// Goes through bytes, one value after another. REQUIRES that the bytes outlive this.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, std::endian order, std::size_t begin = 0)
      : bytes_(bytes), order_(order), at_(begin) {
    HOTTEL_REQUIRE(begin <= bytes.size());
  }

  // Where the next value begins.
  std::size_t at() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  // The next value, an integer or a floating-point number. REQUIRES that its bytes are there.
  template <class T>
  T take() {
    std::array<char, sizeof(T)> raw;
    HOTTEL_REQUIRE(bytes_left() >= sizeof(T));
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), sizeof(T), raw.begin());
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  // REQUIRES that as many bytes are there.
  void pass_over(std::size_t count) {
    HOTTEL_REQUIRE(bytes_left() >= count);
    at_ += count;
  }

 private:
  std::string_view bytes_;
  std::endian order_;
  std::size_t at_;
};

}  // namespace hottel

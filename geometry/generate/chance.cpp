#include "geometry/generate/chance.h"

#include <utility>

namespace hottel {

std::vector<std::int64_t> drawn(std::int64_t count, std::int64_t n, Chance& chance) {
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) numbers[static_cast<std::size_t>(i)] = i;
  for (std::int64_t i = 0; i < count; ++i)
    std::swap(numbers[static_cast<std::size_t>(i)], numbers[static_cast<std::size_t>(chance.between(i, n - 1))]);
  numbers.resize(static_cast<std::size_t>(count));
  return numbers;
}

std::uint64_t integer_root(std::uint64_t value) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit > 0; bit >>= 1)
    if ((root + bit) * (root + bit) <= value) root += bit;
  return root;
}

std::int64_t side_of_square(std::uint64_t value) {
  const std::uint64_t root = integer_root(value);
  return static_cast<std::int64_t>(root * root < value ? root + 1 : root);
}

std::int64_t side_of_cube(std::uint64_t value) {
  std::uint64_t side = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 20; bit > 0; bit >>= 1)
    if ((side + bit) * (side + bit) * (side + bit) < value) side += bit;
  return static_cast<std::int64_t>(value == 0 ? 0 : side + 1);
}

}  // namespace hottel

// Medians, and samples of long lists.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hottel {

// Returns the middle one by size; of an even number the upper of the two. REQUIRES one number or more.
inline double middle_of(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// Returns every n-th one, n the least for which at most `most` are left.
template <class List>
auto thinned(const List& all, std::size_t most) {
  std::vector<typename List::value_type> some;
  const double step = std::max(1.0, static_cast<double>(all.size()) / static_cast<double>(most));
  for (double at = 0; at < static_cast<double>(all.size()); at += step)
    some.push_back(all[static_cast<std::size_t>(at)]);
  return some;
}

}  // namespace hottel

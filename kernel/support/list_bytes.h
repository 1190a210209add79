// What lists take of memory.
#pragma once

#include <cstddef>
#include <vector>

namespace hottel {

// The bytes of the entries of a list, with those that it has room for.
template <class Entry>
std::size_t bytes_of(const std::vector<Entry>& list) {
  return list.capacity() * sizeof(Entry);
}

// Empties a list, and gives back what it took.
template <class Entry>
void give_back(std::vector<Entry>& list) {
  std::vector<Entry>().swap(list);
}

}  // namespace hottel

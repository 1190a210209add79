// Arrays whose members are set by those who fill them, and by nobody before.
#pragma once

#include <new>
#include <utility>
#include <vector>

#include "kernel/support/folder_memory.h"

namespace hottel {

// A PlacingAllocator of members that resize() leaves as they are: no pass of one thread over memory, or over a disk,
// that many threads are about to fill.
template <class T>
class UnsetAllocator : public PlacingAllocator<T> {
 public:
  using PlacingAllocator<T>::PlacingAllocator;
  UnsetAllocator() = default;
  template <class Other>
  UnsetAllocator(const UnsetAllocator<Other>& other) : PlacingAllocator<T>(other.memory()) {}

  template <class Member>
  void construct(Member* at) {
    ::new (static_cast<void*>(at)) Member;
  }
  template <class Member, class... Arguments>
  void construct(Member* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) Member(std::forward<Arguments>(arguments)...);
  }
};

// REQUIRES members that are numbers.
template <class T>
using UnsetArray = std::vector<T, UnsetAllocator<T>>;

}  // namespace hottel

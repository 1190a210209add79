// Memory that could not be had, and for what.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <string_view>

namespace hottel {

// A std::bad_alloc that knows which work it ended. It takes no memory of its own.
class OutOfMemory : public std::bad_alloc {
 public:
  // what() is the name of the work, its first 63 bytes.
  explicit OutOfMemory(std::string_view work) noexcept {
    std::copy_n(work.begin(), std::min(work.size(), sizeof(work_) - 1), work_);
  }
  const char* what() const noexcept override { return work_; }

 private:
  char work_[64] = {};
};

}  // namespace hottel

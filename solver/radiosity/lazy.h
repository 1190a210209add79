// A value that is made when it is first asked for.
#pragma once

#include <memory>
#include <mutex>

namespace hottel {

// Holds nothing until get() is called, which may be by many threads at once.
//
//   (1) `make` runs once; who asks meanwhile waits
//   (2) where it throws there is still nothing: the next one makes it
// REQUIRES: `make` returns a std::unique_ptr that holds something, the same whoever asks, and starts no parallel work
// (a thread that waits for others may be given work that asks for the same value).
template <class T>
class Lazy {
 public:
  template <class Make>
  const T& get(const Make& make) const {
    const std::lock_guard lock(mutex_);
    if (!value_) value_ = make();
    return *value_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const T> value_;
};

}  // namespace hottel

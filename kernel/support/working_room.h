// How much memory one piece of work on a thread may take beside its result.
#pragma once

#include <cstddef>
#include <limits>

namespace hottel {

// While it lives, work on this thread that keeps count of what it takes is refused beyond so many bytes: it throws
// RequestError. Of several the last one holds. No result depends on it.
// REQUIRES: made and destroyed on one thread.
class WorkingRoom {
 public:
  explicit WorkingRoom(std::size_t bytes) : before_(bytes_) { bytes_ = bytes; }
  ~WorkingRoom() { bytes_ = before_; }
  WorkingRoom(const WorkingRoom&) = delete;
  WorkingRoom& operator=(const WorkingRoom&) = delete;

  static std::size_t bytes() { return bytes_; }  // as many as there are where nobody said so

 private:
  static inline thread_local std::size_t bytes_ = std::numeric_limits<std::size_t>::max();
  const std::size_t before_;
};

}  // namespace hottel

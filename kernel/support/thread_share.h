// How many threads the work of one caller may take, whatever others take.
#pragma once

namespace hottel {

// While it lives, each loop that this thread runs (parallel_ranges), and each of the stages that it starts (Stage),
// runs on at most so many threads, the calling one included. Loops of other threads are not limited by it; a
// ThreadLimit holds besides. Of several, the last one holds. Results do not depend on it.
//
// Throws ContractViolation unless threads >= 0; 0: no limit but that of all. REQUIRES: made and destroyed on one
// thread.
class ThreadShare {
 public:
  explicit ThreadShare(int threads);
  ~ThreadShare();
  ThreadShare(const ThreadShare&) = delete;
  ThreadShare& operator=(const ThreadShare&) = delete;

 private:
  int before_;
};

// The share of this thread; 0 where it has none. Work that goes on on another thread takes it along.
int thread_share();

}  // namespace hottel

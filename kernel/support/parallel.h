// Work on many threads, in the one floating-point environment that the error bounds are about.
#pragma once

#include <cfenv>
#include <cstddef>
#include <memory>

namespace hottel {

// While it lives, this thread rounds to nearest and keeps subnormal numbers, whatever its caller has set. At its end
// the environment is what it was before, floating-point flags included: those raised meanwhile are lost.
// REQUIRES: made and destroyed on one thread.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatingPoint() { std::fesetenv(&saved_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t saved_;
};

// While it lives, at most so many threads work, this one included. Of several, the lowest limit holds. Results do not
// depend on it.
// Throws ContractViolation unless threads >= 1.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();

 private:
  struct Limit;
  std::unique_ptr<Limit> limit_;
};

// How many threads may work, this one included: those of the machine, or what a ThreadLimit leaves.
int threads_allowed();

namespace detail {
using RangeFunction = void (*)(const void* function, std::size_t begin, std::size_t end);
void run_ranges(std::size_t n, std::size_t grain, const void* function, RangeFunction call);
}  // namespace detail

// Calls f(begin, end) for disjoint ranges that together are [0, n), on all threads that are allowed.
//
//   (1) f runs in the default floating-point environment (DefaultFloatingPoint) on every thread; the caller's is as
//       it was afterwards
//   (2) the first exception that f throws keeps ranges that were not begun from being begun, and is thrown again here
//   (3) f may itself call parallel_ranges
//   (4) all that f did is seen by what follows the call
//   (5) where n is 0, f is not called
//   (6) what asks the caller to stop (StopScope) asks f to stop, on every thread
//
// Which ranges there are depends on the number of threads: what f computes for an index must not depend on its range.
// Throws ContractViolation unless grain >= 1.
// REQUIRES: f may be called from several threads at once.
template <class F>
void parallel_ranges(std::size_t n, std::size_t grain, const F& f) {
  detail::run_ranges(n, grain, &f, [](const void* function, std::size_t begin, std::size_t end) {
    (*static_cast<const F*>(function))(begin, end);
  });
}

// The same with f(k) for every k in [0, n), each once. What f does for different k may happen at the same time and
// in any order.
template <class F>
void parallel_for(std::size_t n, const F& f, std::size_t grain = 1) {
  parallel_ranges(n, grain, [&f](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) f(k);
  });
}

}  // namespace hottel

#include "kernel/support/parallel.h"

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/thread_share.h"

namespace hottel {
namespace {

thread_local int own_share = 0;  // of the threads, for loops of this one; 0: all that are allowed

}  // namespace
}  // namespace hottel

// ThreadSanitizer does not see how TBB's library hands over work, since that is not instrumented; it does see
// std::thread. So its build takes the second of two ways, which starts its threads anew in every call.
#ifndef HOTTEL_STD_THREADS

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace hottel {

struct ThreadLimit::Limit {
  explicit Limit(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
  tbb::global_control control;
};

namespace detail {

void run_ranges(std::size_t n, std::size_t grain, const void* function, RangeFunction call) {
  HOTTEL_REQUIRE(grain >= 1);
  const DefaultFloatingPoint here;
  // Captures the environment of this thread, which the tasks then run in.
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  const auto loop = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, grain),
        [function, call, stop = stop_flag](const auto& range) {
          const StopScope scope(stop);
          call(function, range.begin(), range.end());
        },
        context);
  };
  if (own_share == 0) return loop();
  // An arena for this loop alone, in which the caller has a place of its own: it waits for nobody. Loops within run
  // there too.
  tbb::task_arena arena(own_share, 1);
  const ThreadShare within(0);
  arena.execute(loop);
}

}  // namespace detail

int threads_allowed() {
  const auto limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int all = std::min(static_cast<int>(limit), tbb::this_task_arena::max_concurrency());
  return own_share == 0 ? all : std::min(own_share, all);
}

}  // namespace hottel

#else

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hottel {
namespace {

std::atomic<int> allowed{static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
thread_local bool is_inside = false;  // a call from within runs on its own thread

}  // namespace

struct ThreadLimit::Limit {
  explicit Limit(int threads) : before(allowed) { allowed = std::min(before, threads); }
  ~Limit() { allowed = before; }
  int before;
};

namespace detail {

void run_ranges(std::size_t n, std::size_t grain, const void* function, RangeFunction call) {
  HOTTEL_REQUIRE(grain >= 1);
  std::atomic<std::size_t> next{0};
  std::exception_ptr first;
  std::mutex mutex;
  const auto work = [&, stop = stop_flag] {
    const DefaultFloatingPoint here;
    const StopScope scope(stop);
    const bool was_inside = std::exchange(is_inside, true);
    for (std::size_t begin; (begin = next.fetch_add(grain)) < n;) {
      try {
        call(function, begin, std::min(begin + grain, n));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!first) first = std::current_exception();
        next = n;
      }
    }
    is_inside = was_inside;
  };
  std::vector<std::thread> others;
  const int threads = is_inside || n <= grain ? 1 : threads_allowed();
  for (int k = 1; k < threads; ++k) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace detail

int threads_allowed() { return own_share == 0 ? allowed.load() : std::min(own_share, allowed.load()); }

}  // namespace hottel

#endif

namespace hottel {

ThreadLimit::ThreadLimit(int threads) {
  HOTTEL_REQUIRE(threads >= 1);
  limit_ = std::make_unique<Limit>(threads);
}
ThreadLimit::~ThreadLimit() = default;

ThreadShare::ThreadShare(int threads) : before_(own_share) {
  HOTTEL_REQUIRE(threads >= 0);
  own_share = threads;
}
ThreadShare::~ThreadShare() { own_share = before_; }

int thread_share() { return own_share; }

}  // namespace hottel

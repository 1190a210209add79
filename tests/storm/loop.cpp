#include "tests/storm/loop.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "kernel/support/parallel.h"
#include "tests/storm/crash_notice.h"

namespace hottel::storm {

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void for_each_scene(const StormOptions& options,
                    const std::function<void(unsigned thread, std::uint64_t number)>& run) {
  const unsigned count = std::max(1U, options.threads);
  const std::uint64_t at_once = std::clamp<std::uint64_t>(options.scenes / (8 * count), 1, 64);
  const CrashNotice notice;
  const ThreadLimit limit(1);  // a scene stays on its thread, which knows its number should it die
  std::atomic<std::uint64_t> next{0}, done{0};
  const auto work = [&](unsigned thread) {
    const SignalStack stack;
    for (std::uint64_t from; (from = next.fetch_add(at_once)) < options.scenes;) {
      const std::uint64_t to = std::min(from + at_once, options.scenes);
      for (std::uint64_t k = from; k < to; ++k) {
        run(thread, options.first + k);
        ++done;
        if (thread == 0 && options.progress) options.progress(done.load());
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned thread = 1; thread < count; ++thread) threads.emplace_back(work, thread);
  work(0);
  for (std::thread& thread : threads) thread.join();
}

}  // namespace hottel::storm

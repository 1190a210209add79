// A data race on purpose: tools/sanitize thread must see it, or it sees none at all.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "kernel/support/parallel.h"

int main() {
  using Clock = std::chrono::steady_clock;
  const hottel::ThreadLimit limit(2);
  const auto patience = Clock::now() + std::chrono::seconds(60);
  // Each thread waits for the other, so both are at work however busy the machine is; relaxed, so nothing orders what
  // they do then.
  std::atomic<int> arrived{0};
  long sum = 0;
  hottel::parallel_for(
      2,
      [&](std::size_t k) {
        arrived.fetch_add(1, std::memory_order_relaxed);
        while (arrived.load(std::memory_order_relaxed) < 2 && Clock::now() < patience) std::this_thread::yield();
        sum += static_cast<long>(k) + 1;
      },
      1);
  std::printf("%ld\n", sum);
}

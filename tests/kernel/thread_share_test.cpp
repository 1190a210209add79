#include "kernel/support/thread_share.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stage.h"

namespace hottel::thread_share_test {
namespace {

// How many threads a loop has that gives each of them something to do.
std::size_t threads_of_a_loop() {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallel_for(64, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  return seen.size();
}

TEST(ThreadShare, LimitsTheLoopsOfOneThread) {
  const ThreadShare one(1);
  EXPECT_EQ(threads_of_a_loop(), 1u);
  EXPECT_EQ(threads_allowed(), 1);
  EXPECT_EQ(thread_share(), 1);
}

TEST(ThreadShare, LimitsLoopsWithinLoops) {
  const ThreadShare two(2);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallel_for(8, [&](std::size_t) {
    parallel_for(8, [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
  });
  EXPECT_LE(seen.size(), 2u);
}

TEST(ThreadShare, DoesNotLimitOtherThreads) {
  const int all = threads_allowed();
  const ThreadShare one(1);
  int others = 0;
  std::thread([&] { others = threads_allowed(); }).join();
  EXPECT_EQ(others, all);
  {
    const ThreadShare none(0);
    EXPECT_EQ(threads_allowed(), all);
  }
  EXPECT_EQ(threads_allowed(), 1);
}

TEST(ThreadShare, IsTakenAlongByStages) {
  Stage<std::size_t> inner("inner", [](const StageProgress&) { return threads_of_a_loop(); });
  Stage<std::size_t> outer("outer", [&](const StageProgress& progress) { return *inner.get(progress); });
  const ThreadShare one(1);
  EXPECT_EQ(*outer.get(), 1u);
}

TEST(ThreadShare, LetsManyThreadsShareAValueThatALoopMakes) {
  // One thread makes the value in a loop of its own while loops of the others wait for it.
  std::once_flag once;
  std::atomic<int> made{0};
  const auto ask = [&] {
    const ThreadShare one(1);
    parallel_for(4, [&](std::size_t) { std::call_once(once, [&] { parallel_for(4, [&](std::size_t) { ++made; }); }); });
  };
  std::thread a(ask), b(ask), c(ask);
  for (std::thread* thread : {&a, &b, &c}) thread->join();
  EXPECT_EQ(made, 4);
}

TEST(ThreadShare, PassesExceptionsOn) {
  const ThreadShare two(2);
  EXPECT_THROW(parallel_for(100, [](std::size_t) { throw RequestError("no"); }), RequestError);
  EXPECT_THROW(ThreadShare(-1), ContractViolation);
  EXPECT_EQ(thread_share(), 2);
}

}  // namespace
}  // namespace hottel::thread_share_test

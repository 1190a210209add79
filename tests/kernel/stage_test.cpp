#include "kernel/support/stage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel::stage_test {
namespace {

using namespace std::chrono_literals;

// Waits until something is so; false when it is not within a minute.
bool becomes(const auto& what) {
  for (int k = 0; k < 60000 && !what(); ++k) std::this_thread::sleep_for(1ms);
  return what();
}

void work_until_stopped(const StageProgress& progress) {
  for (;;) {
    throw_if_interrupted();
    progress("work", 0.5);
    std::this_thread::sleep_for(1ms);
  }
}

// (1)
TEST(StageThreads, MakeTheValueOnce) {
  std::atomic<int> made{0};
  Stage<int> stage("value", [&](const StageProgress&) {
    std::this_thread::sleep_for(30ms);
    return ++made;
  });
  EXPECT_EQ(stage.peek(), nullptr);
  std::vector<std::shared_ptr<const int>> values(8);
  std::vector<std::thread> threads;
  for (auto& value : values) threads.emplace_back([&] { value = stage.get(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& value : values) EXPECT_EQ(value, values.front());
  EXPECT_EQ(*values.front(), 1);
  EXPECT_EQ(stage.peek(), values.front());
  EXPECT_EQ(made, 1);
}

// (2), by what the progress of one throws
TEST(StageThreads, OneWaitIsDroppedAndTheOthersGoOn) {
  std::atomic<bool> may_end{false}, is_dropped{false}, others_wait{false};
  Stage<std::string> stage("value", [&](const StageProgress& progress) {
    while (!may_end) {
      throw_if_interrupted();
      progress("work", 0.25);
      std::this_thread::sleep_for(1ms);
    }
    return std::string("made");
  });
  std::thread other([&] {
    const auto value = stage.get([&](std::string_view, double) { others_wait = true; });
    EXPECT_EQ(*value, "made");
  });
  ASSERT_TRUE(becomes([&] { return others_wait.load(); }));
  std::thread dropped([&] {
    const auto drop = [](std::string_view stage_that_runs, double fraction) {
      EXPECT_EQ(stage_that_runs, "work");
      EXPECT_EQ(fraction, 0.25);
      throw std::runtime_error("enough");
    };
    EXPECT_THROW(stage.get(drop), std::runtime_error);
    is_dropped = true;
  });
  ASSERT_TRUE(becomes([&] { return is_dropped.load(); }));
  EXPECT_EQ(stage.peek(), nullptr);
  may_end = true;
  other.join();
  dropped.join();
  ASSERT_NE(stage.peek(), nullptr);
}

// (2), by the waiting thread's own StopScope
TEST(StageThreads, AWaitStopsWithItsThreadsWork) {
  std::atomic<bool> may_end{false}, stop{false};
  Stage<int> stage("value", [&](const StageProgress&) {
    while (!may_end) std::this_thread::sleep_for(1ms);
    return 1;
  });
  std::thread waiting([&] {
    const StopScope scope(&stop);
    EXPECT_THROW(stage.get(), Interrupted);
  });
  stop = true;
  waiting.join();
  may_end = true;
  EXPECT_EQ(*stage.get(), 1);
}

// (3)
TEST(StageThreads, WorkStopsWhenNobodyWaitsAndBeginsAnew) {
  std::atomic<int> begun{0}, stopped{0};
  Stage<int> stage("value", [&](const StageProgress& progress) {
    if (++begun == 1) {
      try {
        work_until_stopped(progress);
      } catch (const Interrupted&) {
        ++stopped;
        throw;
      }
    }
    return begun.load();
  });
  EXPECT_THROW(stage.get([](std::string_view, double) { throw std::runtime_error("enough"); }), std::runtime_error);
  EXPECT_EQ(*stage.get(), 2);
  EXPECT_EQ(stopped, 1);
}

TEST(StageThreads, WorkThatEndsAllTheSameLeavesItsValue) {
  std::atomic<bool> may_end{false};
  std::atomic<int> made{0};
  Stage<int> stage("value", [&](const StageProgress&) {
    while (!may_end) std::this_thread::sleep_for(1ms);
    return ++made;
  });
  EXPECT_THROW(stage.get([](std::string_view, double) { throw std::runtime_error("enough"); }), std::runtime_error);
  may_end = true;
  EXPECT_TRUE(becomes([&] { return stage.peek() != nullptr; }));
  EXPECT_EQ(*stage.get(), 1);
}

// Stages that others ask for stop with them.
TEST(StageThreads, AStoppedStageDropsItsWaitForAnother) {
  std::atomic<int> begun{0};
  const auto before = std::make_shared<Stage<int>>("before", [&](const StageProgress& progress) {
    if (++begun == 1) work_until_stopped(progress);
    return 7;
  });
  Stage<int> after("after", [before](const StageProgress& progress) { return *before->get(progress) + 1; });
  std::string told;
  EXPECT_THROW(after.get([&](std::string_view stage, double) {
    told = stage;
    if (told == "work") throw std::runtime_error("enough");
  }),
               std::runtime_error);
  EXPECT_EQ(told, "work");  // what runs is told through all that wait for it
  EXPECT_EQ(*after.get(), 8);
  EXPECT_EQ(begun, 2);
}

// (4)
TEST(StageThreads, AFailureIsThrownToEveryone) {
  std::atomic<int> begun{0};
  Stage<int> stage("value", [&](const StageProgress&) -> int {
    ++begun;
    throw std::runtime_error("no such value");
  });
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) threads.emplace_back([&] { EXPECT_THROW(stage.get(), std::runtime_error); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THROW(stage.get(), std::runtime_error);
  EXPECT_EQ(stage.peek(), nullptr);
  EXPECT_EQ(begun, 1);
}

// (5)
TEST(StageThreads, TheDestructorStopsWhatRuns) {
  std::atomic<bool> is_stopped{false}, has_begun{false};
  {
    Stage<int> stage("value", [&](const StageProgress&) -> int {
      has_begun = true;
      while (!interrupted()) std::this_thread::sleep_for(1ms);
      is_stopped = true;
      throw Interrupted();
    });
    EXPECT_THROW(stage.get([&](std::string_view, double) {
      if (has_begun) throw std::runtime_error("enough");
    }),
                 std::runtime_error);
  }
  EXPECT_TRUE(is_stopped);
}

// parallel_ranges (6)
TEST(ParallelStop, ReachesEveryThread) {
  std::atomic<bool> stop{false};
  const StopScope scope(&stop);
  std::atomic<int> asked{0};
  EXPECT_THROW(parallel_for(1000,
                            [&](std::size_t) {
                              if (++asked == 20) stop = true;
                              std::this_thread::sleep_for(100us);
                              throw_if_interrupted();
                            }),
               Interrupted);
  EXPECT_LT(asked, 1000);
  EXPECT_TRUE(interrupted());
  {
    const StopScope none(nullptr);
    EXPECT_FALSE(interrupted());
  }
  EXPECT_TRUE(interrupted());
}

TEST(ParallelStop, OfOneThreadIsNoneOfAnother) {
  std::atomic<bool> stop{true};
  const StopScope scope(&stop);
  bool other_is_interrupted = true;
  std::thread([&] { other_is_interrupted = interrupted(); }).join();
  EXPECT_FALSE(other_is_interrupted);
  EXPECT_TRUE(interrupted());
}

}  // namespace
}  // namespace hottel::stage_test

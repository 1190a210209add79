// Work beside a window: the last that was asked for, and nothing of what was asked for before.
#include "viewer/window/background.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <random>
#include <stdexcept>

#include "kernel/support/interrupt.h"

namespace hottel::background_test {
namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 60s;

// Waits until it is so; whether it has become so.
template <class Condition>
bool becomes(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(100us);
  }
  return true;
}

// Collects until there is nothing more to come.
bool collect_all(Background& background) {
  return becomes([&] {
    background.collect();
    return !background.is_busy();
  });
}

// Work that goes on until it is stopped, and tells how it ended.
struct EndlessWork {
  std::shared_ptr<std::atomic<bool>> has_begun = std::make_shared<std::atomic<bool>>(false);
  std::shared_ptr<std::atomic<bool>> was_stopped = std::make_shared<std::atomic<bool>>(false);

  Background::Apply operator()(const StageProgress& progress, const Background::Tell&) const {
    *has_begun = true;
    try {
      for (;;) {
        progress("endless", 0);
        std::this_thread::sleep_for(100us);
      }
    } catch (const Interrupted&) {
      *was_stopped = true;
      throw;
    }
  }
};

TEST(BackgroundThread, StopsWhatRunsWhenOtherWorkIsAskedFor) {
  Background background;
  const EndlessWork endless;
  int applied = 0;
  background.post(endless);
  ASSERT_TRUE(becomes([&] { return endless.has_begun->load(); }));
  background.post([&](const auto&, const auto&) { return [&] { applied = 7; }; });
  ASSERT_TRUE(collect_all(background));
  EXPECT_TRUE(*endless.was_stopped);
  EXPECT_EQ(applied, 7);
}

// (1), of follow()
TEST(BackgroundThread, LetsWhatRunsEndBeforeWhatFollows) {
  Background background;
  std::promise<void> may_end;
  std::vector<int> applied;
  const auto work = [&applied](int number) {
    return [&applied, number](const auto&, const auto&) { return [&applied, number] { applied.push_back(number); }; };
  };
  std::atomic<bool> has_begun = false;
  background.follow([&, ended = may_end.get_future().share()](const StageProgress& progress, const auto&) {
    has_begun = true;
    ended.wait();
    progress("first", 1);  // it is not stopped
    return [&] { applied.push_back(1); };
  });
  ASSERT_TRUE(becomes([&] { return has_begun.load(); }));
  background.follow(work(2));
  background.follow(work(3));  // in place of 2, which waits
  may_end.set_value();
  ASSERT_TRUE(collect_all(background));
  EXPECT_EQ(applied, (std::vector{1, 3}));
  const EndlessWork endless;
  background.follow(endless);
  ASSERT_TRUE(becomes([&] { return endless.has_begun->load(); }));
  background.post(work(4));
  ASSERT_TRUE(collect_all(background));
  EXPECT_EQ(applied, (std::vector{1, 3, 4}));
}

TEST(BackgroundThread, AppliesWhereItIsCollectedAndOnce) {
  Background background;
  std::thread::id made, applied;
  int times = 0;
  background.post([&](const auto&, const auto&) {
    made = std::this_thread::get_id();
    return [&] {
      applied = std::this_thread::get_id();
      ++times;
    };
  });
  EXPECT_TRUE(background.is_busy());
  ASSERT_TRUE(becomes([&] { return background.collect(); }));
  EXPECT_EQ(applied, std::this_thread::get_id());
  EXPECT_NE(made, applied);
  EXPECT_FALSE(background.collect());
  EXPECT_EQ(times, 1);
  ASSERT_TRUE(becomes([&] { return !background.is_busy(); }));
}

TEST(BackgroundThread, DropsWhatWasNotCollectedBeforeOtherWork) {
  std::atomic<int> changes = 0;
  Background background([&] { ++changes; });
  std::vector<int> applied;
  background.post([&](const auto&, const auto&) { return [&] { applied.push_back(1); }; });
  ASSERT_TRUE(becomes([&] { return changes == 1; }));
  background.post([&](const auto&, const auto&) { return [&] { applied.push_back(2); }; });
  ASSERT_TRUE(collect_all(background));
  EXPECT_EQ(applied, std::vector<int>{2});
}

TEST(BackgroundThread, DoesTheLastOfTheWorkThatWaits) {
  Background background;
  const EndlessWork endless;
  background.post(endless);
  ASSERT_TRUE(becomes([&] { return endless.has_begun->load(); }));
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future();
  std::atomic<bool> is_at_gate = false;
  background.post([&, open](const auto&, const auto&) {
    is_at_gate = true;
    open.wait();
    return Background::Apply();
  });
  ASSERT_TRUE(becomes([&] { return is_at_gate.load(); }));
  std::atomic<int> made = 0;
  for (int k = 1; k <= 10; ++k)
    background.post([&made, k](const auto&, const auto&) {
      made = 100 * made + k;  // a second one would show
      return Background::Apply();
    });
  gate.set_value();
  ASSERT_TRUE(becomes([&] { return !background.is_busy(); }));
  EXPECT_EQ(made, 10);
}

TEST(BackgroundThread, TellsBeforeItIsDone) {
  std::atomic<int> changes = 0;
  Background background([&] { ++changes; });
  std::promise<void> gate;
  const std::shared_future<void> open = gate.get_future();
  std::vector<int> applied;
  background.post([&, open](const auto&, const auto& tell) {
    for (int k = 0; k < 3; ++k) tell([&applied, k] { applied.push_back(k); });
    open.wait();
    return [&] { applied.push_back(3); };
  });
  ASSERT_TRUE(becomes([&] { return changes == 3; }));
  EXPECT_TRUE(background.collect());
  EXPECT_EQ(applied, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(background.is_busy());
  gate.set_value();
  ASSERT_TRUE(collect_all(background));
  EXPECT_EQ(applied, (std::vector<int>{0, 1, 2, 3}));
}

TEST(BackgroundThread, DropsWhatWorkThrowsAndGoesOn) {
  Background background;
  background.post([](const auto&, const auto&) -> Background::Apply { throw std::runtime_error("no"); });
  ASSERT_TRUE(becomes([&] { return !background.is_busy(); }));
  EXPECT_FALSE(background.collect());
  bool is_done = false;
  background.post([&](const auto&, const auto&) { return [&] { is_done = true; }; });
  ASSERT_TRUE(collect_all(background));
  EXPECT_TRUE(is_done);
}

TEST(BackgroundThread, CancelStopsWhatRunsAndDropsWhatWaits) {
  Background background;
  const EndlessWork endless;
  background.post(endless);
  ASSERT_TRUE(becomes([&] { return endless.has_begun->load(); }));
  background.cancel();
  ASSERT_TRUE(becomes([&] { return !background.is_busy(); }));
  EXPECT_TRUE(*endless.was_stopped);
  EXPECT_FALSE(background.collect());
}

TEST(BackgroundThread, EndsAtAnyMoment) {
  std::mt19937_64 random(20261122);
  for (int k = 0; k < 300; ++k) {
    const EndlessWork endless;
    std::optional<Background> background(std::in_place);
    const auto delay = [&] { std::this_thread::sleep_for(std::chrono::microseconds(random() % 300)); };
    const auto posts = random() % 4;
    for (std::uint64_t n = 0; n < posts; ++n) {
      background->post(endless);
      delay();
      if (random() % 3 == 0) background->cancel();
      if (random() % 3 == 0) background->collect();
    }
    delay();
    background.reset();
    EXPECT_EQ(endless.has_begun->load(), endless.was_stopped->load());
  }
}

}  // namespace
}  // namespace hottel::background_test

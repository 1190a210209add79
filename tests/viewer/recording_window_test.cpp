#include "viewer/window/recording_window.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/stopwatch.h"

namespace hottel::recording_window_test {
namespace {

using Kind = WindowEvent::Kind;

WindowEvent key(const char* name) { return {.kind = Kind::kKey, .key = name}; }

// What comes at once: kinds, and the names of keys.
std::vector<std::pair<Kind, std::string>> waiting(RecordingWindow& window) {
  std::vector<std::pair<Kind, std::string>> found;
  while (const auto event = window.next(0)) found.emplace_back(event->kind, event->key);
  return found;
}

TEST(RecordingWindow, GivesEventsBackInOrderEachOnce) {
  RecordingWindow window({40, 30});
  const WindowEvent press{
      .kind = Kind::kPress, .x = 1.5, .y = -2, .button = MouseButton::kRight, .held = {.alt = true}};
  window.push(press);
  window.push(key("a"));
  window.push(key("b"));
  const auto first = window.next(0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, Kind::kPress);
  EXPECT_EQ(first->x, 1.5);
  EXPECT_EQ(first->y, -2);
  EXPECT_EQ(first->button, MouseButton::kRight);
  EXPECT_EQ(first->held, (HeldKeys{.alt = true}));
  EXPECT_THAT(waiting(window), testing::ElementsAre(std::pair(Kind::kKey, "a"), std::pair(Kind::kKey, "b")));
}

TEST(RecordingWindow, WaitsAsLongAsAskedAndNoLonger) {
  RecordingWindow window({40, 30});
  Stopwatch watch;
  EXPECT_FALSE(window.next(0.12));
  EXPECT_GE(watch.lap(), 0.12);
  EXPECT_FALSE(window.next(0));
  EXPECT_FALSE(window.next(-1));
  EXPECT_LT(watch.lap(), 5);
}

TEST(RecordingWindow, SeveralWakesAreOneInItsTurn) {
  RecordingWindow window({40, 30});
  window.push(key("a"));
  window.wake();
  window.push(key("b"));
  window.wake();
  EXPECT_THAT(waiting(window),
              testing::ElementsAre(std::pair(Kind::kKey, "a"), std::pair(Kind::kWake, ""), std::pair(Kind::kKey, "b")));
  window.wake();
  EXPECT_THAT(waiting(window), testing::ElementsAre(std::pair(Kind::kWake, "")));
}

TEST(RecordingWindow, AnotherThreadWakesAndPushes) {
  RecordingWindow window({40, 30});
  for (const bool by_wake : {true, false}) {
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (by_wake) {
        window.wake();
      } else {
        window.push(key("x"));
      }
    });
    const auto event = window.next(60);
    other.join();
    ASSERT_TRUE(event);
    EXPECT_EQ(event->kind, by_wake ? Kind::kWake : Kind::kKey);
  }
}

TEST(RecordingWindow, EventsOfManyThreadsAllArrive) {
  RecordingWindow window({40, 30});
  constexpr int kEach = 500;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&window] {
      for (int e = 0; e < kEach; ++e) window.push(key("x"));
    });
  int keys = 0;
  for (; keys < 4 * kEach; ++keys) ASSERT_TRUE(window.next(60));
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(window.next(0));
}

TEST(RecordingWindow, ResizingGivesAnEvent) {
  RecordingWindow window({40, 30});
  window.resize({50, 60});
  EXPECT_EQ(window.size(), (FrameSize{50, 60}));
  window.resize({50, 60});
  EXPECT_THAT(waiting(window), testing::ElementsAre(std::pair(Kind::kResize, ""), std::pair(Kind::kResize, "")));
  EXPECT_THROW(window.resize({0, 60}), ContractViolation);
  EXPECT_THROW(RecordingWindow({4, 0}), ContractViolation);
}

TEST(RecordingWindow, KeepsTheLastFrameAndHandsOutEach) {
  RecordingWindow window({4, 3});
  EXPECT_EQ(window.frame(), Raster());
  EXPECT_EQ(window.frames(), 0u);
  window.show(Raster(4, 3, 0xFF112233));
  std::vector<Raster> watched;
  window.on_frame([&](const Raster& frame) {
    EXPECT_EQ(window.frames(), watched.size() + 2);
    EXPECT_EQ(window.frame(), frame);
    watched.push_back(frame);
  });
  window.show(Raster(4, 3, 0xFF445566));
  window.show(Raster(7, 2, 0xFF778899));
  EXPECT_EQ(window.frames(), 3u);
  EXPECT_EQ(window.frame(), Raster(7, 2, 0xFF778899));
  EXPECT_THAT(watched, testing::ElementsAre(Raster(4, 3, 0xFF445566), Raster(7, 2, 0xFF778899)));
}

TEST(RecordingWindow, RemembersTitleAndClipboard) {
  RecordingWindow window({4, 3});
  EXPECT_EQ(window.title(), "");
  window.set_title("room.json");
  window.set_clipboard("F(a, b) = 0.5");
  EXPECT_EQ(window.title(), "room.json");
  EXPECT_EQ(window.clipboard(), "F(a, b) = 0.5");
}

TEST(RecordingWindow, StopsWaitingWhenAStopIsAskedFor) {
  RecordingWindow window({4, 3});
  std::atomic<bool> stop{false};
  const StopScope scope(&stop);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop = true;
  });
  Stopwatch watch;
  EXPECT_THROW(window.next(60), Interrupted);
  EXPECT_LT(watch.lap(), 10);
  other.join();
  EXPECT_THROW(window.next(0), Interrupted);
}

}  // namespace
}  // namespace hottel::recording_window_test

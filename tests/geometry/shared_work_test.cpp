// Tasks that are dealt out.
#include "geometry/shared_work.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>
#include <vector>

namespace hottel::shared_work_test {
namespace {

// (1)
TEST(WorkQueue, DealsEachTaskOnceToAnyNumberOfThreads) {
  WorkQueue queue({.count = 100'000, .dear = 37, .most = 64}, 3);
  std::vector<std::vector<WorkRange>> taken(3);
  std::vector<std::thread> threads;
  for (auto& mine : taken)
    threads.emplace_back([&queue, &mine] {
      for (WorkRange range = queue.take(); !range.is_empty(); range = queue.take()) mine.push_back(range);
    });
  for (std::thread& thread : threads) thread.join();
  WorkCount count;
  for (const auto& mine : taken)
    for (const WorkRange& range : mine) count.add(range);
  EXPECT_TRUE(count.has_each_once(100'000));
}

// (1)
TEST(WorkQueue, DealsWhatIsGivenBackAgain) {
  WorkQueue queue({.count = 10}, 1);
  const WorkRange first = queue.take();
  queue.give_back(first);
  EXPECT_EQ(queue.take(), first);
  EXPECT_EQ(queue.take().begin, first.end);
}

// (2)
TEST(WorkQueue, DealsTheDearOneByOneAndTheOthersWithinTheirSizes) {
  WorkQueue queue({.count = 1000, .dear = 5, .least = 10, .most = 20}, 2);
  EXPECT_EQ(queue.take(), (WorkRange{0, 1}));
  EXPECT_EQ(queue.take(3), (WorkRange{1, 4})) << "one for each hand";
  EXPECT_EQ(queue.take(3), (WorkRange{4, 5})) << "dear ones and others never come together";
  std::size_t end = 5;
  for (WorkRange range = queue.take(); !range.is_empty(); range = queue.take()) {
    EXPECT_EQ(range.begin, end);
    end = range.end;
    if (end < 1000) {
      EXPECT_GE(range.size(), 10u);
    }
    EXPECT_LE(range.size(), 20u);
  }
  EXPECT_EQ(end, 1000u);
}

// (3)
TEST(WorkQueue, HasNothingAfterAStop) {
  WorkQueue queue({.count = 10}, 1);
  queue.give_back(queue.take());
  queue.stop();
  EXPECT_TRUE(queue.take().is_empty());
}

TEST(WorkCount, HasEachOnceWhereAnObviousCountSaysSo) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 2000; ++k) {
    const std::size_t n = 1 + random() % 6;
    WorkCount count;
    std::multiset<std::size_t> tasks;
    for (std::size_t ranges = random() % 5; ranges > 0; --ranges) {
      const std::size_t begin = random() % n, end = begin + 1 + random() % (n - begin);
      count.add({begin, end});
      for (std::size_t task = begin; task < end; ++task) tasks.insert(task);
    }
    bool is_once = true;
    for (std::size_t task = 0; task < n; ++task) is_once = is_once && tasks.count(task) == 1;
    EXPECT_EQ(count.has_each_once(n), is_once);
  }
}

}  // namespace
}  // namespace hottel::shared_work_test

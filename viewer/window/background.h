// Work beside a window: the last that was asked for, on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "kernel/support/stage.h"

namespace hottel {

// Does one piece of work after another, of those that wait the last one only.
//
//   (1) work that is asked for by post() while other work runs stops that: its progress throws Interrupted. By follow()
//       it waits for what runs, which is collected: so something new comes however fast work is asked for
//   (2) what a piece of work returns is called by collect(), on the thread that calls it; not where the work was
//       stopped, threw, or was followed by other work before it was collected
//   (3) with steps: work may call `tell` with something to be called by collect() before it is done
//   (4) the destructor stops what runs, and waits for that
// What work throws is dropped: work that can fail returns what tells of it.
class Background {
 public:
  using Apply = std::function<void()>;
  using Tell = std::function<void(Apply)>;
  using Work = std::function<Apply(const StageProgress& progress, const Tell& tell)>;

  // changed: called on the thread of the work when there is something to collect; must be quick.
  explicit Background(std::function<void()> changed = {});
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  void post(Work work);
  void follow(Work work);
  // Stops what runs and drops what waits.
  void cancel();
  // Calls what was returned and told since; returns whether there was anything.
  bool collect();
  // True while work waits or runs, or something is to be collected.
  bool is_busy() const;

 private:
  void run();

  const std::function<void()> changed_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::optional<Work> waiting_;
  std::vector<Apply> told_;
  std::uint64_t asked_ = 0;  // counts post() and cancel()
  bool is_running_ = false;
  bool is_stopping_ = false;
  std::atomic<bool> is_dropped_{false};  // what runs is not wanted any more
  std::thread thread_;
};

}  // namespace hottel

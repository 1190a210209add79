// Values that are made when they are first asked for, each once, and shared by all who ask.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace hottel {

// Told to who waits, on the waiting thread, about every 5 ms: the stage that runs, and the fraction of it that is
// done. May throw: then the wait is over, and what it threw is thrown by who was asked.
using StageProgress = std::function<void(std::string_view stage, double fraction)>;

// Progress of one function, told as that of a stage. REQUIRES: the name outlives it.
inline std::function<void(double)> telling(const char* stage, const StageProgress& progress) {
  return [stage, progress](double fraction) { progress(stage, fraction); };
}

// A value of any type, made by a thread of its own. See Stage.
class AnyStage {
 public:
  using Value = std::shared_ptr<const void>;
  using Make = std::function<Value(const StageProgress& progress)>;

  AnyStage(std::string name, Make make) : name_(std::move(name)), make_(std::move(make)) {}
  ~AnyStage();
  AnyStage(const AnyStage&) = delete;
  AnyStage& operator=(const AnyStage&) = delete;

  Value get(const StageProgress& progress);
  Value peek() const;
  const std::string& name() const { return name_; }

 private:
  enum class State { kAbsent, kRunning, kDone, kFailed };

  void start();
  void run();
  void leave();
  void wait_a_tick(std::unique_lock<std::mutex>& lock, const StageProgress& progress);

  const std::string name_;
  Make make_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
  State state_ = State::kAbsent;
  std::size_t waiting_ = 0;
  std::atomic<bool> is_stopped_{false};
  Value value_;
  std::exception_ptr failure_;
  std::string told_stage_;  // the last that was told of what runs
  double told_fraction_ = 0;
};

// A value made when it is first asked for, by a thread of its own, from inputs that never change.
//
//   (1) it is made once, however many threads ask at once; the others wait
//   (2) who waits may be dropped: by what its progress throws, or, with Interrupted, by its own StopScope or
//       request_interrupt(). Others go on waiting
//   (3) when nobody waits any more, the work is asked to stop (StopScope). It leaves the value absent, never half
//       made, and the next one to ask begins anew; work that ends all the same leaves the value it made
//   (4) what the work throws, but Interrupted, is thrown to all who ask, now and later; bad_alloc as OutOfMemory
//   (5) the destructor stops what runs and waits for it
// REQUIRES: `make` holds what it needs, and nothing that holds this; it passes its progress on to stages that it asks.
// COST: a thread, about 20 µs, the first time; afterwards a lock.
template <class T>
class Stage {
 public:
  using Make = std::function<T(const StageProgress& progress)>;

  Stage(std::string name, Make make)
      : any_(std::move(name), [make = std::move(make)](const StageProgress& progress) -> AnyStage::Value {
          return std::make_shared<const T>(make(progress));
        }) {}

  // Returns the value, made now if it is not there. progress: told while this waits.
  std::shared_ptr<const T> get(const StageProgress& progress = {}) {
    return std::static_pointer_cast<const T>(any_.get(progress));
  }
  // Returns the value if it is there, else null. Never waits for it.
  std::shared_ptr<const T> peek() const { return std::static_pointer_cast<const T>(any_.peek()); }

 private:
  AnyStage any_;
};

}  // namespace hottel

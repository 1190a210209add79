// Values that are computed when they are first asked for, once each, and shared by all who ask.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "kernel/support/interrupt.h"

namespace hottel {

// Progress of one function, passed on as progress of a stage. REQUIRES: the name outlives it.
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

// A value that a thread of its own computes when it is first asked for, from inputs that never change.
//
//   (1) it is computed once, however many threads ask at once; the others wait
//   (2) one waiting thread can be cancelled: by an exception of its progress function, or, with Interrupted, by its own
//       StopScope or request_interrupt(). Others go on waiting
//   (3) when no thread waits any more, the computation is asked to stop (StopScope). The value is then absent, never
//       half made, and the next call begins it anew; a computation that ends all the same leaves its value
//   (4) what the computation throws, except Interrupted, is thrown to all callers, now and later; bad_alloc as
//       OutOfMemory
//   (5) the destructor stops a running computation and waits for it
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

// How far work has come, and requests to stop: to all work from a signal handler, or to one piece of work from who
// started it.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <string_view>
#include <utility>

namespace hottel {

// Called on a waiting thread about every 5 ms: the name of the stage that runs, and the fraction of it that is
// done. It may throw: this ends the wait, and the exception goes on to the caller of the stage.
using StageProgress = std::function<void(std::string_view stage, double fraction)>;

// Thrown where work stops because it was asked to. The program then exits with 130; no output has been replaced. It is
// no std::runtime_error: who catches failures of input or request does not catch it.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// Set once and for all: nothing in the library takes a request back.
inline std::atomic<bool> interrupt_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets this flag");

// Asks all work to stop. May be called from a signal handler and from any thread.
inline void request_interrupt() noexcept { interrupt_flag.store(true, std::memory_order_relaxed); }

// The flag that stops the work which this thread does now; null: only request_interrupt() does.
inline thread_local const std::atomic<bool>* stop_flag = nullptr;

// While it lives, work of this thread, and of those that parallel_ranges() gives parts of it, is asked to stop once the
// flag is set. REQUIRES: made and destroyed on one thread; the flag outlives it.
class StopScope {
 public:
  explicit StopScope(const std::atomic<bool>* flag) : before_(std::exchange(stop_flag, flag)) {}
  ~StopScope() { stop_flag = before_; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  const std::atomic<bool>* before_;
};

// True after request_interrupt(), on every thread, and where this thread's own work is asked to stop (StopScope).
// COST: two relaxed loads; poll it at least every tenth of a second in work that may be long.
inline bool interrupted() noexcept {
  return interrupt_flag.load(std::memory_order_relaxed) ||
         (stop_flag != nullptr && stop_flag->load(std::memory_order_relaxed));
}

// Throws Interrupted where a stop was asked for.
inline void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace hottel

// A request to stop, from a signal handler to work that polls it.
#pragma once

#include <atomic>
#include <exception>

namespace hottel {

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

// True after request_interrupt(), on every thread.
// COST: one relaxed load; poll it at least every tenth of a second in work that may be long.
inline bool interrupted() noexcept { return interrupt_flag.load(std::memory_order_relaxed); }

// Throws Interrupted where a stop was asked for.
inline void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace hottel

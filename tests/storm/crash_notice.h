// Tells which scene a thread was at when a signal ends the program.
#pragma once

#include <csignal>
#include <cstdint>
#include <vector>

namespace hottel::storm {

// While it lives, SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT write to standard error how to begin again at the scene
// of the thread that they hit, and then do what they did before. One at a time.
class CrashNotice {
 public:
  CrashNotice();
  ~CrashNotice();
  CrashNotice(const CrashNotice&) = delete;
  CrashNotice& operator=(const CrashNotice&) = delete;

  static constexpr int kSolids = -1, kRooms = -2, kHiding = -3;

  // What this thread is at; k of the lattice in the plane, 0 for a pair in space, kSolids for solids there, kRooms
  // for furnished rooms, kHiding for bodies that hide. REQUIRES that law lives as long as the thread is at it.
  static void is_at(std::uint64_t scene, int k, const char* law);
};

// While it lives, signals of this thread have a stack of their own: its stack may be what overflowed.
class SignalStack {
 public:
  SignalStack();
  ~SignalStack();
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;

 private:
  std::vector<char> memory_;
  stack_t before_{};
};

}  // namespace hottel::storm

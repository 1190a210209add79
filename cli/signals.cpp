#include "cli/signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "io/external/external_command.h"
#include "io/files/pending_removal.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

[[noreturn]] void end_now(int signal) {
  kill_external_command();
  remove_pending();
  ::_exit(128 + signal);
}

std::atomic<int> asked_by{0};  // the signal that asked for a stop
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");

bool first_signal_ends = false;

}  // namespace

extern "C" {

// What was asked to stop has not within a second.
static void hottel_on_alarm(int) { end_now(asked_by == 0 ? SIGINT : asked_by.load()); }

static void hottel_on_stop(int signal) {
  if (first_signal_ends || interrupted()) end_now(signal);
  asked_by = signal;
  request_interrupt();
  ::alarm(1);
}
}

int code_of_interruption() { return 128 + (asked_by == 0 ? SIGINT : asked_by.load()); }

void install_signal_handlers(bool ends_at_first) {
  first_signal_ends = ends_at_first;
  struct sigaction action {};
  sigfillset(&action.sa_mask);
  action.sa_handler = hottel_on_alarm;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = hottel_on_stop;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, &action, &before);
  if (before.sa_handler == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // started by nohup
  std::signal(SIGCHLD, SIG_DFL);                                   // where it is ignored a command's status is lost
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace hottel

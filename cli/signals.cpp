#include "cli/signals.h"

#include <unistd.h>

#include <csignal>

#include "io/files/pending_removal.h"
#include "io/foreign/foreign_command.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

[[noreturn]] void end_now(int signal) {
  kill_foreign_command();
  remove_pending();
  ::_exit(128 + signal);
}

}  // namespace

extern "C" {

static void hottel_end_now(int signal) { end_now(signal == SIGALRM ? SIGINT : signal); }

static void hottel_on_interrupt(int) {
  if (interrupted()) end_now(SIGINT);
  request_interrupt();
  ::alarm(1);
}
}

void install_signal_handlers() {
  struct sigaction action {};
  sigfillset(&action.sa_mask);
  action.sa_handler = hottel_on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  action.sa_handler = hottel_end_now;
  for (const int signal : {SIGALRM, SIGTERM}) sigaction(signal, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, &action, &before);
  if (before.sa_handler == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // started by nohup
  std::signal(SIGCHLD, SIG_DFL);                                   // where it is ignored a command's status is lost
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace hottel

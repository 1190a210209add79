#include "tests/storm/crash_notice.h"

#include <unistd.h>

#include <array>
#include <cstddef>

namespace hottel::storm {

namespace {

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, kSignals.size()> before;

struct Place {
  std::uint64_t scene = 0;
  int k = 0;
  const char* law = nullptr;
};
thread_local Place place;

// A line put together without anything that a signal handler may not call.
class Line {
 public:
  Line& operator<<(const char* text) {
    for (; *text != '\0' && size_ < text_.size(); ++text) text_[size_++] = *text;
    return *this;
  }
  Line& operator<<(std::uint64_t number) {
    std::array<char, 21> digits{};
    std::size_t first = digits.size() - 1;
    do digits[--first] = static_cast<char>('0' + number % 10);
    while ((number /= 10) > 0);
    return *this << &digits[first];
  }
  void write() const {
    const auto written = ::write(STDERR_FILENO, text_.data(), size_);
    static_cast<void>(written);  // nothing can be done about it
  }

 private:
  std::array<char, 256> text_{};
  std::size_t size_ = 0;
};

void tell(int signal, siginfo_t* info, void*) {
  if (place.law != nullptr) {
    Line line;
    line << "\nsignal " << static_cast<std::uint64_t>(signal) << " at scene " << place.scene << ", law: " << place.law
         << "\nagain: hottel_storm --seed " << place.scene << " --scenes 1 --all";
    if (place.k <= 0)
      line << " --dimension 3"
           << (place.k == CrashNotice::kSolids   ? " --solids\n"
               : place.k == CrashNotice::kRooms  ? " --rooms\n"
               : place.k == CrashNotice::kHiding ? " --hiding\n"
                                                 : "\n");
    else
      line << " --k " << static_cast<std::uint64_t>(place.k) << "\n";
    line.write();
  }
  for (std::size_t s = 0; s < kSignals.size(); ++s)
    if (kSignals[s] == signal) sigaction(signal, &before[s], nullptr);
  if (info->si_code <= 0) raise(signal);  // it was sent; what an instruction did it will do again
}

}  // namespace

CrashNotice::CrashNotice() {
  struct sigaction action {};
  action.sa_sigaction = tell;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (std::size_t s = 0; s < kSignals.size(); ++s) sigaction(kSignals[s], &action, &before[s]);
}

CrashNotice::~CrashNotice() {
  for (std::size_t s = 0; s < kSignals.size(); ++s) sigaction(kSignals[s], &before[s], nullptr);
}

void CrashNotice::is_at(std::uint64_t scene, int k, const char* law) { place = {scene, k, law}; }

SignalStack::SignalStack() : memory_(1 << 16) {
  const stack_t stack{memory_.data(), 0, memory_.size()};
  sigaltstack(&stack, &before_);
}

SignalStack::~SignalStack() { sigaltstack(&before_, nullptr); }

}  // namespace hottel::storm

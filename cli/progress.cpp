#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

constexpr int kBarWidth = 24;

std::string time_left(double seconds) {
  const long s = std::lround(std::min(seconds, 360000.0));
  if (s < 60) return fmt::format("{} s", std::max(s, 1L));
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

void write_to_stderr(const std::string& text) {
  // A progress bar that cannot be drawn is no reason to stop.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

constexpr const char* kWiped = "\r\033[K";

std::atomic<int> bars_drawn{0};

}  // namespace

std::string progress_line(const std::string& what, double fraction, double seconds_so_far) {
  const double f = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(f * kBarWidth);
  std::string line = fmt::format("{}  [{}{}]  {:3.0f} %", what, std::string(static_cast<std::size_t>(filled), '#'),
                                 std::string(static_cast<std::size_t>(kBarWidth - filled), '.'), std::floor(f * 100));
  if (f > 0) line += fmt::format("  {} left", time_left(seconds_so_far * (1 - f) / f));
  return line;
}

Progress::Progress(std::string what, bool is_shown, double total)
    : what_(std::move(what)), is_shown_(is_shown), total_(total) {}

Progress::~Progress() {
  if (!is_drawn_) return;
  write_to_stderr(kWiped);
  --bars_drawn;
}

void Progress::make_room() {
  if (bars_drawn > 0) write_to_stderr(kWiped);
}

bool Progress::is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

void Progress::update(double fraction) {
  const double done = fraction * total_;
  double before = done_.load(std::memory_order_relaxed);
  while (before < done && !done_.compare_exchange_weak(before, done, std::memory_order_relaxed)) {
  }
  draw_when_due(std::max(before, done) / total_);
}

void Progress::advance(double amount) {
  draw_when_due((done_.fetch_add(amount, std::memory_order_relaxed) + amount) / total_);
}

void Progress::draw_when_due(double fraction) {
  if (!is_shown_) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const long now = static_cast<long>(seconds * 1000);
  long due = next_draw_ms_.load(std::memory_order_relaxed);
  if (now < due || !next_draw_ms_.compare_exchange_strong(due, now + 100)) return;
  if (!is_drawn_.exchange(true)) ++bars_drawn;
  write_to_stderr(fmt::format("\r{}\033[K", progress_line(what_, fraction, seconds)));
}

}  // namespace hottel

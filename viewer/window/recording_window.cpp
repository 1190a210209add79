#include "viewer/window/recording_window.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr double kLongestWait = 0.05;  // seconds, until interrupted() is asked again

}  // namespace

RecordingWindow::RecordingWindow(FrameSize size) : size_(size) { HOTTEL_REQUIRE(size.width > 0 && size.height > 0); }

FrameSize RecordingWindow::size() const {
  const std::scoped_lock lock(mutex_);
  return size_;
}

std::optional<WindowEvent> RecordingWindow::next(double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto left = [&] { return seconds - std::chrono::duration<double>(Clock::now() - start).count(); };
  std::unique_lock lock(mutex_);
  for (double wait = seconds; events_.empty() && wait > 0; wait = left()) {
    throw_if_interrupted();
    has_event_.wait_for(lock, std::chrono::duration<double>(std::min(wait, kLongestWait)));
  }
  throw_if_interrupted();
  if (events_.empty()) return std::nullopt;
  WindowEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

void RecordingWindow::wake() {
  {
    const std::scoped_lock lock(mutex_);
    const auto is_wake = [](const WindowEvent& e) { return e.kind == WindowEvent::Kind::kWake; };
    if (std::any_of(events_.begin(), events_.end(), is_wake)) return;
    events_.push_back({.kind = WindowEvent::Kind::kWake});
  }
  has_event_.notify_one();
}

void RecordingWindow::show(const Raster& frame) {
  std::function<void(const Raster&)> watcher;
  {
    const std::scoped_lock lock(mutex_);
    frame_ = frame;
    ++frames_;
    watcher = watcher_;
  }
  if (watcher) watcher(frame);
}

void RecordingWindow::set_title(std::string_view title) {
  const std::scoped_lock lock(mutex_);
  title_ = title;
}

void RecordingWindow::set_clipboard(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  clipboard_ = text;
}

void RecordingWindow::push(WindowEvent event) {
  {
    const std::scoped_lock lock(mutex_);
    events_.push_back(std::move(event));
  }
  has_event_.notify_one();
}

void RecordingWindow::resize(FrameSize size) {
  HOTTEL_REQUIRE(size.width > 0 && size.height > 0);
  {
    const std::scoped_lock lock(mutex_);
    size_ = size;
    events_.push_back({.kind = WindowEvent::Kind::kResize});
  }
  has_event_.notify_one();
}

void RecordingWindow::on_frame(std::function<void(const Raster&)> watcher) {
  const std::scoped_lock lock(mutex_);
  watcher_ = std::move(watcher);
}

Raster RecordingWindow::frame() const {
  const std::scoped_lock lock(mutex_);
  return frame_;
}

std::size_t RecordingWindow::frames() const {
  const std::scoped_lock lock(mutex_);
  return frames_;
}

std::string RecordingWindow::title() const {
  const std::scoped_lock lock(mutex_);
  return title_;
}

std::string RecordingWindow::clipboard() const {
  const std::scoped_lock lock(mutex_);
  return clipboard_;
}

}  // namespace hottel

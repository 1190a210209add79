// A window without a screen: for scripts, recordings and tests.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/window/window.h"

namespace hottel {

// Gives back the events that are pushed into it, and remembers what it is shown.
//
//   (1) next() returns the events in the order in which they came, each once, at once where there is one
//   (2) a kWake comes in its turn; while one waits for its turn, wake() adds none
//   (3) resize() gives a kResize, also where the size stays; size() is the new one at once
//   (4) frame() is what was shown last, of the size it had
//
// Any thread may call any function but show(), which belongs to the one that calls next().
class RecordingWindow : public Window {
 public:
  // Throws ContractViolation unless both sides are positive.
  explicit RecordingWindow(FrameSize size);

  FrameSize size() const override;
  std::optional<WindowEvent> next(double seconds) override;
  void wake() override;
  void show(const Raster& frame) override;
  void set_title(std::string_view title) override;
  void set_clipboard(std::string_view text) override;

  // What next() shall return.
  void push(WindowEvent event);
  // Throws ContractViolation unless both sides are positive.
  void resize(FrameSize size);
  // show() calls it with every frame, after the frame has been counted and kept.
  void on_frame(std::function<void(const Raster&)> watcher);

  // Without pixels where nothing has been shown.
  Raster frame() const;
  std::size_t frames() const;  // shown so far
  std::string title() const;
  std::string clipboard() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable has_event_;
  std::deque<WindowEvent> events_;
  FrameSize size_;
  Raster frame_;
  std::size_t frames_ = 0;
  std::string title_, clipboard_;
  std::function<void(const Raster&)> watcher_;
};

}  // namespace hottel

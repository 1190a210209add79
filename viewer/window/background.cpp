#include "viewer/window/background.h"

#include <exception>
#include <utility>

#include "kernel/support/interrupt.h"

namespace hottel {

Background::Background(std::function<void()> changed) : changed_(std::move(changed)), thread_([this] { run(); }) {}

Background::~Background() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
    is_dropped_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void Background::post(Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(work);
    ++asked_;
    is_dropped_ = true;
    told_.clear();
  }
  news_.notify_all();
}

void Background::follow(Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(work);
  }
  news_.notify_all();
}

void Background::cancel() {
  const std::lock_guard lock(mutex_);
  waiting_.reset();
  ++asked_;
  is_dropped_ = true;
  told_.clear();
}

bool Background::collect() {
  std::vector<Apply> told;
  {
    const std::lock_guard lock(mutex_);
    told = std::exchange(told_, {});
  }
  for (const Apply& apply : told) apply();
  return !told.empty();
}

bool Background::is_busy() const {
  const std::lock_guard lock(mutex_);
  return waiting_ || is_running_ || !told_.empty();
}

void Background::run() {
  for (;;) {
    Work work;
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex_);
      is_running_ = false;
      news_.wait(lock, [this] { return is_stopping_ || waiting_; });
      if (is_stopping_) return;
      work = *std::exchange(waiting_, std::nullopt);
      number = asked_;
      is_running_ = true;
      is_dropped_ = false;
    }
    const StopScope scope(&is_dropped_);
    const Tell tell = [this, number](Apply apply) {
      {
        const std::lock_guard lock(mutex_);
        if (asked_ != number || !apply) return;
        told_.push_back(std::move(apply));
      }
      if (changed_) changed_();
    };
    const StageProgress progress = [](std::string_view, double) { throw_if_interrupted(); };
    try {
      tell(work(progress, tell));
    } catch (const std::exception&) {  // Interrupted too: nobody waits for it
    }
  }
}

}  // namespace hottel

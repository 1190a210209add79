#include "kernel/support/stage.h"

#include <chrono>

#include "kernel/support/interrupt.h"
#include "kernel/support/out_of_memory.h"
#include "kernel/support/thread_share.h"

namespace hottel {
namespace {

constexpr std::chrono::milliseconds kTick{5};

}  // namespace

AnyStage::~AnyStage() {
  is_stopped_ = true;
  if (thread_.joinable()) thread_.join();
}

AnyStage::Value AnyStage::peek() const {
  const std::lock_guard lock(mutex_);
  return value_;
}

AnyStage::Value AnyStage::get(const StageProgress& progress) {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (state_ == State::kDone) return value_;
    if (state_ == State::kFailed) std::rethrow_exception(failure_);
    if (state_ == State::kAbsent) {
      throw_if_interrupted();
      start();
    }
    // Work that is stopping cannot be joined, only waited for: then it begins anew, by us or by another.
    const bool joins = !is_stopped_;
    waiting_ += joins;
    try {
      while (state_ == State::kRunning && joins == !is_stopped_) wait_a_tick(lock, progress);
    } catch (...) {
      if (joins) leave();
      throw;
    }
    waiting_ -= joins;
  }
}

// REQUIRES the lock, and that nothing runs.
void AnyStage::start() {
  if (thread_.joinable()) thread_.join();  // it has nothing left to do
  is_stopped_ = false;
  told_stage_ = name_;
  told_fraction_ = 0;
  thread_ = std::thread([this, threads = thread_share()] {
    const ThreadShare share(threads);
    run();
  });
  state_ = State::kRunning;
}

// REQUIRES the lock.
void AnyStage::leave() {
  if (--waiting_ == 0 && state_ == State::kRunning) is_stopped_ = true;
}

// REQUIRES the lock, and has it again when it returns or throws.
void AnyStage::wait_a_tick(std::unique_lock<std::mutex>& lock, const StageProgress& progress) {
  if (changed_.wait_for(lock, kTick, [this] { return state_ != State::kRunning; })) return;
  const std::string stage = told_stage_;
  const double fraction = told_fraction_;
  struct Unlocked {
    std::unique_lock<std::mutex>& lock;
    explicit Unlocked(std::unique_lock<std::mutex>& l) : lock(l) { lock.unlock(); }
    ~Unlocked() { lock.lock(); }
  } const unlocked(lock);
  throw_if_interrupted();
  if (progress) progress(stage, fraction);
}

void AnyStage::run() {
  const StopScope scope(&is_stopped_);
  const StageProgress tell = [this](std::string_view stage, double fraction) {
    throw_if_interrupted();
    const std::lock_guard lock(mutex_);
    told_stage_ = stage;
    told_fraction_ = fraction;
  };
  Value value;
  std::exception_ptr failure;
  try {
    value = make_(tell);
    make_ = nullptr;  // its inputs are not needed again
  } catch (const Interrupted&) {
  } catch (const OutOfMemory&) {  // of a stage before it
    failure = std::current_exception();
  } catch (const std::bad_alloc&) {
    failure = std::make_exception_ptr(OutOfMemory(name_));
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  value_ = std::move(value);
  failure_ = failure;
  state_ = value_ ? State::kDone : failure_ ? State::kFailed : State::kAbsent;
  changed_.notify_all();
}

}  // namespace hottel

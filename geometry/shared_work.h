// Numbered tasks that are dealt out to threads here, and to others elsewhere.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {

// Tasks from begin up to, and without, end.
struct WorkRange {
  std::size_t begin = 0, end = 0;

  bool is_empty() const { return begin == end; }
  std::size_t size() const { return end - begin; }
  friend bool operator==(const WorkRange&, const WorkRange&) = default;
};

// So many tasks, and how they are dealt: of the first ones, the dear, one at a time; of the others from least to most.
struct WorkSizes {
  std::size_t count = 0, dear = 0, least = 1, most = 1;
};

// Deals tasks out in their order, many at the beginning and few at the end. For several threads at once.
//
//   (1) each task is dealt once, and once more for each time that it was given back
//   (2) a hand gets one of the dear tasks, or from least to most of the others where there are as many
//   (3) after stop() none is left
class WorkQueue {
 public:
  // hands: how many threads work, here and elsewhere. REQUIRES dear <= count, hands >= 1, 1 <= least <= most.
  WorkQueue(const WorkSizes& sizes, std::size_t hands) : sizes_(sizes), hands_(hands) {}

  // Tasks for so many of the hands; empty where none is left. REQUIRES for_hands >= 1.
  WorkRange take(std::size_t for_hands = 1) {
    const std::lock_guard lock(mutex_);
    if (is_stopped_) return {};
    if (!returned_.empty()) {
      const WorkRange range = returned_.back();
      returned_.pop_back();
      return range;
    }
    const bool is_dear = next_ < sizes_.dear;
    const std::size_t left = (is_dear ? sizes_.dear : sizes_.count) - next_;
    const std::size_t share = is_dear ? 1 : std::clamp(left / (kTurns * hands_), sizes_.least, sizes_.most);
    const std::size_t begin = next_;
    next_ += std::min(left, share * for_hands);
    return {begin, next_};
  }
  // Deals these again: who had them could not do them.
  void give_back(const WorkRange& range) {
    const std::lock_guard lock(mutex_);
    returned_.push_back(range);
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }

 private:
  static constexpr std::size_t kTurns = 8;  // so many for each hand, if all took as much as now

  const WorkSizes sizes_;
  const std::size_t hands_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::vector<WorkRange> returned_;
  bool is_stopped_ = false;
};

// What somebody gets who asks for work: tasks to be done here, or what others found, or nothing as all is over.
template <class Done>
struct WorkTurn {
  WorkRange here{};
  std::optional<Done> there{};

  bool is_over() const { return here.is_empty() && !there.has_value(); }
};

// Who does which tasks, and how what others found comes here.
template <class Done>
class SharedWork {
 public:
  virtual ~SharedWork() = default;

  // The next turn of the thread that asks. It waits where all is dealt and others are not done, and throws Interrupted
  // where it is asked to stop.
  //
  //   (1) each task is in one turn: to be done here, or done elsewhere
  //   (2) it is over for all threads as soon as all tasks are in turns, or after stop()
  virtual WorkTurn<Done> next() = 0;
  // Ends it for all threads: one of them has failed.
  virtual void stop() = 0;
};

// Who takes part in jobs of one kind. What others find must be what is found here, bit for bit.
template <class Job, class Done>
class WorkCrew {
 public:
  virtual ~WorkCrew() = default;
  // Begins to share; null where this job is done here alone. From any thread. REQUIRES that the job outlives the work.
  virtual std::unique_ptr<SharedWork<Done>> begin(const Job& job) = 0;
};

// While it lives, this crew takes part in the jobs of all threads of this process. Results do not depend on it.
// Throws ContractViolation where there is one already.
template <class Crew>
class CrewScope {
 public:
  explicit CrewScope(Crew& crew) {
    Crew* none = nullptr;
    HOTTEL_REQUIRE(crew_.compare_exchange_strong(none, &crew));
  }
  ~CrewScope() { crew_ = nullptr; }
  CrewScope(const CrewScope&) = delete;
  CrewScope& operator=(const CrewScope&) = delete;

  // Null where there is none.
  static Crew* crew() { return crew_; }

 private:
  static inline std::atomic<Crew*> crew_{nullptr};
};

// All tasks are done here.
template <class Done>
class OwnWork : public SharedWork<Done> {
 public:
  // As of WorkQueue.
  OwnWork(const WorkSizes& sizes, std::size_t hands) : queue_(sizes, hands) {}

  WorkTurn<Done> next() override { return {.here = queue_.take()}; }
  void stop() override { queue_.stop(); }

 private:
  WorkQueue queue_;
};

// Counts the tasks of turns. For one thread at a time.
class WorkCount {
 public:
  void add(const WorkRange& range) { done_.push_back(range); }
  void add(const WorkCount& other) { done_.insert(done_.end(), other.done_.begin(), other.done_.end()); }
  // True iff each of so many was counted once. COST: n log n in the ranges.
  bool has_each_once(std::size_t count) {
    std::ranges::sort(done_, {}, &WorkRange::begin);
    std::size_t end = 0;
    for (const WorkRange& range : done_) {
      if (range.begin != end || range.end < end) return false;
      end = range.end;
    }
    return end == count;
  }

 private:
  std::vector<WorkRange> done_;
};

// Shares a job with the crew of this process; does it here alone where there is none, or it does not take part.
template <class Done, class Job>
std::unique_ptr<SharedWork<Done>> begin_shared(const Job& job) {
  if (WorkCrew<Job, Done>* const crew = CrewScope<WorkCrew<Job, Done>>::crew())
    if (auto work = crew->begin(job)) return work;
  return std::make_unique<OwnWork<Done>>(job.tasks, static_cast<std::size_t>(threads_allowed()));
}

// Calls take(turn) for all turns of some work, on so many threads at once; on this one where it is one. Throws what
// that throws, which ends the work, and ContractViolation unless each of so many tasks came once.
template <class Done, class Take>
void take_all_turns(SharedWork<Done>& work, std::size_t tasks, int threads, const Take& take) {
  const DefaultFloatingPoint environment;
  WorkCount done;
  std::mutex together;
  const auto take_some = [&](std::size_t) {
    WorkCount mine;
    try {
      for (WorkTurn<Done> turn = work.next(); !turn.is_over(); turn = work.next()) {
        mine.add(turn.there ? turn.there->tasks : turn.here);
        take(std::move(turn));
      }
    } catch (...) {
      work.stop();
      throw;
    }
    const std::lock_guard lock(together);
    done.add(mine);
  };
  if (threads == 1)
    take_some(0);  // which may have all threads for itself
  else
    parallel_for(static_cast<std::size_t>(threads), take_some);
  HOTTEL_REQUIRE(done.has_each_once(tasks));
}

}  // namespace hottel

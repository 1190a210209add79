// Work that is shared with nobody, but as others might: in a random order, with a random part of it done elsewhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

#include "geometry/plane/exchange/sweep_crew.h"
#include "geometry/shared_work.h"
#include "geometry/space/exchange/pair_crew.h"

namespace hottel {

enum class WorkFault : unsigned char { kNone, kLost, kTwice };

// Cuts tasks into ranges at random and deals these in a random order, about half of them done elsewhere. A fault is
// that the first of those that are done elsewhere is lost, or comes twice.
template <class Done>
class ShuffledWork : public SharedWork<Done> {
 public:
  ShuffledWork(std::size_t count, std::uint64_t seed, WorkFault fault, std::function<Done(const WorkRange&)> elsewhere)
      : fault_(fault), elsewhere_(std::move(elsewhere)), random_(seed) {
    for (std::size_t begin = 0; begin < count;) {
      const std::size_t end = std::min(count, begin + 1 + random_() % (1 + count / 8));
      left_.push_back({begin, end});
      begin = end;
    }
    std::shuffle(left_.begin(), left_.end(), random_);
  }

  WorkTurn<Done> next() override {
    const std::lock_guard lock(mutex_);
    while (!left_.empty()) {
      const WorkRange range = left_.back();
      left_.pop_back();
      const bool is_last = left_.empty() && fault_ != WorkFault::kNone;
      if (!is_last && random_() % 2 == 0) return {.here = range};
      const WorkFault fault = std::exchange(fault_, WorkFault::kNone);
      if (fault == WorkFault::kLost) continue;
      if (fault == WorkFault::kTwice) left_.push_back(range);
      return {.there = elsewhere_(range)};
    }
    return {};
  }
  void stop() override {
    const std::lock_guard lock(mutex_);
    left_.clear();
  }

 private:
  WorkFault fault_;
  const std::function<Done(const WorkRange&)> elsewhere_;
  std::mt19937_64 random_;
  std::mutex mutex_;
  std::vector<WorkRange> left_;
};

// Crews of such work.
class ShuffledCrew3 : public PairCrew3 {
 public:
  explicit ShuffledCrew3(std::uint64_t seed, WorkFault fault = WorkFault::kNone) : seed_(seed), fault_(fault) {}
  std::unique_ptr<PairWork3> begin(const PairJob3& job) override {
    ++sums_;
    return std::make_unique<ShuffledWork<DoneTasks3>>(job.tasks.count, seed_, fault_, elsewhere(job));
  }
  int sums() const { return sums_; }

 protected:
  virtual std::function<DoneTasks3(const WorkRange&)> elsewhere(const PairJob3& job) {
    const auto helper = std::make_shared<PairHelper3>(job.prepared, job.table, job.request);
    return [helper](const WorkRange& tasks) { return helper->measure(tasks); };
  }

 private:
  std::uint64_t seed_;
  WorkFault fault_;
  int sums_ = 0;
};

class ShuffledCrew2 : public SweepCrew2 {
 public:
  explicit ShuffledCrew2(std::uint64_t seed, WorkFault fault = WorkFault::kNone) : seed_(seed), fault_(fault) {}
  std::unique_ptr<SweepWork2> begin(const SweepJob2& job) override {
    ++sweeps_;
    return std::make_unique<ShuffledWork<SweptPart2>>(job.order.size(), seed_, fault_, elsewhere(job));
  }
  int sweeps() const { return sweeps_; }

 protected:
  virtual std::function<SweptPart2(const WorkRange&)> elsewhere(const SweepJob2& job) {
    return [&job_prepared = job.prepared, &table = job.table, order = job.order](const WorkRange& places) {
      return swept_part(places, order.subspan(places.begin, places.size()), job_prepared.arrangement, table);
    };
  }

 private:
  std::uint64_t seed_;
  WorkFault fault_;
  int sweeps_ = 0;
};

}  // namespace hottel

#include "parallel/space/pair_crew.h"

#include <string>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

class LedPairWork3 : public PairWork3 {
 public:
  LedPairWork3(std::unique_ptr<LedWork> work, const ElementTable3& table) : work_(std::move(work)), table_(table) {}

  WorkTurn<DoneTasks3> next() override {
    const WorkTurn<FoundBytes> turn = work_->next();
    if (!turn.there) return {.here = turn.here};
    DoneTasks3 done = read_done_3(turn.there->bytes, table_);
    HOTTEL_REQUIRE(done.tasks == turn.there->tasks);
    return {.there = std::move(done)};
  }
  void stop() override { work_->stop(); }

 private:
  std::unique_ptr<LedWork> work_;
  const ElementTable3& table_;
};

class HelperPairJob3 : public HelperJob {
 public:
  HelperPairJob3(std::string_view bytes, KeptScene3& kept)
      : job_(bytes, kept), helper_(*job_.prepared, *job_.table, job_.request) {}

  std::string work(const WorkRange& tasks, std::string_view) override {
    return done_message_3(helper_.measure(tasks), *job_.table);
  }

 private:
  ReceivedPairJob3 job_;
  PairHelper3 helper_;
};

}  // namespace

std::unique_ptr<PairWork3> LedPairCrew3::begin(const PairJob3& job) {
  auto work = leader_.begin([&] { return Job{.bytes = mark_ + pair_job_message_3(job), .tasks = job.tasks}; });
  if (work == nullptr) return nullptr;
  return std::make_unique<LedPairWork3>(std::move(work), job.table);
}

std::unique_ptr<HelperJob> PairJobs3::make(std::string_view bytes) {
  return std::make_unique<HelperPairJob3>(bytes, kept_);
}

}  // namespace hottel

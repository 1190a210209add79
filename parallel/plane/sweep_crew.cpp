#include "parallel/plane/sweep_crew.h"

#include <string>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

class LedSweepWork2 : public SweepWork2 {
 public:
  explicit LedSweepWork2(std::unique_ptr<LedWork> work) : work_(std::move(work)) {}

  WorkTurn<SweptPart2> next() override {
    const WorkTurn<FoundBytes> turn = work_->next();
    if (!turn.there) return {.here = turn.here};
    SweptPart2 part = read_part_2(turn.there->bytes);
    HOTTEL_REQUIRE((WorkRange{part.begin, part.end} == turn.there->tasks));
    return {.there = std::move(part)};
  }
  void stop() override { work_->stop(); }

 private:
  std::unique_ptr<LedWork> work_;
};

class HelperSweepJob2 : public HelperJob {
 public:
  HelperSweepJob2(std::string_view bytes, KeptScene2& kept) : job_(bytes, kept) {}

  std::string work(const WorkRange& tasks, std::string_view told) override {
    return part_message_2(swept_part(tasks, read_vertices_2(told), job_.prepared->arrangement, *job_.table));
  }

 private:
  ReceivedSweepJob2 job_;
};

}  // namespace

std::unique_ptr<SweepWork2> LedSweepCrew2::begin(const SweepJob2& job) {
  auto work = leader_.begin([&] {
    return Job{.bytes = mark_ + sweep_job_message_2(job),
               .tasks = sweep_sizes(job.order.size()),
               .telling = [order = job.order](const WorkRange& tasks) {
                 return vertices_message_2(order.subspan(tasks.begin, tasks.size()));
               }};
  });
  if (work == nullptr) return nullptr;
  return std::make_unique<LedSweepWork2>(std::move(work));
}

std::unique_ptr<HelperJob> SweepJobs2::make(std::string_view bytes) {
  return std::make_unique<HelperSweepJob2>(bytes, kept_);
}

}  // namespace hottel

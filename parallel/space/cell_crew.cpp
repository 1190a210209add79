#include "parallel/space/cell_crew.h"

#include <string>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

class LedCellWork3 : public CellWork3 {
 public:
  explicit LedCellWork3(std::unique_ptr<LedWork> work) : work_(std::move(work)) {}

  WorkTurn<LitCells3> next() override {
    const WorkTurn<FoundBytes> turn = work_->next();
    if (!turn.there) return {.here = turn.here};
    LitCells3 lit = read_lit_3(turn.there->bytes);
    HOTTEL_REQUIRE(lit.tasks == turn.there->tasks);
    return {.there = std::move(lit)};
  }
  void stop() override { work_->stop(); }

 private:
  std::unique_ptr<LedWork> work_;
};

class HelperCellJob3 : public HelperJob {
 public:
  HelperCellJob3(std::string_view bytes, KeptScene3& kept) : job_(bytes, kept) {}

  std::string work(const WorkRange& cells, std::string_view) override {
    return lit_message_3(job_.light->means(cells));
  }

 private:
  ReceivedCellJob3 job_;
};

}  // namespace

std::unique_ptr<CellWork3> LedCellCrew3::begin(const CellJob3& job) {
  auto work = leader_.begin([&] { return Job{.bytes = mark_ + cell_job_message_3(job), .tasks = job.tasks}; });
  if (work == nullptr) return nullptr;
  return std::make_unique<LedCellWork3>(std::move(work));
}

std::unique_ptr<HelperJob> CellJobs3::make(std::string_view bytes) {
  return std::make_unique<HelperCellJob3>(bytes, kept_);
}

}  // namespace hottel

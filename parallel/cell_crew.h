// The light of grids among the ranks of an MPI job: what both dimensions have in common.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/shared_work.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "solver/lit_cells.h"

namespace hottel {

// The light of some cells, in bytes and back, bit for bit.
std::string lit_message(const LitCells& lit);
LitCells read_lit(std::string_view bytes);

// Work on light whose helpers answer with lit_message().
std::unique_ptr<SharedWork<LitCells>> led_light(std::unique_ptr<LedWork> work);

// On rank 0: shares the cells of grids with all other ranks. message: what they are told of a job.
template <class CellJob, std::string (*message)(const CellJob&)>
class LedCellCrew : public WorkCrew<CellJob, LitCells> {
 public:
  // mark: what the bytes of its jobs begin with. REQUIRES that the leader outlives it.
  LedCellCrew(Leader& leader, char mark) : leader_(leader), mark_(mark) {}
  // Null where helpers have another job.
  std::unique_ptr<SharedWork<LitCells>> begin(const CellJob& job) override {
    auto work = leader_.begin([&] { return Job{.bytes = mark_ + message(job), .tasks = job.tasks}; });
    return work ? led_light(std::move(work)) : nullptr;
  }

 private:
  Leader& leader_;
  const char mark_;
};

// On the others: makes jobs of what begin() sent, without the mark.
template <class ReceivedJob, class Kept>
class CellJobs : public HelperJobs {
 public:
  // REQUIRES that what is kept outlives it.
  explicit CellJobs(Kept& kept) : kept_(kept) {}
  std::unique_ptr<HelperJob> make(std::string_view bytes) override { return std::make_unique<Lighting>(bytes, kept_); }

 private:
  class Lighting : public HelperJob {
   public:
    Lighting(std::string_view bytes, Kept& kept) : job_(bytes, kept) {}
    std::string work(const WorkRange& tasks, std::string_view) override { return lit_message(job_.light->lit(tasks)); }

   private:
    ReceivedJob job_;
  };

  Kept& kept_;
};

}  // namespace hottel

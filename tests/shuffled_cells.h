// Crews that light grids as others might (shuffled_work.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "solver/plane/light/cell_crew.h"
#include "solver/space/light/cell_crew.h"
#include "tests/shuffled_work.h"

namespace hottel {

// Light: LightOfElements2 or LightOfElements3.
template <class Job, class Light>
class ShuffledCells : public WorkCrew<Job, LitCells> {
 public:
  explicit ShuffledCells(std::uint64_t seed, WorkFault fault = WorkFault::kNone) : seed_(seed), fault_(fault) {}
  std::unique_ptr<SharedWork<LitCells>> begin(const Job& job) override {
    ++grids_;
    return std::make_unique<ShuffledWork<LitCells>>(job.tasks.count, seed_, fault_, elsewhere(job));
  }
  int grids() const { return grids_; }

 protected:
  virtual std::function<LitCells(const WorkRange&)> elsewhere(const Job& job) {
    const auto light = std::make_shared<Light>(job.prepared, job.granularity, job.solution, job.grid);
    return [light](const WorkRange& tasks) { return light->lit(tasks); };
  }

 private:
  std::uint64_t seed_;
  WorkFault fault_;
  int grids_ = 0;
};
using ShuffledCells2 = ShuffledCells<CellJob2, LightOfElements2>;
using ShuffledCells3 = ShuffledCells<CellJob3, LightOfElements3>;

}  // namespace hottel

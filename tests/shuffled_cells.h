// Crews that light grids in space as others might (shuffled_work.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "solver/space/light/cell_crew.h"
#include "tests/shuffled_work.h"

namespace hottel {

class ShuffledCells3 : public CellCrew3 {
 public:
  explicit ShuffledCells3(std::uint64_t seed, WorkFault fault = WorkFault::kNone) : seed_(seed), fault_(fault) {}
  std::unique_ptr<CellWork3> begin(const CellJob3& job) override {
    ++grids_;
    return std::make_unique<ShuffledWork<LitCells3>>(job.tasks.count, seed_, fault_, elsewhere(job));
  }
  int grids() const { return grids_; }

 protected:
  virtual std::function<LitCells3(const WorkRange&)> elsewhere(const CellJob3& job) {
    const auto light = std::make_shared<LightOfElements3>(job.prepared, job.granularity, job.solution, job.grid);
    return [light](const WorkRange& cells) { return light->means(cells); };
  }

 private:
  std::uint64_t seed_;
  WorkFault fault_;
  int grids_ = 0;
};

}  // namespace hottel

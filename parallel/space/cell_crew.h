// The light of grids in space among the ranks of an MPI job.
#pragma once

#include <memory>
#include <string_view>

#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/space/cell_messages.h"

namespace hottel {

// On rank 0: shares the cells of grids with all other ranks. REQUIRES that the leader outlives it.
class LedCellCrew3 : public CellCrew3 {
 public:
  // mark: what the bytes of its jobs begin with.
  LedCellCrew3(Leader& leader, char mark) : leader_(leader), mark_(mark) {}
  std::unique_ptr<CellWork3> begin(const CellJob3& job) override;

 private:
  Leader& leader_;
  const char mark_;
};

// On the others: makes jobs of what begin() sent, without the mark.
class CellJobs3 : public HelperJobs {
 public:
  // REQUIRES that what is kept outlives it.
  explicit CellJobs3(KeptScene3& kept) : kept_(kept) {}
  std::unique_ptr<HelperJob> make(std::string_view bytes) override;

 private:
  KeptScene3& kept_;
};

}  // namespace hottel

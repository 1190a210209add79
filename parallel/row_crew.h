// Rows of radiosity systems among the ranks of an MPI job.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/row_messages.h"

namespace hottel {

// On rank 0: shares the rows of systems with all other ranks. REQUIRES that the leader outlives it.
class LedRowCrew : public RowCrew {
 public:
  // mark: what the bytes of its jobs begin with. Systems of fewer entries than the least are not shared.
  LedRowCrew(Leader& leader, char mark, std::size_t least = kLeastSharedEntries)
      : leader_(leader), mark_(mark), least_(least) {}
  // Null also where the matrix stands on the disk: memory is short then.
  std::unique_ptr<SharedRows> begin(const RadiositySystem& system, const std::vector<char>& is_wanted) override;

 private:
  Leader& leader_;
  const char mark_;
  const std::size_t least_;
};

// On the others: makes jobs of what begin() sent, without the mark.
class RowJobs : public HelperJobs {
 public:
  std::unique_ptr<HelperJob> make(std::string_view bytes) override;
};

}  // namespace hottel

// Pairs in space among the ranks of an MPI job.
#pragma once

#include <memory>
#include <string_view>

#include "geometry/space/exchange/pair_crew.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/space/pair_messages.h"

namespace hottel {

// On rank 0: shares sums of pairs with all other ranks. REQUIRES that the leader outlives it.
class LedPairCrew3 : public PairCrew3 {
 public:
  // mark: what the bytes of its jobs begin with.
  LedPairCrew3(Leader& leader, char mark) : leader_(leader), mark_(mark) {}
  std::unique_ptr<PairWork3> begin(const PairJob3& job) override;

 private:
  Leader& leader_;
  const char mark_;
};

// On the others: makes jobs of what begin() sent, without the mark.
class PairJobs3 : public HelperJobs {
 public:
  // REQUIRES that what is kept outlives it.
  explicit PairJobs3(KeptScene3& kept) : kept_(kept) {}
  std::unique_ptr<HelperJob> make(std::string_view bytes) override;

 private:
  KeptScene3& kept_;
};

}  // namespace hottel

// Sweeps in the plane among the ranks of an MPI job.
#pragma once

#include <memory>
#include <string_view>

#include "geometry/plane/exchange/sweep_crew.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/plane/sweep_messages.h"

namespace hottel {

// On rank 0: shares sweeps with all other ranks. REQUIRES that the leader outlives it.
class LedSweepCrew2 : public SweepCrew2 {
 public:
  // mark: what the bytes of its jobs begin with.
  LedSweepCrew2(Leader& leader, char mark) : leader_(leader), mark_(mark) {}
  std::unique_ptr<SweepWork2> begin(const SweepJob2& job) override;

 private:
  Leader& leader_;
  const char mark_;
};

// On the others: makes jobs of what begin() sent, without the mark.
class SweepJobs2 : public HelperJobs {
 public:
  // REQUIRES that what is kept outlives it.
  explicit SweepJobs2(KeptScene2& kept) : kept_(kept) {}
  std::unique_ptr<HelperJob> make(std::string_view bytes) override;

 private:
  KeptScene2& kept_;
};

}  // namespace hottel

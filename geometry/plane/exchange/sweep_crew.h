// Other processes that sweep vertices of a scene in the plane together with this one.
#pragma once

#include <memory>
#include <span>

#include "geometry/element.h"
#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/shared_work.h"

namespace hottel {

// What is shared of a sweep: its vertices, in this order.
struct SweepJob2 {
  const PreparedScene2& prepared;
  Granularity granularity;     // of the table
  const ElementTable2& table;  // that of the scene, some of whose rows may have been taken
  std::span<const VertexId> order;
};

using SweepWork2 = SharedWork<SweptPart2>;

// Who takes part in sweeps. What they find must be what swept_part() finds: the same sums and counts.
class SweepCrew2 {
 public:
  virtual ~SweepCrew2() = default;
  // Begins to share; null where this sweep is done here alone. From any thread. REQUIRES that the job outlives the
  // work.
  virtual std::unique_ptr<SweepWork2> begin(const SweepJob2& job) = 0;
};

// While it lives, this crew takes part in sweeps of all threads of this process. Results do not depend on it.
// Throws ContractViolation where there is one already.
class SweepCrewScope2 {
 public:
  explicit SweepCrewScope2(SweepCrew2& crew);
  ~SweepCrewScope2();
  SweepCrewScope2(const SweepCrewScope2&) = delete;
  SweepCrewScope2& operator=(const SweepCrewScope2&) = delete;
};
// Null where there is none.
SweepCrew2* sweep_crew_2();

// Returns what the sweeps about some vertices, those of these places, add up to. COST: as sum_pairs_about.
SweptPart2 swept_part(const WorkRange& places, std::span<const VertexId> vertices, const Arrangement2& arrangement,
                      const ElementTable2& table);

}  // namespace hottel

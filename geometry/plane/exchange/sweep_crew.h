// Other processes that sweep vertices of a scene in the plane together with this one.
#pragma once

#include <cstddef>
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
using SweepCrew2 = WorkCrew<SweepJob2, SweptPart2>;

// How the vertices of a sweep are dealt out. Sums of more of them at a time are fewer for each, as terms of neighbours
// add up; those of some thousands are some tens of megabytes.
inline WorkSizes sweep_sizes(std::size_t vertices) { return {.count = vertices, .least = 64, .most = 4096}; }

// Returns what the sweeps about some vertices, those of these places, add up to. COST: as sum_pairs_about.
SweptPart2 swept_part(const WorkRange& places, std::span<const VertexId> vertices, const Arrangement2& arrangement,
                      const ElementTable2& table);

}  // namespace hottel

// Other processes that measure pairs of a scene in space together with this one.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/element.h"
#include "geometry/shared_work.h"
#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/exchange/pair_tasks.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// What some tasks found, and the counts of all of them. Of tasks that found nothing there is nothing.
struct DoneTasks3 {
  WorkRange tasks;
  std::vector<std::pair<std::size_t, FoundPairs3>> found;  // by task, ascending
  ExchangeReport3 counts{};                                // those that sum_pairs() adds to
};

using PairWork3 = SharedWork<DoneTasks3>;

// What is shared of a sum of pairs: the tasks that PairTasks3 numbers, those of patches with the sky being dear.
struct PairJob3 {
  const PreparedScene3& prepared;
  Granularity granularity;     // of the table
  const ElementTable3& table;  // that of the scene
  const PairSumRequest3& request;
  WorkSizes tasks;
};

// Who takes part in sums of pairs. What they find must be what PairHelper3 finds, bit for bit.
using PairCrew3 = WorkCrew<PairJob3, DoneTasks3>;

// Does tasks of a sum that another process asks for.
//
//   (1) what sum_pairs() would find, task by task, bit for bit, for any number of threads
// REQUIRES that all outlives it. COST: that of the pairs; parallel.
class PairHelper3 {
 public:
  // Of the request the tolerance, what is proven or wanted, and the turn count.
  PairHelper3(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request);
  ~PairHelper3();

  std::size_t tasks() const;
  // Throws as sum_pairs does. REQUIRES tasks that there are.
  DoneTasks3 measure(const WorkRange& tasks) const;

 private:
  struct Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace hottel

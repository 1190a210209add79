// The light of grids in space among the ranks of an MPI job.
#pragma once

#include "parallel/cell_crew.h"
#include "parallel/space/cell_messages.h"

namespace hottel {

using LedCellCrew3 = LedCellCrew<CellJob3, cell_job_message_3>;
using CellJobs3 = CellJobs<ReceivedCellJob3, KeptScene3>;

}  // namespace hottel

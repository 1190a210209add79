// The light of grids in the plane among the ranks of an MPI job.
#pragma once

#include "parallel/cell_crew.h"
#include "parallel/plane/cell_messages.h"

namespace hottel {

using LedCellCrew2 = LedCellCrew<CellJob2, cell_job_message_2>;
using CellJobs2 = CellJobs<ReceivedCellJob2, KeptScene2>;

}  // namespace hottel

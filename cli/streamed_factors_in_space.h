// Lists of exact view factors in space, written row by row: no matrix of all of them is made.
#pragma once

#include "cli/factors_options.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {

// Whether no more is asked for than rows of the list. Throws UsageError for --out-of-core where more is, and for
// --checkpoint.
bool streams_rows_in_space(const FactorsOptions& options);

// Computes and writes them. The same bytes as by the matrix.
// REQUIRES streams_rows_in_space(options).
void write_streamed_factors_in_space(FactorsOptions& options, const Simulation3& simulation, const FactorOrigin& origin,
                                     FactorsFiles& files, const Streams& streams);

}  // namespace hottel

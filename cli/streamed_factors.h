// Lists of exact view factors in the plane, written row by row: no matrix of all of them is made.
#pragma once

#include "cli/factors_options.h"
#include "geometry/row_ranges.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {

// Whether no more is asked for than rows of the list: nothing that needs the whole matrix.
bool needs_rows_alone(const FactorsOptions& options);

// Returns the list that is asked for, of rows that come range by range, and tells which rows were asked for. REQUIRES
// that scene and rows outlive it.
FactorTable table_of_rows(const FactorsOptions& options, const SceneTable& scene, RowRanges& rows,
                          const Streams& streams);

// Throws RequestError where the elements do not fit into the memory that is allowed, or the pairs, unless they stay on
// disk. COST: that of counting.
void require_memory_of_rows(const FactorsOptions& options, const Scene2& scene);

// Whether that is worth it: more than some millions of pairs see each other. (Pairs are rounded twice then.)
bool streams_rows(const FactorsOptions& options, const Simulation2& simulation, const Streams& streams);

// Computes and writes them. The same bytes as by the matrix.
// REQUIRES needs_rows_alone(options).
void write_streamed_factors(FactorsOptions& options, const Simulation2& simulation, const FactorOrigin& origin,
                            FactorsFiles& files, Streams& streams);

}  // namespace hottel

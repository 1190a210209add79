// What decks of View3D ask of the output of hottel factors: row, col, out and list.
#pragma once

#include "cli/factors_options.h"
#include "cli/streams.h"
#include "geometry/space/scene/polygon.h"
#include "io/results/factor_files.h"

namespace hottel {

// Restricts a table to the row and the column that a deck asks for, tells its rows as closely as `list` says, and
// says where an option or a format keeps something from being obeyed.
//
//   (1) row, col: of a surface; where rows are groups, of the group that it is combined in; where they are elements, of
//       all of its elements
//   (2) list: 1 tells of each row its number, name, area, emittance and the sum of its factors to rows and to all else;
//       2 its factors too; 3 and more its corners
void obey_deck(const FactorsOptions& options, const Streams& streams, FactorTable& table,
               const std::vector<Polygon3>& polygons);

}  // namespace hottel

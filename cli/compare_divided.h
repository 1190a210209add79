// hottel compare --divide: what dividing costs and gives, by any method.
#pragma once

#include "cli/command.h"
#include "cli/comparing.h"

namespace hottel {

// Compares at each division of options.divide, each surface in as many elements, and writes divide.csv, divide.svg and
// divide.png. The exact factors of the finest are what mean radiosities of faces at the others are held against; those
// of each are the row `exact`. A command (run:) is told the division by {elements} in it. Throws UsageError for fewer
// than two divisions, or such that do not ascend, for file:, which has one division, and for a command without
// {elements}.
ExitCode compare_divided(const CompareOptions& options, const ValidScene& scene, Streams& streams);

}  // namespace hottel

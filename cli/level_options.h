// --levels and --light-levels: how far elements are divided, everywhere and where light ends.
#pragma once

#include <CLI/CLI.hpp>

#include "solver/refinement.h"

namespace hottel {

struct LevelOptions {
  int everywhere = 0, at_borders = 0;

  // Adds both options to the command line of a command. REQUIRES that this outlives the command.
  void add_to(CLI::App& command);
  // Throws UsageError where --light-levels is given and is not more than --levels.
  void require_sense() const;
  RefinementLevels levels() const { return {everywhere, at_borders}; }
};

}  // namespace hottel

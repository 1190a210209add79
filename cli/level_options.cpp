#include "cli/level_options.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "kernel/support/failure.h"

namespace hottel {

void LevelOptions::add_to(CLI::App& command) {
  command.add_option("--levels", everywhere, "divide every element N times: in halves, in space in four")
      ->type_name("N")
      ->transform(whole_number(0, TreePath::kMostLevels));
  command
      .add_option("--light-levels", at_borders,
                  "divide elements that the border of a beam or of a shadow crosses until they were divided N times")
      ->type_name("N")
      ->transform(whole_number(0, TreePath::kMostLevels));
}

void LevelOptions::require_sense() const {
  if (at_borders > 0 && at_borders <= everywhere)
    throw UsageError(fmt::format("--light-levels {} changes nothing: all elements are divided {} times (--levels)",
                                 at_borders, everywhere));
}

}  // namespace hottel

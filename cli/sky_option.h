// --sky: whether the sky's factors are integrated, or what rows leave.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "geometry/exchange_request.h"

namespace hottel {

struct SkyOption {
  std::string by;  // empty: not said

  // Adds the option to the command line of a command. REQUIRES that this outlives the command.
  void add_to(CLI::App& command);
  // The choice for a scene in space. Throws UsageError where the user makes one for a method that is not exact.
  SkyBy in_space(const std::string& method = "exact") const;
  // Throws UsageError where the user makes a choice for a scene in the plane.
  void refuse_in_plane() const;
};

}  // namespace hottel

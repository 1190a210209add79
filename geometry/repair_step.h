// What a repair of a scene says that it did.
#pragma once

#include <string>

namespace hottel {

// One thing that was done to a surface, or that was left undone (not-repaired). docs/check.md lists the kinds.
struct RepairStep {
  std::string kind;
  std::string surface;
  std::string message;
};

}  // namespace hottel

// What a repair of a scene says that it did.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace hottel {

// One thing that was done to a surface, or that was left undone (not-repaired). docs/check.md lists the kinds.
struct RepairStep {
  std::string kind;
  std::string surface;
  std::string message;
};

// True iff something was done.
inline bool is_anything_done(const std::vector<RepairStep>& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const RepairStep& step) { return step.kind != "not-repaired"; });
}

}  // namespace hottel

// A scene in space that was repaired.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/repair_step.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A repaired scene, and how it came from the one that was given.
struct Repair3 {
  Scene3 scene;
  std::vector<RepairStep> steps;          // "merged", "snapped", "triangulated", "dropped", "reversed", "not-repaired"
  std::vector<std::string> former_names;  // by surface: what it was called before the repair
  // The surfaces, as they were numbered before, of which a corner moved; those whose corners moved together in one
  // list.
  std::vector<std::vector<std::uint32_t>> moved{};
  std::vector<std::uint32_t> origins{};  // by surface: which one it was before
};

}  // namespace hottel

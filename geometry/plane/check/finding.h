// One thing that is worth telling about a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "geometry/severity.h"

namespace hottel {

// What was found, where, what it means for light, and what to do. docs/check.md lists the kinds.
struct Finding2 {
  Severity severity = Severity::kNote;
  std::string kind;                       // a stable word
  std::vector<std::uint32_t> surfaces{};  // the first one gives the line
  std::optional<Point2> at{};             // in the scene
  std::string message{}, suggestion{};    // sentences without a full stop; the suggestion may be empty
};

using Findings2 = std::vector<Finding2>;

// Sorts by severity, then by the first surface in the order of the scene (those that name none last); stable.
void sort_findings(Findings2& findings);

bool has_error(const Findings2& findings);

}  // namespace hottel

// One thing that is worth telling about a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// kError:   light cannot be computed, or a promise of the scene is broken
// kWarning: probably not meant
// kNote:    legal, and worth knowing
enum class Severity : unsigned char { kError, kWarning, kNote };

constexpr const char* to_string(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  return "";
}

// What was found, where, what it means for light, and what to do. docs/check.md lists the kinds.
struct Finding {
  Severity severity = Severity::kNote;
  std::string kind;                       // a stable word
  std::vector<std::uint32_t> surfaces{};  // the first one gives the line
  std::optional<Point2> at{};             // in the scene
  std::string message{}, suggestion{};    // sentences without a full stop; the suggestion may be empty
};

using Findings = std::vector<Finding>;

// Sorts by severity, then by the first surface in the order of the scene (those that name none last); stable.
void sort_findings(Findings& findings);

bool has_error(const Findings& findings);

}  // namespace hottel

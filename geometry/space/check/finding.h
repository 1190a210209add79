// One thing that is worth telling about a scene in space.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/severity.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// What was found, where, what it means for light, and what to do. docs/check.md lists the kinds.
//
//   (1) `surfaces` are indices into the surfaces of the scene; a finding about the whole scene names none
//   (2) kind is for programs, message and suggestion are for people
struct Finding3 {
  Severity severity = Severity::kNote;
  std::string kind;                       // a stable word
  std::vector<std::uint32_t> surfaces{};  // the first one gives the line
  std::optional<Point3> at{};             // in the scene
  std::string message{}, suggestion{};    // sentences without a full stop; the suggestion may be empty
};

using Findings3 = std::vector<Finding3>;

// Sorts the findings as they are printed.
//
//   (1) errors come first, then warnings, then notes
//   (2) of one severity, by the first surface in the order of the scene; those that name no surface come last
//   (3) stable: those alike in both keep their order
void sort_findings(Findings3& findings);

// True iff light cannot be computed, or a promise of the scene is broken: some finding is Severity::kError.
bool has_error(const Findings3& findings);

}  // namespace hottel

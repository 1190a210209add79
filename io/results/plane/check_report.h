// What was found in a scene, as JSON and as text for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/factor_changes.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/check/repair.h"

namespace hottel {

// What a repair did, and what it changed; without the factors of both scenes there are no changes to tell.
struct RepairReport {
  const std::vector<RepairStep2>* steps = nullptr;
  const std::vector<FactorChange>* changes = nullptr;
};

// Returns {"findings":[{"severity","kind","surfaces":[names],"at":[x,y],"line","message","suggestion"}]} and a final
// newline. Coordinates are the nearest doubles; "at" and "line" are null where there is no place. With a repair also
// "repairs":[{"kind","surface","message"}] and "changes":[{"from","to","before","after"}]: null where a face had no row
// or was not there, the whole list null where factors could not be compared.
std::string check_json(const Scene2& scene, const Findings2& findings, const RepairReport* repair = nullptr);

// Returns one paragraph a finding and a closing count. Of one kind at most `most` are shown, the rest is counted.
inline constexpr std::size_t kMostOfAKind = 20;
// Returns one paragraph a finding and a closing line that counts errors, warnings and notes. Of one kind at most `most`
// are shown, the rest is counted.
std::string check_text(const Scene2& scene, const Findings2& findings, std::size_t most = kMostOfAKind);

// Returns the paragraphs alone: "FILE:LINE: SEVERITY: KIND at PLACE: MESSAGE", the suggestion on a line below. LINE and
// PLACE are left out where there is none.
std::string findings_text(const Scene2& scene, const Findings2& findings, std::size_t most = kMostOfAKind);

// Returns each finding as a sentence for the notes of a report: "warning: KIND: MESSAGE (SUGGESTION)".
std::vector<std::string> finding_notes(const Findings2& findings);

// Returns the steps a line each, then all changes as csv: from,to,before,after.
std::string repair_text(const Scene2& scene, const RepairReport& repair);

}  // namespace hottel

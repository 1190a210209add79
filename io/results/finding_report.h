// What was found in a scene of any dimension and what a repair did to it, as JSON and as text for people.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/factor_changes.h"
#include "geometry/repair_step.h"
#include "geometry/scene_table.h"
#include "geometry/severity.h"

namespace hottel {

// What a repair did, and what it changed; without the factors of both scenes there are no changes to tell.
struct RepairReport {
  const std::vector<RepairStep>* steps = nullptr;
  const std::vector<FactorChange>* changes = nullptr;
};

// A finding without its dimension.
struct ReportedFinding {
  Severity severity = Severity::kNote;
  std::string kind;
  std::vector<std::string> surfaces{};  // by name
  FileLine where{};                     // of the first one; or the file of the scene alone
  bool is_in_mesh = false;              // that is a face of a mesh
  std::vector<double> at{};             // nearest doubles; empty: nowhere
  std::string place{};                  // the same for people
  std::string message{}, suggestion{};
};

// Returns findings of a scene of some dimension without it. coordinates(point): the nearest doubles of a place.
template <class Finding, class Coordinates>
std::vector<ReportedFinding> reported(const SceneTable& scene, const std::vector<Finding>& findings,
                                      const Coordinates& coordinates) {
  std::vector<ReportedFinding> result;
  for (const Finding& finding : findings) {
    ReportedFinding one{finding.severity, finding.kind};
    for (const std::uint32_t s : finding.surfaces) one.surfaces.push_back(scene.surfaces[s].name);
    one.where.file = scene.file;
    if (!finding.surfaces.empty()) {
      const Surface& first = scene.surfaces[finding.surfaces.front()];
      one.where = place_of(scene, first);
      one.is_in_mesh = first.in_mesh.file > 0;
    }
    if (finding.at) {
      one.at = coordinates(*finding.at);
      one.place = place_text(*finding.at);
    }
    one.message = finding.message;
    one.suggestion = finding.suggestion;
    result.push_back(std::move(one));
  }
  return result;
}

// Of one kind so many are shown to people unless they ask for more; the rest is counted.
inline constexpr std::size_t kMostOfAKind = 20;

// Returns {"findings":[{"severity","kind","surfaces":[names],"at":[coordinates],"line","message","suggestion"}]} and a
// final newline, of a face of a mesh also "file", before the line. "at" and "line" are null where there is no place.
// With a repair also "repairs":[{"kind","surface","message"}] and "changes":[{"from","to","before","after"}]: null
// where a face had no row or was not there, the whole list null where factors could not be compared.
std::string check_json(const std::vector<ReportedFinding>& findings, const RepairReport* repair = nullptr);

// Returns one paragraph a finding: "FILE:LINE: SEVERITY: KIND at PLACE: MESSAGE", the suggestion on a line below. LINE
// and PLACE are left out where there is none. Of one kind at most `most` are shown, the rest is counted.
std::string findings_text(const std::vector<ReportedFinding>& findings, std::size_t most);

// Returns a finding as a sentence for the notes of a report: "warning: KIND: MESSAGE (SUGGESTION)".
std::string finding_note(Severity severity, const std::string& kind, const std::string& message,
                         const std::string& suggestion);
template <class Finding>
std::vector<std::string> finding_notes(const std::vector<Finding>& findings) {
  std::vector<std::string> notes;
  for (const Finding& finding : findings)
    notes.push_back(finding_note(finding.severity, finding.kind, finding.message, finding.suggestion));
  return notes;
}

// Returns the same and a closing line that counts errors, warnings and notes.
std::string check_text(const std::vector<ReportedFinding>& findings, std::size_t most);

// Returns the steps a line each, then all changes as csv: from,to,before,after.
std::string repair_text(const SceneTable& scene, const RepairReport& repair);

}  // namespace hottel

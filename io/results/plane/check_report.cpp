#include "io/results/plane/check_report.h"

#include <fmt/format.h>

#include <utility>

#include "geometry/plane/check/wording.h"

namespace hottel {
namespace {

std::vector<ReportedFinding> reported(const Scene2& scene, const Findings2& findings) {
  std::vector<ReportedFinding> result;
  for (const Finding2& finding : findings) {
    ReportedFinding one{finding.severity, finding.kind};
    for (const std::uint32_t s : finding.surfaces) one.surfaces.push_back(scene.surfaces[s].name);
    if (!finding.surfaces.empty()) one.line = scene.surfaces[finding.surfaces.front()].line;
    if (finding.at) {
      one.at = {to_double(finding.at->x), to_double(finding.at->y)};
      one.place = place_text(*finding.at);
    }
    one.message = finding.message;
    one.suggestion = finding.suggestion;
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace

std::string check_json(const Scene2& scene, const Findings2& findings, const RepairReport* repair) {
  return check_json(reported(scene, findings), repair);
}

std::string check_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  return check_text(scene.file, reported(scene, findings), most);
}

std::string findings_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  return findings_text(scene.file, reported(scene, findings), most);
}

std::vector<std::string> finding_notes(const Findings2& findings) {
  std::vector<std::string> notes;
  for (const Finding2& finding : findings)
    notes.push_back(finding_note(finding.severity, finding.kind, finding.message, finding.suggestion));
  return notes;
}

}  // namespace hottel

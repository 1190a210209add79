#include "io/results/space/check_report.h"

#include <utility>
#include <vector>

#include "geometry/space/check/wording.h"

namespace hottel {
namespace {

std::vector<ReportedFinding> reported(const Scene3& scene, const Findings3& findings) {
  std::vector<ReportedFinding> result;
  for (const Finding3& finding : findings) {
    ReportedFinding one{finding.severity, finding.kind};
    for (const std::uint32_t s : finding.surfaces) one.surfaces.push_back(scene.surfaces[s].name);
    if (!finding.surfaces.empty()) one.line = scene.surfaces[finding.surfaces.front()].line;
    if (finding.at) {
      one.at = {to_double(finding.at->x), to_double(finding.at->y), to_double(finding.at->z)};
      one.place = place_text(*finding.at);
    }
    one.message = finding.message;
    one.suggestion = finding.suggestion;
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace

std::string check_json(const Scene3& scene, const Findings3& findings, const RepairReport* repair) {
  return check_json(reported(scene, findings), repair);
}

std::string findings_text(const Scene3& scene, const Findings3& findings, std::size_t most) {
  return findings_text(scene.file, reported(scene, findings), most);
}

std::vector<std::string> finding_notes(const Findings3& findings) {
  std::vector<std::string> notes;
  for (const Finding3& finding : findings)
    notes.push_back(finding_note(finding.severity, finding.kind, finding.message, finding.suggestion));
  return notes;
}

std::string check_text(const Scene3& scene, const Findings3& findings, std::size_t most) {
  return check_text(scene.file, reported(scene, findings), most);
}

}  // namespace hottel

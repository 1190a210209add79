#include "io/results/plane/check_report.h"

#include "geometry/plane/check/wording.h"

namespace hottel {
namespace {

std::vector<ReportedFinding> reported(const Scene2& scene, const Findings2& findings) {
  return reported(scene, findings, [](const Point2& p) { return std::vector<double>{to_double(p.x), to_double(p.y)}; });
}

}  // namespace

std::string check_json(const Scene2& scene, const Findings2& findings, const RepairReport* repair) {
  return check_json(reported(scene, findings), repair);
}

std::string check_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  return check_text(reported(scene, findings), most);
}

std::string findings_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  return findings_text(reported(scene, findings), most);
}

}  // namespace hottel

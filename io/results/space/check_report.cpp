#include "io/results/space/check_report.h"

#include <vector>

#include "geometry/space/check/wording.h"

namespace hottel {
namespace {

std::vector<ReportedFinding> reported(const Scene3& scene, const Findings3& findings) {
  return reported(scene, findings, [](const Point3& p) {
    return std::vector<double>{to_double(p.x), to_double(p.y), to_double(p.z)};
  });
}

}  // namespace

std::string check_json(const Scene3& scene, const Findings3& findings, const RepairReport* repair) {
  return check_json(reported(scene, findings), repair);
}

std::string findings_text(const Scene3& scene, const Findings3& findings, std::size_t most) {
  return findings_text(reported(scene, findings), most);
}

std::string check_text(const Scene3& scene, const Findings3& findings, std::size_t most) {
  return check_text(reported(scene, findings), most);
}

}  // namespace hottel

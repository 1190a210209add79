#include "solver/space/check/lost_light.h"

#include "geometry/space/check/mesh_findings.h"
#include "geometry/space/check/shells.h"
#include "geometry/space/check/visibility_findings.h"

namespace hottel {
namespace {

bool is_any_lost(const ExchangeMatrix& matrix) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.to != matrix.sky() && !matrix.elements()[entry.to].material) return true;
  return false;
}

}  // namespace

Findings3 lost_light_warnings(const Scene3& scene, const ExchangeMatrix& matrix) {
  Findings3 findings;
  if (is_any_lost(matrix)) findings = visibility_findings(scene, find_meshes(scene), matrix, false);
  std::erase_if(findings, [](const Finding3& finding) { return finding.kind != "black-back"; });
  tell_inside_out(scene, inside_out_shells(scene), findings);
  return findings;
}

}  // namespace hottel

#include "solver/check/scene_check_2.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "geometry/arrangement/cells_2.h"
#include "geometry/check/cell_findings_2.h"
#include "geometry/check/contact_findings_2.h"
#include "geometry/check/gap_findings_2.h"
#include "geometry/check/near_misses_2.h"
#include "geometry/check/needles_2.h"
#include "geometry/check/sight_findings.h"
#include "geometry/check/wording.h"
#include "kernel/failure.h"
#include "solver/check/light_findings.h"

namespace hottel {
namespace {

void append(Findings& findings, Findings more) { std::move(more.begin(), more.end(), std::back_inserter(findings)); }

Findings needle_findings(const Scene2& scene, const Arrangement2& arrangement) {
  Findings findings;
  for (const Needle2& needle : find_needles(arrangement)) {
    const Point2 at = to_point(arrangement.vertices().to_scene(arrangement.vertices().exact(needle.at)));
    std::vector<std::uint32_t> surfaces{arrangement.sources(needle.right).front().surface,
                                        arrangement.sources(needle.left).front().surface};
    std::sort(surfaces.begin(), surfaces.end());
    std::string message = fmt::format("{} meet at {} in an angle of about {:.3g} degrees", names_text(scene, surfaces),
                                      place_text(at), needle.degrees);
    findings.push_back({Severity::kNote, "needle", std::move(surfaces), at, std::move(message),
                        "factors are exact here too; approximate methods lose digits between such surfaces"});
  }
  return findings;
}

// The matrix that solve would use: by elements where some surface is divided.
ExchangeMatrix factors_as_solved(const PreparedScene2& prepared, const CheckOptions& options) {
  const auto& surfaces = prepared.scene.surfaces;
  const bool is_divided = std::any_of(surfaces.begin(), surfaces.end(), [](auto& s) { return s.elements > 1; });
  const ExchangeOptions2 exchange{.per = is_divided ? Per::kElement : Per::kFace,
                                  .wants_visibility = false,
                                  .memory = options.memory,
                                  .progress = options.progress};
  return is_divided ? exact_exchange(prepare(prepared.scene, Divided::kYes), exchange)
                    : exact_exchange(prepared, exchange);
}

}  // namespace

SceneCheck2 check_scene(const Scene2& scene, const CheckOptions& options) {
  SceneCheck2 check;
  append(check.findings, contact_findings(scene, find_contacts(scene)));
  const std::vector<NearMiss2> near_misses = find_near_misses(scene);
  if (has_error(check.findings)) {
    append(check.findings, gap_findings(scene, near_misses, false));
    check.findings.push_back({Severity::kNote,
                              "light-not-checked",
                              {},
                              {},
                              "surfaces claim the same side with different materials: what needs view factors was not "
                              "looked at",
                              "mend that and check again"});
  } else {
    const PreparedScene2 prepared = prepare(scene);
    append(check.findings, needle_findings(scene, prepared.arrangement));
    append(check.findings,
           cell_findings(prepared, Cells2(prepared.arrangement.triangulation(), prepared.arrangement.side_count()))
               .findings);
    try {
      check.factors = factors_as_solved(prepared, options);
    } catch (const RequestError& error) {
      check.findings.push_back({Severity::kNote,
                                "light-not-checked",
                                {},
                                {},
                                fmt::format("what needs view factors was not looked at: {}", error.what()),
                                "check a part of the scene"});
    }
    append(check.findings, gap_findings(scene, near_misses, check.factors.has_value()));
    if (check.factors) {
      append(check.findings, sight_findings(prepared, *check.factors));
      append(check.findings, light_findings(scene, *check.factors, options.progress));
    }
  }
  sort_findings(check.findings);
  return check;
}

}  // namespace hottel

#include "solver/space/check/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/space/check/contact_findings.h"
#include "geometry/space/check/mesh_findings.h"
#include "geometry/space/check/shells.h"
#include "geometry/space/check/solid_findings.h"
#include "geometry/space/check/visibility_findings.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/contacts/near_contacts.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/unmeasured_pairs.h"
#include "kernel/support/failure.h"
#include "solver/check/dark_suns.h"
#include "solver/check/kelvin_hint.h"
#include "solver/check/light_errors.h"
#include "solver/check/light_fates.h"
#include "solver/space/check/middle_views.h"
#include "solver/space/check/widest_gap.h"

namespace hottel {
namespace {

void append(Findings3& findings, Findings3 more) { std::move(more.begin(), more.end(), std::back_inserter(findings)); }

void add_unplaced(Findings3& findings, Severity severity, const char* kind, std::string message,
                  std::string suggestion) {
  findings.push_back({severity, kind, {}, {}, std::move(message), std::move(suggestion)});
}

void tell_materials(const Scene3& scene, Findings3& findings) {
  std::vector<char> is_used(scene.materials.size(), 0);
  bool is_lit = !scene.sky_emission.is_zero() || std::any_of(scene.lights.begin(), scene.lights.end(),
                                                             [](const Light& l) { return !l.power.is_zero(); });
  for (const Surface& surface : scene.surfaces)
    for (const bool is_back : {false, true})
      if (const auto material = surface.material_of(is_back)) {
        is_used[*material] = 1;
        is_lit |= !scene.materials[*material].emission.is_zero();
      }
  if (!scene.surfaces.empty() && !is_lit)
    add_unplaced(findings, Severity::kNote, "no-light", "nothing emits: every radiosity is 0",
                 "view factors do not need any light; to solve, give a material or the sky an emission");
  for (std::size_t m = 0; m < is_used.size(); ++m)
    if (is_used[m] == 0)
      add_unplaced(findings, Severity::kNote, "unused-material",
                   fmt::format("no surface has the material {}", quoted_name(scene.materials[m].name)),
                   "take it away, or look for a surface that should have it");
}

std::size_t faces_with_material(const Scene3& scene) {
  std::size_t count = 0;
  for (const Surface& surface : scene.surfaces)
    for (const bool is_back : {false, true}) count += surface.material_of(is_back).has_value();
  return count;
}

void tell_unchecked(const std::string& reason, const char* suggestion, Findings3& findings) {
  add_unplaced(findings, Severity::kNote, "light-not-checked", "what needs view factors was not looked at: " + reason,
               suggestion);
}

// The scene prepared; nothing where claims conflict, which is told.
std::shared_ptr<const PreparedScene3> prepared_scene(const Scene3& scene, const CheckSources3& sources,
                                                     Findings3& findings) {
  try {
    return sources.prepared();
  } catch (const InputError& error) {
    (void)Solids3(scene);  // throws where it is a "behind" that cannot be obeyed
    const FileLine& where = error.where();
    const std::string place = where.text() + ": ";
    Finding3 finding{Severity::kError, "conflicting-claims"};
    for (std::uint32_t s = 0; s < scene.surfaces.size() && finding.surfaces.empty(); ++s) {
      const FileLine own = place_of(scene, scene.surfaces[s]);
      if (where.line > 0 && own.line == where.line && own.file == where.file) finding.surfaces = {s};
    }
    finding.message = std::string(error.what()).substr(place.size());
    // The first says which materials they are, where there are more.
    for (std::size_t k = error.hints().size() > 1 ? 1 : 0; k < error.hints().size(); ++k)
      finding.suggestion += (finding.suggestion.empty() ? "" : "; ") + error.hints()[k];
    findings.push_back(std::move(finding));
    tell_unchecked("surfaces claim the same side with different materials", "mend that and check again", findings);
    return nullptr;
  }
}

// What `solve` would refuse; without all view factors, of what is given only.
std::vector<LightError> errors_of(const Scene3& scene, const ExchangeMatrix& matrix,
                                  std::span<const LightShares> lights) {
  try {
    const RadiositySources sources = sources_of(matrix, scene, lights);
    return light_errors(scene, matrix, sources, light_fates(scene, matrix, sources), "area");
  } catch (const RequestError& error) {  // lights that are too much for doubles, or cannot be told
    return {refused_light(scene, error.what())};
  }
}

void tell_light_errors(const Scene3& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
                       bool is_whole, Findings3& findings) {
  for (LightError& error : is_whole ? errors_of(scene, matrix, lights) : size_errors(scene, matrix, "area")) {
    Finding3 finding{Severity::kError, std::move(error.kind), std::move(error.surfaces)};
    if (!finding.surfaces.empty()) finding.at = middle(scene.polygons[finding.surfaces.front()]);
    finding.message = std::move(error.message);
    finding.suggestion = std::move(error.suggestion);
    findings.push_back(std::move(finding));
  }
}

void tell_lights_in_solids(const Scene3& scene, std::span<const LightShares> lights, Findings3& findings) {
  for (std::size_t k = 0; k < lights.size(); ++k)
    if (!lights[k].solid.empty())
      findings.push_back({Severity::kWarning,
                          "light-in-solid",
                          {},
                          scene.light_places[k].position,
                          lost_light_text(scene.lights[k], lights[k]),
                          "move it out, or turn that mesh around where a room was meant"});
}

void tell_dark_suns(const Scene3& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
                    Findings3& findings) {
  for (std::size_t k = 0; k < lights.size(); ++k)
    if (scene.light_places[k].rotation.is_zero())  // else it may come
      if (const std::string text = dark_sun_text(scene.lights[k], lights[k], matrix); !text.empty())
        add_unplaced(findings, Severity::kNote, "dark-sun", text, kDarkSunSuggestion);
}

void check_light(const PreparedScene3& prepared, Meshes3 meshes, const CheckSources3& sources, SceneCheck3& check) {
  const std::size_t count = faces_with_material(prepared.scene);
  const bool is_whole = count <= kMostFacesChecked3;
  std::shared_ptr<const ExchangeMatrix> matrix;
  try {
    if (is_whole)
      matrix = check.factors = sources.factors();
    else
      matrix = std::make_shared<const ExchangeMatrix>(middle_views(prepared, kMostLooks3));
  } catch (const RequestError& error) {
    if (const auto* pairs = dynamic_cast<const UnmeasuredPairs*>(&error)) check.unmeasured = pairs->count();
    tell_unchecked(error.what(), "check a part of the scene", check.findings);
    return;
  }
  if (prepared.scene.closed || is_whole) meshes.leak = widest_gap(meshes, prepared, *matrix);
  append(check.findings, visibility_findings(prepared.scene, meshes, *matrix, is_whole));
  const std::vector<LightShares> lights = sources.lights ? sources.lights() : std::vector<LightShares>();
  tell_lights_in_solids(prepared.scene, lights, check.findings);
  if (is_whole) tell_dark_suns(prepared.scene, *matrix, lights, check.findings);
  tell_light_errors(prepared.scene, *matrix, lights, is_whole, check.findings);
  if (!is_whole)
    tell_unchecked(
        fmt::format("the scene has {} faces with a material, and it was looked from the middle of {} of them", count,
                    std::min(count, kMostLooks3)),
        "`hottel factors` tells all that they see", check.findings);
}

// What follows from it that a solid holds the rest of the scene.
void leave_out_consequences(const Scene3& scene, const std::vector<char>& is_held, Findings3& findings) {
  std::erase_if(findings, [&](const Finding3& finding) {
    return finding.kind == "covered" && is_held[scene.surfaces[finding.surfaces.front()].group] != 0;
  });
}

}  // namespace

SceneCheck3 check_scene(const Scene3& scene, const CheckSources3& sources) {
  SceneCheck3 check;
  append(check.findings, contact_findings(scene, find_contacts(scene)));
  append(check.findings, shape_findings(scene));
  const Meshes3 meshes = find_meshes(scene);
  append(check.findings, mesh_findings(scene, meshes));
  if (const auto prepared = prepared_scene(scene, sources, check.findings)) {
    SolidFindings3 solids = solid_findings(scene, prepared->arrangement().solids());
    append(check.findings, std::move(solids.findings));
    check_light(*prepared, meshes, sources, check);
    tell_inside_out(scene, inside_out_shells(scene), check.findings);
    leave_out_consequences(scene, solids.is_held, check.findings);
  }
  tell_materials(scene, check.findings);
  if (const auto hint = kelvin_hint(scene, check.factors.get()))
    add_unplaced(check.findings, Severity::kNote, "kelvin", *hint, kKelvinSuggestion);
  sort_findings(check.findings);
  return check;
}

}  // namespace hottel

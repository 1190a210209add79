#include "geometry/check/sight_findings.h"

#include <fmt/format.h>

#include "geometry/check/wording.h"
#include "geometry/scene/name.h"

namespace hottel {
namespace {

// What a face sees at all.
struct Sight {
  bool materials = false, black = false, sky = false;
};

Sight sight_of(const ExchangeMatrix& matrix, std::uint32_t face) {
  Sight sight;
  for (const FactorEntry& entry : matrix.row(face)) {
    if (entry.to == matrix.sky())
      sight.sky = true;
    else
      (matrix.elements()[entry.to].material ? sight.materials : sight.black) = true;
  }
  return sight;
}

Finding not_closed(const Scene2& scene, const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> surfaces;
  std::uint32_t most = faces.front();
  for (const std::uint32_t face : faces) {
    surfaces.push_back(matrix.elements()[face].surface);
    if (matrix.factor(face, matrix.sky()).value > matrix.factor(most, matrix.sky()).value) most = face;
  }
  const Surface2& first = scene.surfaces[surfaces.front()];
  return {Severity::kError,
          "not-closed",
          surfaces,
          middle(first.from, first.to),
          fmt::format("the scene promises to be closed, but the front{} of {} see{} the sky, {} the most (F = {})",
                      faces.size() == 1 ? "" : "s", names_text(scene, surfaces), faces.size() == 1 ? "s" : "",
                      quoted_name(scene.surfaces[matrix.elements()[most].surface].name),
                      shortest(matrix.factor(most, matrix.sky()).value)),
          "close the gap, reverse a polyline whose fronts look outward, or take the promise \"closed\" away"};
}

// Faces of one group with a material that see none.
struct Lonely {
  std::vector<std::uint32_t> black, sky;  // see black backs (and perhaps the sky), nothing but the sky
  std::size_t faces = 0;                  // of the group, with a row
};

std::string faces_text(const Scene2& scene, const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& faces,
                       std::vector<std::uint32_t>& surfaces) {
  bool has_front = false, has_back = false;
  for (const std::uint32_t face : faces) {
    const Element& element = matrix.elements()[face];
    (element.is_back ? has_back : has_front) = true;
    if (surfaces.empty() || surfaces.back() != element.surface) surfaces.push_back(element.surface);
  }
  const bool one = faces.size() == 1;
  return fmt::format("the {}{}{} of {} see{}", has_front ? one ? "front" : "fronts" : "",
                     has_front && has_back ? " and " : "", has_back ? one ? "back" : "backs" : "",
                     names_text(scene, surfaces), one ? "s" : "");
}

void tell_lonely(const Scene2& scene, const ExchangeMatrix& matrix, const Lonely& lonely, Findings& findings) {
  const auto place = [&](std::uint32_t s) { return middle(scene.surfaces[s].from, scene.surfaces[s].to); };
  if (!lonely.black.empty()) {
    std::vector<std::uint32_t> surfaces;
    const std::string text = faces_text(scene, matrix, lonely.black, surfaces);
    findings.push_back({Severity::kWarning, "sees-only-black", surfaces, place(surfaces.front()),
                        text + " black backs and no face with a material: what goes there is lost, nothing comes back",
                        "what stands around may be listed the wrong way round (the front is on the right), or want a "
                        "\"back\""});
  }
  // That a part of a body looks away from everything is in the nature of bodies.
  if (lonely.sky.empty() || lonely.sky.size() < lonely.faces) return;
  std::vector<std::uint32_t> surfaces;
  const std::string text = faces_text(scene, matrix, lonely.sky, surfaces);
  findings.push_back({Severity::kNote, "sees-only-sky", surfaces, place(surfaces.front()),
                      text + " nothing but the sky: no surface gets light from there or sends any",
                      "if others should be seen, list the points the other way round"});
}

}  // namespace

Findings sight_findings(const Scene2& scene, const ExchangeMatrix& matrix) {
  Findings findings;
  std::vector<std::uint32_t> open;
  std::vector<Lonely> groups(scene.groups.size());
  for (std::uint32_t face = 0; face < matrix.size(); ++face) {
    if (!matrix.has_row(face)) continue;
    const Element& element = matrix.elements()[face];
    const Sight sight = sight_of(matrix, face);
    if (scene.closed && sight.sky && !element.is_back) open.push_back(face);
    Lonely& group = groups[scene.surfaces[element.surface].group];
    ++group.faces;
    if (!sight.materials) (sight.black ? group.black : group.sky).push_back(face);
  }
  if (!open.empty()) findings.push_back(not_closed(scene, matrix, open));
  for (const Lonely& group : groups) tell_lonely(scene, matrix, group, findings);
  return findings;
}

}  // namespace hottel

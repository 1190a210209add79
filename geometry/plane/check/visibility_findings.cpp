#include "geometry/plane/check/visibility_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "geometry/name.h"
#include "geometry/plane/check/openings.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/closest_point.h"

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

// Fronts that see the sky, by the opening they see it through: kNoOpening where none is narrow.
using OpenFronts = std::map<std::uint32_t, std::vector<std::uint32_t>>;
constexpr std::uint32_t kNoOpening = 0xffffffff;

OpenFronts fronts_by_opening(const PreparedScene2& prepared, const ExchangeMatrix& matrix, const Openings2& openings) {
  const Arrangement2& arrangement = prepared.arrangement;
  std::vector<std::uint32_t> opening(prepared.scene.surfaces.size(), kNoOpening);
  for (const PieceSideId side : arrangement.sides()) {
    if (arrangement.is_covered(side)) continue;
    const FacePart2& owner = arrangement.owner(side);
    if (const auto found = openings.behind(side); found && !owner.is_back)
      opening[owner.surface] = std::min(opening[owner.surface], *found);
  }
  OpenFronts fronts;
  for (std::uint32_t face = 0; face < matrix.size(); ++face) {
    const Element& element = matrix.elements()[face];
    if (!matrix.has_row(face) || element.is_back || !sight_of(matrix, face).sky) continue;
    fronts[opening[element.surface]].push_back(face);
  }
  return fronts;
}

// "the fronts of 'a' and 'b' see the sky, 'a' the most (F = 0.1)"
std::string sky_text(const Scene2& scene, const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& fronts,
                     std::vector<std::uint32_t>& surfaces) {
  std::uint32_t most = fronts.front();
  for (const std::uint32_t face : fronts) {
    const std::uint32_t surface = matrix.elements()[face].surface;
    if (surfaces.empty() || surfaces.back() != surface) surfaces.push_back(surface);
    if (matrix.factor(face, matrix.sky()).value > matrix.factor(most, matrix.sky()).value) most = face;
  }
  const std::string factor = shortest(matrix.factor(most, matrix.sky()).value);
  if (surfaces.size() == 1)
    return fmt::format("the front of {} sees the sky (F = {})", names_text(scene, surfaces), factor);
  return fmt::format("the fronts of {} see the sky, {} the most (F = {})", names_text(scene, surfaces),
                     quoted_name(matrix.elements()[most].name), factor);
}

// The end of a surface that goes on at its other end only.
struct LooseEnd {
  std::uint32_t surface;
  Point2 at;
};

// The first of these surfaces. REQUIRES an arrangement that is not divided.
std::optional<LooseEnd> loose_end(const PreparedScene2& prepared, const std::vector<std::uint32_t>& surfaces) {
  const Arrangement2& arrangement = prepared.arrangement;
  std::vector<std::uint32_t> pieces(arrangement.vertices().size(), 0);
  for (const Segment2& piece : arrangement.pieces())
    for (const VertexId end : {piece.a, piece.b}) ++pieces[end.index()];
  for (const std::uint32_t s : surfaces) {
    const Edge2& edge = prepared.scene.edges[s];
    const Segment2& segment = arrangement.segment(s);
    const bool begins_alone = pieces[segment.a.index()] == 1, ends_alone = pieces[segment.b.index()] == 1;
    if (begins_alone != ends_alone) return LooseEnd{s, begins_alone ? edge.from : edge.to};
  }
  return std::nullopt;
}

void tell_open(const PreparedScene2& prepared, const ExchangeMatrix& matrix, Findings2& findings) {
  const Scene2& scene = prepared.scene;
  const Openings2 openings(prepared.arrangement);
  for (const auto& [opening, fronts] : fronts_by_opening(prepared, matrix, openings)) {
    const Opening2* gap = opening == kNoOpening ? nullptr : &openings.all()[opening];
    if (!scene.closed && (gap == nullptr || !gap->closes_the_room || gap->part >= kLeakPart)) continue;
    std::vector<std::uint32_t> surfaces;
    std::string text = sky_text(scene, matrix, fronts, surfaces);
    Point2 at = middle(scene.edges[surfaces.front()]);
    if (gap != nullptr) {
      at = middle(gap->from, gap->to);
      text += fmt::format(" through the opening from {} to {}, {} wide", place_text(gap->from), place_text(gap->to),
                          length_text(squared_distance(gap->from, gap->to)));
    } else if (const auto end = loose_end(prepared, surfaces)) {
      at = end->at;
      text += fmt::format("; the end of {} at {} touches nothing", quoted_name(scene.surfaces[end->surface].name),
                          place_text(end->at));
    }
    if (scene.closed)
      findings.push_back({Severity::kError, "not-closed", surfaces, at, "the scene promises to be closed, but " + text,
                          gap != nullptr ? "close it, or take the promise \"closed\" away"
                                         : "reverse what has its fronts outside, close the room, or take the promise "
                                           "\"closed\" away"});
    else
      findings.push_back({Severity::kNote, "opening", surfaces, at, text,
                          "if the room should be closed, close it, and promise it: \"closed\": true"});
  }
}

// Faces of one group with a material that see nothing.
struct Lonely {
  std::vector<std::uint32_t> sky;  // see nothing but the sky
  std::size_t faces = 0;           // of the group, with a row
};

std::string faces_text(const Scene2& scene, const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& faces,
                       std::vector<std::uint32_t>& surfaces) {
  bool has_front = false, has_back = false;
  for (const std::uint32_t face : faces) {
    const Element& element = matrix.elements()[face];
    (element.is_back ? has_back : has_front) = true;
    if (surfaces.empty() || surfaces.back() != element.surface) surfaces.push_back(element.surface);
  }
  const bool one = surfaces.size() == 1 && !(has_front && has_back);
  return fmt::format("the {}{}{} of {} see{}", has_front ? one ? "front" : "fronts" : "",
                     has_front && has_back ? " and " : "", has_back ? one ? "back" : "backs" : "",
                     names_text(scene, surfaces), one ? "s" : "");
}

void tell_lonely(const Scene2& scene, const ExchangeMatrix& matrix, const Lonely& lonely, Findings2& findings) {
  // That a part of a body looks away from everything is in the nature of bodies.
  if (lonely.sky.empty() || lonely.sky.size() < lonely.faces) return;
  std::vector<std::uint32_t> surfaces;
  const std::string text = faces_text(scene, matrix, lonely.sky, surfaces);
  findings.push_back({Severity::kNote, "sees-only-sky", surfaces, middle(scene.edges[surfaces.front()]),
                      text + " nothing but the sky: no surface gets light from there or sends any",
                      "if others should be seen, list the points the other way round"});
}

}  // namespace

Findings2 visibility_findings(const PreparedScene2& prepared, const ExchangeMatrix& matrix) {
  const Scene2& scene = prepared.scene;
  Findings2 findings;
  tell_open(prepared, matrix, findings);
  std::vector<Lonely> groups(scene.groups.size());
  for (std::uint32_t face = 0; face < matrix.size(); ++face) {
    if (!matrix.has_row(face)) continue;
    const Sight sight = sight_of(matrix, face);
    Lonely& group = groups[scene.surfaces[matrix.elements()[face].surface].group];
    ++group.faces;
    if (!sight.materials && !sight.black) group.sky.push_back(face);
  }
  for (const Lonely& group : groups) tell_lonely(scene, matrix, group, findings);
  return findings;
}

}  // namespace hottel

#include "geometry/plane/check/black_backs.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "geometry/name.h"
#include "geometry/plane/check/behind_remedies.h"
#include "geometry/plane/check/wording.h"

namespace hottel {
namespace {

// Who loses most light on a back.
struct Loss {
  std::uint32_t from = 0;
  double factor = -1;     // none so far
  std::size_t faces = 0;  // that lose any
};

bool is_black(const ExchangeMatrix& matrix, std::uint32_t to) {
  return to != matrix.sky() && !matrix.elements()[to].material;
}

std::vector<Loss> losses_by_surface(const Scene2& scene, const ExchangeMatrix& matrix) {
  std::vector<Loss> losses(scene.surfaces.size());
  for (std::uint32_t from = 0; from < matrix.size(); ++from) {
    if (!matrix.has_row(from)) continue;
    for (const FactorEntry& entry : matrix.row(from)) {
      if (!is_black(matrix, entry.to)) continue;
      Loss& loss = losses[matrix.elements()[entry.to].surface];
      ++loss.faces;
      if (entry.factor.value > loss.factor) {
        loss.factor = entry.factor.value;
        loss.from = from;
      }
    }
  }
  return losses;
}

bool sees_material(const ExchangeMatrix& matrix, std::uint32_t from) {
  const auto row = matrix.row(from);
  return std::any_of(row.begin(), row.end(),
                     [&](const FactorEntry& entry) { return entry.to != matrix.sky() && !is_black(matrix, entry.to); });
}

std::string suggestion(const Scene2& scene, std::uint32_t surface, const BehindRemedy2* remedy) {
  constexpr const char* kBack = "a \"back\", or its material \"two_sided\": true";
  const std::string group = quoted_name(scene.groups[scene.surfaces[surface].group].name);
  if (remedy == nullptr) return fmt::format("give {} {}", group, kBack);
  if (remedy->swallows.empty())
    return fmt::format("give {} \"behind\": \"solid\" where nothing is behind it, else {}", group, kBack);
  std::vector<std::uint32_t> surfaces;
  for (const Face& face : remedy->swallows)
    if (surfaces.empty() || surfaces.back() != face.surface) surfaces.push_back(face.surface);
  return fmt::format("give {} {}; \"behind\": \"solid\" would fill the space there and cover {} wholly", group, kBack,
                     names_text(scene, surfaces));
}

std::string loss_text(const Scene2& scene, const ExchangeMatrix& matrix, std::uint32_t surface, const Loss& loss) {
  std::string text = fmt::format("the back of {} is black: there {} loses F = {} of its light",
                                 quoted_name(scene.surfaces[surface].name),
                                 quoted_name(matrix.elements()[loss.from].name), shortest(loss.factor));
  if (loss.faces > 1) text += fmt::format(", the most of {} faces", loss.faces);
  if (!sees_material(matrix, loss.from)) text += "; it sees no face with a material";
  return text;
}

// What the front of each surface sees; kNoRow where it has no row.
enum class FrontSees : unsigned char { kNoRow, kSkyAlone, kSurfaces };

std::vector<FrontSees> seen_by_fronts(const Scene2& scene, const ExchangeMatrix& matrix) {
  std::vector<FrontSees> seen(scene.surfaces.size(), FrontSees::kNoRow);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    if (element.is_back || !matrix.has_row(i)) continue;
    const FactorRow row = matrix.row(i);
    const bool sees_surfaces = row.size() > 0 && row[0].to != matrix.sky();  // the sky is the last
    seen[element.surface] =
        std::max(seen[element.surface], sees_surfaces ? FrontSees::kSurfaces : FrontSees::kSkyAlone);
  }
  return seen;
}

// Whether the fronts of these surfaces see nothing but the sky.
bool face_the_sky(const std::vector<FrontSees>& seen, const std::vector<std::uint32_t>& surfaces) {
  FrontSees most = FrontSees::kNoRow;
  for (const std::uint32_t s : surfaces) most = std::max(most, seen[s]);
  return most == FrontSees::kSkyAlone;
}

}  // namespace

bool sees_black_backs_2(const ExchangeMatrix& matrix) {
  for (std::uint32_t from = 0; from < matrix.size(); ++from)
    for (const FactorEntry& entry : matrix.row(from))
      if (matrix.has_row(from) && is_black(matrix, entry.to)) return true;
  return false;
}

BlackBacks2 black_backs(const PreparedScene2& prepared, const FreeRegions2& regions, const ExchangeMatrix& matrix,
                        const std::vector<char>& told) {
  const Scene2& scene = prepared.scene;
  const std::vector<Loss> losses = losses_by_surface(scene, matrix);
  std::vector<std::vector<std::uint32_t>> lost(scene.groups.size());
  BlackBacks2 result;
  for (std::uint32_t s = 0; s < losses.size(); ++s)
    if (losses[s].factor >= 0 && told[s] == 0) {
      lost[scene.surfaces[s].group].push_back(s);
      result.surfaces.push_back(s);
    }
  if (result.surfaces.empty()) return result;
  BehindRemedies2 remedies(prepared, regions);
  const std::vector<FrontSees> seen = seen_by_fronts(scene, matrix);
  for (std::vector<std::uint32_t>& surfaces : lost) {
    if (surfaces.empty()) continue;
    const std::uint32_t s = *std::max_element(surfaces.begin(), surfaces.end(),
                                              [&](auto a, auto b) { return losses[a].factor < losses[b].factor; });
    std::string message = loss_text(scene, matrix, s, losses[s]);
    if (surfaces.size() > 1)
      message += fmt::format("; so are {} more of {} that others see", surfaces.size() - 1,
                             quoted_name(scene.groups[scene.surfaces[s].group].name));
    std::string advice = suggestion(scene, s, remedies.of(s));
    if (face_the_sky(seen, surfaces))
      advice = fmt::format("if its front should face {}, list its points the other way round; else {}",
                           quoted_name(matrix.elements()[losses[s].from].name), advice);
    result.findings.push_back({Severity::kWarning, "black-back", std::move(surfaces), middle(scene.edges[s]),
                               std::move(message), std::move(advice)});
  }
  return result;
}

}  // namespace hottel

#include "geometry/plane/check/black_backs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
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
  const std::string group = quoted_name(scene.groups[scene.surfaces[surface].group].name);
  if (remedy == nullptr) return fmt::format("give {} a \"back\"", group);
  if (remedy->swallows.empty())
    return fmt::format("give {} \"behind\": \"solid\" where nothing is behind it, else a \"back\"", group);
  std::vector<std::uint32_t> surfaces;
  for (const Face& face : remedy->swallows)
    if (surfaces.empty() || surfaces.back() != face.surface) surfaces.push_back(face.surface);
  return fmt::format("give {} a \"back\"; \"behind\": \"solid\" would fill the space there and cover {} wholly", group,
                     names_text(scene, surfaces));
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
  BlackBacks2 result;
  std::optional<BehindRemedies2> remedies;
  for (std::uint32_t s = 0; s < losses.size(); ++s) {
    const auto& [from, factor, faces] = losses[s];
    if (factor < 0 || told[s] != 0) continue;
    if (!remedies) remedies.emplace(prepared, regions);
    const Surface& surface = scene.surfaces[s];
    std::string message =
        fmt::format("the back of {} is black: there {} loses F = {} of its light", quoted_name(surface.name),
                    quoted_name(matrix.elements()[from].name), shortest(factor));
    if (faces > 1) message += fmt::format(", the most of {} faces", faces);
    if (!sees_material(matrix, from)) message += "; it sees no face with a material";
    result.findings.push_back({Severity::kWarning,
                               "black-back",
                               {s},
                               middle(scene.edges[s]),
                               std::move(message),
                               suggestion(scene, s, remedies->of(s))});
    result.surfaces.push_back(s);
  }
  return result;
}

}  // namespace hottel

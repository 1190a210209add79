#include "solver/check/light_fates.h"

#include <algorithm>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

void add_fates(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySources& given, int channel,
               LightFates& fates) {
  const RadiositySystem system(matrix, scene.materials, channel);
  fates.rows_are_closed &= system.rows_are_closed();
  const Sources sources = system.sources(given, channel);
  const std::vector<char> is_taken_from = given.withdrawn.empty()
                                              ? std::vector<char>(sources.is_lit.size(), 0)
                                              : system.sources(given.withdrawn_alone(true), channel).is_lit;
  const std::size_t count = system.components().size();
  std::vector<std::vector<std::uint32_t>> faces(count);
  std::vector<double> area(count), lost(count);
  for (const SystemRow& row : system.rows()) {
    double out = 0;
    for (const FactorEntry& entry : matrix.row(row.element))
      if (system.unknown(entry.to) < 0) out += entry.factor.value;
    const double size = matrix.elements()[row.element].area.value;
    area[row.component] += size;
    lost[row.component] += size * (row.loss.hi + row.reflectivity.hi * out);
    faces[row.component].push_back(row.element);
  }
  for (std::size_t c = 0; c < count; ++c) {
    LightFate& fate = fates.of[faces[c]];
    const bool is_lit = sources.is_lit[c] != 0 || is_taken_from[c] != 0, loses = system.components()[c].loses;
    fate.is_lit |= is_lit;
    fate.has_no_solution |= !loses && is_lit;
    fate.reflects_all |= !loses;
    fate.loss = std::min(fate.loss, lost[c] / area[c]);
  }
}

}  // namespace

LightFates light_fates(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySources& sources) {
  LightFates fates;
  for (int channel = 0; channel < channel_count(scene); ++channel) add_fates(scene, matrix, sources, channel, fates);
  return fates;
}

}  // namespace hottel

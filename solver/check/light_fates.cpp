#include "solver/check/light_fates.h"

#include <algorithm>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

// In two bands, the components of the thermal one with a face that keeps what it gains in the solar one, where some
// light reaches it.
std::vector<char> gains_by_component(const ExchangeMatrix& matrix, const SceneTable& scene,
                                     const RadiositySystem& system, const RadiositySources& given) {
  std::vector<char> result(system.components().size(), 0);
  const RadiositySystem solar(matrix, scene.materials, static_cast<int>(kSolarBand));
  const Sources sources = solar.sources(given, static_cast<int>(kSolarBand));
  const auto is_lit = [&](std::uint32_t element) {
    const std::int32_t u = solar.unknown(element);
    if (u >= 0) return sources.is_lit[solar.rows()[static_cast<std::size_t>(u)].component] != 0;
    const auto row = matrix.row(element);
    const bool is_shone_on = !given.direct_irradiance.empty() && given.direct_irradiance[element][kSolarBand].upper > 0;
    return is_shone_on || std::any_of(row.begin(), row.end(), [&](const FactorEntry& entry) {
             const std::int32_t other = entry.to == matrix.sky() ? -1 : solar.unknown(entry.to);
             return other >= 0 ? sources.is_lit[solar.rows()[static_cast<std::size_t>(other)].component] != 0
                               : !sources.emission[entry.to].is_zero();
           });
  };
  for (const SystemRow& row : system.rows()) {
    const Material& material = scene.materials[*matrix.elements()[row.element].material];
    const bool is_white = material.reflectivity.value[kSolarBand] == 1 && material.emission.value[kSolarBand] == 0;
    if (given.keeps_gains[row.element] && !is_white && is_lit(row.element)) result[row.component] = 1;
  }
  return result;
}

void add_fates(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySources& given, int channel,
               LightFates& fates) {
  const RadiositySystem system(matrix, scene.materials, channel);
  fates.rows_are_closed &= system.rows_are_closed();
  fates.are_real_rows_closed &= system.rows_are_closed() || matrix.has_closed_rows();
  const Sources sources = system.sources(given, channel);
  std::vector<char> is_taken_from = given.withdrawn.empty()
                                        ? std::vector<char>(sources.is_lit.size(), 0)
                                        : system.sources(given.withdrawn_alone(true), channel).is_lit;
  if (given.has_bands && channel == static_cast<int>(kThermalBand)) {
    const std::vector<char> may_gain = gains_by_component(matrix, scene, system, given);
    for (std::size_t c = 0; c < may_gain.size(); ++c) is_taken_from[c] |= may_gain[c];
  }
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
